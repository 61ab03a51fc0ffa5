//! The best mesh within reach, where the bound on angles may be out of reach.
//!
//! Up to 33 degrees one run of the default recipe meets the bound. Above, many runs never end, and their triangles have
//! smaller angles than those of a mesh for 30 degrees. So several runs are made, each with a budget of its own:
//!
//! 1. A run at 30 degrees, which ends. No mesh with a smaller angle than this one has is ever returned.
//! 2. Runs at the bound that is asked, or at the [angle ceiling](crate::quality::angle_ceiling) if that is lower.
//! 3. If none of them ends: runs at 36 degrees, and then one degree up as long as they end, or down until one ends.
//!
//! ```text
//!   asked 40:   30 ends   40 fails   36 ends   37 ends   38 fails        the mesh of 37 degrees is returned
//! ```
//!
//! A run ends if no triangle stays bad but those that the input, protected segments or the length floor force. At each
//! bound several recipes have a run: off-centers up to 35 degrees, then centroids of terminal triangles, which end most
//! often above, then off-centers of terminal triangles.
//!
//! Measured on `data/shapes` at 34 to 38 degrees: where a run ends, one of these recipes ends with at most
//! [`ONE_RUN`] times the vertices of the forecast. The others run on to any budget.

use super::quiet::Quiet;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Angle, Triangle};
use crate::quality::AngleCeiling;
use crate::refine::{
    Leftover, Observer, OptionError, Outlook, Preset, Reason, RefineOptions, Refinement, Report, Start, StopReason,
};

/// The bound of the run that always ends, in degrees.
const SAFE_DEG: f64 = 30.0;
/// Off-centers end up to this bound, in degrees.
const PRACTICE_DEG: f64 = RefineOptions::PRACTICE_DEG;
/// Where the search begins if nothing ends at the bound that is asked, in degrees.
const LIKELY_DEG: f64 = 36.0;
/// The vertices of a run, over those of the forecast at its bound.
const ONE_RUN: f64 = 3.0;
/// The vertices of all runs above 33 degrees, over those of the forecast at the bound that is asked.
const ALL_RUNS: f64 = 20.0;
/// Angles are rounded: a mesh whose smallest angle is lower by no more than this is not worse, in degrees.
const ROUNDING_DEG: f64 = 1e-9;

/// Which of several runs gave a mesh, where the bound on angles may be out of reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attempted {
    /// The recipe of the run.
    pub preset: Preset,
    /// The bound that the run met, in degrees: the one that was asked, or a lower one.
    pub bound_deg: f64,
    /// Whether that is a lower one.
    pub is_lowered: bool,
    /// The corner that keeps every mesh below the bound that was asked, if there is one.
    pub ceiling: Option<AngleCeiling>,
    /// How many runs were made.
    pub runs: usize,
}

/// The recipes that have a run at a bound, the most promising first.
fn presets(bound_deg: f64) -> &'static [Preset] {
    match bound_deg {
        deg if deg <= PRACTICE_DEG => &[Preset::OffCenter],
        deg if deg <= 35.0 => &[Preset::OffCenter, Preset::LeppCentroid, Preset::LeppOffCenter],
        deg if deg <= 38.0 => &[Preset::LeppCentroid, Preset::LeppOffCenter],
        _ => &[Preset::LeppCentroid],
    }
}

/// A mesh, and the run that made it.
struct Found {
    cdt: ConstrainedTriangulation,
    report: Report,
    options: RefineOptions,
    preset: Preset,
    bound_deg: f64,
}

/// The search for the highest bound that is met.
struct Search<'a> {
    start: &'a Start,
    asked: &'a RefineOptions,
    watch: Quiet<'a>,
    /// Vertices that the forecast expects at the bound that is asked.
    expected: f64,
    /// Vertices that runs may still have.
    left: f64,
    runs: usize,
}

/// Refines to the highest bound that is met; the outlook is that of the start under these options.
///
/// # Guarantees
/// The smallest angle is that of the run at 30 degrees or larger. The runs above 30 degrees have no more than
/// [`ALL_RUNS`] times the vertices of the forecast, all together.
pub(super) fn best_of(
    start: &Start,
    asked: &RefineOptions,
    outlook: &Outlook,
    observer: &mut dyn Observer,
) -> Result<(ConstrainedTriangulation, Report, Attempted), OptionError> {
    let mut search = Search { start, asked, watch: Quiet::new(observer), expected: 0.0, left: 0.0, runs: 0 };
    let safe = search.safe()?;
    search.expected = outlook.forecast.vertices.max(safe.report.vertices as f64);
    search.left = ALL_RUNS * search.expected;
    let asked_deg = asked.criteria.min_angle.degrees();
    let ceiling = outlook.angle_ceiling.filter(|ceiling| ceiling.forbids(asked.criteria.min_angle));
    // A corner with a smaller sector keeps its own triangles below the bound, and no others.
    let lowered = ceiling.map(|ceiling| just_below(ceiling.bound)).filter(|&deg| deg >= PRACTICE_DEG);
    let found = search.highest(lowered.unwrap_or(asked_deg), safe)?;
    let attempted = Attempted {
        preset: found.preset,
        bound_deg: found.bound_deg,
        is_lowered: found.bound_deg < asked_deg,
        ceiling: ceiling.filter(|_| lowered.is_some()),
        runs: search.runs,
    };
    let Found { cdt, mut report, .. } = search.shown(found)?;
    if attempted.is_lowered {
        judge(&cdt, asked, &mut report);
    }
    Ok((cdt, report, attempted))
}

/// An angle in degrees, rounded down to four digits: at a ceiling itself rounding decides.
pub(super) fn just_below(angle: Angle) -> f64 {
    (1e4 * angle.degrees()).floor() / 1e4
}

impl Search<'_> {
    /// The run that always ends. The observer takes it for the beginning, unless events are to be shown later.
    fn safe(&mut self) -> Result<Found, OptionError> {
        let options = self.options(Preset::OffCenter, SAFE_DEG, self.asked.limits.max_vertices);
        let mut refinement = Refinement::new(self.start.clone(), options)?;
        if refinement.prepare(&mut self.watch) {
            if !self.watch.observer.wants_events() {
                self.watch.observer.begins(&mut refinement);
            }
            refinement.run(&mut self.watch);
        }
        let (cdt, report) = refinement.finish();
        self.runs += 1;
        Ok(Found { cdt, report, options, preset: Preset::OffCenter, bound_deg: SAFE_DEG })
    }

    fn options(&self, preset: Preset, bound_deg: f64, max_vertices: usize) -> RefineOptions {
        let options = RefineOptions { recipe: preset.recipe(), ..*self.asked }.with_max_vertices(max_vertices);
        // The bound that is asked stays as it is, bit for bit.
        let is_asked = bound_deg == self.asked.criteria.min_angle.degrees();
        if is_asked { options } else { options.with_min_angle_deg(bound_deg) }
    }

    /// The mesh of the highest bound up to `target_deg` at which a run ends.
    fn highest(&mut self, target_deg: f64, safe: Found) -> Result<Found, OptionError> {
        let least_deg = safe.report.min_angle_deg - ROUNDING_DEG;
        if !has_ended(&safe.report) {
            return Ok(safe);
        }
        if let Some(found) = self.at(target_deg, least_deg)? {
            return Ok(found);
        }
        let mut best = safe;
        let mut bound_deg = LIKELY_DEG.min(target_deg.ceil() - 1.0);
        let mut step = 1.0;
        while best.bound_deg < bound_deg && (PRACTICE_DEG..target_deg).contains(&bound_deg) {
            match self.at(bound_deg, least_deg)? {
                Some(found) => best = found,
                None => step = -1.0,
            }
            bound_deg += step;
        }
        Ok(best)
    }

    /// The mesh of the first recipe that ends at a bound.
    fn at(&mut self, bound_deg: f64, least_deg: f64) -> Result<Option<Found>, OptionError> {
        for &preset in presets(bound_deg) {
            let strength = Angle::from_degrees(bound_deg).tan() / self.asked.criteria.min_angle.tan();
            let expected = self.expected * strength * strength.sqrt();
            let budget = (ONE_RUN * expected).max(100.0).min(self.left);
            if self.watch.is_cancelled || budget < 0.5 * expected {
                return Ok(None);
            }
            // The cast saturates.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of vertices")]
            let budget = (budget as usize).min(self.asked.limits.max_vertices);
            let options = self.options(preset, bound_deg, budget);
            let mut refinement = Refinement::new(self.start.clone(), options)?;
            if refinement.prepare(&mut self.watch) {
                refinement.run(&mut self.watch);
            }
            let (cdt, report) = refinement.finish();
            self.runs += 1;
            self.left -= report.vertices as f64;
            if has_ended(&report) && report.min_angle_deg >= least_deg {
                return Ok(Some(Found { cdt, report, options, preset, bound_deg }));
            }
        }
        Ok(None)
    }

    /// The same mesh, made once more before the observer, if it wants to see the steps or to time them.
    fn shown(&mut self, found: Found) -> Result<Found, OptionError> {
        let clock = self.watch.observer.clock();
        if self.watch.is_cancelled || !(self.watch.observer.wants_events() || clock.is_some()) {
            return Ok(found);
        }
        let mut refinement = Refinement::new(self.start.clone().with_clock(clock), found.options)?;
        if refinement.prepare(self.watch.observer) {
            if self.watch.observer.wants_events() {
                self.watch.observer.begins(&mut refinement);
            }
            refinement.run(self.watch.observer);
        }
        let (cdt, report) = refinement.finish();
        Ok(Found { cdt, report, ..found })
    }
}

/// Whether a run has met its bound but where something forbids it.
fn has_ended(report: &Report) -> bool {
    let is_forbidden = |reason: Reason| {
        reason.is_forced() || matches!(reason, Reason::ProtectedSegment | Reason::SizeFloor | Reason::NotPicked)
    };
    report.stop == StopReason::Finished
        && report.lost_segments.is_empty()
        && report.leftovers.iter().all(|leftover| is_forbidden(leftover.reason))
}

/// Adds the triangles that miss the bound that was asked, where a lower one was met.
pub(super) fn judge(cdt: &ConstrainedTriangulation, asked: &RefineOptions, report: &mut Report) {
    if report.stop == StopReason::Finished {
        report.stop = StopReason::NoLongerImproves;
    }
    let mut listed = std::mem::take(&mut report.leftovers).into_iter().peekable();
    for (triangle, f) in cdt.real_faces().enumerate() {
        if let Some(leftover) = listed.next_if(|leftover| leftover.triangle == triangle) {
            report.leftovers.push(leftover);
            continue;
        }
        let [a, b, c] = cdt.corners_from_newest(f);
        let corners = Triangle::new(a, b, c);
        if asked.criteria.missed_by(&corners).angle {
            let min_angle_deg = corners.min_angle().degrees();
            report.leftovers.push(Leftover { triangle, min_angle_deg, reason: Reason::StrategyCannotImprove });
        }
    }
}
