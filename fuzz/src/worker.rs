//! A child that tries one input after the other, and a watchdog that ends it when an input takes too long or too much
//! memory.
//!
//! What it does goes to standard output, a line each:
//!
//! ```text
//! at NUMBER EXECUTIONS MESHES REFUSED SLOWEST_MS SLOWEST_NUMBER PEAK_BYTES
//! fault NUMBER KIND<tab>DETAIL
//! hang NUMBER MILLISECONDS
//! memory NUMBER BYTES
//! ```

use std::io::{Write as _, stdout};
use std::process::exit;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::thread;
use std::time::{Duration, Instant};

use crate::MEMORY;
use crate::judge::{Fault, Tally};
use crate::targets::Target;

/// What a child is to do.
#[derive(Clone, Copy)]
pub struct Work {
    /// The target.
    pub target: &'static Target,
    /// The seed.
    pub seed: u64,
    /// The first number.
    pub from: u64,
    /// From one number to the next.
    pub stride: u64,
    /// How many inputs at most.
    pub count: u64,
    /// When to stop.
    pub time: Duration,
    /// Limits of one input.
    pub limits: Limits,
    /// Whether each number is told before it is tried.
    pub tells_each: bool,
}

/// What one input may take.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Time.
    pub time: Duration,
    /// Memory, in bytes.
    pub memory: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { time: Duration::from_secs(10), memory: 1 << 30 }
    }
}

/// Exit status after a hang.
pub const HANG: i32 = 70;
/// Exit status after too much memory.
pub const MEMORY_SPENT: i32 = 71;

/// The input at work, and when it began: milliseconds since the start, plus one; 0 where none is.
static NUMBER: AtomicU64 = AtomicU64::new(0);
static BEGAN: AtomicU64 = AtomicU64::new(0);

/// Ends the process when the input at work takes too long or too much memory.
///
/// Time is that of the processor, so that a busy machine makes no hangs; who waits is given ten times as much by the
/// clock.
pub fn watch(limits: Limits) -> Instant {
    let start = Instant::now();
    thread::spawn(move || {
        let mut at_work = (0, 0, Duration::ZERO);
        loop {
            thread::sleep(Duration::from_millis(20));
            let (number, began) = (NUMBER.load(Relaxed), BEGAN.load(Relaxed));
            if began == 0 {
                continue;
            }
            if (number, began) != (at_work.0, at_work.1) {
                at_work = (number, began, processor_time().unwrap_or_default());
                continue;
            }
            let by_clock = start.elapsed().saturating_sub(Duration::from_millis(began));
            let taken = processor_time().map_or(by_clock, |now| now.saturating_sub(at_work.2));
            let used = MEMORY.current_usage();
            if used > limits.memory {
                end(&format!("memory {number} {used}"), MEMORY_SPENT);
            }
            if taken > limits.time || by_clock > 10 * limits.time {
                end(&format!("hang {number} {}", by_clock.as_millis()), HANG);
            }
        }
    });
    start
}

/// Processor time of this process, where the system tells: in ticks of a hundredth of a second.
fn processor_time() -> Option<Duration> {
    let text = std::fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<&str> = text.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = fields.get(11)?.parse::<u64>().ok()? + fields.get(12)?.parse::<u64>().ok()?;
    Some(Duration::from_millis(10 * ticks))
}

/// Notes that an input is at work.
pub fn begin(number: u64, start: Instant) {
    NUMBER.store(number, Relaxed);
    BEGAN.store(start.elapsed().as_millis() as u64 + 1, Relaxed);
}

/// Notes that none is.
pub fn rest() {
    BEGAN.store(0, Relaxed);
}

fn end(line: &str, status: i32) -> ! {
    say(line);
    exit(status)
}

fn say(line: &str) {
    let mut out = stdout().lock();
    // A parent that is gone wants to know nothing more.
    if writeln!(out, "{line}").and_then(|()| out.flush()).is_err() {
        exit(0);
    }
}

/// What was done so far.
#[derive(Default)]
struct Progress {
    executions: u64,
    tally: Tally,
    slowest: (Duration, u64),
}

impl Progress {
    fn say(&self, number: u64) {
        let Tally { meshes, refused } = self.tally;
        let (slowest, which) = (self.slowest.0.as_millis(), self.slowest.1);
        say(&format!("at {number} {} {meshes} {refused} {slowest} {which} {}", self.executions, MEMORY.peak_usage()));
    }
}

/// Does the work.
pub fn work(work: &Work) {
    let start = watch(work.limits);
    let mut progress = Progress::default();
    let mut said = Instant::now();
    let mut number = work.from;
    while progress.executions < work.count && start.elapsed() < work.time {
        if work.tells_each {
            say(&format!("try {number}"));
        }
        let before = Instant::now();
        begin(number, start);
        let input = work.target.input(work.seed, number);
        let verdict = work.target.try_out(&input, &mut progress.tally);
        rest();
        drop(input);
        progress.executions += 1;
        progress.slowest = progress.slowest.max((before.elapsed(), number));
        if let Err(Fault { kind, detail }) = verdict {
            let [kind, detail] = [kind, detail].map(|s| s.replace(['\n', '\t'], " "));
            say(&format!("fault {number} {kind}\t{}", detail.chars().take(300).collect::<String>()));
        }
        number += work.stride;
        if said.elapsed() > Duration::from_millis(200) {
            said = Instant::now();
            progress.say(number);
        }
    }
    progress.say(number);
}
