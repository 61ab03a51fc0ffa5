//! What it costs to be able to go back: memory of the records, time of a run with and without them, time of going back.
//!
//! `cargo run --release -p trimalla --example history_cost`, with a number of triangles after it (a million by default)
#![allow(clippy::print_stdout, reason = "an example talks")]

use std::time::Instant;

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::refine::{Fill, NoObserver, RefineOptions, Refinement};

/// A unit square with points spread without a pattern: multiples of two irrational numbers, their whole parts away.
fn drawing(points: u32) -> Pslg {
    let mut square = Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let spread = |i: u32, step: f64| 0.001 + 0.998 * (f64::from(i) * step).fract();
    let at = |i: u32| Point::new(spread(i, 0.754_877_666_246_692_8), spread(i, 0.618_033_988_749_895));
    square.points.extend((1..points).map(at));
    square
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let triangles: u32 = std::env::args().nth(1).map_or(Ok(1_000_000), |arg| arg.parse())?;
    // Half as many vertices as triangles; four in five of them are Steiner points.
    let drawing = drawing(triangles / 10);
    let mut options = RefineOptions::default().with_max_area(1.3 / f64::from(triangles));
    options.recipe.fill = Fill::None; // A lattice goes in node by node, which says little of steps.
    let begin = || -> Result<Refinement, Box<dyn std::error::Error>> {
        let (cdt, _) = build(&drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
        Ok(Refinement::new(cdt, options)?)
    };

    let mut plain = begin()?;
    let start = Instant::now();
    plain.run(&mut NoObserver);
    let plain_time = start.elapsed().as_secs_f64();

    let mut recorded = begin()?;
    recorded.keep_history(usize::MAX);
    let start = Instant::now();
    recorded.run(&mut NoObserver);
    let recorded_time = start.elapsed().as_secs_f64();
    let (steps, bytes) = (recorded.steps_made(), recorded.history_bytes());
    println!("triangles                  {}", recorded.overview().triangles);
    println!("steps                      {steps}");
    println!("bytes of records           {bytes}, {} a step", bytes as u64 / steps);
    println!("run, seconds               {plain_time:.3}, with records {recorded_time:.3}");

    let start = Instant::now();
    for _ in 0..1000 {
        recorded.back();
    }
    println!("back, microseconds         {:.2} a step, over the last thousand", 1e3 * start.elapsed().as_secs_f64());
    let start = Instant::now();
    let mut left: u64 = 0;
    while recorded.back() {
        left += 1;
    }
    println!("back to the start, seconds {:.3} for {left} steps", start.elapsed().as_secs_f64());
    Ok(())
}
