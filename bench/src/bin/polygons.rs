//! `polygon::Triangulator` beside `earcut`, one polygon in memory after the other, in one run.
//!
//! `cargo run --release --bin polygons [ROUNDS]` prints, for each family and number of corners, the time of both for a
//! polygon (the median of the rounds, which alternate between the two) and their ratio.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use trimalla::geometry::Point;
use trimalla::polygon::{Polygon, PolygonError, Triangulator};
use trimalla_bench::Outcome;
use trimalla_bench::random::Random;

const SIZES: [usize; 11] = [4, 5, 7, 10, 20, 30, 100, 300, 1000, 10_000, 100_000];
/// How many corners all polygons of a row have together.
const CORNERS: usize = 200_000;

/// A name, and the polygon of so many corners.
type Family = (&'static str, fn(usize, &mut Random) -> Vec<Point>);

const FAMILIES: [Family; 6] = [
    ("noisy circle", |n, random| star(n, 0.98, random)),
    ("star", |n, random| star(n, 0.3, random)),
    ("walk", walk),
    ("comb", comb),
    ("spiral", spiral),
    ("stairs", stairs),
];

fn main() -> Outcome<()> {
    let rounds = std::env::args().nth(1).map_or(Ok(9), |r| r.parse())?;
    println!("{:<14}{:>9}{:>14}{:>14}{:>8}", "family", "corners", "ours, ns", "earcut, ns", "ratio");
    for n in SIZES {
        for (name, make) in FAMILIES {
            let mut random = Random(n as u64);
            let polygons: Vec<Vec<Point>> = (0..(CORNERS / n).max(1)).map(|_| make(n, &mut random)).collect();
            let [ours, theirs] = race(&polygons, rounds)?;
            println!("{name:<14}{n:>9}{ours:>14.0}{theirs:>14.0}{:>8.2}", ours / theirs);
        }
    }
    Ok(())
}

/// The median times for a polygon, in nanoseconds.
fn race(polygons: &[Vec<Point>], rounds: usize) -> Outcome<[f64; 2]> {
    let arrays: Vec<Vec<[f64; 2]>> =
        polygons.iter().map(|polygon| polygon.iter().map(|p| [p.x, p.y]).collect()).collect();
    let mut times = [Vec::new(), Vec::new()];
    let (mut ours, mut theirs) = (Triangulator::new(), earcut::Earcut::new());
    let mut corners: Vec<u32> = Vec::new();
    for _ in 0..rounds {
        let begun = Instant::now();
        for polygon in polygons {
            black_box(triangulate(&mut ours, polygon)?);
        }
        times[0].push(begun.elapsed().as_nanos() as f64 / polygons.len() as f64);
        let begun = Instant::now();
        for polygon in &arrays {
            theirs.earcut_slice(polygon, &[] as &[u32], &mut corners);
            black_box(&corners);
        }
        times[1].push(begun.elapsed().as_nanos() as f64 / polygons.len() as f64);
    }
    Ok(times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    }))
}

fn triangulate(ours: &mut Triangulator, points: &[Point]) -> Result<usize, PolygonError> {
    Ok(ours.triangulate(Polygon::new(points, &[points.len() as u32])?)?.len())
}

/// Even angles, radii between `least` and 1.
fn star(n: usize, least: f64, random: &mut Random) -> Vec<Point> {
    (0..n).map(|i| polar(random.between(least, 1.0), TAU * i as f64 / n as f64)).collect()
}

/// A closed curve of some waves, as outlines of maps and letters are.
fn walk(n: usize, random: &mut Random) -> Vec<Point> {
    let waves: Vec<[f64; 3]> =
        (2..8).map(|k| [f64::from(k), random.between(0.0, 0.5 / f64::from(k)), TAU * random.unit()]).collect();
    let radius = |a: f64| 1.5 + waves.iter().map(|[k, size, phase]| size * (k * a + phase).sin()).sum::<f64>();
    let at = |i: usize| TAU * i as f64 / n as f64;
    (0..n).map(|i| polar(radius(at(i)) * random.between(0.9999, 1.0), at(i))).collect()
}

/// Teeth of different lengths above a base.
fn comb(n: usize, random: &mut Random) -> Vec<Point> {
    let mut points = vec![Point::new(0.0, 0.0), Point::new(n as f64, 0.0)];
    points.extend((2..n).map(|i| {
        let y = if i % 2 == 0 { random.between(5.0, 9.0) } else { random.between(1.0, 2.0) };
        Point::new((n - i) as f64, y)
    }));
    points
}

/// A spiral arm of some turns.
fn spiral(n: usize, random: &mut Random) -> Vec<Point> {
    let half = n / 2;
    let turns = (half as f64 / 12.0).clamp(0.4, 20.0);
    let arm = |i: usize, inner: f64| {
        let a = turns * TAU * i as f64 / half as f64;
        polar(1.0 + a / TAU - inner, a)
    };
    let mut points: Vec<Point> = (0..n - half).map(|i| arm(i, random.between(0.0, 0.1))).collect();
    points.extend((0..half).rev().map(|i| arm(i, 0.5)));
    points
}

/// Horizontal and vertical sides, as buildings have.
fn stairs(n: usize, random: &mut Random) -> Vec<Point> {
    let mut points = vec![Point::new(0.0, 5.0)];
    for i in 0..n / 2 - 1 {
        let height = -(10.0 * random.unit()).floor();
        points.extend([i, i + 1].map(|x| Point::new(x as f64, height)));
    }
    points.push(Point::new((n / 2 - 1) as f64, 5.0));
    points
}

fn polar(radius: f64, angle: f64) -> Point {
    Point::new(radius * angle.cos(), radius * angle.sin())
}
