//! Carving: removes what is outside the domain, in one change that can be taken back.

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::flat_hull::leave_out;
use super::outside::Outside;
use crate::half_edge::{FaceId, Journal};
use crate::triangulation::Closure;

impl<J: Journal> Edit<'_, J> {
    /// Removes the real faces that `keep` (one entry a face slot) refuses; ghosts then close the boundary of what
    /// is left, and every edge of that boundary is constrained.
    ///
    /// Returns whether anything was kept; where not, nothing has changed.
    ///
    /// # Complexity
    /// Linear in all faces.
    pub fn carve(&mut self, keep: &[bool]) -> bool {
        if keep.len() < self.face_slots() {
            return false;
        }
        let kept: Vec<bool> = (0..self.face_slots()).map(|f| keep[f] && self.is_real(FaceId::from_index(f))).collect();
        self.carve_real(&kept)
    }

    /// [`carve`](Self::carve) for a `kept` that names real faces only.
    pub(crate) fn carve_real(&mut self, kept: &[bool]) -> bool {
        debug_assert!((0..kept.len()).all(|f| !kept[f] || self.is_real(FaceId::from_index(f))), "a real face");
        let Some(first) = kept.iter().position(|&is_kept| is_kept) else { return false };
        let boundary = self.boundary_of(kept);
        let outside = Outside::beside(self, kept, &boundary, self.outside());
        self.data.outside_mut().set(outside, self.j);
        let (t, j) = self.parts();
        let ghosts = t.mesh.carve(kept, &boundary, j);
        t.set_state(2, Closure::Domain, None, j);
        self.constrain_boundary(&ghosts);
        self.work.hint = FaceId::from_index(first);
        true
    }

    /// Makes the convex hull the domain, without the flat triangles at it; returns whether the triangulation is closed
    /// by a domain now. See [`ConstrainedDelaunay::carve_hull`](super::ConstrainedDelaunay::carve_hull).
    pub fn carve_hull(&mut self) -> bool {
        if self.closure() == Closure::Domain {
            return true;
        }
        let kept = self.faces_within_hull();
        self.carve_real(&kept)
    }

    /// Makes each boundary edge that is part of no segment a segment of its own, numbered after all others in the order
    /// of their vertices, each from its lower end on: refinement splits them and joins others to them as to segments of
    /// the input.
    fn constrain_boundary(&mut self, ghosts: &[FaceId]) {
        let bare = ghosts.iter().filter_map(|&f| self.ghost_edge(f)).filter(|&g| !self.is_marked(g));
        let ends = |g| [self.origin(g).min(self.dest(g)), self.origin(g).max(self.dest(g))];
        let mut bare: Vec<_> = bare.map(|g| (ends(g), g)).collect();
        bare.sort_unstable();
        for (ends, g) in bare {
            let mark = self.data.begin_segment(ends, self.j);
            self.data.set_mark(g, mark, self.j);
        }
    }
}

impl ConstrainedTriangulation {
    /// The real faces (one entry a face slot) without the flat ones at the hull.
    pub(crate) fn faces_within_hull(&self) -> Vec<bool> {
        let mut outside: Vec<bool> = (0..self.face_slots()).map(|f| !self.is_real(FaceId::from_index(f))).collect();
        if self.dimension() == 2 {
            leave_out(self, &mut outside);
        }
        outside.into_iter().map(|is_outside| !is_outside).collect()
    }
}
