//! `smallest-angle`: the triangle with the smallest angle first, by its squared sine.

use crate::half_edge::FaceId;
use crate::refine::steps::{SelectStep, View};

/// Step 2, `smallest-angle`.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallestAngle;

impl SelectStep for SmallestAngle {
    fn priority(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let ([a, b, c], ruler) = (view.cdt.corners(face), view.ruler);
        // The smallest angle is never above 60 degrees, where the sine rises with it: twice the area over the
        // product of the two longer sides.
        let doubled_area = ruler.vector(a, b).cross(ruler.vector(a, c));
        let mut sides = [ruler.length_sq(a, b), ruler.length_sq(b, c), ruler.length_sq(c, a)];
        sides.sort_by(f64::total_cmp);
        (doubled_area / sides[1]) * (doubled_area / sides[2])
    }
}
