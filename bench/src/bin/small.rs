//! Many small sets: points beside `delaunator`, and constrained triangulations of polygons beside `spade`.
//!
//! `cargo run --release --bin small [ROUNDS]` prints the time of both for a set (the median of the rounds, which alternate
//! between the two) and their ratio.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};
use trimalla::geometry::Point;
use trimalla::{delaunay, polygon};
use trimalla_bench::Outcome;
use trimalla_bench::random::Random;

const SIZES: [usize; 6] = [4, 10, 30, 100, 1000, 10_000];
/// How many points all sets of a row have together.
const POINTS: usize = 100_000;

fn main() -> Outcome<()> {
    let rounds = std::env::args().nth(1).map_or(Ok(9), |r| r.parse())?;
    println!("{:<28}{:>8}{:>14}{:>14}{:>8}", "", "size", "ours, ns", "theirs, ns", "ratio");
    for n in SIZES {
        let mut random = Random(n as u64);
        let sets = |make: &dyn Fn(&mut Random) -> Vec<Point>, random: &mut Random| -> Vec<Vec<Point>> {
            (0..(POINTS / n).max(1)).map(|_| make(random)).collect()
        };
        let clouds = sets(&|random| (0..n).map(|_| Point::new(random.unit(), random.unit())).collect(), &mut random);
        let mut ours = delaunay::Triangulator::new();
        let theirs: Vec<Vec<delaunator::Point>> =
            clouds.iter().map(|cloud| cloud.iter().map(|p| delaunator::Point { x: p.x, y: p.y }).collect()).collect();
        let ratio = race(
            rounds,
            || clouds.iter().map(|cloud| ours.triangulate(cloud).map_or(0, <[_]>::len)).sum(),
            || theirs.iter().map(|cloud| delaunator::triangulate(cloud).len()).sum(),
        );
        print_row("points, delaunator", n, clouds.len(), ratio);
        let stars = sets(&|random| star(n, random), &mut random);
        let mut ours = polygon::Triangulator::new();
        let ratio = race(
            rounds,
            || stars.iter().map(|star| constrained(&mut ours, star)).sum(),
            || stars.iter().map(|star| by_spade(star)).sum(),
        );
        print_row("polygons, spade", n, stars.len(), ratio);
    }
    Ok(())
}

fn print_row(name: &str, n: usize, sets: usize, [ours, theirs]: [f64; 2]) {
    let sets = sets as f64;
    println!("{name:<28}{n:>8}{:>14.0}{:>14.0}{:>8.2}", ours / sets, theirs / sets, ours / theirs);
}

/// The median times of two calls, in nanoseconds.
fn race(rounds: usize, mut ours: impl FnMut() -> usize, mut theirs: impl FnMut() -> usize) -> [f64; 2] {
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..rounds {
        for (call, times) in [&mut ours as &mut dyn FnMut() -> usize, &mut theirs].into_iter().zip(&mut times) {
            let begun = Instant::now();
            black_box(call());
            times.push(begun.elapsed().as_nanos() as f64);
        }
    }
    times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    })
}

fn star(n: usize, random: &mut Random) -> Vec<Point> {
    let at = |i: usize, radius: f64| {
        let angle = TAU * i as f64 / n as f64;
        Point::new(radius * angle.cos(), radius * angle.sin())
    };
    (0..n).map(|i| at(i, random.between(0.3, 1.0))).collect()
}

/// How many triangles there are; none of a polygon that is refused.
fn constrained(ours: &mut polygon::Triangulator, star: &[Point]) -> usize {
    let ends = [star.len() as u32];
    let polygon = polygon::Polygon::new(star, &ends);
    polygon.and_then(|polygon| ours.triangulate_delaunay(polygon).map(<[_]>::len)).unwrap_or(0)
}

fn by_spade(star: &[Point]) -> usize {
    let points = star.iter().map(|p| Point2::new(p.x, p.y)).collect();
    let n = star.len();
    let sides = (0..n).map(|i| [i, (i + 1) % n]).collect();
    ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, sides).map_or(0, |t| t.num_inner_faces())
}
