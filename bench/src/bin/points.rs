//! Makes point files, and times one triangulation of one.
//!
//! `points make WORKLOAD N FILE`, `points time FILE [ALGORITHM]`

use std::path::Path;

use trimalla::delaunay::AlgorithmKey;
use trimalla_bench::{Measured, Outcome, measure, read_points, workload, write_points};

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["make", name, n, file] => write_points(Path::new(file), &workload(name, n.parse()?)?),
        ["time", file] => time(Path::new(file), AlgorithmKey::default()),
        ["time", file, algorithm] => time(Path::new(file), algorithm.parse()?),
        _ => Err("usage: points make WORKLOAD N FILE | points time FILE [ALGORITHM]".into()),
    }
}

/// The library call alone: points in memory in the caller's order, one cold call.
fn time(file: &Path, algorithm: AlgorithmKey) -> Outcome<()> {
    let points = read_points(file)?;
    let (t, measured) = measure(|| algorithm.triangulate(&points, None))?;
    let t = t?;
    let Measured { wall, cpu, bytes, .. } = measured;
    println!("{wall} {cpu} {} {} {bytes}", t.used_vertices().count(), t.face_count());
    Ok(())
}
