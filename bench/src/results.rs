//! The results of a job: the runs of each program, and which results are correct.

use crate::Measured;
use crate::jobs::{Job, Program, Task};

/// The runs of one program on one job.
#[derive(Clone, Debug)]
pub struct Runs {
    /// The program.
    pub program: Program,
    /// Its measurements.
    pub runs: Vec<Measured>,
    /// Why it did not run to the end.
    pub failure: Option<String>,
}

/// The verdict on a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The counts of the exact programs.
    Right,
    /// Another number of vertices or triangles than most exact programs.
    Wrong,
    /// Another task, not comparable.
    Other,
    /// No result.
    Failed,
}

/// All that was measured on one job.
#[derive(Clone, Debug)]
pub struct Results {
    /// The job.
    pub job: Job,
    /// Vertices of the input.
    pub points: usize,
    /// By program.
    pub all: Vec<Runs>,
}

impl Runs {
    /// The median of a quantity.
    pub fn median(&self, value: impl Fn(&Measured) -> f64) -> Option<f64> {
        let mut values: Vec<f64> = self.runs.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied()
    }

    /// Median, least and greatest processor seconds.
    pub fn cpu(&self) -> Option<[f64; 3]> {
        let all = || self.runs.iter().map(|m| m.cpu);
        Some([self.median(|m| m.cpu)?, all().reduce(f64::min)?, all().reduce(f64::max)?])
    }

    fn counts(&self) -> Option<(usize, usize)> {
        self.runs.first().map(|m| (m.vertices, m.triangles))
    }
}

impl Results {
    /// The counts on which most exact programs agree. Meshes are not comparable by count.
    fn agreed(&self) -> Option<(usize, usize)> {
        if matches!(self.job.task, Task::Refine(..)) {
            return None;
        }
        let exact: Vec<_> = self.all.iter().filter(|r| r.program.exact).filter_map(Runs::counts).collect();
        let votes = |c: &(usize, usize)| exact.iter().filter(|&e| e == c).count();
        exact.iter().copied().max_by_key(votes)
    }

    /// The verdict on the result of a program.
    pub fn verdict(&self, runs: &Runs) -> Verdict {
        match (runs.counts(), self.agreed()) {
            _ if runs.failure.is_some() => Verdict::Failed,
            (None, _) => Verdict::Failed,
            (Some(_), _) if runs.program.inside_only(self.job.task) => Verdict::Other,
            (Some(counts), Some(agreed)) if counts != agreed => Verdict::Wrong,
            (Some((vertices, triangles)), None) if vertices < self.points || triangles == 0 => Verdict::Wrong,
            _ => Verdict::Right,
        }
    }

    /// The fastest peer with a correct result.
    pub fn best_peer(&self) -> Option<&Runs> {
        let right = |r: &&Runs| !r.program.is_ours() && self.verdict(r) == Verdict::Right;
        let cpu = |r: &Runs| r.median(|m| m.cpu).unwrap_or(f64::INFINITY);
        self.all.iter().filter(right).min_by(|a, b| cpu(a).total_cmp(&cpu(b)))
    }

    /// The runs of a program.
    pub fn of(&self, key: &str) -> Option<&Runs> {
        self.all.iter().find(|r| r.program.key == key)
    }

    /// The median of one program over that of another.
    pub fn ratio(&self, key: &str, peer: &str, value: impl Fn(&Measured) -> f64) -> Option<f64> {
        Some(self.of(key)?.median(&value)? / self.of(peer)?.median(&value)?)
    }
}
