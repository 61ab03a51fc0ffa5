//! What came of a run.

use std::fmt;

use serde_json::{Value, json};
use trimalla::refine::{Reason, Report, StopReason};

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// Every triangle is good, but for those that the input's own angles force.
    Done,
    /// The vertex budget was used up.
    Budget,
    /// The time was.
    Time,
    /// It ended by itself and left triangles below the bound, most of them for this reason.
    Left(Reason),
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

    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Budget => "budget",
            Self::Time => "time",
            Self::Left(reason) => reason.key(),
        }
    }

    fn from_key(key: &str) -> Option<Self> {
        let ends = [Self::Done, Self::Budget, Self::Time].into_iter();
        ends.chain(Reason::ALL.map(Self::Left)).find(|end| end.key() == key)
    }
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}

/// What came of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Outcome {
    pub(crate) end: End,
    pub(crate) vertices: usize,
    pub(crate) triangles: usize,
    pub(crate) steiner_points: usize,
    pub(crate) min_angle_deg: f64,
    pub(crate) max_angle_deg: f64,
    /// Triangles below the bound, forced or not.
    pub(crate) below_bound: usize,
    pub(crate) seconds: f64,
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
        }
    }

    pub(crate) fn is_done(&self) -> bool {
        self.end == End::Done
    }

    pub(crate) fn to_json(&self) -> Value {
        json!({
            "result": self.end.key(),
            "vertices": self.vertices,
            "triangles": self.triangles,
            "steiner_points": self.steiner_points,
            "min_angle": self.min_angle_deg,
            "max_angle": self.max_angle_deg,
            "below_bound": self.below_bound,
            "seconds": self.seconds,
        })
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
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outcomes_come_back_from_json() {
        let ends = [End::Done, End::Budget, End::Time, End::Left(Reason::PrecisionFloor)];
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
            };
            let text = outcome.to_json().to_string();
            assert_eq!(Outcome::from_json(&serde_json::from_str(&text).unwrap()), Some(outcome));
        }
        assert_eq!(Outcome::from_json(&json!({ "result": "done" })), None);
    }
}
