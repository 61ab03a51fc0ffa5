//! Carving: what is outside away, in one change that can be taken back.

use crate::constrained::{ConstrainedDelaunay, Outside};
use crate::mesh::{FaceId, Journal};
use crate::triangulation::Closure;

impl ConstrainedDelaunay {
    /// Removes the real faces that `keep` (one entry a face slot) refuses; ghosts then close the border of what
    /// is left, and every edge of that border is constrained.
    ///
    /// Returns whether anything was kept; where not, nothing has changed.
    ///
    /// # Guarantees
    /// One change: a rollback puts all faces back into their slots.
    ///
    /// # Complexity
    /// Linear in all faces.
    pub fn carve<J: Journal>(&mut self, keep: &[bool], j: &mut J) -> bool {
        if keep.len() < self.face_slots() {
            return false;
        }
        let kept: Vec<bool> = (0..self.face_slots()).map(|f| keep[f] && self.is_real(FaceId::from_index(f))).collect();
        self.carve_real(&kept, j)
    }

    /// [`carve`](Self::carve), where `kept` names real faces alone.
    pub(super) fn carve_real<J: Journal>(&mut self, kept: &[bool], j: &mut J) -> bool {
        debug_assert!((0..kept.len()).all(|f| !kept[f] || self.is_real(FaceId::from_index(f))), "a real face");
        let Some(first) = kept.iter().position(|&is_kept| is_kept) else { return false };
        let border = self.border_of(kept);
        self.outside = Outside::beside(self, kept, &border, &self.outside);
        let ghosts = self.t.mesh.carve(kept, &border, j);
        self.t.set_state(2, Closure::Domain, None, j);
        self.constrain_border(&ghosts, j);
        self.last = FaceId::from_index(first);
        true
    }

    /// Makes border edges that no segment runs along segments of their own, named after all others in the order of
    /// their vertices, each from its lower end on: they are split and meet others like segments of the input.
    fn constrain_border<J: Journal>(&mut self, ghosts: &[FaceId], j: &mut J) {
        let bare = ghosts.iter().filter_map(|&f| self.t.ghost_edge(f)).filter(|&g| !self.t.is_marked(g));
        let ends = |g| [self.t.origin(g).min(self.t.dest(g)), self.t.origin(g).max(self.t.dest(g))];
        let mut bare: Vec<_> = bare.map(|g| (ends(g), g)).collect();
        bare.sort_unstable();
        for (ends, g) in bare {
            let mark = self.begin_segment(ends, j);
            self.t.mesh.set_mark(g, mark, j);
        }
    }
}
