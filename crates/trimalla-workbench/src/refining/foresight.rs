//! Warnings before the work: angles that no mesh can reach, meshes that the budget will cut short.

use trimalla::geometry::Point;
use trimalla::quality::AngleCeiling;
use trimalla::refine::{Cause, Feature, Forecast, Gap, Outlook, RefineOptions};

use crate::numbers::{FileNumbers, grouped, short};

/// By what factor a forecast may be wrong.
const UNSURE: f64 = 3.0;

/// Warnings before the work, in the numbers of a file.
#[derive(Debug)]
pub(super) struct Foresight<'a> {
    names: &'a FileNumbers<'a>,
    options: RefineOptions,
    warnings: Vec<String>,
}

impl<'a> Foresight<'a> {
    pub(super) fn new(names: &'a FileNumbers<'a>, options: RefineOptions) -> Self {
        Self { names, options, warnings: Vec::new() }
    }

    /// The warnings so far.
    pub(super) fn warnings(&self) -> &[String] {
        &self.warnings
    }

    pub(super) fn into_warnings(self) -> Vec<String> {
        self.warnings
    }

    /// Warns of what is ahead.
    pub(super) fn look(&mut self, outlook: &Outlook) {
        if let Some(ceiling) = outlook.angle_ceiling.filter(|c| c.forbids(self.options.criteria.min_angle)) {
            self.warn(self.describe_ceiling(&ceiling));
        }
        if outlook.forecast.exceeds(&self.options.limits) {
            self.warn(self.describe_forecast(&outlook.forecast));
        } else if let Some(gap) = outlook.forecast.narrow_gap() {
            self.warn(self.describe_narrow_gap(&outlook.forecast, &gap));
        }
        if let Some(gap) = outlook.within_rounding {
            self.warn(describe_within_rounding(self.names, &gap));
        }
    }

    fn warn(&mut self, text: String) {
        self.warnings.push(self.names.of_file(text));
    }

    /// An angle bound that no mesh can meet.
    fn describe_ceiling(&self, ceiling: &AngleCeiling) -> String {
        let is_lowered = self.options.make_several_attempts() && ceiling.bound.degrees() >= RefineOptions::PRACTICE_DEG;
        format!(
            "no mesh has all angles at {} degrees or above: the corner of {} degrees at {}, {}, allows {}{}",
            short(self.options.criteria.min_angle.degrees()),
            short(ceiling.sector.degrees()),
            self.names.vertex(ceiling.vertex),
            ceiling.at,
            short(ceiling.bound.degrees()),
            if is_lowered { ", which is the bound now" } else { "" }
        )
    }

    /// A budget that is too small.
    fn describe_forecast(&self, forecast: &Forecast) -> String {
        let cause = match forecast.cause {
            Cause::Gap(gap) => format!("{} is the cause", describe_gap(self.names, &gap)),
            Cause::ShortSegment(gap) => format!("{} is the cause", self.describe_segment(&gap)),
            Cause::Area => "the area bound is the cause".to_owned(),
            Cause::Features => "its features are the cause, none of them small".to_owned(),
            _ => "the drawing itself has so many".to_owned(),
        };
        let limits = &self.options.limits;
        let is_sure = forecast.vertices > UNSURE * limits.max_vertices as f64;
        let verb = if is_sure { "will" } else { "may" };
        format!(
            "{} triangles are needed, more than the budget of {} vertices allows: {cause}; the mesh {verb} stop at the budget",
            about(forecast.triangles),
            grouped(limits.max_vertices as u64)
        )
    }

    /// A gap that takes most of the triangles, though the budget is large enough.
    fn describe_narrow_gap(&self, forecast: &Forecast, gap: &Gap) -> String {
        format!(
            "most of {} triangles are needed for {}: if the two are meant to touch, let them share a vertex",
            about(forecast.triangles),
            describe_gap(self.names, gap)
        )
    }

    fn describe_segment(&self, gap: &Gap) -> String {
        let [one, other] = gap.between.map(|feature| describe_feature(self.names, feature));
        format!("the segment of length {} between {one} and {other}", short(gap.width))
    }
}

/// Two features that are close, and where.
fn describe_gap(names: &FileNumbers<'_>, gap: &Gap) -> String {
    let [one, other] = gap.between.map(|feature| describe_feature(names, feature));
    let Point { x, y } = gap.at;
    format!("the gap of {} between {one} and {other} near ({}, {})", short(gap.width), short(x), short(y))
}

/// Two features within rounding of each other.
fn describe_within_rounding(names: &FileNumbers<'_>, gap: &Gap) -> String {
    format!(
        "{} is within rounding: no vertex fits into it, and triangles there stay as they are",
        describe_gap(names, gap)
    )
}

fn describe_feature(names: &FileNumbers<'_>, feature: Feature) -> String {
    match feature {
        Feature::Vertex(v) => names.vertex(v),
        Feature::Segment(s) => names.segment(s.index()),
        _ => "the convex hull".to_owned(),
    }
}

/// A large number in two digits.
fn about(x: f64) -> String {
    if !x.is_finite() {
        return "more than 1e308".to_owned();
    }
    let rounded: f64 = format!("{x:.1e}").parse().unwrap_or(x);
    if rounded < 1e7 { format!("about {}", grouped(rounded as u64)) } else { format!("about {rounded:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, 0.1 + 0.2, 90.00000000000001, -499.99999999, 1e-6, 1.23456789e-9, 1e9].map(short);
        assert_eq!(texts, ["0", "0.3", "90", "-500", "1e-6", "1.2346e-9", "1e9"]);
        assert_eq!(
            [93.0, 124_853.0, 2.04e9, f64::INFINITY].map(about),
            ["about 93", "about 120,000", "about 2e9", "more than 1e308"]
        );
    }
}
