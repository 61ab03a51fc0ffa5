//! Drawings made of rings.

use super::pslg::Pslg;
use crate::geometry::Point;

impl Pslg {
    /// The drawing of one ring: each point is joined to the next, and the last to the first.
    ///
    /// # Examples
    /// ```
    /// use trimalla::Pslg;
    ///
    /// let triangle = Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert_eq!(triangle.segments, [[0, 1], [1, 2], [2, 0]]);
    /// ```
    #[must_use]
    pub fn of_ring<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Self {
        Self::of_rings([points])
    }

    /// The drawing of several rings, as polygons with holes, and islands in them, come from maps and fonts.
    ///
    /// The rings may run either way; a ring that repeats its first point at its end is closed as it is. What is
    /// inside an odd number of rings is the domain under
    /// [`DomainRule::Nesting`](crate::domain::DomainRule::Nesting), which needs no hole seeds.
    ///
    /// # Examples
    /// ```
    /// use trimalla::domain::DomainRule;
    /// use trimalla::{DomainOptions, Pslg, triangulate};
    ///
    /// let outline = vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    /// let hole = vec![[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]];
    /// let drawing = Pslg::of_rings([outline, hole]);
    /// let nested = DomainOptions { rule: DomainRule::Nesting, ..DomainOptions::default() };
    /// let mesh = triangulate(&drawing, &nested)?.mesh;
    /// assert_eq!(mesh.triangles.len(), 8);
    /// # Ok::<(), trimalla::domain::DomainError>(())
    /// ```
    #[must_use]
    pub fn of_rings<R, P>(rings: impl IntoIterator<Item = R>) -> Self
    where
        R: IntoIterator<Item = P>,
        P: Into<Point>,
    {
        let mut drawing = Self::default();
        for ring in rings {
            drawing.add_ring(ring.into_iter().map(Into::into));
        }
        drawing
    }

    /// Adds a ring: each point is joined to the next, and the last to the first. One point gives no segment.
    ///
    /// # Shape
    /// Columns of markers and attributes are left as they are: if there are any, entries for the new points and
    /// segments are the caller's to add.
    pub fn add_ring(&mut self, ring: impl IntoIterator<Item = Point>) {
        let first = self.points.len();
        self.points.extend(ring);
        let is_closed = self.points.len() > first + 1 && self.points[first] == self.points[self.points.len() - 1];
        if is_closed {
            self.points.pop();
        }
        let (from, to) = (first as u32, self.points.len() as u32);
        let ends = (from..to).map(|v| [v, if v + 1 == to { from } else { v + 1 }]);
        self.segments.extend(ends.filter(|[a, b]| a != b));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_close_once() {
        let closed = Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]);
        assert_eq!(closed, Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]));
        let several = Pslg::of_rings([vec![[0.0, 0.0]], vec![], vec![[1.0, 0.0], [2.0, 0.0]]]);
        assert_eq!((several.points.len(), several.segments), (3, vec![[1, 2], [2, 1]]));
    }
}
