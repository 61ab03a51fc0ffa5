//! Inside and outside of a triangulation by parity.

use super::flood::depths;
use crate::constrained::ConstrainedTriangulation;
use crate::half_edge::FaceId;

impl ConstrainedTriangulation {
    /// Which faces lie inside by parity, one entry a face slot, to be given to
    /// [`carve`](crate::constrained::ConstrainedDelaunay::carve): those behind an odd number of segments, counted from
    /// outside.
    ///
    /// Segments that share an edge count each. Where ways from outside cross different numbers of segments, as they do
    /// around the end of an open chain, the least counts.
    ///
    /// # Complexity
    /// Linear in the faces, times the greatest number of segments that share an edge.
    ///
    /// # Source
    /// The end of `CDTFace` in `[Vigo97]`, section 5. [`build`](super::build()) applies it to a drawing under
    /// [`DomainRule::Nesting`](super::DomainRule::Nesting).
    ///
    /// # Examples
    /// ```
    /// use trimalla::constrained::{ConstrainedDelaunay, Crossings};
    /// use trimalla::geometry::Point;
    /// use trimalla::half_edge::NoJournal;
    ///
    /// // A square in a triangle that contains all.
    /// let points = [[-9.0, -9.0], [9.0, -9.0], [0.0, 18.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
    /// let mut t = ConstrainedDelaunay::new(&points, &[[3, 4], [4, 5], [5, 6], [6, 3]], Crossings::Refuse)?;
    /// let inside = t.inside_by_parity();
    /// assert!(t.carve(&inside, &mut NoJournal));
    /// assert_eq!(t.face_count(), 2);
    /// # Ok::<(), trimalla::constrained::ConstraintError>(())
    /// ```
    #[must_use]
    pub fn inside_by_parity(&self) -> Vec<bool> {
        let depth = depths(self, |mark| self.segments_of_class(mark).len() as u32);
        let is_inside = |f: usize| self.is_real(FaceId::from_index(f)) && depth[f] % 2 == 1;
        (0..self.face_slots()).map(is_inside).collect()
    }
}
