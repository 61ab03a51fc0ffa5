//! Circulators: every neighbourhood as an iterator.

use super::half_edges::HalfEdgeMesh;
use super::ids::{FaceId, HalfEdgeId, VertexId};

/// The outgoing half-edges of a vertex, counter-clockwise, ghosts included.
#[derive(Clone, Debug)]
pub struct Star<'a> {
    mesh: &'a HalfEdgeMesh,
    first: HalfEdgeId,
    current: Option<HalfEdgeId>,
    left: usize,
}

impl Iterator for Star<'_> {
    type Item = HalfEdgeId;

    #[inline]
    fn next(&mut self) -> Option<HalfEdgeId> {
        let h = self.current?;
        let n = self.mesh.ccw(h);
        // A star longer than the mesh means broken twins: ends instead of looping for ever.
        self.left = self.left.saturating_sub(1);
        self.current = (n != self.first && self.left > 0).then_some(n);
        Some(h)
    }
}

/// The boundary half-edges of one loop, the domain on their left.
#[derive(Clone, Debug)]
pub struct BoundaryLoop<'a> {
    mesh: &'a HalfEdgeMesh,
    first: HalfEdgeId,
    current: Option<HalfEdgeId>,
    left: usize,
}

impl Iterator for BoundaryLoop<'_> {
    type Item = HalfEdgeId;

    fn next(&mut self) -> Option<HalfEdgeId> {
        let h = self.current?;
        let n = self.mesh.next_on_boundary(h);
        self.left = self.left.saturating_sub(1);
        self.current = (n != self.first && self.left > 0).then_some(n);
        Some(h)
    }
}

impl HalfEdgeMesh {
    /// The outgoing half-edges of `v`, counter-clockwise, those to infinity included.
    ///
    /// Empty for a vertex without edges.
    #[must_use]
    pub fn star(&self, v: VertexId) -> Star<'_> {
        let current = self.outgoing(v);
        Star { mesh: self, first: current.unwrap_or(HalfEdgeId::NONE), current, left: self.face_slots() }
    }

    /// The outgoing half-edges around the origin of `first`, counter-clockwise, starting with it.
    #[must_use]
    pub fn star_from(&self, first: HalfEdgeId) -> Star<'_> {
        Star { mesh: self, first, current: Some(first), left: self.face_slots() }
    }

    /// The finite edges at `v`, as half-edges that start there.
    pub fn edges_around(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        self.star(v).filter(|&h| self.dest(h).is_finite())
    }

    /// The neighbours of `v`, counter-clockwise.
    ///
    /// # Source
    /// `[Valenzuela09]` algorithm 2.1.
    pub fn neighbours(&self, v: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.edges_around(v).map(|h| self.dest(h))
    }

    /// The real faces at `v`, counter-clockwise.
    pub fn faces_around(&self, v: VertexId) -> impl Iterator<Item = FaceId> + '_ {
        self.star(v).map(HalfEdgeId::face).filter(|&f| !self.is_ghost(f))
    }

    /// The faces across the three edges of `f`: real ones only.
    pub fn adjacent_faces(&self, f: FaceId) -> impl Iterator<Item = FaceId> + '_ {
        f.half_edges().into_iter().map(|h| self.twin(h).face()).filter(|&g| !self.is_ghost(g))
    }

    /// Number of finite edges at `v`.
    #[must_use]
    pub fn degree(&self, v: VertexId) -> usize {
        self.edges_around(v).count()
    }

    /// Whether `v` lies on the hull or on the boundary of a domain: then it has a ghost. `false` for a vertex without
    /// edges.
    ///
    /// # Complexity
    /// The degree of `v`.
    #[must_use]
    pub fn is_boundary_vertex(&self, v: VertexId) -> bool {
        self.star(v).any(|h| self.is_ghost(h.face()))
    }

    /// The boundary half-edge that starts at `v`, the domain on its left; `None` for inner vertices, and for those
    /// without faces.
    ///
    /// Where the boundary passes through `v` several times, it is the first one counter-clockwise from
    /// [`outgoing`](Self::outgoing).
    ///
    /// The source keeps this half-edge at every vertex on the hull, "whenever possible". Here a vertex keeps any of its
    /// half-edges, which makes flips and insertions faster, and this method looks for the boundary one.
    ///
    /// # Complexity
    /// The degree of `v`.
    ///
    /// # Source
    /// Section 2.3 of `[Valenzuela09]`.
    #[must_use]
    pub fn boundary_half_edge(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.star(v).find(|&h| self.is_inner_side_of_boundary(h))
    }

    /// The vertices on the hull or the boundary, by id.
    ///
    /// # Complexity
    /// Linear in the face slots, and O(n log n) in the boundary.
    #[must_use]
    pub fn boundary_vertices(&self) -> Vec<VertexId> {
        let ends = self.ghost_faces().flat_map(|f| self.face_vertices(f)).filter(|v| v.is_finite());
        let mut vertices: Vec<VertexId> = ends.collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// The boundary half-edge that follows boundary half-edge `h`, the domain on the left.
    ///
    /// ```text
    ///        domain
    ///   a ── h ──> b ── next ──> c        the ghosts right of h and next meet in the edge b–∞
    ///     ghost (b,a,∞)  ghost (c,b,∞)
    /// ```
    #[must_use]
    pub fn next_on_boundary(&self, h: HalfEdgeId) -> HalfEdgeId {
        // twin(h) = b→a; its prev is ∞→b, whose twin b→∞ lies in the ghost (c,b,∞) after c→b.
        self.twin(self.twin(self.twin(h).prev()).prev())
    }

    /// The loop of boundary half-edges through `h`.
    #[must_use]
    pub fn boundary_loop(&self, h: HalfEdgeId) -> BoundaryLoop<'_> {
        BoundaryLoop { mesh: self, first: h, current: Some(h), left: self.face_slots() }
    }

    /// One half-edge of every boundary loop, lowest half-edge first.
    #[must_use]
    pub fn boundary_loops(&self) -> Vec<HalfEdgeId> {
        let mut seen = vec![false; self.half_edges.len()];
        let mut firsts = Vec::new();
        for f in self.ghost_faces() {
            let Some(h) = self.ghost_edge(f).map(|g| self.twin(g)) else { continue };
            if seen[h.index()] {
                continue;
            }
            firsts.push(h);
            for b in self.boundary_loop(h) {
                seen[b.index()] = true;
            }
        }
        firsts
    }
}
