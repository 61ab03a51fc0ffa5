//! Insertion and splits by cavity: what `delaunay::cavity` does, with segments and provenance.
//!
//! A cavity is found first and filled afterwards. In between the caller may inspect its rim, which has the later
//! neighbours of the vertex and the subsegments opposite it, and give up: nothing has changed yet.

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::provenance::Provenance;
use super::split_subsegment::SplitError;
use crate::delaunay::Cavity;
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed};
use crate::half_edge::{FaceId, HalfEdgeId, Journal, VertexId};
use crate::locate::Locus;

/// What is known of the cavity of a split.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SplitCavity {
    /// Whether the circles of both faces at the edge hold the point, as those of all other faces of the cavity do: it
    /// may lie off the edge by its rounding.
    is_proved: bool,
    /// The ends of the edge, if it is one of the boundary.
    boundary: Option<[VertexId; 2]>,
}

impl ConstrainedTriangulation {
    /// Finds the cavity of a free point at a known locus; returns whether it can be filled.
    pub(crate) fn find_cavity(&self, cavity: &mut Cavity, p: Point, locus: Locus) -> bool {
        cavity.find(self, p, locus)
    }

    /// Finds the cavity of a split.
    ///
    /// # Errors
    /// [`SplitError`].
    pub(crate) fn find_split(
        &mut self,
        cavity: &mut Cavity,
        h: HalfEdgeId,
        p: Point,
    ) -> Result<SplitCavity, SplitError> {
        self.can_split(h, p)?;
        if !self.outside_allows(h, p) || !cavity.find(self, p, Locus::Edge(h)) {
            return Err(SplitError::Crowded);
        }
        let holds = |h: HalfEdgeId| !self.is_real(h.face()) || self.circle_holds(h.face(), p);
        let is_proved = self.side_of(h, p) == Orientation::Collinear || holds(h) && holds(self.twin(h));
        Ok(SplitCavity { is_proved, boundary: self.noted_ends(h) })
    }

    /// Whether the circle of a face holds a point, ties included.
    fn circle_holds(&self, f: FaceId, p: Point) -> bool {
        let [a, b, c] = self.face_points(f);
        in_circle_perturbed(a, b, c, p) == CircleSide::Inside
    }

    /// Whether `h` is an unconstrained edge between two faces that fails the circle test, ties included: then its two
    /// faces form a strictly convex quadrilateral, and it can be flipped.
    #[must_use]
    pub fn fails_circle_test(&self, h: HalfEdgeId) -> bool {
        let o = self.twin(h);
        let inner = self.is_real(h.face()) && self.is_real(o.face()) && !self.is_marked(h);
        inner && {
            let [x, y] = self.edge_points(h);
            let [q, d] = [h, o].map(|h| self.point(self.apex(h)));
            in_circle_perturbed(x, y, q, d) == CircleSide::Inside
        }
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Fills a cavity that was just found with a fan around a new vertex; `cavity` holds the faces of the fan then.
    pub(crate) fn fill_cavity(&mut self, cavity: &mut Cavity, p: Point, provenance: Provenance) -> VertexId {
        let v = self.add_vertex(p, provenance);
        cavity.fill(self.data.triangulation_mut(), v, self.j);
        self.search_from(v);
        v
    }

    /// Fills the cavity of a split that was just found with a fan around a new vertex; returns it, and whether the fan
    /// stayed as it was filled, without flips.
    pub(crate) fn fill_split(
        &mut self,
        cavity: &mut Cavity,
        found: SplitCavity,
        p: Point,
        provenance: Provenance,
    ) -> (VertexId, bool) {
        let v = self.fill_cavity(cavity, p, provenance);
        self.note_split(found.boundary, v, p);
        (v, found.is_proved || self.legalise_spokes(v) == 0)
    }

    /// Legalises the spokes of a vertex that lies off the edge it split, by its rounding: if it lies outside the circle
    /// of a face at that edge, the face should have stayed. The rim has passed the circle test. Returns how many flips
    /// that took.
    fn legalise_spokes(&mut self, v: VertexId) -> u64 {
        self.data.star(v).for_each(|spoke| self.work.lawson.push(spoke));
        self.legalise()
    }

    /// Inserts a point at a known locus by cavity; `None`, and nothing changed, where rounding leaves no room.
    pub(crate) fn insert_by_cavity(&mut self, p: Point, locus: Locus) -> Option<VertexId> {
        let (provenance, boundary) = match locus {
            Locus::Edge(h) => (self.provenance_on(h, p), self.noted_ends(h)),
            _ => (Provenance::Free, None),
        };
        self.with_cavity(|edit, cavity| {
            edit.find_cavity(cavity, p, locus).then(|| {
                let v = edit.fill_cavity(cavity, p, provenance);
                edit.note_split(boundary, v, p);
                v
            })
        })
    }

    /// Splits a subsegment by cavity.
    ///
    /// # Errors
    /// [`SplitError`]; nothing has changed then.
    pub(crate) fn split_by_cavity(
        &mut self,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        self.with_cavity(|edit, cavity| {
            let found = edit.data.find_split(cavity, h, p)?;
            Ok(edit.fill_split(cavity, found, p, provenance).0)
        })
    }

    /// Replaces the two faces at unconstrained edge `h` by four around a vertex at `p`, and flips nothing; `None`, and
    /// nothing changed, where the point does not see all four sides.
    pub(crate) fn insert_in_pair(&mut self, p: Point, h: HalfEdgeId) -> Option<VertexId> {
        self.with_cavity(|edit, cavity| {
            cavity.take_pair(edit.data, p, h).then(|| edit.fill_cavity(cavity, p, Provenance::Free))
        })
    }

    /// Replaces some faces by a fan around a vertex at `p`, and flips nothing; `None`, and nothing changed, where they
    /// are no disk without a vertex inside, are parted by constrained edges, or the point does not see all of their
    /// sides.
    pub(crate) fn insert_in_faces(&mut self, p: Point, faces: &[FaceId]) -> Option<VertexId> {
        self.with_cavity(|edit, cavity| {
            cavity.take_faces(edit.data, p, faces).then(|| edit.fill_cavity(cavity, p, Provenance::Free))
        })
    }

    /// Flips edges at a vertex and opposite it, and beside flipped ones, until all pass the circle test.
    pub(crate) fn legalise_around(&mut self, v: VertexId) {
        let star: Vec<HalfEdgeId> = self.data.star(v).flat_map(|spoke| [spoke, spoke.next()]).collect();
        star.into_iter().for_each(|h| self.work.lawson.push(h));
        self.legalise();
    }

    /// Calls `act` with the cavity of the workspace.
    fn with_cavity<T>(&mut self, act: impl FnOnce(&mut Self, &mut Cavity) -> T) -> T {
        let mut cavity = std::mem::take(&mut self.work.cavity);
        let result = act(self, &mut cavity);
        self.work.cavity = cavity;
        result
    }
}
