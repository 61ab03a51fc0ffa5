//! Carving: what is outside away, in one change that can be taken back.

use crate::constrained::ConstrainedDelaunay;
use crate::mesh::Journal;
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
        if keep.len() < self.face_slots() || !self.real_faces().any(|f| keep[f.index()]) {
            return false;
        }
        self.t.mesh.carve(keep, j);
        self.t.set_state(2, Closure::Domain, None, j);
        self.constrain_border(j);
        if let Some(f) = self.t.real_faces().next() {
            self.last = f;
        }
        true
    }

    /// Marks border edges that no segment runs along.
    fn constrain_border<J: Journal>(&mut self, j: &mut J) {
        let bare: Vec<_> =
            self.t.ghost_faces().filter_map(|f| self.t.ghost_edge(f)).filter(|&g| !self.t.is_marked(g)).collect();
        if bare.is_empty() {
            return;
        }
        let before = self.constraints.len();
        let mark = self.constraints.mark_of(&[]);
        self.note_classes(before, j);
        for g in bare {
            self.t.mesh.set_mark(g, mark, j);
        }
    }
}
