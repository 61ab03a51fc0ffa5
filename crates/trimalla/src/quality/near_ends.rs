//! Input segments along which an unused end of another segment lies.
//!
//! An end outside the domain, within rounding of a segment of the boundary, lies on one exact side of that segment. The
//! chain of that segment bends to either side of it by the rule of [`Strip`], so the end may lie on either side of the
//! chain:
//!
//! ```text
//!             . b                 . b        The end e is above s–t, outside the domain. The split point m is above e, by
//!     e .  ´              __ m __e._         rounding: the segment e–b crosses the edge m–t, though no part of it is in
//!   s ─────────── t     s ──       ──── t    the domain.
//!     (domain)             (domain)
//! ```

use crate::geometry::{BoundingBox, BoxTree, Point, Segment, Strip};

/// The segments of a drawing, found by the points that lie along them.
pub(super) struct NearEnds {
    strips: Vec<(Strip, BoundingBox)>,
    places: BoxTree,
}

impl NearEnds {
    /// The segments between points; those with an end that is out of range or not finite are left out.
    ///
    /// # Complexity
    /// n log n in the segments.
    pub(super) fn of(points: &[Point], segments: &[[u32; 2]]) -> Self {
        let place = |v: u32| points.get(v as usize).copied().filter(|p| p.is_finite());
        let ends = segments.iter().filter_map(|&[a, b]| Some(Segment::new(place(a)?, place(b)?)));
        let strips: Vec<_> = ends.filter(|s| s.start != s.end).map(strip_and_box).collect();
        let places = BoxTree::new(strips.iter().map(|s| s.1).collect());
        Self { strips, places }
    }

    /// Whether points lie along one of the segments together.
    ///
    /// # Complexity
    /// About the square root of the number of segments and those near the first point.
    pub(super) fn are_along(&self, points: [Point; 3]) -> bool {
        let near = self.places.near(Segment::new(points[0], points[0]), [0.0, 0.0]);
        near.into_iter().map(|i| &self.strips[i as usize]).any(|(strip, around)| {
            points.into_iter().all(|p| around.contains(p)) && points.into_iter().all(|p| strip.contains(p))
        })
    }
}

/// The strip of a segment and the box around the segment, as much larger as the strip reaches beside it.
fn strip_and_box(segment: Segment) -> (Strip, BoundingBox) {
    let strip = Strip::new(segment, Strip::LAST_PLACES);
    let ([w, h], tight) = (strip.reach(), segment.bounding_box());
    let corners = [Point::new(tight.min.x - w, tight.min.y - h), Point::new(tight.max.x + w, tight.max.y + h)];
    let finite = corners.into_iter().filter(|p| p.is_finite());
    (strip, finite.fold(tight, BoundingBox::including))
}
