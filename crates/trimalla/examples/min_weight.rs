//! How long a triangulation of least weight takes: uniform points, or a grid.
//!
//! Run it with `cargo run --release -p trimalla --example min_weight -- 10000 1`, or with `grid` in place of the seed.
#![allow(clippy::print_stdout, reason = "an example prints")]

use std::time::Instant;

use trimalla::geometry::Point;
use trimalla::optimal::{OptimalError, OptimalInput, WeightBudget, minimum_weight};
use trimalla::trace::NoTrace;

fn main() -> Result<(), OptimalError> {
    let mut arguments = std::env::args().skip(1);
    let count = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(10_000);
    let kind = arguments.next().unwrap_or_else(|| "1".to_owned());
    let points = points(count, &kind);
    let begin = Instant::now();
    let found = minimum_weight(&OptimalInput::of_points(&points), WeightBudget::default(), &mut NoTrace)?;
    println!("{} points, {kind}: {:.2} s", points.len(), begin.elapsed().as_secs_f64());
    println!("candidate edges {}, possible {}, skeleton {}", found.candidates, found.possible, found.skeleton.len());
    println!(
        "faces {}, with components inside {}, size of the largest {}",
        found.faces, found.faces_with_components, found.largest_face
    );
    let optimal = found.optimal;
    println!("triangles {}, weight {:.12}, proved {}", optimal.triangles.len(), optimal.value, optimal.is_proved);
    Ok(())
}

/// Points of a kind: a seed of uniform ones, `grid`, or `circle`.
fn points(count: usize, kind: &str) -> Vec<Point> {
    match kind {
        "grid" => {
            let side = (count as f64).sqrt() as usize;
            (0..side * side).map(|i| Point::new((i % side) as f64, (i / side) as f64)).collect()
        }
        "circle" => {
            let angle = |i: usize| std::f64::consts::TAU * i as f64 / count as f64;
            let on_circle = |a: f64| Point::new(trimalla::geometry::math::cos(a), trimalla::geometry::math::sin(a));
            (0..count).map(|i| on_circle(angle(i))).collect()
        }
        seed => {
            let mut state = seed.parse().unwrap_or(1_u64);
            let mut unit = || {
                state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
                let mut z = state;
                z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
                z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
                ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
            };
            (0..count).map(|_| Point::new(unit(), unit())).collect()
        }
    }
}
