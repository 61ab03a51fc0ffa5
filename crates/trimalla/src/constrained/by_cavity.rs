//! Insertion and splits by cavity: what `delaunay::cavity` does, with segments and provenance.

use super::constrained::ConstrainedDelaunay;
use super::provenance::Provenance;
use super::split_subsegment::SplitError;
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed};
use crate::locate::Locus;
use crate::mesh::{FaceId, HalfEdgeId, Journal, VertexId};

/// The cavity of a split, which is the cavity found last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SplitCavity {
    /// Whether the faces beside the edge have the point in their circles, as all others of the cavity have: it may lie off the
    /// edge by its rounding.
    is_proved: bool,
    /// The ends of the edge, if it is one of the border.
    border: Option<[VertexId; 2]>,
}

impl ConstrainedDelaunay {
    /// Inserts a point whose place is known, by cavity; `None`, and nothing changed, where rounding leaves no room.
    pub(crate) fn insert_by_cavity<J: Journal>(&mut self, p: Point, locus: Locus, j: &mut J) -> Option<VertexId> {
        let provenance = match locus {
            Locus::Edge(h) => self.provenance_on(h, p),
            _ => Provenance::Free,
        };
        if !self.cavity.find(&self.t, p, locus) {
            return None;
        }
        let border = match locus {
            Locus::Edge(h) => self.noted_ends(h),
            _ => None,
        };
        let v = self.fill_cavity(p, provenance, j);
        self.note_split(border, v, p, j);
        Some(v)
    }

    /// Finds the cavity of a free point whose place is known; says whether it can be filled.
    pub(crate) fn find_cavity(&mut self, p: Point, locus: Locus) -> bool {
        self.cavity.find(&self.t, p, locus)
    }

    /// Splits a subsegment by cavity.
    ///
    /// # Errors
    /// [`SplitError`]; nothing has changed then.
    pub(crate) fn split_by_cavity<J: Journal>(
        &mut self,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
        j: &mut J,
    ) -> Result<VertexId, SplitError> {
        let found = self.find_split(h, p)?;
        Ok(self.fill_split(found, p, provenance, j))
    }

    /// Finds the cavity of a split, to be filled by [`fill_split`](Self::fill_split).
    ///
    /// # Errors
    /// [`SplitError`].
    pub(crate) fn find_split(&mut self, h: HalfEdgeId, p: Point) -> Result<SplitCavity, SplitError> {
        self.can_split(h, p)?;
        if !self.outside_allows(h, p) || !self.cavity.find(&self.t, p, Locus::Edge(h)) {
            return Err(SplitError::Crowded);
        }
        let holds = |h: HalfEdgeId| !self.t.is_real(h.face()) || self.circle_holds(h.face(), p);
        let is_proved = self.t.side_of(h, p) == Orientation::Collinear || holds(h) && holds(self.t.twin(h));
        Ok(SplitCavity { is_proved, border: self.noted_ends(h) })
    }

    /// Puts a vertex into the cavity found last, which is that of a split.
    pub(crate) fn fill_split<J: Journal>(
        &mut self,
        found: SplitCavity,
        p: Point,
        provenance: Provenance,
        j: &mut J,
    ) -> VertexId {
        let v = self.fill_cavity(p, provenance, j);
        self.note_split(found.border, v, p, j);
        if !found.is_proved {
            self.legalise_spokes(v, j);
        }
        v
    }

    /// Whether the circle of a face holds a point, ties included.
    fn circle_holds(&self, f: FaceId, p: Point) -> bool {
        let [a, b, c] = self.t.face_points(f);
        in_circle_perturbed(a, b, c, p) == CircleSide::Inside
    }

    /// Legalises the spokes of a vertex that has filled its cavity off the edge it parted, by its rounding: where it lies
    /// beyond the circle of a face beside that edge, the face should have stayed. The rim has passed the same test.
    fn legalise_spokes<J: Journal>(&mut self, v: VertexId, j: &mut J) {
        self.t.star(v).for_each(|spoke| self.lawson.push(spoke));
        self.lawson.legalise_all(&mut self.t, j);
    }

    /// Parts the two faces at unconstrained edge `h` into four by a vertex at `p`, and no flips; `None`, and nothing
    /// changed, where the point does not see all four sides.
    pub(crate) fn insert_in_pair<J: Journal>(&mut self, p: Point, h: HalfEdgeId, j: &mut J) -> Option<VertexId> {
        if !self.cavity.take_pair(&self.t, p, h) {
            return None;
        }
        Some(self.fill_cavity(p, Provenance::Free, j))
    }

    /// Whether unconstrained edge `h` between two faces fails the circle test (ties included): its flip is proved then.
    pub(crate) fn fails_circle_test(&self, h: HalfEdgeId) -> bool {
        let o = self.t.twin(h);
        let inner = self.t.is_real(h.face()) && self.t.is_real(o.face()) && !self.t.is_marked(h);
        inner && {
            let [x, y] = self.t.edge_points(h);
            let [q, d] = [h, o].map(|h| self.t.point(self.t.apex(h)));
            in_circle_perturbed(x, y, q, d) == CircleSide::Inside
        }
    }

    /// Flips an edge that fails the circle test.
    pub(crate) fn flip_edge<J: Journal>(&mut self, h: HalfEdgeId, j: &mut J) -> HalfEdgeId {
        self.t.mesh.flip(h, j)
    }

    /// Puts a vertex into the cavity found last, which takes the faces of the fan in its stead.
    pub(crate) fn fill_cavity<J: Journal>(&mut self, p: Point, provenance: Provenance, j: &mut J) -> VertexId {
        let v = self.add_vertex(p, provenance, j);
        self.cavity.fill(&mut self.t, v, j);
        self.last = self.t.outgoing(v).map_or(self.last, |h| h.face());
        v
    }
}
