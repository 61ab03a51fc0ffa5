//! Slots of faces and vertices: taken, appended, freed.

use super::half_edges::{HalfEdge, HalfEdgeMesh};
use super::ids::{FaceId, HalfEdgeId, VertexId};
use super::journal::{Journal, columns};

impl HalfEdgeMesh {
    /// A face slot: the newest freed one, or a new one at the end.
    #[inline(always)]
    pub(crate) fn take_face<J: Journal>(&mut self, j: &mut J) -> FaceId {
        if let Some(f) = self.free_faces.pop() {
            if J::ACTIVE {
                j.note(columns::FACE_REUSED, f.0, u64::from(f.0));
            }
            return f;
        }
        self.take_new_face(j)
    }

    /// A new face slot at the end.
    #[inline(always)]
    pub(super) fn take_new_face<J: Journal>(&mut self, j: &mut J) -> FaceId {
        let f = FaceId::from_index(self.face_slots());
        self.half_edges.extend([HalfEdge::DEAD; 3]);
        self.note_appended([f], j);
        f
    }

    /// Two face slots, as two calls of [`take_face`](Self::take_face) give them.
    #[inline(always)]
    pub(super) fn take_two_faces<J: Journal>(&mut self, j: &mut J) -> [FaceId; 2] {
        if !self.free_faces.is_empty() {
            return [self.take_face(j), self.take_face(j)];
        }
        let f = FaceId::from_index(self.face_slots());
        self.half_edges.extend([HalfEdge::DEAD; 6]);
        let faces = [f, FaceId(f.0 + 1)];
        self.note_appended(faces, j);
        faces
    }

    /// Room for the marks and regions of slots that were appended just now, and their entries in the journal.
    #[inline(always)]
    fn note_appended<J: Journal, const N: usize>(&mut self, faces: [FaceId; N], j: &mut J) {
        if !self.mark.is_empty() {
            self.mark.extend([[0; 3]; N]);
        }
        if !self.region.is_empty() {
            self.region.extend([0; N]);
        }
        if J::ACTIVE {
            faces.iter().for_each(|f| j.note(columns::FACE_APPENDED, f.0, 0));
        }
    }

    /// Frees a face: its slot gets the fixed dead value and goes onto the free list.
    ///
    /// The caller mends twins and vertices that pointed into it.
    pub(crate) fn free_face<J: Journal>(&mut self, f: FaceId, j: &mut J) {
        for h in f.half_edges() {
            self.set_origin(h, VertexId::DEAD, j);
            self.set_twin(h, HalfEdgeId::NONE, j);
            if !self.mark.is_empty() {
                self.set_mark_one_side(h, 0, j);
            }
        }
        self.set_region(f, 0, j);
        self.free_faces.push(f);
        if J::ACTIVE {
            j.note(columns::FACE_FREED, f.0, 0);
        }
    }

    /// A vertex slot: the newest freed one, or a new one at the end. It has no edges yet.
    pub(crate) fn take_vertex<J: Journal>(&mut self, j: &mut J) -> VertexId {
        if let Some(v) = self.free_vertices.pop() {
            if J::ACTIVE {
                j.note(columns::VERTEX_REUSED, v.0, u64::from(v.0));
            }
            return v;
        }
        let v = VertexId::from_index(self.outgoing.len());
        self.outgoing.push(HalfEdgeId::NONE);
        if J::ACTIVE {
            j.note(columns::VERTEX_APPENDED, v.0, 0);
        }
        v
    }

    /// Puts a vertex slot without edges onto the free list.
    pub(crate) fn free_vertex<J: Journal>(&mut self, v: VertexId, j: &mut J) {
        self.free_vertices.push(v);
        if J::ACTIVE {
            j.note(columns::VERTEX_FREED, v.0, 0);
        }
    }

    /// Makes room for that many faces in a mesh without any. It reuses the allocation of `spare`, whose pages are
    /// mapped already.
    pub(crate) fn reserve_faces<T>(&mut self, faces: usize, mut spare: Vec<T>) {
        spare.clear();
        // Collecting in place keeps the allocation of an empty vector whose elements have the same layout.
        self.half_edges = spare.into_iter().map(|_| HalfEdge::DEAD).collect();
        self.half_edges.reserve(3 * faces);
    }

    /// Makes room for so many more vertices with the faces that each brings.
    pub(crate) fn reserve_vertices(&mut self, vertices: usize) {
        let half_edges = 3 * 2 * vertices;
        self.outgoing.reserve(vertices);
        self.half_edges.reserve(half_edges);
        if !self.mark.is_empty() {
            self.mark.reserve(2 * vertices);
        }
        if !self.region.is_empty() {
            self.region.reserve(2 * vertices);
        }
    }
}
