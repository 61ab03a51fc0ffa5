//! What the benchmark programs share: workloads, point files, clocks.
//!
//! A point file is an 8-byte count, then x and y of each point, little endian.

use std::error::Error;
use std::fs::File;
use std::io::{BufReader, BufWriter, Read, Write};
use std::path::Path;
use std::time::Instant;

use rustix::time::{ClockId, clock_gettime};
use trimalla::geometry::Point;

/// Anything that may go wrong on the way.
pub type Outcome<T> = Result<T, Box<dyn Error>>;

/// The names of the workloads, the one of the headline first.
pub const WORKLOADS: [&str; 6] = ["uniform", "clustered", "grid", "grid0.1", "circle", "line"];

/// About `n` points of a workload, the same ones every time.
pub fn workload(name: &str, n: usize) -> Outcome<Vec<Point>> {
    let mut random = Random(11);
    let side = (n as f64).sqrt().round() as usize;
    let on_grid = |step: f64| {
        let cell = move |i: usize| Point::new((i % side) as f64 * step, (i / side) as f64 * step);
        (0..side * side).map(cell).collect()
    };
    Ok(match name {
        "uniform" => (0..n).map(|_| Point::new(random.unit(), random.unit())).collect(),
        "clustered" => clustered(n, &mut random),
        "grid" => on_grid(1.0),
        "grid0.1" => on_grid(0.1),
        "circle" => (0..n).map(|_| std::f64::consts::TAU * random.unit()).map(|a| Point::new(a.cos(), a.sin())).collect(),
        "line" => (0..n).map(|_| random.unit()).map(|x| Point::new(x, x / 3.0)).collect(),
        _ => return Err(format!("no workload is called '{name}': there are {WORKLOADS:?}").into()),
    })
}

/// A thousand Gaussian clusters, their widths spread from 1e-4 to 1e-2, points in no order.
fn clustered(n: usize, random: &mut Random) -> Vec<Point> {
    let clusters: Vec<(Point, f64)> =
        (0..1000).map(|_| (Point::new(random.unit(), random.unit()), 10f64.powf(-4.0 + 2.0 * random.unit()))).collect();
    (0..n)
        .map(|_| {
            let (centre, width) = clusters[(random.unit() * 1000.0) as usize];
            let (radius, angle) = ((-2.0 * (1.0 - random.unit()).ln()).sqrt() * width, std::f64::consts::TAU * random.unit());
            Point::new(centre.x + radius * angle.cos(), centre.y + radius * angle.sin())
        })
        .collect()
}

/// The generator `SplitMix64`.
struct Random(u64);

impl Random {
    /// Evenly spread in [0, 1).
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Writes a point file.
pub fn write_points(path: &Path, points: &[Point]) -> Outcome<()> {
    let mut file = BufWriter::new(File::create(path)?);
    file.write_all(&(points.len() as u64).to_le_bytes())?;
    for p in points {
        file.write_all(&p.x.to_le_bytes())?;
        file.write_all(&p.y.to_le_bytes())?;
    }
    Ok(file.flush()?)
}

/// Reads a point file; takes no memory but the points'.
pub fn read_points(path: &Path) -> Outcome<Vec<Point>> {
    let mut file = BufReader::new(File::open(path)?);
    let mut number = || -> Outcome<[u8; 8]> {
        let mut bytes = [0; 8];
        file.read_exact(&mut bytes)?;
        Ok(bytes)
    };
    let n = u64::from_le_bytes(number()?);
    let mut points = Vec::with_capacity(usize::try_from(n)?);
    for _ in 0..n {
        points.push(Point::new(f64::from_le_bytes(number()?), f64::from_le_bytes(number()?)));
    }
    Ok(points)
}

/// One measured call, as the drivers print it and the comparison reads it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measured {
    /// Seconds that passed.
    pub wall: f64,
    /// Seconds of processor time.
    pub cpu: f64,
    /// Vertices of the result.
    pub vertices: usize,
    /// Triangles of the result.
    pub triangles: usize,
    /// Largest resident memory during the call beyond that before it, in bytes.
    pub bytes: usize,
}

/// Runs a call and measures everything but what it made.
pub fn measure<T>(call: impl FnOnce() -> T) -> Outcome<(T, Measured)> {
    let (before, wall, cpu) = (peak_bytes()?, Instant::now(), cpu_seconds());
    let result = call();
    let (cpu, wall) = (cpu_seconds() - cpu, wall.elapsed().as_secs_f64());
    let bytes = peak_bytes()? - before;
    Ok((result, Measured { wall, cpu, bytes, ..Measured::default() }))
}

fn cpu_seconds() -> f64 {
    let t = clock_gettime(ClockId::ProcessCPUTime);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}

/// The peak of this process's resident memory.
fn peak_bytes() -> Outcome<usize> {
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:")).ok_or("no VmHWM in /proc/self/status")?;
    Ok(1024 * line.trim().trim_end_matches(" kB").parse::<usize>()?)
}
