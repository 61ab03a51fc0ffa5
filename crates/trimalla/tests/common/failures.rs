//! Checks drawings and reduces those that fail to the fewest segments and points, as Rust to paste into a test.
//!
//! [`Failures`] collects the failures of many drawings, so that one run names all of them.
#![allow(dead_code, reason = "every test uses a part of it")]

use std::fmt::{Debug, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use trimalla::drawing::Pslg;

/// The result of a check: nothing, or what is wrong.
pub(crate) type Verdict = Result<(), String>;

/// How often the check is run while a drawing is reduced.
const MOST_CHECKS: usize = 3000;
/// How long one drawing is reduced.
const TIMEOUT: Duration = Duration::from_secs(4);
/// How many failures are reduced and printed; further ones are named only.
const PRINTED: usize = 12;

/// The failures of the drawings checked so far.
#[derive(Default)]
pub(crate) struct Failures {
    checked: usize,
    failures: Vec<String>,
}

impl Failures {
    /// Checks a drawing; one that fails is reduced and kept.
    pub(crate) fn check(&mut self, name: &str, pslg: &Pslg, check: impl Fn(&Pslg) -> Verdict) {
        self.checked += 1;
        let Err(why) = guarded(pslg, &check) else { return };
        if self.failures.len() >= PRINTED {
            return self.failures.push(format!("{name}: {why}"));
        }
        let few = reduced(pslg, &check);
        let still = guarded(&few, &check).err().unwrap_or_default();
        self.failures.push(format!("{name}: {why}\n{}// {still}", snippet(&few)));
    }

    /// Panics if any drawing failed, with all failures.
    pub(crate) fn expect_none(self) {
        let Self { checked, failures } = self;
        assert!(checked > 0, "nothing was checked");
        assert!(failures.is_empty(), "{} of {checked} failed:\n\n{}", failures.len(), failures.join("\n\n"));
    }
}

/// Fails if a list of faults is not empty.
pub(crate) fn none<T: Debug>(what: &str, faults: &[T]) -> Verdict {
    match faults {
        [] => Ok(()),
        [first, ..] => Err(format!("{what}: {} faults, first {first:?}", faults.len())),
    }
}

/// Fails if two values differ.
pub(crate) fn equal<T: PartialEq + Debug>(what: &str, left: &T, right: &T) -> Verdict {
    if left == right {
        return Ok(());
    }
    let mut words = format!("{what}: {left:?} is not {right:?}");
    if words.len() > 600 {
        let end = (0..=600).rev().find(|&i| words.is_char_boundary(i)).unwrap_or(0);
        words.truncate(end);
    }
    Err(words)
}

/// A drawing as Rust, every bit kept.
pub(crate) fn snippet(pslg: &Pslg) -> String {
    let mut rust = String::from("let pslg = Pslg {\n    points: vec![\n");
    for p in &pslg.points {
        let _ = writeln!(rust, "        Point::new({:?}, {:?}),", p.x, p.y);
    }
    let _ = writeln!(rust, "    ],\n    segments: vec!{:?},", pslg.segments);
    let seeds: Vec<String> = pslg.holes.iter().map(|h| format!("Point::new({:?}, {:?})", h.x, h.y)).collect();
    if !seeds.is_empty() {
        let _ = writeln!(rust, "    holes: vec![{}],", seeds.join(", "));
    }
    rust.push_str("    ..Pslg::default()\n};\n");
    rust
}

/// Runs a check; a panic is a failure.
pub(crate) fn guarded(pslg: &Pslg, check: &impl Fn(&Pslg) -> Verdict) -> Verdict {
    let said = catch_unwind(AssertUnwindSafe(|| check(pslg)));
    said.unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|&s| s.to_owned()));
        Err(format!("panicked: {}", text.unwrap_or_default()))
    })
}

/// Removes holes, then segments, then points while the check still fails.
fn reduced(pslg: &Pslg, check: &impl Fn(&Pslg) -> Verdict) -> Pslg {
    let mut checks = 0;
    let until = Instant::now() + TIMEOUT;
    let mut fails = |fewer: &Pslg| {
        checks += 1;
        checks < MOST_CHECKS && Instant::now() < until && guarded(fewer, check).is_err()
    };
    let mut few = Pslg {
        points: pslg.points.clone(),
        segments: pslg.segments.clone(),
        holes: pslg.holes.clone(),
        ..Pslg::default()
    };
    if !fails(&few) {
        return pslg.clone();
    }
    for _ in 0..2 {
        few = without_runs(
            few,
            |p| p.holes.len(),
            |p, gone| Pslg { holes: kept(&p.holes, gone), ..p.clone() },
            &mut fails,
        );
        few = without_runs(
            few,
            |p| p.segments.len(),
            |p, gone| Pslg { segments: kept(&p.segments, gone), ..p.clone() },
            &mut fails,
        );
        few = without_runs(few, |p| p.points.len(), without_points, &mut fails);
    }
    few
}

/// Removes runs of something, halving their length, while the check still fails.
fn without_runs(
    mut pslg: Pslg,
    count: impl Fn(&Pslg) -> usize,
    without: impl Fn(&Pslg, [usize; 2]) -> Pslg,
    fails: &mut impl FnMut(&Pslg) -> bool,
) -> Pslg {
    let mut run = count(&pslg).div_ceil(2);
    while run > 0 {
        let mut at = 0;
        while at < count(&pslg) {
            let fewer = without(&pslg, [at, (at + run).min(count(&pslg))]);
            if fails(&fewer) {
                pslg = fewer;
            } else {
                at += run;
            }
        }
        run /= 2;
    }
    pslg
}

fn kept<T: Clone>(list: &[T], [from, to]: [usize; 2]) -> Vec<T> {
    [&list[..from], &list[to..]].concat()
}

/// Without a run of points and the segments that end at them.
fn without_points(pslg: &Pslg, [from, to]: [usize; 2]) -> Pslg {
    let gone = from as u32..to as u32;
    let shift = |v: u32| if v >= gone.end { v - (gone.end - gone.start) } else { v };
    let segments = pslg.segments.iter().filter(|s| !s.iter().any(|v| gone.contains(v))).map(|s| s.map(shift)).collect();
    Pslg { points: kept(&pslg.points, [from, to]), segments, ..pslg.clone() }
}
