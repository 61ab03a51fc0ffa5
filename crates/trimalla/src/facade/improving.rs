//! Meshes made smaller after their refinement.

use super::Refined;
use crate::constrained::ConstrainedDelaunay;
use crate::improve::{AngleBound, Progress, SiftOptions, sift};
use crate::refine::{self, Observer, OptionError, RefineOptions, Refinement, Report, Start, StopReason};
use crate::size::SizeBounds;

/// What is done to make a mesh smaller after its refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Improve {
    /// Nothing.
    #[default]
    None,
    /// Steiner vertices are taken out, and others moved, as long as every bound holds: [`sift`]. Not where a [`Sizing`]
    /// asks for smaller triangles than the options and regions do, and not where a triangle stayed bad.
    ///
    /// [`Sizing`]: super::Sizing
    Sift {
        /// How much work is spent, from 1 to 9.
        effort: u8,
    },
}

/// How much smaller a mesh was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Improved {
    /// Vertices after the refinement.
    pub vertices_before: usize,
    /// Vertices now.
    pub vertices: usize,
    /// Whether every angle is proved to be at least the bound: [`AngleBound::is_met_by`].
    pub is_proved: bool,
}

/// Makes a refined mesh smaller. One that was cancelled stays as it is, and so does one with a triangle that stayed
/// bad: around that nothing could be proved.
pub(super) fn improved(
    refined: Refined,
    effort: u8,
    options: &RefineOptions,
    observer: &mut dyn Observer,
) -> Result<Refined, OptionError> {
    let asked = options.criteria.effective_min_angle().degrees();
    let bound_deg = refined.attempted.map_or(asked, |attempted| attempted.bound_deg);
    let Some(bound) = AngleBound::new(bound_deg) else { return Ok(refined) };
    if refined.report.stop == StopReason::Cancelled || !refined.report.leftovers.is_empty() {
        return Ok(refined);
    }
    let sizes = SizeBounds::new(options.criteria.max_area, &refined.cdt, Vec::new());
    let fits = |t: &_, f| sizes.admit(t, f);
    let most = options.limits.max_vertices;
    let mut goes_on = |progress: Progress| {
        observer.progress(refine::Progress { vertices: progress.vertices, waiting: 0, max_vertices: most })
    };
    let (before, vertices_before) = (refined.cdt.clone(), refined.report.vertices);
    let sifted = sift(
        ConstrainedDelaunay::from(refined.cdt),
        &SiftOptions { effort, ..SiftOptions::new(bound) },
        &fits,
        &mut goes_on,
    );
    let is_smaller = sifted.vertices < sifted.vertices_before;
    let cdt = if is_smaller { sifted.mesh.into() } else { before };
    let is_proved = cdt.real_faces().all(|f| bound.is_met_by(cdt.face_points(f)));
    let (cdt, survey) = Refinement::new(Start::from(ConstrainedDelaunay::from(cdt)), *options)?.finish();
    let Report { vertices, triangles, steiner_points, min_angle_deg, max_angle_deg, leftovers, .. } = survey;
    let report =
        Report { vertices, triangles, steiner_points, min_angle_deg, max_angle_deg, leftovers, ..refined.report };
    let improved = Improved { vertices_before, vertices, is_proved };
    Ok(Refined { cdt, report, improved: Some(improved), ..refined })
}
