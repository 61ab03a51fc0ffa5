//! `circumcenter`: the center of the circumcircle.
//!
//! # Source
//! `[Ruppert95]`, `[Chew93]`.

use crate::geometry::{Point, Triangle};
use crate::half_edge::FaceId;
use crate::refine::steps::{Places, PointStep, Proposal, View};

/// Step 3, `circumcenter`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circumcenter;

impl PointStep for Circumcenter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        places.extend(center_of(view, face).and_then(|point| Proposal::towards(view, face, point)));
    }
}

/// The circumcenter of a face, rounded.
pub(super) fn center_of(view: View<'_>, face: FaceId) -> Option<Point> {
    let [a, b, c] = view.cdt.corners(face);
    Triangle::new(a, b, c).circumcenter()
}
