//! The history of a document: 100,000 single steps of a refinement, back and forth.
//!
//! ```text
//! cargo run --release -p trimalla-workbench --example history [STEPS [ALGORITHM]]
//! ```
//!
//! Prints what the commands take at median and at most, and what the process takes in memory.

use std::time::{Duration, Instant};

use trimalla_workbench::{Document, Interface, MessageKind};

/// Keeps what the document says of commands that it dropped.
#[derive(Default)]
struct Dropped(Vec<String>);

impl Interface for Dropped {
    fn message(&mut self, _: MessageKind, text: &str) {
        if text.contains("no longer be undone") {
            self.0.push(text.to_owned());
        }
    }
}

#[allow(clippy::print_stdout, reason = "an example")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let steps: usize = std::env::args().nth(1).map_or(Ok(100_000), |word| word.parse())?;
    let (mut document, mut dropped) = (Document::new(), Dropped::default());
    let algorithm = std::env::args().nth(2).unwrap_or_else(|| "circumcenter".to_owned());
    let begin =
        format!("Generate polygon 200\nTriangulate\nSet algorithm {algorithm}\nSet max-area {}\n", 0.2 / steps as f64);
    for line in begin.lines() {
        document.run(line, &mut dropped)?;
    }
    let resident_before = resident();
    print_row("command", "times", &["median", "longest"].map(str::to_owned));
    let mut measure = |line: &str, times: usize| -> Result<(), Box<dyn std::error::Error>> {
        let mut taken = Vec::with_capacity(times);
        for _ in 0..times {
            let began = Instant::now();
            document.run(line, &mut dropped)?;
            taken.push(began.elapsed());
        }
        taken.sort_unstable();
        let (median, longest) = (taken[times / 2], taken[times - 1]);
        print_row(line, &times.to_string(), &[in_microseconds(median), in_microseconds(longest)]);
        Ok(())
    };
    measure("Step", 1)?; // begins the refinement
    measure("Step", steps - 1)?;
    measure("Undo", 1000)?;
    measure("Redo", 1000)?;
    measure("Undo 1000", 1)?;
    measure("Redo 1000", 1)?;
    let (made, vertices) = (document.steps_made(), document.triangulation().map_or(0, |t| t.points().len()));
    println!("{made} steps, {vertices} vertices");
    let (undoable, _) = document.undoable();
    println!(
        "{undoable} commands can be undone{}",
        if dropped.0.is_empty() { "" } else { ", older ones were dropped" }
    );
    println!("history: {} of {} bytes, {} a step", document.history_bytes(), Document::HISTORY_BYTES, {
        document.history_bytes() / undoable.max(1)
    });
    if let (Some(before), Some(after)) = (resident_before, resident()) {
        println!("resident: {} MB more than before the first step", (after - before) >> 10);
    }
    Ok(())
}

#[allow(clippy::print_stdout, reason = "an example")]
fn print_row(command: &str, times: &str, taken: &[String; 2]) {
    println!("{command:<10} {times:>7} {:>12} {:>12}", taken[0], taken[1]);
}

fn in_microseconds(taken: Duration) -> String {
    format!("{:.1} µs", taken.as_secs_f64() * 1e6)
}

/// The memory that the process has, in KiB, where the system tells.
fn resident() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().trim_end_matches(" kB").parse().ok()
}
