//! Drawings that make naive programs quadratic: segments from one vertex, segments nested on one line, copies of a segment.
//!
//! ```text
//! cargo run --release -p trimalla --example hubs_and_overlaps
//! ```
//!
//! Prints the least time of three, and by how much the memory of the process grew (on Linux).

#![allow(clippy::print_stdout, reason = "an example prints")]

use std::f64::consts::TAU;
use std::time::Instant;

use trimalla::constrained::{ConstrainedDelaunay, ConstraintError, Crossings};
use trimalla::geometry::{Point, math};

type Drawing = (Vec<Point>, Vec<[u32; 2]>);

fn main() -> Result<(), ConstraintError> {
    const SPOKES: u32 = 100_000;
    let nested = nested(10_000);
    let inwards = (nested.0.clone(), nested.1.iter().rev().copied().collect());
    // The small ones first: what the large ones give back to the allocator would hide how the memory grows.
    let rows: [(&str, Drawing); 7] = [
        ("100,000 copies of one", copies(100_000)),
        ("10,000 nested on a line, outwards", nested),
        ("the same, inwards", inwards),
        ("100,000 disjoint segments", disjoint(SPOKES)),
        ("100,000 from a hub to a circle", star(SPOKES, TAU, false)),
        ("the same, from the circle to the hub", star(SPOKES, TAU, true)),
        ("100,000 from a hub to an arc of 1e-7", star(SPOKES, 1e-7, false)),
    ];
    println!("| drawing | points, s | with segments, s | bytes a segment |\n|--|--|--|--|");
    for (name, (points, segments)) in rows {
        let before = resident();
        let cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Refuse)?;
        let with_segments = resident() - before;
        drop(cdt);
        let before = resident();
        let bare = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse)?;
        let without = resident() - before;
        drop(bare);
        let bytes = (with_segments - without).max(0.0) / segments.len() as f64;
        let (alone, whole) = (least_time(&points, &[])?, least_time(&points, &segments)?);
        println!("| {name} | {alone:.3} | {whole:.3} | {bytes:.0} |");
    }
    Ok(())
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

fn copies(n: u32) -> Drawing {
    let points = [[0.0, 0.0], [4.0, 1.0], [1.0, 3.0], [2.0, -2.0]].map(Point::from).to_vec();
    (points, (0..n).map(|i| if i % 2 == 0 { [0, 1] } else { [1, 0] }).collect())
}
