//! Phase two of inserting a segment: replaces the crossed faces by others that have the segment as an edge.

use super::plan::SegmentPlan;
use super::pseudo_polygon::{Edges, Filler, Filling};
use crate::delaunay::Lawson;
use crate::half_edge::{FaceId, Half, HalfEdgeId, Journal};
use crate::triangulation::Triangulation;

/// The faces that a segment crosses, in two halves; kept between segments so that none allocates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Corridor {
    faces: Vec<FaceId>,
    left: Half,
    right: Half,
    filler: Filler,
}

impl Corridor {
    /// Puts the planned edge into the triangulation, with that mark, and legalises the new faces. If the triangulation
    /// was constrained Delaunay before, it is so again: a segment only hides vertices, so every face that it does not
    /// cross still passes the circle test.
    ///
    /// Returns whether the edge is there. If not, nothing has changed: the plan crosses constrained edges or is out of
    /// date.
    pub(super) fn apply<J: Journal>(
        &mut self,
        t: &mut Triangulation,
        plan: &SegmentPlan,
        mark: u32,
        filling: Filling,
        lawson: &mut Lawson,
        j: &mut J,
    ) -> bool {
        if let Some(h) = plan.existing {
            t.mesh.set_mark(h, mark, j);
            return true;
        }
        if !plan.constrained.is_empty() {
            return false;
        }
        if let [crossed] = plan.crossed[..] {
            self.flip_into_place(t, crossed, mark, j);
        } else if let Some(edges) = self.refill(t, plan, mark, filling, j) {
            if edges == Edges::Unproved {
                self.inner_edges().for_each(|h| lawson.push(h));
            }
        } else {
            return false;
        }
        lawson.legalise_all(t, j);
        true
    }

    /// The segment that crosses a single edge is the other diagonal of its two faces.
    ///
    /// ```text
    ///        l                    l
    ///       /|\                  / \        the segment runs inside both faces, so the quadrilateral is
    ///   from ─ ─ to     ──>  from ═══ to     strictly convex
    ///       \|/                  \ /
    ///        r                    r
    /// ```
    fn flip_into_place<J: Journal>(&mut self, t: &mut Triangulation, crossed: HalfEdgeId, mark: u32, j: &mut J) {
        self.faces.clear();
        self.faces.extend([crossed.face(), t.twin(crossed).face()]);
        let h = t.mesh.flip(crossed, j);
        t.mesh.set_mark(h, mark, j);
    }

    /// Fills the pseudo-polygons on both sides.
    fn refill<J: Journal>(
        &mut self,
        t: &mut Triangulation,
        plan: &SegmentPlan,
        mark: u32,
        filling: Filling,
        j: &mut J,
    ) -> Option<Edges> {
        let Self { faces, left, right, filler } = self;
        faces.clear();
        faces.extend(plan.crossed.first().map(|h| h.face()));
        faces.extend(plan.crossed.iter().map(|&h| t.twin(h).face()));
        left.start(plan.from, plan.left.iter(), plan.to, plan.left_rim.iter());
        right.start(plan.to, plan.right.iter().rev(), plan.from, plan.right_rim.iter().rev());
        let edges = [fill(t, left, filler, filling)?, fill(t, right, filler, filling)?];
        t.mesh.refill(faces, [left, right], mark, j);
        Some(if edges == [Edges::Legal; 2] { Edges::Legal } else { Edges::Unproved })
    }

    /// The edges inside both halves that were filled last, one half-edge each.
    fn inner_edges(&self) -> impl Iterator<Item = HalfEdgeId> + '_ {
        let (left, right) = self.faces.split_at(self.left.patch.len());
        [(left, &self.left.patch), (right, &self.right.patch)].into_iter().flat_map(|(faces, p)| p.inner_edges(faces))
    }
}

/// Fills one half of a cavity.
fn fill(t: &Triangulation, half: &mut Half, filler: &mut Filler, filling: Filling) -> Option<Edges> {
    filler.points.clear();
    filler.points.extend(half.boundary.iter().map(|&v| t.point(v)));
    filler.fill(&mut half.patch, filling)
}
