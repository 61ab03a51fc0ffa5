//! Drawings that make naive programs quadratic: segments from one vertex, segments nested on one line, copies of a
//! segment.
//!
//! ```text
//! cargo run --release -p trimalla --example hubs_and_overlaps
//! ```
//!
//! Prints the least time of three, and by how much more the memory of a process grows with the segments than without
//! (on Linux). Each growth is that of a process of its own: what an earlier drawing gave back to the allocator would
//! hide it.

#![allow(clippy::print_stdout, reason = "an example prints")]

use std::error::Error;
use std::f64::consts::TAU;
use std::process::Command;
use std::time::Instant;

use trimalla::constrained::{ConstrainedDelaunay, ConstraintError, Crossings};
use trimalla::geometry::{Point, math};

type Drawing = (Vec<Point>, Vec<[u32; 2]>);
/// A name, how the drawing of so many segments is made, and how many it has.
type Row = (&'static str, fn(u32) -> Drawing, u32);

const ROWS: [Row; 8] = [
    ("100,000 copies of one", copies, 100_000),
    ("10,000 nested on a line, outwards", nested, 10_000),
    ("the same, inwards", inwards, 10_000),
    ("the same, in no order", mixed, 10_000),
    ("100,000 disjoint segments", disjoint, 100_000),
    ("100,000 from a hub to a circle", |n| star(n, TAU, false), 100_000),
    ("the same, from the circle to the hub", |n| star(n, TAU, true), 100_000),
    ("100,000 from a hub to an arc of 1e-7", |n| star(n, 1e-7, false), 100_000),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [row, segments] = &arguments[..] {
        println!("{}", growth(ROWS[row.parse::<usize>()?], segments == "with")?);
        return Ok(());
    }
    println!("| drawing | points, s | with segments, s | bytes a segment |\n|--|--|--|--|");
    for (i, (name, drawing, n)) in ROWS.into_iter().enumerate() {
        let bytes = (growth_in_child(i, "with")? - growth_in_child(i, "without")?) / f64::from(n);
        let (points, segments) = drawing(n);
        let (alone, whole) = (least_time(&points, &[])?, least_time(&points, &segments)?);
        println!("| {name} | {alone:.3} | {whole:.3} | {bytes:.0} |");
    }
    Ok(())
}

/// [`growth`] of a process of its own: the median of five.
fn growth_in_child(row: usize, segments: &str) -> Result<f64, Box<dyn Error>> {
    let mut bytes = [0.0; 5];
    for bytes in &mut bytes {
        let child = Command::new(std::env::current_exe()?).args([&row.to_string(), segments]).output()?;
        *bytes = String::from_utf8(child.stdout)?.trim().parse()?;
    }
    bytes.sort_unstable_by(f64::total_cmp);
    Ok(bytes[2])
}

/// By how many bytes this process grows while it triangulates a drawing, with or without its segments.
fn growth((_, drawing, n): Row, with_segments: bool) -> Result<f64, ConstraintError> {
    let built = |n: u32| {
        let (points, segments) = drawing(n);
        let before = resident();
        let used = if with_segments { &segments[..] } else { &[] };
        ConstrainedDelaunay::new(&points, used, Crossings::Refuse).map(|cdt| (resident() - before, cdt))
    };
    // The first call loads the program's own pages.
    drop(built(10)?);
    built(n).map(|(bytes, _)| bytes)
}

fn least_time(points: &[Point], segments: &[[u32; 2]]) -> Result<f64, ConstraintError> {
    let mut least = f64::INFINITY;
    for _ in 0..3 {
        let start = Instant::now();
        ConstrainedDelaunay::new(points, segments, Crossings::Refuse)?;
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok(least)
}

/// Bytes of this process in memory; 0 where the system does not tell.
fn resident() -> f64 {
    let pages = std::fs::read_to_string("/proc/self/statm").ok();
    let pages = pages.and_then(|text| text.split_whitespace().nth(1)?.parse::<f64>().ok());
    pages.map_or(0.0, |pages| 4096.0 * pages)
}

/// Segments from the center of the unit circle to points on an arc of it, or back.
fn star(n: u32, arc: f64, reversed: bool) -> Drawing {
    let on_circle = |i: u32| {
        let angle = arc * f64::from(i) / f64::from(n);
        Point::new(math::cos(angle), math::sin(angle))
    };
    let points = std::iter::once(Point::new(0.0, 0.0)).chain((0..n).map(on_circle)).collect();
    (points, (1..=n).map(|i| if reversed { [i, 0] } else { [0, i] }).collect())
}

/// One segment in each cell of a grid.
fn disjoint(n: u32) -> Drawing {
    let side = n.isqrt() + 1;
    let cell = |i: u32| Point::new(f64::from(i % side), f64::from(i / side));
    let turned = |i: u32| (0.4 * math::cos(f64::from(i)), 0.4 * math::sin(f64::from(i)));
    let ends = |i: u32| {
        let (c, (dx, dy)) = (cell(i), turned(i));
        [Point::new(c.x - dx, c.y - dy), Point::new(c.x + dx, c.y + dy)]
    };
    ((0..n).flat_map(ends).collect(), (0..n).map(|i| [2 * i, 2 * i + 1]).collect())
}

/// Segments on a line, each inside the next one.
fn nested(n: u32) -> Drawing {
    let pair = |i: u32| [Point::new(-f64::from(i + 1), 0.0), Point::new(f64::from(i + 1), 0.0)];
    let beside = [Point::new(0.0, f64::from(n)), Point::new(0.0, -f64::from(n))];
    ((0..n).flat_map(pair).chain(beside).collect(), (0..n).map(|i| [2 * i, 2 * i + 1]).collect())
}

fn inwards(n: u32) -> Drawing {
    let (points, segments) = nested(n);
    (points, segments.into_iter().rev().collect())
}

/// Nested segments in steps of a prime, so that each is among those before it somewhere.
fn mixed(n: u32) -> Drawing {
    let (points, segments) = nested(n);
    (points, (0..n).map(|i| segments[(i * 7919 % n) as usize]).collect())
}

fn copies(n: u32) -> Drawing {
    let points = [[0.0, 0.0], [4.0, 1.0], [1.0, 3.0], [2.0, -2.0]].map(Point::from).to_vec();
    (points, (0..n).map(|i| if i % 2 == 0 { [0, 1] } else { [1, 0] }).collect())
}
