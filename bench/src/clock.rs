//! Time and memory of one call.

use std::error::Error;
use std::fmt;
use std::time::Instant;

use rustix::time::{ClockId, clock_gettime};

/// A result whose error may be of any type.
pub type Outcome<T> = Result<T, Box<dyn Error>>;

/// One measured call, as every driver prints it and the comparison reads it.
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

impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {} {} {}", self.wall, self.cpu, self.vertices, self.triangles, self.bytes)
    }
}

/// Runs a call and measures time and memory; the caller adds the size of the result.
pub fn measure<T>(call: impl FnOnce() -> T) -> Outcome<(T, Measured)> {
    let (before, wall, cpu) = (peak_bytes()?, Instant::now(), cpu_seconds());
    let result = call();
    let (cpu, wall) = (cpu_seconds() - cpu, wall.elapsed().as_secs_f64());
    let bytes = peak_bytes()? - before;
    Ok((result, Measured { wall, cpu, bytes, ..Measured::default() }))
}

/// Processor time of this process so far.
pub fn cpu_seconds() -> f64 {
    let t = clock_gettime(ClockId::ProcessCPUTime);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}

/// The peak of this process's resident memory.
fn peak_bytes() -> Outcome<usize> {
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:")).ok_or("no VmHWM in /proc/self/status")?;
    Ok(1024 * line.trim().trim_end_matches(" kB").parse::<usize>()?)
}
