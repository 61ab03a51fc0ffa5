//! Jobs: which program gets which input, and how it is called.

use std::path::{Path, PathBuf};

/// The task of a program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Task {
    /// The Delaunay triangulation of the points.
    Points,
    /// The constrained Delaunay triangulation, outside kept.
    Constrained,
    /// The triangles inside a polygon.
    Polygon,
    /// A mesh. Degrees, largest area (0: none), and the edge length that gives CGAL's mesher about as many triangles.
    Refine(f64, f64, f64),
}

impl Task {
    /// Its key, as drivers know it.
    pub fn key(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Constrained => "constrained",
            Self::Polygon => "polygon",
            Self::Refine(..) => "refine",
        }
    }
}

/// One input and its task.
#[derive(Clone, Debug)]
pub struct Job {
    /// Its name in the report.
    pub name: String,
    /// The heading under which it is reported.
    pub family: &'static str,
    /// The name of the input.
    pub input: String,
    /// The task.
    pub task: Task,
}

/// The headings, in the order of the report.
pub const FAMILIES: [&str; 5] = ["points", "constrained", "channel", "polygons", "refinement"];

/// Every job of the standard report.
pub fn standard() -> Vec<Job> {
    let points = ["u10k", "u100k", "u1m", "u10m", "clus1m", "kuz1m", "grid1m", "grid0.1-1m", "circ100k", "line100k"];
    let mut jobs: Vec<Job> = points.map(|p| job("points", p, Task::Points)).into();
    jobs.extend(["w5a", "w5b", "w5c"].map(|p| job("constrained", p, Task::Constrained)));
    jobs.extend(["channel1k", "channel10k", "channel100k", "channel1m"].map(|p| job("channel", p, Task::Constrained)));
    jobs.extend(["poly10k", "poly100k"].map(|p| job("polygons", p, Task::Polygon)));
    jobs.push(refine("A", 30.0, 1.3e-7, 0.00065));
    for input in ["w6b", "w6bs"] {
        jobs.extend([20.0, 25.0, 30.0, 33.0].map(|angle| refine(input, angle, 0.0, 0.0)));
    }
    jobs.push(refine("w6c", 0.0, 7.5e-7, 0.0015));
    jobs
}

/// A job outside the standard report: the name of an input alone, or with an angle as in `w6b-10k:30`.
pub fn other(name: &str) -> Option<Job> {
    if let Some((input, angle)) = name.split_once(':') {
        return Some(refine(input, angle.parse().ok()?, 0.0, 0.0));
    }
    let starts = |kinds: &[&str]| kinds.iter().any(|k| name.starts_with(k));
    Some(match () {
        () if starts(&["w5"]) => job("constrained", name, Task::Constrained),
        () if starts(&["channel"]) => job("channel", name, Task::Constrained),
        () if starts(&["poly"]) => job("polygons", name, Task::Polygon),
        () if starts(&["u", "clus", "kuz", "grid", "circ", "line"]) => job("points", name, Task::Points),
        () => return None,
    })
}

fn job(family: &'static str, input: &str, task: Task) -> Job {
    Job { name: input.into(), family, input: input.into(), task }
}

fn refine(input: &str, angle: f64, area: f64, size: f64) -> Job {
    let name = if angle > 0.0 { format!("{input}:{angle}") } else { format!("{input}:area") };
    Job { name, ..job("refinement", input, Task::Refine(angle, area, size)) }
}

/// A program that is measured.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// Its key, also the driver's first argument.
    pub key: &'static str,
    /// Its name in the report.
    pub title: &'static str,
    /// The driver's file name.
    driver: &'static str,
    /// The tasks that it gets: p, c, o, r for points, constrained, polygon, refine; `R` for `w6b:30` only, `a` for
    /// bounds on areas only.
    tasks: &'static str,
    /// Whether its counts decide what is right.
    pub exact: bool,
}

/// Every program.
pub const PROGRAMS: [Program; 13] = [
    program("trimalla", "trimalla", "ours", "pcor", true),
    program("trimalla-divide-and-conquer", "trimalla, divide and conquer", "ours", "p", true),
    program("trimalla-unfilled", "trimalla, no lattice", "ours", "a", true),
    program("trimalla-circumcenter", "trimalla, circumcenters", "ours", "R", true),
    program("trimalla-lepp-centroid", "trimalla, LEPP centroids", "ours", "R", true),
    program("triangle", "Triangle 1.6", "triangle", "pcor", true),
    program("cgal", "CGAL", "cgal", "pcor", true),
    program("spade", "spade", "peers", "pcor", false),
    program("delaunator", "delaunator", "peers", "p", false),
    program("cdt", "cdt", "peers", "pco", false),
    program("earcut", "earcut", "peers", "o", false),
    program("i_triangle", "i_triangle", "peers", "o", false),
    program("i_triangle-delaunay", "i_triangle, Delaunay", "peers", "o", false),
];

const fn program(
    key: &'static str,
    title: &'static str,
    driver: &'static str,
    tasks: &'static str,
    exact: bool,
) -> Program {
    Program { key, title, driver, tasks, exact }
}

impl Program {
    /// Whether it is trimalla, in any form.
    pub fn is_ours(&self) -> bool {
        self.driver == "ours"
    }

    /// Whether it answers a constrained task with the inside of the segments, so that its counts are not comparable.
    pub fn inside_only(&self, task: Task) -> bool {
        self.key == "cdt" && task == Task::Constrained
    }

    /// Whether it gets a job.
    pub fn does(&self, job: &Job) -> bool {
        match job.task {
            Task::Points => self.tasks.contains('p'),
            Task::Constrained => self.tasks.contains('c'),
            Task::Polygon => self.tasks.contains('o'),
            Task::Refine(_, area, _) => {
                self.tasks.contains('r')
                    || (self.tasks.contains('a') && area > 0.0)
                    || (self.tasks.contains('R') && job.input.starts_with("w6b") && job.name.ends_with(":30"))
            }
        }
    }

    /// Where its driver lies, if it could be built.
    pub fn driver(&self, binaries: &Path) -> Option<PathBuf> {
        let path = binaries.join(self.driver);
        path.exists().then_some(path)
    }

    /// The driver's arguments.
    pub fn arguments(&self, job: &Job, inputs: &Path) -> Vec<String> {
        let (angle, area, size) = match job.task {
            Task::Refine(angle, area, size) => (angle, area, size),
            _ => (0.0, 0.0, 0.0),
        };
        let file = inputs.join(&job.input).display().to_string();
        vec![self.key.into(), job.task.key().into(), file, angle.to_string(), format!("{area:.12}"), size.to_string()]
    }
}
