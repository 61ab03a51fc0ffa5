//! Changes of a constrained triangulation: vertices in, out and elsewhere.

use std::ops::Deref;

use super::constrained_triangulation::ConstrainedTriangulation;
use super::provenance::Provenance;
use super::regions::RegionRule;
use super::workspace::Workspace;
use crate::delaunay::{BuildError, Inserted, RemoveError, insert_at, remove_vertex};
use crate::geometry::Point;
use crate::half_edge::{FaceId, HalfEdgeId, Journal, UndoLog, VertexId};
use crate::locate::Locus;
use crate::triangulation::{Closure, Triangulation};

/// A constrained triangulation that is being changed, with a workspace, and with a journal of the overwritten entries.
///
/// # Guarantees
/// Each operation is done as a whole or changes nothing, and leaves a triangulation. If all edges passed the circle
/// test before, they do so after, except for the operations that say otherwise.
#[derive(Debug)]
pub struct Edit<'a, J> {
    pub(super) data: &'a mut ConstrainedTriangulation,
    pub(super) work: &'a mut Workspace,
    pub(super) j: &'a mut J,
}

/// An edit is read as the triangulation that it changes.
impl<J> Deref for Edit<'_, J> {
    type Target = ConstrainedTriangulation;

    #[inline(always)]
    fn deref(&self) -> &ConstrainedTriangulation {
        self.data
    }
}

impl<'a, J: Journal> Edit<'a, J> {
    #[inline(always)]
    pub(super) fn new(data: &'a mut ConstrainedTriangulation, work: &'a mut Workspace, j: &'a mut J) -> Self {
        Self { data, work, j }
    }

    /// Calls `act` with another journal.
    pub fn with_log<K: Journal, T>(&mut self, log: &mut K, act: impl FnOnce(&mut Edit<'_, K>) -> T) -> T {
        act(&mut Edit::new(self.data, self.work, log))
    }

    /// The triangulation and the journal.
    #[inline(always)]
    pub(super) fn parts(&mut self) -> (&mut Triangulation, &mut J) {
        (self.data.triangulation_mut(), self.j)
    }

    /// Lets the next point location start at a vertex.
    #[inline(always)]
    pub(super) fn search_from(&mut self, v: VertexId) {
        self.work.hint = self.data.outgoing(v).map_or(self.work.hint, HalfEdgeId::face);
    }

    /// Pushes an edge that [`legalise`](Self::legalise) is to test.
    pub(super) fn push(&mut self, h: HalfEdgeId) {
        self.work.lawson.push(h);
    }

    /// Flips the edges on the stack, and those beside them, until all pass the circle test; returns how many flips it
    /// took.
    pub(super) fn legalise(&mut self) -> u64 {
        self.work.lawson.legalise_all(self.data.triangulation_mut(), self.j)
    }

    /// Inserts a point; on a constrained edge it splits it.
    ///
    /// # Errors
    /// [`BuildError::NotFinite`]; [`BuildError::TooManyPoints`]; [`BuildError::OutsideDomain`] where the exterior was
    /// carved away.
    ///
    /// # Complexity
    /// A walk from the last insertion and about three flips.
    pub fn insert(&mut self, p: Point) -> Result<Inserted, BuildError> {
        let points = self.points().len();
        if !p.is_finite() {
            return Err(BuildError::NotFinite { index: points, point: p });
        }
        match self.locate_from(self.work.hint, p) {
            Locus::Vertex(v) => Ok(Inserted::Existing(v)),
            Locus::Outside(_) if self.closure() == Closure::Domain => Err(BuildError::OutsideDomain(p)),
            locus => {
                BuildError::if_too_many(points, 1)?;
                Ok(Inserted::New(self.insert_vertex_at(p, locus)))
            }
        }
    }

    /// Inserts a point at a known locus.
    pub(crate) fn insert_vertex_at(&mut self, p: Point, locus: Locus) -> VertexId {
        let (provenance, boundary) = match locus {
            Locus::Edge(h) => (self.provenance_on(h, p), self.noted_ends(h)),
            _ => (Provenance::Free, None),
        };
        let v = self.add_vertex(p, provenance);
        insert_at::<false, _>(self.data.triangulation_mut(), v, locus, &mut self.work.lawson, self.j);
        self.note_split(boundary, v, p);
        self.search_from(v);
        v
    }

    /// Inserts a point whose place is known, without flips: the circle test may fail afterwards. `None`, and nothing
    /// changed, where rounding leaves no room.
    pub(crate) fn place_vertex_at(&mut self, p: Point, locus: Locus) -> Option<VertexId> {
        match locus {
            Locus::Face(f) => {
                let v = self.add_vertex(p, Provenance::Free);
                let (t, j) = self.parts();
                t.mesh.split_face(f, v, j);
                Some(v)
            }
            Locus::Edge(h) => self.cut_subsegment(h, p, self.provenance_on(h, p)).ok(),
            _ => None,
        }
    }

    /// Sets the rules of all regions; faces name regions from 1 on ([`set_region`](Self::set_region)).
    pub(crate) fn set_regions(&mut self, rules: Vec<RegionRule>) {
        self.data.set_regions(rules, self.j);
    }

    /// Puts a face into a region, counted from 1; 0 for none.
    pub(crate) fn set_region(&mut self, f: FaceId, region: u32) {
        self.data.set_region(f, region, self.j);
    }

    /// Adds an unused vertex with a provenance.
    pub(super) fn add_vertex(&mut self, p: Point, provenance: Provenance) -> VertexId {
        self.data.add_vertex(p, provenance, self.j)
    }

    /// Sorts the duplicates that [`use_vertex`](Self::use_vertex) has noted.
    pub(crate) fn sort_duplicates(&mut self) {
        self.data.triangulation_mut().sort_duplicates();
    }

    /// Inserts an input vertex that is still unused; a duplicate of a used vertex is noted as one.
    pub(crate) fn use_vertex(&mut self, v: VertexId) {
        let p = self.point(v);
        match self.locate_from(self.work.hint, p) {
            Locus::Vertex(w) => {
                let (t, j) = self.parts();
                t.note_duplicate(v, w, j);
            }
            locus => {
                insert_at::<false, _>(self.data.triangulation_mut(), v, locus, &mut self.work.lawson, self.j);
                self.search_from(v);
            }
        }
    }

    /// Removes a vertex at which no constrained edge ends.
    ///
    /// # Errors
    /// See [`RemoveError`].
    ///
    /// # Complexity
    /// Linear in its degree, and the flips that follow.
    pub fn remove(&mut self, v: VertexId) -> Result<(), RemoveError> {
        remove_vertex(self.data.triangulation_mut(), v, &mut self.work.lawson, self.j)?;
        if v.index() >= self.input_points() {
            self.data.set_provenance(v, Provenance::Free, self.j);
            let (t, j) = self.parts();
            t.drop_vertex(v, j);
        }
        Ok(())
    }

    /// Replaces an edge by the other diagonal of its two faces, whatever the circle test says, if both new faces are
    /// strictly counter-clockwise.
    ///
    /// Refused, with `None` and nothing changed: constrained edges, edges of the boundary, and quadrilaterals that are
    /// not strictly convex. Returns the new diagonal.
    pub fn try_flip(&mut self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let (t, j) = self.parts();
        t.try_flip(h, j)
    }
}

/// Edits that can be taken back.
impl Edit<'_, UndoLog> {
    /// Calls `act`, and takes its changes back if it ends in an error.
    pub(super) fn atomically<T, E>(&mut self, act: impl FnOnce(&mut Self) -> Result<T, E>) -> Result<T, E> {
        let here = self.j.checkpoint();
        let result = act(self);
        if result.is_err() {
            self.data.rollback(self.j, here);
        }
        result
    }
}
