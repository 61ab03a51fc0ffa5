//! How the time of each algorithm of the textbook grows, beside what theory says.
//!
//! `cargo run --release --bin growth [SECONDS] [KEY...]`: sizes from 100 on, each √10 of the one before, up to a million,
//! as long as a run takes no more than so many seconds (10 unless said otherwise). Points are evenly spread in a square,
//! with heights; polygons are stars with noisy radii. A time is the least of up to five runs, in seconds of the
//! processor. The slope is that of the last two sizes but one to the last, on logarithmic axes: 1 is linear.

use std::f64::consts::TAU;
use std::hint::black_box;

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla::optimal::{OptimalInput, OptimalMethod};
use trimalla::polygon::Polygon;
use trimalla::trace::NoTrace;
use trimalla::{DomainOptions, Method, triangulate};
use trimalla_bench::random::Random;
use trimalla_bench::{Outcome, cpu_seconds};

fn main() -> Outcome<()> {
    let mut words = std::env::args().skip(1).peekable();
    let limit: f64 = words.next_if(|word| word.parse::<f64>().is_ok()).map_or(Ok(10.0), |word| word.parse())?;
    let chosen: Vec<String> = words.collect();
    println!("| algorithm | theory | sizes | seconds | slope |\n|---|---|---|---|---:|");
    for method in Method::all().filter(|method| *method != Method::Conforming) {
        if chosen.is_empty() || chosen.iter().any(|key| key == method.key()) {
            println!("{}", row(method, limit)?);
        }
    }
    Ok(())
}

/// A row of the table.
fn row(method: Method, limit: f64) -> Outcome<String> {
    let mut runs: Vec<(usize, f64)> = Vec::new();
    for half in 4..=12 {
        let n = 10_f64.powf(f64::from(half) / 2.0).round() as usize;
        let time = least_time(method, n)?;
        runs.push((n, time));
        // The next size takes ten times as long where the time is quadratic.
        if 10.0 * time > limit {
            break;
        }
    }
    let slope = match runs[..] {
        [.., (n, t), _, (m, u)] => format!("{:.2}", (u / t).ln() / (m as f64 / n as f64).ln()),
        _ => "–".to_owned(),
    };
    let list = |of: &dyn Fn(&(usize, f64)) -> String| runs.iter().map(of).collect::<Vec<_>>().join(", ");
    let (sizes, times) = (list(&|run| run.0.to_string()), list(&|run| format!("{:.2e}", run.1)));
    Ok(format!("| `{}` | {} | {sizes} | {times} | {slope} |", method.key(), theory(method)))
}

/// What theory says, for inputs like these.
fn theory(method: Method) -> &'static str {
    match method.key() {
        "incremental" | "divide-and-conquer" | "lift" | "voronoi" | "monotone" => "n log n",
        "constrained-delaunay" | "greedy" => "n log n expected",
        "seidel" | "art-gallery" => "n log* n expected",
        "flip" | "ears" | "min-max-length" => "n² at worst",
        "min-max-angle" | "max-min-height" => "n² log n at worst",
        "pairs" | "diagonals" | "visible-pairs" | "greedy-naive" | "min-weight-polygon" => "n³",
        "min-max-slope" | "min-max-length-by-tree" => "n³ at worst",
        "min-weight" => "exponential at worst",
        _ => "n² flips at worst",
    }
}

fn least_time(method: Method, n: usize) -> Outcome<f64> {
    let mut least = f64::INFINITY;
    let mut random = Random(n as u64);
    let points: Vec<Point> = (0..n).map(|_| Point::new(random.unit(), random.unit())).collect();
    let heights: Vec<f64> = points.iter().map(|p| (9.0 * p.x).sin() * (7.0 * p.y).cos()).collect();
    let star = star(n, &mut random);
    let domain = (method == Method::Optimal(OptimalMethod::MinWeightPolygon)).then(|| domain(&star)).transpose()?;
    for _ in 0..5 {
        let begun = cpu_seconds();
        match method {
            Method::Delaunay(algorithm) => drop(black_box(algorithm.triangulate(&points, None)?)),
            Method::Optimal(method) => {
                let points = domain.as_ref().map_or(&points, |domain| &domain.points);
                let input = OptimalInput { points, heights: Some(&heights), domain: domain.as_ref() };
                drop(black_box(method.triangulate(&input, &mut NoTrace)?));
            }
            Method::Polygon(method) => {
                let ends = [n as u32];
                drop(black_box(method.triangulate(Polygon::new(&star, &ends)?, &mut NoTrace)?));
            }
            _ => {}
        }
        let time = cpu_seconds() - begun;
        least = least.min(time);
        if time > 1.0 {
            break;
        }
    }
    Ok(least)
}

/// A star-shaped polygon.
fn star(n: usize, random: &mut Random) -> Vec<Point> {
    let at = |i: usize, radius: f64| {
        let angle = TAU * i as f64 / n as f64;
        Point::new(radius * angle.cos(), radius * angle.sin())
    };
    (0..n).map(|i| at(i, random.between(0.5, 1.0))).collect()
}

fn domain(star: &[Point]) -> Outcome<IndexedMesh> {
    Ok(triangulate(&Pslg::of_ring(star.iter().copied()), &DomainOptions::default())?.mesh)
}
