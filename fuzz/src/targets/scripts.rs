//! Scripts of commands: valid, damaged, without sense.

use trimalla_io::{Files, Memory};
use trimalla_workbench::{COMMANDS, Document, Quiet, script};

use super::Target;
use crate::draws::Draws;
use crate::input::{FileCase, Input};
use crate::judge::{Tally, Verdict, must, none};
use crate::texts;

/// See the file.
pub const TARGET: Target =
    Target { name: "scripts", summary: "commands of the workbench, with undo", share: 2, make, judge };

/// What a file may be taken for.
pub const FORMATS: [&str; 1] = ["tri"];

/// A mesh of a few points stays small.
const FIRST: &str = "Set max-vertices 200";

fn make(d: &mut Draws<'_>) -> Input {
    let mut bytes = if d.rest().len() > 16 { d.rest().to_vec() } else { commands(d).into_bytes() };
    if d.once_in(2) {
        for _ in 0..d.within(1, 3) {
            texts::damage(d, &mut bytes);
        }
    }
    Input::File(FileCase { format: "tri", bytes })
}

fn coordinate(d: &mut Draws<'_>) -> String {
    match d.below(12) {
        0 => d.pick(&["nan", "inf", "-1e308", "1e308", "5e-324", "1e17", "0.1"]).to_owned(),
        1 => d.range(-1e6, 1e6).to_string(),
        _ => (d.below(9) as f64 * 0.5).to_string(),
    }
}

fn commands(d: &mut Draws<'_>) -> String {
    let mut text = String::new();
    for _ in 0..d.within(1, 60) {
        let line = match d.below(20) {
            0..=6 => format!("Insert {} {}", coordinate(d), coordinate(d)),
            7 | 8 => "Triangulate".to_owned(),
            9 => format!("Edge {} {}", d.below(20), d.below(20)),
            10 => format!("Move {} {} {}", d.below(20), coordinate(d), coordinate(d)),
            11 => format!("Delete {}", d.below(20)),
            12 => format!("Flip {} {}", d.below(20), d.below(20)),
            13 => format!("Undo {}", d.below(5)),
            14 => format!("Redo {}", d.below(5)),
            15 => format!("LEPP {} {}", d.below(40), d.pick(&["CEN", "MID"])),
            16 => format!("Step {}", d.below(9)),
            17 => "Refine".to_owned(),
            18 => format!("Generate {} {}", d.pick(&["random", "grid", "circle", "spiral", "polygon"]), d.below(30)),
            _ => {
                let name = COMMANDS[d.below(COMMANDS.len())].name;
                format!("{name} {} {} {}", d.below(20), d.below(20), d.below(20))
            }
        };
        text.push_str(&line);
        text.push('\n');
    }
    text
}

/// Whether a line is left out: it would make more than a trial can take, or write what a later run reads.
fn is_left_out(line: &str) -> bool {
    let mut words = line.split_whitespace();
    let name = words.next().unwrap_or_default().to_ascii_lowercase();
    match name.as_str() {
        "load" | "export" | "player" => true,
        "generate" => words.any(|word| word.len() > 3),
        "set" => line.contains("max-vertices"),
        _ => false,
    }
}

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Input::File(FileCase { bytes, .. }) = input else { return Ok(()) };
    let text = String::from_utf8_lossy(bytes);
    let lines: String = text.lines().filter(|line| !is_left_out(line)).map(|line| format!("{line}\n")).collect();
    // Recipes and scripts are written and read in memory.
    let files = Files::Memory(Memory::default());
    let mut document = Document::with_history(8 << 20).with_files(files.clone());
    for line in lines.lines() {
        // 'Undo' and 'Clear' take the bound away.
        if document.options().max_vertices != Some(200) {
            let _ = document.run(FIRST, &mut Quiet);
        }
        let _ = document.run(line, &mut Quiet);
        if let Some(t) = document.triangulation() {
            none("check", &t.check())?;
        }
    }
    tally.meshes += u64::from(document.triangulation().is_some());
    let mut again = Document::new().with_files(files);
    let refused = script::run(&mut again, &document.script(), false, &mut Quiet);
    must(refused.is_empty(), "a record is refused", || format!("{refused:?}"))?;
    must(again == document, "a record leads elsewhere", || document.script())?;
    let (undoable, _) = document.undoable();
    if document.script().lines().count() == undoable {
        let _ = document.run(&format!("Undo {undoable}"), &mut Quiet);
        must(document == Document::new(), "undone, it is not empty", || again.script())?;
    }
    Ok(())
}
