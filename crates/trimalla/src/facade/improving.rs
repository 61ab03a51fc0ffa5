//! Meshes made smaller after their refinement.

use super::Refined;
use super::attempts::{Attempted, judge, just_below};
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation};
use crate::improve::{AngleBound, Progress, SiftOptions, climb, sift};
use crate::refine::{self, Observer, OptionError, Reason, RefineOptions, Refinement, Report, Start, StopReason};
use crate::size::SizeBounds;

/// What is done to make a mesh smaller after its refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Improve {
    /// Nothing.
    #[default]
    None,
    /// Steiner vertices are taken out, and others moved, as long as every bound holds: [`sift`]. Where no refinement
    /// met the bound on angles, the mesh is led to it first, as far as that goes: [`climb`]. Not where a [`Sizing`]
    /// asks for smaller triangles than the options and regions do, and not where a triangle stayed bad otherwise.
    ///
    /// [`Sizing`]: super::Sizing
    Sift {
        /// How much work is spent, from 1 to 9. From 5 on several runs share it, of which the best counts.
        effort: u8,
    },
}

/// How much smaller a mesh was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Improved {
    /// Vertices after the refinement.
    pub vertices_before: usize,
    /// Vertices now.
    pub vertices: usize,
    /// The bound that the refinement met, in degrees, where the mesh was led to a higher one: [`climb`].
    pub climbed_from_deg: Option<f64>,
    /// Whether every angle is proved to be at least the bound: [`AngleBound::is_met_by`].
    pub is_proved: bool,
}

/// A mesh that was made smaller, and the bound that every triangle is proved to meet.
struct Candidate {
    cdt: ConstrainedTriangulation,
    vertices: usize,
    bound: AngleBound,
}

/// Makes a refined mesh smaller, and leads it to the bound that is asked where no refinement met it. One that was
/// cancelled stays as it is, and so does one with a triangle that stayed bad for another reason: around that nothing
/// could be proved.
pub(super) fn improved(
    refined: Refined,
    effort: u8,
    options: &RefineOptions,
    observer: &mut dyn Observer,
) -> Result<Refined, OptionError> {
    let Some((met, target)) = bounds(&refined, options) else { return Ok(refined) };
    let sizes = SizeBounds::new(options.criteria.max_area, &refined.cdt, Vec::new());
    let fits = |t: &_, f| sizes.admit(t, f);
    let most = options.limits.max_vertices;
    let mut goes_on = |progress: Progress| {
        observer.progress(refine::Progress { vertices: progress.vertices, waiting: 0, max_vertices: most })
    };
    let mut best = Candidate { cdt: refined.cdt.clone(), vertices: refined.report.vertices, bound: met };
    let (runs, effort) = runs_of(effort);
    for run in 0..runs {
        let options = SiftOptions { effort, seed: run, ..SiftOptions::new(met) };
        let climbed = climb(refined.cdt.clone().into(), &options, target, &fits, &mut goes_on);
        let options = SiftOptions { bound: climbed.bound, ..options };
        let sifted = sift(climbed.mesh, &options, &fits, &mut goes_on);
        let is_better = (climbed.bound.degrees(), best.vertices) > (best.bound.degrees(), sifted.vertices);
        // A climb may put vertices in, but no more than the budget allows.
        if is_better && sifted.vertices <= most.max(refined.report.vertices) {
            best = Candidate { cdt: sifted.mesh.into(), vertices: sifted.vertices, bound: climbed.bound };
        }
        if climbed.is_cancelled || sifted.is_cancelled {
            break;
        }
    }
    with_mesh(refined, best, (met, target), options)
}

/// How many runs share an effort, and the effort of each.
const fn runs_of(effort: u8) -> (u64, u8) {
    match effort {
        0..=4 => (1, effort),
        5 | 6 => (4, effort - 2),
        _ => (8, effort - 3),
    }
}

/// The bound that a refined mesh meets, and the one that is asked; `None` where the mesh stays as it is.
fn bounds(refined: &Refined, options: &RefineOptions) -> Option<(AngleBound, AngleBound)> {
    let asked = options.criteria.effective_min_angle().degrees();
    let met = refined.attempted.map_or(asked, |attempted| attempted.bound_deg);
    let target =
        refined.attempted.and_then(|attempted| attempted.ceiling).map_or(asked, |ceiling| just_below(ceiling.bound));
    let is_expected = |reason: Reason| met < target && reason == Reason::StrategyCannotImprove;
    let is_sound = refined.report.stop != StopReason::Cancelled
        && refined.report.leftovers.iter().all(|leftover| is_expected(leftover.reason));
    if is_sound { AngleBound::new(met).zip(AngleBound::new(target.max(met))) } else { None }
}

/// The same refinement with a smaller mesh, or one that meets a higher bound.
fn with_mesh(
    refined: Refined,
    found: Candidate,
    (met, target): (AngleBound, AngleBound),
    options: &RefineOptions,
) -> Result<Refined, OptionError> {
    let Candidate { cdt, bound, .. } = found;
    let is_proved = cdt.real_faces().all(|f| bound.is_met_by(cdt.face_points(f)));
    let met_deg = bound.degrees();
    let is_lowered = met_deg < options.criteria.effective_min_angle().degrees();
    let own = if is_lowered { options.with_min_angle_deg(met_deg) } else { *options };
    let (cdt, survey) = Refinement::new(Start::from(ConstrainedDelaunay::from(cdt)), own)?.finish();
    let Report { vertices, triangles, steiner_points, min_angle_deg, max_angle_deg, leftovers, .. } = survey;
    let vertices_before = refined.report.vertices;
    let mut report =
        Report { vertices, triangles, steiner_points, min_angle_deg, max_angle_deg, leftovers, ..refined.report };
    if met_deg > met.degrees() && met_deg == target.degrees() {
        report.stop = StopReason::Finished;
    }
    if is_lowered {
        judge(&cdt, options, &mut report);
    }
    let attempted = refined.attempted.map(|attempted| Attempted { bound_deg: met_deg, is_lowered, ..attempted });
    let climbed_from_deg = (met_deg > met.degrees()).then_some(met.degrees());
    let improved = Improved { vertices_before, vertices, climbed_from_deg, is_proved };
    Ok(Refined { cdt, report, attempted, improved: Some(improved), ..refined })
}
