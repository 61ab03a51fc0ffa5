//! Faces added and removed one by one, checked: the mesh stays a surface.
//!
//! ```text
//!          y                      A vertex on the boundary has fans of real faces, and between two fans a gap: the ghosts of the edge
//!    fan 1 │ gap                  w–y that ends a fan counter-clockwise and of the edge y–x that begins the next one.
//!   ───────y─────── s             A gap is written (e, s): e = w→y has the last face of a fan on its left, s = y→x the first of
//!    gap   │ fan 2                the next; one fan alone has one gap, from its end to its start.
//!          e
//! ```
//!
//! Either operator says for each of the three corners which gaps are there afterwards, and joins the ghosts
//! accordingly.

use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, NoJournal, VertexId};

/// Why a face cannot be added or removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FaceError {
    /// There is no vertex of that index.
    #[error("there is no vertex {0}")]
    NoSuchVertex(VertexId),
    /// There is no real face of that index.
    #[error("there is no triangle {0}")]
    NoSuchFace(FaceId),
    /// A face has three different vertices.
    #[error("the triangle has vertex {0} twice")]
    RepeatedVertex(VertexId),
    /// A face lies on that side of the edge already.
    #[error("there is a triangle left of the edge from vertex {} to vertex {} already", .0[0], .0[1])]
    EdgeTaken([VertexId; 2]),
    /// Faces lie all around the vertex.
    #[error("vertex {0} has triangles all around it")]
    InnerVertex(VertexId),
    /// Faces would lie all around the vertex, and there would be others at it besides.
    #[error("the triangle would close the ring around vertex {0}, which has other triangles besides")]
    ClosedRing(VertexId),
    /// The vertex is part of a chain of edges without faces.
    #[error("vertex {0} lies on an edge without triangles")]
    OnChain(VertexId),
}

/// A gap between two fans: the boundary half-edge that ends at its vertex, and the one that starts there.
type Gap = (HalfEdgeId, HalfEdgeId);

/// One side of a face that is to be added.
#[derive(Clone, Copy)]
enum Side {
    /// The edge is new: its half-edge in the new face.
    New(HalfEdgeId),
    /// A face lies beyond: its half-edge there.
    Beside(HalfEdgeId),
}

impl HalfEdgeMesh {
    /// A mesh of that many vertices and no faces, to be filled by [`add_face`](Self::add_face).
    #[must_use]
    pub fn of_vertices(count: usize) -> Self {
        Self::with_vertices(count)
    }

    /// Adds the face with these vertices, counter-clockwise; what lies beyond its sides and around its corners follows.
    ///
    /// ```text
    ///        c                     c
    ///         \  face             / \            sides that other faces have become edges between two faces;
    ///          \                 / f \  face     the others bound the mesh
    ///      a    b               a ─── b
    /// ```
    ///
    /// # Guarantees
    /// Every edge has at most one face on each side, and the faces around a vertex are one ring, or fans with gaps
    /// between. Where a vertex gets one fan more, the fan goes into the gap at
    /// [`boundary_half_edge`](Self::boundary_half_edge). Vertices on the boundary keep a boundary half-edge as their
    /// [`outgoing`](Self::outgoing) one.
    ///
    /// # Errors
    /// [`FaceError`], and nothing has changed.
    ///
    /// # Complexity
    /// The degrees of the three vertices.
    ///
    /// # Source
    /// Section 2.4 of `[Valenzuela09]`: connectivity follows when faces are inserted and removed.
    ///
    /// # Examples
    /// ```
    /// use trimalla::half_edge::{HalfEdgeMesh, VertexId};
    ///
    /// let mut mesh = HalfEdgeMesh::of_vertices(4);
    /// let [a, b, c, d] = [0, 1, 2, 3].map(VertexId);
    /// let first = mesh.add_face([a, b, c])?;
    /// let second = mesh.add_face([c, d, a])?;
    /// assert!(mesh.adjacent_faces(first).eq([second]));
    /// assert!(mesh.add_face([a, b, d]).is_err(), "a–b has a face on that side");
    /// mesh.remove_face(first)?;
    /// assert!(mesh.real_faces().eq([second]));
    /// # Ok::<(), trimalla::half_edge::FaceError>(())
    /// ```
    pub fn add_face(&mut self, vertices: [VertexId; 3]) -> Result<FaceId, FaceError> {
        self.check_corners(vertices)?;
        let face = self.free_faces.last().copied().unwrap_or(FaceId::from_index(self.face_slots()));
        let mut sides = [Side::New(HalfEdgeId::NONE); 3];
        for k in 0..3 {
            sides[k] = self.side_beside(face.half_edge(k as u32), vertices[k], vertices[(k + 1) % 3])?;
        }
        let mut gaps = Vec::with_capacity(6);
        for k in 0..3 {
            self.gaps_with_corner(vertices[k], sides[(k + 2) % 3], sides[k], &mut gaps)?;
        }
        let marks = sides.map(|side| if let Side::Beside(h) = side { self.mark(h) } else { 0 });
        for side in sides {
            if let Side::Beside(h) = side {
                self.free_face(self.twin(h).face(), &mut NoJournal);
            }
        }
        // The slot that was the newest free one before the ghosts went, or a new one.
        self.take_known_face(face);
        self.set_face(face, vertices, &mut NoJournal);
        for (h, side) in face.half_edges().into_iter().zip(sides) {
            match side {
                Side::Beside(other) => self.glue(h, other, &mut NoJournal),
                Side::New(_) => drop(self.hang_ghost(h, 0, &mut NoJournal)),
            }
        }
        self.set_marks_one_side(face, marks, &mut NoJournal);
        self.join_gaps(&gaps);
        for (h, v) in face.half_edges().into_iter().zip(vertices) {
            let on_boundary = self.star_from(h).find(|&g| self.is_inner_side_of_boundary(g));
            self.set_outgoing(v, on_boundary.unwrap_or(h), &mut NoJournal);
        }
        Ok(face)
    }

    /// Removes a real face; each side becomes a boundary edge, or goes too where no face lies beyond.
    ///
    /// ```text
    ///        c                     c
    ///       / \                   ∞ \            the sides a–b and c–a had no face beyond: they are gone
    ///      / f \  face     ──>       \  face     the side b–c bounds the mesh
    ///     a ─── b               a  ∞  b
    /// ```
    ///
    /// # Guarantees
    /// Those of [`add_face`](Self::add_face), which takes the removal back but for the slots. A vertex without a face
    /// left has no edge either.
    ///
    /// # Errors
    /// [`FaceError::NoSuchFace`], and nothing has changed.
    ///
    /// # Complexity
    /// The degrees of the three vertices.
    ///
    /// # Source
    /// Section 2.4 of `[Valenzuela09]`.
    pub fn remove_face(&mut self, face: FaceId) -> Result<(), FaceError> {
        if !self.is_real(face) {
            return Err(FaceError::NoSuchFace(face));
        }
        let sides = face.half_edges();
        let beyond = sides.map(|h| Some(self.twin(h)).filter(|&t| self.is_real(t.face())));
        let gaps: Vec<Gap> =
            (0..3).filter_map(|k| self.gap_without_corner(sides[k], beyond[(k + 2) % 3], beyond[k])).collect();
        let vertices = self.face_vertices(face);
        let marks = sides.map(|h| self.mark(h));
        for (h, beyond) in sides.into_iter().zip(beyond) {
            if beyond.is_none() {
                self.free_face(self.twin(h).face(), &mut NoJournal);
            }
        }
        self.free_face(face, &mut NoJournal);
        for (beyond, mark) in beyond.into_iter().zip(marks) {
            if let Some(h) = beyond {
                self.hang_ghost(h, mark, &mut NoJournal);
            }
        }
        self.join_gaps(&gaps);
        for v in vertices {
            let start = gaps.iter().map(|gap| gap.1).find(|&s| self.origin(s) == v);
            self.set_outgoing(v, start.unwrap_or(HalfEdgeId::NONE), &mut NoJournal);
        }
        Ok(())
    }

    /// Refuses vertices that a new face cannot have.
    fn check_corners(&self, [a, b, c]: [VertexId; 3]) -> Result<(), FaceError> {
        for v in [a, b, c] {
            if v.index() >= self.vertex_slots() || self.free_vertices.contains(&v) {
                return Err(FaceError::NoSuchVertex(v));
            }
        }
        if a == b || a == c {
            return Err(FaceError::RepeatedVertex(a));
        }
        if b == c {
            return Err(FaceError::RepeatedVertex(b));
        }
        for v in [a, b, c] {
            let (mut real, mut ghost) = (false, false);
            self.star(v).for_each(|h| if self.is_ghost(h.face()) { ghost = true } else { real = true });
            match (real, ghost) {
                (true, false) => return Err(FaceError::InnerVertex(v)),
                (false, true) => return Err(FaceError::OnChain(v)),
                _ => {}
            }
        }
        Ok(())
    }

    /// What lies beyond the side from `x` to `y` of a new face, in which it will be `h`.
    fn side_beside(&self, h: HalfEdgeId, x: VertexId, y: VertexId) -> Result<Side, FaceError> {
        match self.half_edge_between(x, y) {
            None => Ok(Side::New(h)),
            // Vertices on chains were refused: where a ghost lies on one side, a face lies on the other.
            Some(g) if self.is_ghost(g.face()) => Ok(Side::Beside(self.twin(g))),
            Some(_) => Err(FaceError::EdgeTaken([x, y])),
        }
    }

    /// The gaps that appear or change at corner `y` of a new face, between its sides x→y and y→z.
    fn gaps_with_corner(&self, y: VertexId, in_y: Side, out_y: Side, gaps: &mut Vec<Gap>) -> Result<(), FaceError> {
        match (in_y, out_y) {
            (Side::New(end), Side::New(start)) => match self.boundary_half_edge(y) {
                None => gaps.push((end, start)),
                Some(next) => gaps.extend([(self.end_before(next), start), (end, next)]),
            },
            // The fan that began with y→x begins with the new face.
            (Side::Beside(old_start), Side::New(start)) => gaps.push((self.end_before(old_start), start)),
            (Side::New(end), Side::Beside(old_end)) => gaps.push((end, self.next_on_boundary(old_end))),
            (Side::Beside(start), Side::Beside(end)) => {
                let (next, before) = (self.next_on_boundary(end), self.end_before(start));
                if next != start {
                    let own_end = self.end_of_fan(start);
                    if own_end == end {
                        return Err(FaceError::ClosedRing(y));
                    }
                    // The fans between move behind the one that begins with `start`.
                    gaps.extend([(own_end, next), (before, self.next_on_boundary(own_end))]);
                }
            }
        }
        Ok(())
    }

    /// The gap that appears or changes where a face goes whose side `out` starts at the corner; `in_beyond` and
    /// `out_beyond` are the half-edges of real faces beyond the sides that end and start there.
    fn gap_without_corner(
        &self,
        out: HalfEdgeId,
        in_beyond: Option<HalfEdgeId>,
        out_beyond: Option<HalfEdgeId>,
    ) -> Option<Gap> {
        let end = out_beyond.unwrap_or_else(|| self.end_before(out));
        let start = in_beyond.unwrap_or_else(|| self.next_on_boundary(out.prev()));
        // Where the face is a fan of its own, and the only one, nothing is left at the corner.
        let is_gone = end == out.prev() || start == out;
        (!is_gone).then_some((end, start))
    }

    /// The boundary half-edge that ends where boundary half-edge `start` begins, at the other side of the gap.
    fn end_before(&self, start: HalfEdgeId) -> HalfEdgeId {
        self.twin(self.twin(self.twin(start).next()).next())
    }

    /// The boundary half-edge that ends the fan that boundary half-edge `start` begins, counter-clockwise.
    fn end_of_fan(&self, start: HalfEdgeId) -> HalfEdgeId {
        let mut h = start;
        for _ in 0..self.face_slots() {
            let across = self.twin(h.prev());
            if self.is_ghost(across.face()) {
                break;
            }
            h = across;
        }
        h.prev()
    }

    /// Joins the ghosts on both sides of each gap.
    fn join_gaps(&mut self, gaps: &[Gap]) {
        for &(end, start) in gaps {
            let (to_infinity, from_infinity) = (self.twin(start).next(), self.twin(end).prev());
            self.glue(to_infinity, from_infinity, &mut NoJournal);
        }
    }

    /// Takes a given slot, which is free or the next one at the end.
    fn take_known_face(&mut self, face: FaceId) {
        match self.free_faces.iter().rposition(|&f| f == face) {
            Some(i) => drop(self.free_faces.remove(i)),
            None => drop(self.take_new_face(&mut NoJournal)),
        }
    }
}
