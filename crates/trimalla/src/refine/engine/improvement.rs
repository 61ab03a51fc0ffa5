//! Whether a refinement still improves, at bounds that no strategy is proved or known to meet.
//!
//! Up to about 33 degrees refinements end. Above, many never end: every vertex creates more bad triangles than it
//! removes. So above [`UNPROVED_DEG`] the bad triangles are counted when the mesh has [`FACTOR`] times the vertices of
//! the [forecast](forecast_under), and whenever that number has doubled. If a count is no lower than the one before,
//! the refinement stops.
//!
//! ```text
//!   vertices   forecast ······ 10 × ─────── 20 × ─────── 40 ×
//!                              count        count        count
//! ```
//!
//! Measured on the drawings of `data/shapes` at 34 to 38 degrees: runs that end by themselves have at most 3.4 times
//! the vertices of the forecast. The others stop at 20 times the forecast.
//!
//! Bad triangles are not counted for recipes that never make a smallest angle smaller, since they end by themselves;
//! for the order `manual`; and for refinements with a test of the caller's own, which the forecast does not know.

use super::Refinement;
use super::parts::Improvement;
use crate::refine::forecast::forecast_under;
use crate::refine::recipe::PlacePoint;
use crate::refine::recipe::options::RefineOptions;

/// Bounds up to this one, in degrees, are met in practice.
const UNPROVED_DEG: f64 = RefineOptions::PRACTICE_DEG;
/// The first count is due at this many times the forecast.
const FACTOR: f64 = 10.0;

/// Whether refinements may fail to meet the bound on angles; with incenters they may fail at any bound.
fn is_unproved(options: &RefineOptions) -> bool {
    let bound = options.criteria.effective_min_angle().degrees();
    bound > UNPROVED_DEG || bound > 0.0 && options.recipe.point == PlacePoint::Incenter
}

impl Refinement {
    /// When the bad triangles are counted first.
    pub(super) fn initial_improvement(&self) -> Improvement {
        if !is_unproved(&self.problem.options)
            || self.strategy.traits.select.is_manual
            || self.strategy.traits.insert.keeps_small_angles
            || self.problem.test.user_test().is_some()
        {
            return Improvement::UNWATCHED;
        }
        let expected = forecast_under(&self.cdt, &self.problem.options, self.problem.test.size())
            .vertices
            .max(self.ledger.vertices as f64);
        // The cast saturates.
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a number of vertices, not negative"
        )]
        let due = (FACTOR * expected) as usize;
        Improvement { due, ..Improvement::UNWATCHED }
    }

    /// Counts the bad triangles; returns whether there are no fewer than at the last count.
    #[cold]
    pub(super) fn no_longer_improves(&mut self) -> bool {
        let bad = self.cdt.real_faces().filter(|&f| self.badness(f).is_some()).count();
        if bad >= self.ledger.improvement.bad {
            return true;
        }
        self.ledger.improvement = Improvement { due: self.ledger.vertices.saturating_mul(2), bad };
        false
    }
}
