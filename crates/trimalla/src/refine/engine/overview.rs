//! The present size and smallest angle of a triangulation under refinement.

use super::Refinement;
use crate::geometry::Triangle;
use crate::refine::criteria::bad_triangles::SufficientBounds;
use crate::refine::criteria::extremes::Extremes;
use crate::refine::watch::observer::Overview;
use crate::triangulation::corners_of_two;

impl Refinement {
    /// The present size and smallest angle of the triangulation.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn overview(&self) -> Overview {
        let nothing_is_bad = SufficientBounds { sine_sq: 0.0, doubled_area: f64::INFINITY };
        let mut extremes = Extremes::new(self.problem.ruler, nothing_is_bad);
        let mut triangles = 0;
        self.cdt.for_each_two_triangles(|two, count| {
            let are_passed = extremes.are_passed(corners_of_two(two));
            for (t, _) in two[..count].iter().zip(are_passed).filter(|(_, is_passed)| !is_passed) {
                extremes.include(t.face, self.cdt.corners_from_newest(t.face));
            }
            triangles += count;
        });
        let angle = extremes.sharpest.map(|f| {
            let [a, b, c] = self.cdt.corners_from_newest(f);
            Triangle::new(a, b, c).min_angle().degrees()
        });
        Overview { vertices: self.ledger.vertices, triangles, min_angle_deg: angle }
    }
}
