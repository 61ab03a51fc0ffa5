//! From a failure to the fewest points that still show it, as Rust to paste into a test.
#![allow(dead_code, reason = "every test uses a part of it")]

use std::fmt::Debug;
use std::panic::{AssertUnwindSafe, catch_unwind};

use trimalla::geometry::Point;

/// The result of a check: nothing, or what is wrong.
pub(crate) type Verdict = Result<(), String>;

/// How often the check is run while points are removed.
const QUESTIONS: usize = 4000;

/// Panics if `check` fails on `points` or panics itself, with the points reduced.
pub(crate) fn demand(name: &str, points: &[Point], check: impl Fn(&[Point]) -> Verdict) {
    let Err(why) = guarded(points, &check) else {
        return;
    };
    let few = reduced(points, &check);
    let still = guarded(&few, &check).err().unwrap_or_default();
    panic!("{name}: {why}\nreduced to:\n{}\n// {still}", snippet(&few));
}

/// Says that a list of faults is not empty.
pub(crate) fn none<T: Debug>(what: &str, faults: &[T]) -> Verdict {
    match faults {
        [] => Ok(()),
        [first, ..] => Err(format!("{what}: {} faults, first {first:?}", faults.len())),
    }
}

/// The points as Rust, every bit kept.
fn snippet(points: &[Point]) -> String {
    let row = |p: &Point| format!("    Point::new({:?}, {:?}),\n", p.x, p.y);
    let rows: String = points.iter().map(row).collect();
    format!("let points = [\n{rows}];")
}

/// The verdict, a panic being one.
fn guarded(points: &[Point], check: &impl Fn(&[Point]) -> Verdict) -> Verdict {
    let said = catch_unwind(AssertUnwindSafe(|| check(points)));
    said.unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|&s| s.to_owned()));
        Err(format!("panicked: {}", text.unwrap_or_default()))
    })
}

/// Removes runs of points, halving their length, while the check still fails.
fn reduced(points: &[Point], check: &impl Fn(&[Point]) -> Verdict) -> Vec<Point> {
    let mut points = points.to_vec();
    let mut questions = 0;
    let mut run = points.len().div_ceil(2);
    while run > 0 && questions < QUESTIONS {
        let (mut at, before) = (0, points.len());
        while at < points.len() && questions < QUESTIONS {
            let end = (at + run).min(points.len());
            let fewer = [&points[..at], &points[end..]].concat();
            questions += 1;
            if guarded(&fewer, check).is_err() {
                points = fewer;
            } else {
                at = end;
            }
        }
        if points.len() == before || run > 1 {
            run /= 2;
        }
    }
    points
}
