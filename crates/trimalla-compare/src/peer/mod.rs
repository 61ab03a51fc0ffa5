//! Programs of others that are run beside our recipes: Triangle, through its Python package.
//!
//! Triangle is not free software, and it may crash or not end. So it is never linked: each run is a process of its own,
//! `python3` with the script `triangle.py`, which is killed at the time limit. Its mesh is then surveyed by the library
//! as one of ours would be, by the same test for bad triangles and for what the drawing's own angles force.

mod process;

use std::process::Command;
use std::time::Duration;

use serde_json::{Value, json};
use trimalla::domain::DomainRule;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla::refine::{Fill, Insert, Prepare, Progress, Recipe, RefineOptions, Report, Select};
use trimalla::{DomainOptions, refine_mesh_with};

use self::process::Ended;
use crate::outcome::{End, Outcome};

const SCRIPT: &str = include_str!("triangle.py");

/// How long the search for a package may take.
const SEARCH: Duration = Duration::from_secs(30);

/// Triangle, where its Python package is installed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Peer {
    version: String,
}

/// Why there is no such program to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoPeer {
    /// `python3` cannot be started.
    #[error("python3 cannot be started")]
    NoPython,
    /// It has no package `triangle`.
    #[error("python3 has no package 'triangle' (pip install triangle)")]
    NoPackage,
}

/// The input of one run.
pub(crate) struct Question<'a> {
    pub(crate) pslg: &'a Pslg,
    pub(crate) domain: &'a DomainOptions,
    pub(crate) angle_deg: f64,
    pub(crate) max_vertices: usize,
    /// Seconds from the start of the process.
    pub(crate) limit: Duration,
}

/// What the script answers.
struct Answer {
    seconds: f64,
    vertices: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
    segments: Vec<[u32; 2]>,
}

impl Answer {
    fn of_text(text: &[u8]) -> serde_json::Result<Self> {
        let mut object: Value = serde_json::from_slice(text)?;
        let mut column = |key: &str| object.get_mut(key).map(Value::take).unwrap_or_default();
        let segments = match column("segments") {
            Value::Null => Vec::new(),
            segments => serde_json::from_value(segments)?,
        };
        Ok(Self {
            seconds: serde_json::from_value(column("seconds"))?,
            vertices: serde_json::from_value(column("vertices"))?,
            triangles: serde_json::from_value(column("triangles"))?,
            segments,
        })
    }
}

impl Peer {
    /// Looks for Triangle.
    ///
    /// # Errors
    /// [`NoPeer`] says what is missing.
    pub fn triangle() -> Result<Self, NoPeer> {
        match process::run(python(&[]), "", SEARCH, &|| false) {
            Ok(Ended::Answered(version)) => Ok(Self { version: String::from_utf8_lossy(&version).trim().to_owned() }),
            Ok(_) => Err(NoPeer::NoPackage),
            Err(_) => Err(NoPeer::NoPython),
        }
    }

    /// The version of the Python package.
    #[must_use]
    pub fn version(&self) -> &str {
        &self.version
    }

    /// Whether it knows a rule for what belongs to the domain: it cannot nest rings.
    #[must_use]
    pub fn knows(rule: DomainRule) -> bool {
        rule != DomainRule::Nesting
    }
}

fn python(args: &[&str]) -> Command {
    let mut command = Command::new("python3");
    command.arg("-c").arg(SCRIPT).args(args);
    command
}

fn without_mesh(end: End) -> Outcome {
    Outcome::of(&Report::default(), 0.0).ended(end)
}

impl Question<'_> {
    /// Has Triangle mesh the drawing; none if the caller cancelled. The seconds of the outcome are those of the call in
    /// Python, without the start of the process.
    pub(crate) fn run(&self, is_cancelled: &dyn Fn() -> bool) -> Option<Outcome> {
        let command = python(&[&self.switches(), &self.limit.as_secs_f64().to_string()]);
        let ended = process::run(command, &self.text(), self.limit, is_cancelled);
        if is_cancelled() {
            return None;
        }
        Some(match ended {
            Ok(Ended::Answered(text)) => {
                Answer::of_text(&text).map_or_else(|_| without_mesh(End::Crashed), |answer| self.outcome(answer))
            }
            Ok(Ended::Failed) | Err(_) => without_mesh(End::Crashed),
            Ok(Ended::Killed) => without_mesh(End::Time),
        })
    }

    /// Triangle's switches: `p` reads segments, `c` keeps the convex hull, `q` bounds angles, `a` heeds the areas of
    /// regions, `S` is the largest number of Steiner points, `Q` is silence.
    fn switches(&self) -> String {
        let Self { pslg, domain, angle_deg, max_vertices, .. } = self;
        let mut switches = String::new();
        if !pslg.segments.is_empty() {
            switches += if domain.rule == DomainRule::Hull { "pc" } else { "p" };
            switches += if self.bounds_areas() { "a" } else { "" };
        }
        let room = max_vertices.saturating_sub(pslg.points.len());
        switches + &format!("q{angle_deg}S{room}Q")
    }

    fn bounds_areas(&self) -> bool {
        self.pslg.regions.iter().any(|region| region.max_area.is_some())
    }

    /// The drawing as the package wants it. Columns that are empty are left out: it refuses them.
    fn text(&self) -> String {
        let pair = |p: &Point| [p.x, p.y];
        let points = |points: &[Point]| points.iter().map(pair).collect::<Vec<_>>();
        let mut drawing = json!({ "vertices": points(&self.pslg.points) });
        if !self.pslg.segments.is_empty() {
            drawing["segments"] = json!(self.pslg.segments);
            if !self.pslg.holes.is_empty() {
                drawing["holes"] = json!(points(&self.pslg.holes));
            }
            if self.bounds_areas() {
                let row = |region: &trimalla::drawing::Region| {
                    json!([region.seed.x, region.seed.y, region.attribute, region.max_area.unwrap_or(-1.0)])
                };
                drawing["regions"] = json!(self.pslg.regions.iter().map(row).collect::<Vec<_>>());
            }
        }
        drawing.to_string()
    }

    /// The outcome of an answer. The library surveys the mesh and changes nothing: which triangles are below the bound,
    /// and which of them the angles between the subsegments force.
    fn outcome(&self, answer: Answer) -> Outcome {
        let points: Vec<Point> = answer.vertices.into_iter().map(Point::from).collect();
        let is_full = points.len() >= self.max_vertices;
        let mesh = IndexedMesh {
            triangles: answer.triangles,
            segments: answer.segments,
            input_points: self.pslg.points.len().min(points.len()),
            points,
            ..IndexedMesh::default()
        };
        let Ok(surveyed) = refine_mesh_with(&mesh, &[], None, &self.survey(), &mut |_: Progress| false) else {
            return without_mesh(End::Invalid);
        };
        let mut outcome = Outcome::of(&surveyed.report, answer.seconds);
        (outcome.vertices, outcome.triangles) = (mesh.points.len(), mesh.triangles.len());
        outcome.steiner_points = mesh.points.len() - mesh.input_points;
        let is_forced = surveyed.report.leftovers.iter().all(|leftover| leftover.reason.is_forced());
        outcome.ended(match (is_full, is_forced) {
            (true, false) => End::Budget,
            (true, true) if self.bounds_areas() => End::Budget,
            (false, false) => End::Below,
            (_, true) => End::Done,
        })
    }

    /// Options under which a refinement that is cancelled before its first step has changed nothing.
    fn survey(&self) -> RefineOptions {
        let recipe = Recipe {
            fill: Fill::None,
            prepare: Prepare::None,
            select: Select::Manual,
            insert: Insert::Partition,
            ..Recipe::default()
        };
        RefineOptions { recipe, ..RefineOptions::default() }.with_min_angle_deg(self.angle_deg)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is made of an answer with the points of a drawing, its segments, and these triangles.
    fn outcome_of(points: &[[f64; 2]], triangles: Vec<[u32; 3]>, angle_deg: f64) -> Outcome {
        let segments: Vec<[u32; 2]> =
            if points.len() == 3 { vec![[0, 1], [1, 2], [2, 0]] } else { vec![[0, 1], [1, 2], [2, 3], [3, 0]] };
        let pslg = Pslg {
            points: points.iter().copied().map(Point::from).collect(),
            segments: segments.clone(),
            ..Pslg::default()
        };
        let domain = DomainOptions::default();
        let question = Question { pslg: &pslg, domain: &domain, angle_deg, max_vertices: 99, limit: SEARCH };
        question.outcome(Answer { seconds: 1.0, vertices: points.to_vec(), triangles, segments })
    }

    #[test]
    fn meshes_of_others_are_surveyed_by_our_test() {
        let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.1]];
        let fan = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        let end = |last: [u32; 3], angle_deg: f64| outcome_of(&points, [&fan[..3], &[last]].concat(), angle_deg).end;
        assert_eq!(end([3, 0, 4], 11.0), End::Done);
        assert_eq!(end([3, 0, 4], 12.0), End::Below);
        assert_eq!(end([0, 3, 4], 11.0), End::Invalid, "clockwise");
        assert_eq!(end([3, 0, 9], 11.0), End::Invalid, "there is no vertex 9");
    }

    #[test]
    fn angles_that_the_drawing_forces_are_forced_for_others_too() {
        let outcome = outcome_of(&[[0.0, 0.0], [9.0, 0.0], [9.0, 1.0]], vec![[0, 1, 2]], 20.0);
        assert_eq!((outcome.end, outcome.below_bound, outcome.triangles), (End::Done, 1, 1));
    }
}
