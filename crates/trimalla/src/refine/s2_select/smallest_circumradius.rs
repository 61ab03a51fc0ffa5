//! `smallest-circumradius`: the triangle with the smallest circumcircle first.

use crate::half_edge::FaceId;
use crate::refine::steps::{SelectStep, View};

/// Step 2, `smallest-circumradius`.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallestCircumradius;

impl SelectStep for SmallestCircumradius {
    fn priority(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let ([a, b, c], ruler) = (view.cdt.corners(face), view.ruler);
        // The product of the sides over four times the area, squared and without the factor.
        let doubled_area = ruler.vector(a, b).cross(ruler.vector(a, c));
        let [p, q, r] = [ruler.length_sq(a, b), ruler.length_sq(b, c), ruler.length_sq(c, a)];
        (p / doubled_area) * (q / doubled_area) * r
    }
}
