//! The flat half-edge arrays and the functions that write them; [`super::slots`] appends and frees slots.

use super::circulators::Star;
use super::ids::{FaceId, HalfEdgeId, VertexId};
use super::journal::{Entry, Journal, columns};

/// How many spokes of one vertex are searched before the search goes on at both vertices in turn.
const FIRST_SPOKES: usize = 16;

/// The record of a half-edge: both fields are nearly always read and written together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct HalfEdge {
    pub(super) origin: VertexId,
    pub(super) twin: HalfEdgeId,
}

impl HalfEdge {
    /// The record in a dead slot.
    pub(super) const DEAD: Self = Self { origin: VertexId::DEAD, twin: HalfEdgeId::NONE };
}

/// Triangles as triples of half-edges, closed to a sphere by ghost faces.
///
/// # Shape
/// `half_edges`, that is `origin` and `twin`, has three entries a face slot, `outgoing` one a vertex slot.
/// `mark` is empty until the first constraint and has one entry a face slot from then on, for its three half-edges. A
/// dead slot holds one fixed value; free lists are last in, first out.
///
/// # Guarantees
/// Equality compares every array, dead slots and free lists included: two equal meshes answer every
/// later operator alike.
#[doc(alias = "DCEL")]
#[doc(alias = "doubly connected edge list")]
#[doc(alias = "halfedge")]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct HalfEdgeMesh {
    pub(super) half_edges: Vec<HalfEdge>,
    pub(super) mark: Vec<[u32; 3]>,
    /// Region a face lies in; empty until the first region, 0 for none.
    pub(super) region: Vec<u32>,
    pub(super) outgoing: Vec<HalfEdgeId>,
    pub(super) free_faces: Vec<FaceId>,
    pub(super) free_vertices: Vec<VertexId>,
}

/// Whether none of a slot's vertices is dead or at infinity: those two ids are above all others.
#[inline]
fn are_ordinary(slot: &[HalfEdge]) -> bool {
    // One comparison of the maximum replaces three.
    slot.iter().fold(VertexId(0), |greatest, h| greatest.max(h.origin)) < VertexId::DEAD
}

/// Reading.
impl HalfEdgeMesh {
    /// The vertex a half-edge starts at.
    #[must_use]
    #[inline]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.half_edges[h.index()].origin
    }

    /// The vertex a half-edge ends at.
    #[must_use]
    #[inline]
    pub fn dest(&self, h: HalfEdgeId) -> VertexId {
        self.half_edges[h.next().index()].origin
    }

    /// The vertex opposite a half-edge in its face.
    #[must_use]
    #[inline]
    pub fn apex(&self, h: HalfEdgeId) -> VertexId {
        self.half_edges[h.prev().index()].origin
    }

    /// The other side of a half-edge.
    #[must_use]
    #[inline]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.half_edges[h.index()].twin
    }

    /// The next outgoing half-edge counter-clockwise around the origin.
    #[must_use]
    #[inline]
    pub fn ccw(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twin(h.prev())
    }

    /// The next outgoing half-edge clockwise around the origin.
    #[must_use]
    #[inline]
    pub fn cw(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twin(h).next()
    }

    /// The constraint mark of a half-edge, 0 for none.
    #[must_use]
    #[inline]
    pub fn mark(&self, h: HalfEdgeId) -> u32 {
        // Empty without constraints.
        self.mark.as_flattened().get(h.index()).copied().unwrap_or(0)
    }

    /// Whether a half-edge carries a constraint mark.
    #[must_use]
    #[inline]
    pub fn is_marked(&self, h: HalfEdgeId) -> bool {
        self.mark(h) != 0
    }

    /// Whether a side of a face carries a constraint mark.
    #[inline]
    pub(crate) fn has_marked_side(&self, f: FaceId) -> bool {
        self.mark.get(f.index()).is_some_and(|marks| marks[0] | marks[1] | marks[2] != 0)
    }

    /// The region of a face, 0 for none.
    #[must_use]
    #[inline]
    pub fn region(&self, f: FaceId) -> u32 {
        self.region.get(f.index()).copied().unwrap_or(0)
    }

    /// A half-edge that starts at `v`; `None` where the vertex has no edges.
    #[must_use]
    #[inline]
    pub fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.outgoing.get(v.index()).and_then(|h| h.some())
    }

    /// Vertices of a face, counter-clockwise.
    #[must_use]
    #[inline]
    pub fn face_vertices(&self, f: FaceId) -> [VertexId; 3] {
        self.face(f).map(|h| h.origin)
    }

    /// The vertices in the record of a slot; `None` where there is no such slot.
    #[inline]
    pub(crate) fn vertices_in_slot(&self, f: FaceId) -> Option<[VertexId; 3]> {
        let k = f.index() * 3;
        self.half_edges.get(k..k + 3).map(|stored| [stored[0].origin, stored[1].origin, stored[2].origin])
    }

    /// The records of a face's half-edges.
    #[inline(always)]
    pub(super) fn face(&self, f: FaceId) -> [HalfEdge; 3] {
        let k = f.index() * 3;
        let stored = &self.half_edges[k..k + 3];
        [stored[0], stored[1], stored[2]]
    }

    /// Whether a slot holds a face (a ghost included).
    #[must_use]
    #[inline]
    pub fn is_alive(&self, f: FaceId) -> bool {
        self.half_edges.get(f.index() * 3).is_some_and(|h| h.origin != VertexId::DEAD)
    }

    /// Whether a face has the vertex at infinity.
    #[must_use]
    #[inline]
    pub fn is_ghost(&self, f: FaceId) -> bool {
        let [a, b, c] = self.face_vertices(f);
        !(a.is_finite() && b.is_finite() && c.is_finite())
    }

    /// Whether a slot holds a face of three finite vertices.
    #[must_use]
    #[inline]
    pub fn is_real(&self, f: FaceId) -> bool {
        let k = f.index() * 3;
        self.half_edges.get(k..k + 3).is_some_and(are_ordinary)
    }

    /// The finite edge of a ghost face: the half-edge opposite the vertex at infinity.
    #[must_use]
    #[inline]
    pub fn ghost_edge(&self, f: FaceId) -> Option<HalfEdgeId> {
        f.half_edges().into_iter().find(|&h| !self.apex(h).is_finite())
    }

    /// Whether a half-edge has a real face to its left and a ghost to its right.
    #[must_use]
    #[inline]
    pub fn is_inner_side_of_boundary(&self, h: HalfEdgeId) -> bool {
        self.is_real(h.face()) && self.is_ghost(self.twin(h).face())
    }

    /// Whether a real face lies on just one side of an edge.
    #[must_use]
    #[inline]
    pub fn is_boundary_edge(&self, h: HalfEdgeId) -> bool {
        self.is_real(h.face()) != self.is_real(self.twin(h).face())
    }

    /// Number of face slots, dead and ghost ones included.
    #[must_use]
    pub fn face_slots(&self) -> usize {
        self.half_edges.len() / 3
    }

    /// Number of vertex slots, unused ones included.
    #[must_use]
    pub fn vertex_slots(&self) -> usize {
        self.outgoing.len()
    }

    /// Number of faces, ghosts included.
    #[must_use]
    pub fn live_faces(&self) -> usize {
        self.face_slots() - self.free_faces.len()
    }

    /// Face slots that are free, the next one to be used last.
    #[must_use]
    pub fn free_faces(&self) -> &[FaceId] {
        &self.free_faces
    }

    /// Vertex slots that are free.
    #[must_use]
    pub fn free_vertices(&self) -> &[VertexId] {
        &self.free_vertices
    }

    /// Whether constraint marks are kept.
    #[must_use]
    pub fn has_marks(&self) -> bool {
        !self.mark.is_empty()
    }

    /// The real faces, oldest slot first.
    pub fn real_faces(&self) -> impl DoubleEndedIterator<Item = FaceId> + '_ {
        let faces = self.half_edges.chunks_exact(3).enumerate();
        faces.filter(|(_, v)| are_ordinary(v)).map(|(f, _)| FaceId::from_index(f))
    }

    /// The [`real_faces`](Self::real_faces) with their vertices.
    pub(crate) fn real_triangles(&self) -> impl Iterator<Item = (FaceId, [VertexId; 3])> + '_ {
        let faces = self.half_edges.chunks_exact(3).enumerate();
        let real = faces.filter(|(_, stored)| are_ordinary(stored));
        real.map(|(f, stored)| (FaceId::from_index(f), [stored[0].origin, stored[1].origin, stored[2].origin]))
    }

    /// The corners of the [`real_faces`](Self::real_faces), written into the allocation of the marks: it has the right
    /// size, and its pages are mapped already.
    pub(crate) fn into_triangles(mut self) -> Vec<[u32; 3]> {
        let mut triangles = std::mem::take(&mut self.mark);
        triangles.clear();
        triangles.extend(self.real_triangles().map(|(_, corners)| corners.map(|v| v.0)));
        triangles
    }

    /// The ghost faces, oldest slot first.
    pub fn ghost_faces(&self) -> impl DoubleEndedIterator<Item = FaceId> + '_ {
        let faces = self.half_edges.chunks_exact(3).enumerate();
        let ghosts = faces.filter(|(_, stored)| stored.iter().any(|h| !h.origin.is_finite()));
        ghosts.map(|(f, _)| FaceId::from_index(f))
    }

    /// The half-edge from `a` to `b`, if there is one.
    ///
    /// # Complexity
    /// The lower one of the degrees of `a` and `b`.
    #[must_use]
    pub fn half_edge_between(&self, a: VertexId, b: VertexId) -> Option<HalfEdgeId> {
        let mut around_a = self.star(a);
        for h in around_a.by_ref().take(FIRST_SPOKES) {
            if self.dest(h) == b {
                return Some(h);
            }
        }
        self.half_edge_at_hub(around_a, a, self.star(b))
    }

    /// The half-edge to the centre of the second star. The search takes the other spokes of `a` and those of the second
    /// star in turn, and ends with the shorter star.
    #[cold]
    #[inline(never)]
    fn half_edge_at_hub(&self, around_a: Star<'_>, a: VertexId, around_b: Star<'_>) -> Option<HalfEdgeId> {
        let b = around_b.clone().next().map(|h| self.origin(h))?;
        for (h, g) in around_a.zip(around_b) {
            if self.dest(h) == b {
                return Some(h);
            }
            if self.dest(g) == a {
                return Some(self.twin(g));
            }
        }
        None
    }

    /// The half-edge from `a` to `b`; `known` was it at some time and mostly still is, which saves the search.
    pub(crate) fn half_edge_between_known(&self, a: VertexId, b: VertexId, known: HalfEdgeId) -> Option<HalfEdgeId> {
        let is_there = self.half_edges.get(known.index()).is_some_and(|h| h.origin == a) && self.dest(known) == b;
        if is_there { Some(known) } else { self.half_edge_between(a, b) }
    }
}

/// Writing: nothing outside of this file and `slots.rs` touches the arrays.
impl HalfEdgeMesh {
    /// A mesh of unused vertices and no faces, with room for the faces of a triangulation of them.
    #[must_use]
    pub(crate) fn with_vertices(vertices: usize) -> Self {
        Self { outgoing: vec![HalfEdgeId::NONE; vertices], ..Self::default() }
    }

    /// A mesh from finished `origin` and `twin` arrays, as bulk builders make them.
    ///
    /// # Complexity
    /// Linear.
    pub(crate) fn from_arrays(origin: Vec<VertexId>, twin: Vec<HalfEdgeId>, vertices: usize) -> Self {
        let half_edges = origin.into_iter().zip(twin).map(|(origin, twin)| HalfEdge { origin, twin }).collect();
        let mut mesh = Self { half_edges, ..Self::default() };
        mesh.keep_half_edges(vertices);
        mesh
    }

    /// Gives every vertex with edges one of its half-edges, in one pass; the last step of bulk builders.
    pub(crate) fn keep_half_edges(&mut self, vertices: usize) {
        self.outgoing.clear();
        self.outgoing.resize(vertices, HalfEdgeId::NONE);
        for (i, h) in self.half_edges.iter().enumerate() {
            if let Some(slot) = self.outgoing.get_mut(h.origin.index()) {
                *slot = HalfEdgeId::from_index(i);
            }
        }
    }

    #[inline(always)]
    pub(super) fn set_origin<J: Journal>(&mut self, h: HalfEdgeId, v: VertexId, j: &mut J) {
        let slot = &mut self.half_edges[h.index()].origin;
        if J::ACTIVE {
            j.note(columns::ORIGIN, h.0, u64::from(slot.0));
        }
        *slot = v;
    }

    #[inline(always)]
    pub(super) fn set_twin<J: Journal>(&mut self, h: HalfEdgeId, t: HalfEdgeId, j: &mut J) {
        let slot = &mut self.half_edges[h.index()].twin;
        if J::ACTIVE {
            j.note(columns::TWIN, h.0, u64::from(slot.0));
        }
        *slot = t;
    }

    /// Writes origin and twin of a half-edge.
    #[inline(always)]
    pub(super) fn set_half_edge<J: Journal>(&mut self, h: HalfEdgeId, new: HalfEdge, j: &mut J) {
        let slot = &mut self.half_edges[h.index()];
        if J::ACTIVE {
            j.note(columns::ORIGIN, h.0, u64::from(slot.origin.0));
            j.note(columns::TWIN, h.0, u64::from(slot.twin.0));
        }
        *slot = new;
    }

    /// Writes the three vertices of a face and the twins of its half-edges.
    #[inline(always)]
    pub(super) fn set_vertices_and_twins<J: Journal>(
        &mut self,
        f: FaceId,
        v: [VertexId; 3],
        twin: [HalfEdgeId; 3],
        j: &mut J,
    ) {
        let k = f.index() * 3;
        let stored = &mut self.half_edges[k..k + 3];
        for (i, slot) in stored.iter_mut().enumerate() {
            if J::ACTIVE {
                j.note(columns::ORIGIN, f.half_edges()[i].0, u64::from(slot.origin.0));
                j.note(columns::TWIN, f.half_edges()[i].0, u64::from(slot.twin.0));
            }
            *slot = HalfEdge { origin: v[i], twin: twin[i] };
        }
    }

    /// Makes two half-edges each other's twin.
    #[inline(always)]
    pub(crate) fn glue<J: Journal>(&mut self, a: HalfEdgeId, b: HalfEdgeId, j: &mut J) {
        self.set_twin(a, b, j);
        self.set_twin(b, a, j);
    }

    /// Sets the constraint mark of one half-edge; the caller sets the twin's.
    #[inline(always)]
    pub(super) fn set_mark_one_side<J: Journal>(&mut self, h: HalfEdgeId, m: u32, j: &mut J) {
        let slot = &mut self.mark.as_flattened_mut()[h.index()];
        if *slot != m {
            if J::ACTIVE {
                j.note(columns::MARK, h.0, u64::from(*slot));
            }
            *slot = m;
        }
    }

    /// Sets the constraint marks of a face's half-edges, where marks are kept; the caller sets those of the twins.
    #[inline(always)]
    pub(super) fn set_marks_one_side<J: Journal>(&mut self, f: FaceId, marks: [u32; 3], j: &mut J) {
        let Some(stored) = self.mark.get_mut(f.index()) else { return };
        for (h, (slot, new)) in f.half_edges().into_iter().zip(stored.iter_mut().zip(marks)) {
            if J::ACTIVE && *slot != new {
                j.note(columns::MARK, h.0, u64::from(*slot));
            }
            *slot = new;
        }
    }

    /// Sets the constraint mark of an edge, both sides.
    pub(crate) fn set_mark<J: Journal>(&mut self, h: HalfEdgeId, m: u32, j: &mut J) {
        if self.mark.is_empty() {
            if m == 0 {
                return;
            }
            self.begin_marks();
            if J::ACTIVE {
                j.note(columns::MARKS_ADDED, 0, 0);
            }
        }
        self.set_mark_one_side(h, m, j);
        self.set_mark_one_side(self.twin(h), m, j);
    }

    /// Begins to keep marks: makes room for those of all faces, none of which has one yet.
    #[cold]
    #[inline(never)]
    fn begin_marks(&mut self) {
        if self.mark.capacity() == 0 {
            // Zeroed memory: pages without a mark are never mapped.
            self.mark = vec![[0; 3]; self.face_slots()];
        } else {
            self.mark.resize(self.face_slots(), [0; 3]);
        }
    }

    /// Reserves memory for marks, for a caller that will read those of all faces. It is written as a whole then: pages
    /// of zeroed memory would be mapped twice, at the first read and at the first write.
    pub(crate) fn reserve_marks(&mut self) {
        self.mark.reserve_exact(self.face_slots());
    }

    /// Sets the region of a face.
    #[inline(always)]
    pub(crate) fn set_region<J: Journal>(&mut self, f: FaceId, region: u32, j: &mut J) {
        if self.region.is_empty() {
            if region == 0 {
                return;
            }
            self.begin_regions(j);
        }
        let slot = &mut self.region[f.index()];
        if *slot != region {
            if J::ACTIVE {
                j.note(columns::REGION, f.0, u64::from(*slot));
            }
            *slot = region;
        }
    }

    /// Begins to keep regions: makes room for those of all faces, none of which lies in one yet.
    #[cold]
    #[inline(never)]
    fn begin_regions<J: Journal>(&mut self, j: &mut J) {
        self.region = vec![0; self.face_slots()];
        if J::ACTIVE {
            j.note(columns::REGIONS_ADDED, 0, 0);
        }
    }

    #[inline(always)]
    pub(crate) fn set_outgoing<J: Journal>(&mut self, v: VertexId, h: HalfEdgeId, j: &mut J) {
        if let Some(slot) = self.outgoing.get_mut(v.index()) {
            if J::ACTIVE {
                j.note(columns::OUTGOING, v.0, u64::from(slot.0));
            }
            *slot = h;
        }
    }

    /// Points `v` to `to` where it pointed to `from`.
    #[inline(always)]
    pub(super) fn move_outgoing<J: Journal>(&mut self, v: VertexId, from: HalfEdgeId, to: HalfEdgeId, j: &mut J) {
        if self.outgoing.get(v.index()) == Some(&from) {
            self.set_outgoing(v, to, j);
        }
    }

    /// Points `v` to `to` where the half-edge it kept no longer starts at it.
    #[inline]
    pub(crate) fn rehome<J: Journal>(&mut self, v: VertexId, to: HalfEdgeId, j: &mut J) {
        if self.outgoing(v).is_some_and(|h| self.origin(h) != v) {
            self.set_outgoing(v, to, j);
        }
    }

    /// Writes the three vertices of a face.
    #[inline]
    pub(crate) fn set_face<J: Journal>(&mut self, f: FaceId, v: [VertexId; 3], j: &mut J) {
        for (h, v) in f.half_edges().into_iter().zip(v) {
            self.set_origin(h, v, j);
        }
    }

    /// Puts back one overwritten entry; says whether the column is one of the mesh's.
    pub(crate) fn undo(&mut self, entry: Entry) -> bool {
        let i = entry.index as usize;
        #[allow(clippy::cast_possible_truncation, reason = "these columns were widened from u32")]
        let old = entry.old as u32;
        match entry.column {
            columns::ORIGIN => self.half_edges[i].origin = VertexId(old),
            columns::TWIN => self.half_edges[i].twin = HalfEdgeId(old),
            columns::MARK => self.mark.as_flattened_mut()[i] = old,
            columns::MARKS_ADDED => self.mark.clear(),
            columns::REGION => self.region[i] = old,
            columns::REGIONS_ADDED => self.region.clear(),
            columns::OUTGOING => self.outgoing[i] = HalfEdgeId(old),
            columns::FACE_APPENDED => {
                self.half_edges.truncate(3 * i);
                self.mark.truncate(i);
                self.region.truncate(i);
            }
            columns::FACE_FREED => drop(self.free_faces.pop()),
            columns::FACE_REUSED => self.free_faces.push(FaceId(old)),
            columns::VERTEX_APPENDED => self.outgoing.truncate(i),
            columns::VERTEX_FREED => drop(self.free_vertices.pop()),
            columns::VERTEX_REUSED => self.free_vertices.push(VertexId(old)),
            _ => return false,
        }
        true
    }

    /// Ends a bulk build: renames the vertices from storage order to the caller's ids, and gives each one of its
    /// half-edges.
    ///
    /// # Complexity
    /// Linear; one look-up a half-edge.
    pub(crate) fn name_vertices(&mut self, names: &[VertexId], vertices: usize) {
        let mut outgoing = vec![HalfEdgeId::NONE; vertices];
        for (i, h) in self.half_edges.iter_mut().enumerate() {
            if let Some(&name) = names.get(h.origin.index()) {
                h.origin = name;
                outgoing[name.index()] = HalfEdgeId::from_index(i);
            }
        }
        self.outgoing = outgoing;
    }
}
