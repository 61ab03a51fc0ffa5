//! The outcome of a run.

use std::fmt;

use serde_json::{Value, json};
use trimalla::refine::{Reason, Report, StepTimes, StopReason};

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Every triangle is good, but for those that the input forces.
    Done,
    /// The vertex budget was used up.
    Budget,
    /// The time was.
    Time,
    /// It ended by itself and left triangles below the bound, most of them for this reason.
    Left(Reason),
    /// A program of others left triangles below the bound.
    Below,
    /// A program of others made no valid mesh.
    Invalid,
    /// A program of others ended without a mesh.
    Crashed,
}

impl End {
    fn of(report: &Report) -> Self {
        match report.stop {
            StopReason::Budget => Self::Budget,
            StopReason::Cancelled => Self::Time,
            _ => {
                let unforced = report.reasons().into_iter().filter(|(reason, _)| !reason.is_forced());
                // Of equal counts the reason that is named first.
                let most = unforced.reduce(|most, next| if next.1 > most.1 { next } else { most });
                most.map_or(Self::Done, |(reason, _)| Self::Left(reason))
            }
        }
    }

    /// In words.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Budget => "budget",
            Self::Time => "time",
            Self::Left(reason) => reason.key(),
            Self::Below => "below the bound",
            Self::Invalid => "invalid mesh",
            Self::Crashed => "crashed",
        }
    }

    fn from_key(key: &str) -> Option<Self> {
        let ends = [Self::Done, Self::Budget, Self::Time, Self::Below, Self::Invalid, Self::Crashed].into_iter();
        ends.chain(Reason::ALL.map(Self::Left)).find(|end| end.key() == key)
    }
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}

/// The outcome of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// How it ended.
    pub end: End,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Vertices that are not the drawing's.
    pub steiner_points: usize,
    /// The smallest angle, in degrees.
    pub min_angle_deg: f64,
    /// The largest angle, in degrees.
    pub max_angle_deg: f64,
    /// Triangles below the bound, forced or not.
    pub below_bound: usize,
    /// What triangulation and refinement took.
    pub seconds: f64,
    /// What the steps took, where they were timed.
    pub step_times: Option<StepTimes>,
}

impl Outcome {
    pub(crate) fn of(report: &Report, seconds: f64) -> Self {
        Self {
            end: End::of(report),
            vertices: report.vertices,
            triangles: report.triangles,
            steiner_points: report.steiner_points,
            min_angle_deg: report.min_angle_deg,
            max_angle_deg: report.max_angle_deg,
            below_bound: report.leftovers.len(),
            seconds,
            step_times: report.step_times,
        }
    }

    /// Gives it another end.
    #[must_use]
    pub(crate) fn ended(self, end: End) -> Self {
        Self { end, ..self }
    }

    /// Whether there is a mesh without a triangle below the bound but for those that the drawing forces.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.end == End::Done
    }

    pub(crate) fn to_json(&self) -> Value {
        let mut object = json!({
            "result": self.end.key(),
            "vertices": self.vertices,
            "triangles": self.triangles,
            "steiner_points": self.steiner_points,
            "min_angle": self.min_angle_deg,
            "max_angle": self.max_angle_deg,
            "below_bound": self.below_bound,
            "seconds": self.seconds,
        });
        if let Some(times) = &self.step_times {
            let by_name = times.by_name().map(|(name, seconds)| (name.to_owned(), json!(seconds)));
            object["step_seconds"] = Value::Object(by_name.into_iter().collect());
        }
        object
    }

    pub(crate) fn from_json(value: &Value) -> Option<Self> {
        let count = |key: &str| usize::try_from(value.get(key)?.as_u64()?).ok();
        let number = |key: &str| value.get(key)?.as_f64();
        Some(Self {
            end: End::from_key(value.get("result")?.as_str()?)?,
            vertices: count("vertices")?,
            triangles: count("triangles")?,
            steiner_points: count("steiner_points")?,
            min_angle_deg: number("min_angle")?,
            max_angle_deg: number("max_angle")?,
            below_bound: count("below_bound")?,
            seconds: number("seconds")?,
            step_times: value.get("step_seconds").and_then(step_times),
        })
    }
}

fn step_times(value: &Value) -> Option<StepTimes> {
    let number = |key: &str| value.get(key)?.as_f64();
    Some(StepTimes {
        prepare: number("prepare")?,
        select: number("select")?,
        point: number("point")?,
        insert: number("insert")?,
        recover: number("recover")?,
        rest: number("rest")?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outcomes_come_back_from_json() {
        let ends = [
            End::Done,
            End::Budget,
            End::Time,
            End::Left(Reason::PrecisionFloor),
            End::Below,
            End::Invalid,
            End::Crashed,
        ];
        for end in ends {
            let outcome = Outcome {
                end,
                vertices: 7,
                triangles: 9,
                steiner_points: 3,
                min_angle_deg: 0.1 + 0.2,
                max_angle_deg: 1e2 / 3.0,
                below_bound: 1,
                seconds: 1e-7 / 3.0,
                step_times: (end == End::Done).then(|| StepTimes { insert: 0.1 + 0.2, ..StepTimes::default() }),
            };
            let text = outcome.to_json().to_string();
            assert_eq!(Outcome::from_json(&serde_json::from_str(&text).unwrap()), Some(outcome));
        }
        assert_eq!(Outcome::from_json(&json!({ "result": "done" })), None);
    }
}
