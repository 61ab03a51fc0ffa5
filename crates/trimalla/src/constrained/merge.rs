//! Merging two subsegments: the vertex between them taken out.

use super::constrained::ConstrainedDelaunay;
use crate::delaunay::{Hole, RemoveError, flip_spokes_away, legalise_hole};
use crate::mesh::{HalfEdgeId, UndoLog, VertexId};

impl ConstrainedDelaunay {
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
    /// # Errors
    /// [`RemoveError`] where other constraints end at `v`, where it is an input vertex, or where the neighbours
    /// leave no room for the straight edge, or where the border of a domain is near itself; nothing has changed then.
    pub fn merge_subsegments(&mut self, v: VertexId, log: &mut UndoLog) -> Result<HalfEdgeId, RemoveError> {
        let refused =
            RemoveError::Constrained { vertex: v, point: self.t.points().get(v.index()).copied().unwrap_or_default() };
        let Some(&[h, g]) = self.subsegments_at(v).as_slice().first_chunk::<2>() else {
            return Err(RemoveError::Unused(v));
        };
        if v.index() < self.input_points || self.subsegments_at(v).len() != 2 || self.t.mark(h) != self.t.mark(g) {
            return Err(refused);
        }
        let here = log.checkpoint();
        let ends = self.t.edge_points(h);
        if self.border_ends(h).is_some() && self.needs_proof_outside(ends) {
            return Err(refused);
        }
        if let Some(e) = self.try_merge(v, log) {
            self.set_provenance(v, super::Provenance::Free, log);
            self.t.drop_vertex(v, log);
            return Ok(e);
        }
        self.rollback(log, here);
        Err(refused)
    }

    fn subsegments_at(&self, v: VertexId) -> Vec<HalfEdgeId> {
        self.t.edges_around(v).filter(|&h| self.t.is_marked(h)).collect()
    }

    fn try_merge(&mut self, v: VertexId, log: &mut UndoLog) -> Option<HalfEdgeId> {
        let mut hole = Hole::default();
        hole.begin(&self.t, v);
        flip_spokes_away(&mut self.t, v, &mut hole, log);
        let spokes: Vec<HalfEdgeId> = self.t.star(v).collect();
        let h = spokes.iter().copied().find(|&h| self.t.is_marked(h))?;
        let opposite = self.t.ccw(self.t.ccw(h));
        if spokes.len() != 4 || !self.t.is_marked(opposite) || !self.merged_faces_are_ccw(h, opposite) {
            return None;
        }
        let e = self.t.mesh.unsplit_edge(h, log);
        legalise_hole(&mut self.t, &hole, &mut self.lawson, log);
        Some(e)
    }

    fn merged_faces_are_ccw(&self, h: HalfEdgeId, opposite: HalfEdgeId) -> bool {
        let (y, x) = (self.t.dest(h), self.t.dest(opposite));
        let (q, d) = (self.t.dest(self.t.ccw(h)), self.t.dest(self.t.cw(h)));
        let fits = |a, b, c: VertexId| !c.is_finite() || self.t.is_ccw(a, b, c);
        fits(x, y, q) && fits(y, x, d)
    }
}
