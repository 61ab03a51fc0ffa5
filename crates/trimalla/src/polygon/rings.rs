//! A polygon as plain arrays.

use super::PolygonError;
use crate::geometry::{Point, Ring};

/// A polygon: points, and where each ring of them ends. The first ring is the outline, the others are holes.
///
/// Rings may run either way, and a ring is closed by itself: its last point is joined to its first. Collinear runs,
/// and rings that touch each other or themselves in points, are allowed; what crosses is refused by the algorithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon<'a> {
    points: &'a [Point],
    ring_ends: &'a [u32],
}

impl<'a> Polygon<'a> {
    /// The polygon of these points, whose ring `i` ends before point `ring_ends[i]`.
    ///
    /// # Errors
    /// A ring end out of order, a coordinate that is not finite, too many points.
    pub fn new(points: &'a [Point], ring_ends: &'a [u32]) -> Result<Self, PolygonError> {
        let limit = (u32::MAX / 8) as usize;
        if points.len() > limit {
            return Err(PolygonError::TooMany { count: points.len(), limit });
        }
        if let Some((index, &point)) = points.iter().enumerate().find(|(_, p)| !p.is_finite()) {
            return Err(PolygonError::NotFinite { index: index as u32, point });
        }
        let mut begin = 0;
        for (ring, &end) in ring_ends.iter().enumerate() {
            if end < begin || end as usize > points.len() {
                return Err(PolygonError::RingEnd { ring, end });
            }
            begin = end;
        }
        Ok(Self { points, ring_ends })
    }

    /// The points of all rings.
    #[must_use]
    pub const fn points(self) -> &'a [Point] {
        self.points
    }

    /// The number of rings.
    #[must_use]
    pub const fn ring_count(self) -> usize {
        self.ring_ends.len()
    }

    /// The indices of the points of each ring, the outline first.
    pub fn rings(self) -> impl ExactSizeIterator<Item = std::ops::Range<usize>> + Clone + 'a {
        let ends = self.ring_ends;
        (0..ends.len()).map(move |i| {
            let begin = if i == 0 { 0 } else { ends[i - 1] };
            begin as usize..ends[i] as usize
        })
    }

    /// The ring of these points.
    #[must_use]
    pub fn ring(self, range: std::ops::Range<usize>) -> Ring<'a> {
        Ring::new(&self.points[range])
    }
}
