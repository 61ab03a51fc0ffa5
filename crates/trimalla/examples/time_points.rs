//! Times both Delaunay algorithms on evenly spread points: `time_points [N]`.
#![allow(clippy::print_stdout, reason = "an example prints")]
use std::time::Instant;
use trimalla::delaunay::AlgorithmKey;
use trimalla::geometry::Point;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let n = std::env::args().nth(1).map_or(Ok(1_000_000), |s| s.parse())?;
    let mut state = 1u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 33) as u32) / f64::from(1u32 << 31)
    };
    let points: Vec<Point> = (0..n).map(|_| Point::new(unit(), unit())).collect();
    for algorithm in AlgorithmKey::ALL {
        let start = Instant::now();
        let t = algorithm.triangulate(&points, None)?;
        let seconds = start.elapsed().as_secs_f64();
        println!("{algorithm}: {} triangles in {seconds:.3} s", t.face_count());
    }
    Ok(())
}
