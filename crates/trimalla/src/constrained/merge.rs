//! Merging two subsegments: removes the vertex between them.

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::provenance::Provenance;
use crate::delaunay::{Hole, RemoveError, flip_spokes_away, legalise_hole};
use crate::half_edge::{HalfEdgeId, Journal, VertexId};

impl<J: Journal> Edit<'_, J> {
    /// Takes out Steiner vertex `v`, at which exactly two subsegments of one class meet; they become one edge.
    ///
    /// ```text
    ///         q                      q
    ///       / | \                  /   \
    ///      x ═ v ═ y     ──>      x ═════ y     spokes on each side are flipped away first, but one
    ///       \ | /                  \   /
    ///         d                      d
    /// ```
    ///
    /// After an error the caller takes the changes back.
    ///
    /// # Errors
    /// [`RemoveError`] where other constraints end at `v`, where it is an input vertex, or where the neighbours
    /// leave no room for the straight edge, or where the boundary of a domain is near itself.
    pub fn merge_subsegments(&mut self, v: VertexId) -> Result<HalfEdgeId, RemoveError> {
        let refused =
            RemoveError::Constrained { vertex: v, point: self.points().get(v.index()).copied().unwrap_or_default() };
        let h = match self.subsegments_at(v)[..] {
            [_, ..] if v.index() < self.input_points() => return Err(refused),
            [h, g] if self.mark(h) == self.mark(g) => h,
            [_, _, ..] => return Err(refused),
            _ => return Err(RemoveError::Unused(v)),
        };
        if self.boundary_ends(h).is_some() && self.needs_proof_outside(self.edge_points(h)) {
            return Err(refused);
        }
        let merged = self.try_merge(v).ok_or(refused)?;
        self.data.set_provenance(v, Provenance::Free, self.j);
        let (t, j) = self.parts();
        t.drop_vertex(v, j);
        Ok(merged)
    }

    fn try_merge(&mut self, v: VertexId) -> Option<HalfEdgeId> {
        let mut hole = Hole::default();
        hole.begin(self, v);
        let (t, j) = self.parts();
        flip_spokes_away(t, v, &mut hole, j);
        let spokes: Vec<HalfEdgeId> = self.star(v).collect();
        let h = spokes.iter().copied().find(|&h| self.is_marked(h))?;
        let opposite = self.ccw(self.ccw(h));
        if spokes.len() != 4 || !self.is_marked(opposite) || !self.merged_faces_are_ccw(h, opposite) {
            return None;
        }
        let (t, j) = self.parts();
        let e = t.mesh.unsplit_edge(h, j);
        legalise_hole(self.data.triangulation_mut(), &hole, &mut self.work.lawson, self.j);
        Some(e)
    }
}

impl ConstrainedTriangulation {
    fn subsegments_at(&self, v: VertexId) -> Vec<HalfEdgeId> {
        self.edges_around(v).filter(|&h| self.is_marked(h)).collect()
    }

    fn merged_faces_are_ccw(&self, h: HalfEdgeId, opposite: HalfEdgeId) -> bool {
        let (y, x) = (self.dest(h), self.dest(opposite));
        let (q, d) = (self.dest(self.ccw(h)), self.dest(self.cw(h)));
        let fits = |a, b, c: VertexId| !c.is_finite() || self.is_ccw(a, b, c);
        fits(x, y, q) && fits(y, x, d)
    }
}
