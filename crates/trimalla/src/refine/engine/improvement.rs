//! Whether a refinement still improves, at bounds that no strategy is proved or known to meet.
//!
//! Up to about 33 degrees refinements end. Above, many go on for ever: every vertex leaves more bad triangles than it
//! removes, until the mesh is full of them. So above [`UNPROVED_DEG`] the bad triangles are counted when the mesh has
//! [`FACTOR`] times the vertices of the [forecast](forecast_under), and each time it has doubled since. When there are
//! no fewer than the time before, the refinement stops.
//!
//! ```text
//!   vertices   forecast ······ 10 × ─────── 20 × ─────── 40 ×
//!                              count        count        count
//! ```
//!
//! Measured on the drawings of `data/shapes` at 34 to 38 degrees: the runs that end by themselves end at 3.4 times the
//! forecast at most. Those that do not stop at 20 times the forecast.
//!
//! Not watched: recipes that never make a smallest angle smaller, since they end by themselves; orders by hand; and
//! refinements with a test of the caller's own, which no forecast knows of.

use super::Refinement;
use super::parts::Improvement;
use crate::refine::forecast::forecast_under;
use crate::refine::recipe::PlacePoint;
use crate::refine::recipe::options::RefineOptions;

/// Bounds up to this one, in degrees, are met in practice.
const UNPROVED_DEG: f64 = 33.0;
/// The first count is due at this many times the forecast.
const FACTOR: f64 = 10.0;

/// Whether the bound on angles is one that refinements need not meet: incenters meet none.
fn is_unproved(options: &RefineOptions) -> bool {
    let bound = options.criteria.effective_min_angle().degrees();
    bound > UNPROVED_DEG || bound > 0.0 && options.recipe.point == PlacePoint::Incenter
}

impl Refinement {
    /// What to watch from the start on.
    pub(super) fn improvement_from_start(&self) -> Improvement {
        if !is_unproved(&self.problem.options)
            || self.strategy.traits.select.is_manual
            || self.strategy.traits.insert.keeps_small_angles
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

    /// Counts the bad triangles, which is due; says whether there are no fewer than the last time.
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
