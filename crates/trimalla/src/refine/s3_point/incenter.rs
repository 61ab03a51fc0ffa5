//! `incenter`: the center of the inscribed circle.
//!
//! ```text
//!          c                   c
//!         ╱ ╲                 ╱│╲         with --insert partition: the three triangles a b i, b c i and c a i
//!        ╱   ╲      ──>      ╱ i ╲
//!       a ─── b             a ─── b
//! ```
//!
//! The simplest way to get more triangles. Every angle is halved, which is why the source shows it: do not use it under
//! an angle bound, where a refinement ends only because it no longer improves. For area bounds it works.
//!
//! # Source
//! `[MeshSuite]` 2.2, figure 1.

use crate::geometry::{Containment, Triangle};
use crate::half_edge::FaceId;
use crate::locate::Locus;
use crate::refine::steps::{Places, PointStep, PointTraits, Proposal, View};

/// Step 3, `incenter`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incenter;

impl PointStep for Incenter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let [a, b, c] = view.cdt.corners(face);
        let triangle = Triangle::new(a, b, c);
        let point = triangle.incenter();
        // Rounding leaves thin triangles no inner point.
        if triangle.locate(point) == Containment::Inside {
            places.push(Proposal::Free { point, locus: Locus::Face(face) });
        }
    }

    fn traits(&self) -> PointTraits {
        PointTraits { minds_encroachment: false, shells_at_every_joint: false, ..PointTraits::default() }
    }
}
