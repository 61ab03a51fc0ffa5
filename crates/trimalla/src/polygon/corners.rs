//! The corners of a polygon, ready for a sweep.

use super::{Polygon, PolygonError};
use crate::geometry::Point;

/// A corner: where it is, which vertex it is, and which corner.
///
/// Several corners may be at one point: a ring touches another one, or itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    pub(super) point: Point,
    pub(super) vertex: u32,
    pub(super) corner: u32,
}

/// The corners of all rings, without those that repeat the point of the corner before.
///
/// Corner `i` begins side `i`, which leads to the next corner of its ring. The sweep adds corners where a vertex lies
/// inside a side; those belong to no ring.
#[derive(Clone, Debug, Default)]
pub(super) struct Corners {
    /// Where each corner is.
    pub(super) points: Vec<Point>,
    /// Which vertex of the polygon each corner is.
    pub(super) vertices: Vec<u32>,
    /// The corners before and after each corner in its ring.
    pub(super) links: Vec<[u32; 2]>,
    /// The ring of each corner; empty if there is one ring.
    pub(super) rings: Vec<u32>,
    /// The number of rings that have corners.
    pub(super) ring_count: usize,
    /// The number of corners that rings have.
    pub(super) count: usize,
}

impl Corners {
    /// Takes up another polygon.
    pub(super) fn fill(&mut self, polygon: Polygon<'_>) -> Result<(), PolygonError> {
        self.points.clear();
        self.vertices.clear();
        self.links.clear();
        self.rings.clear();
        self.ring_count = 0;
        for (ring, range) in polygon.rings().enumerate() {
            let (first, begin) = (range.start as u32, self.points.len());
            if range.is_empty() {
                continue;
            }
            self.append(&polygon.points()[range], first);
            let count = self.points.len() - begin;
            if count < 3 {
                return Err(PolygonError::Flat { ring, first });
            }
            self.link(begin as u32);
            self.ring_count += 1;
            if polygon.ring_count() > 1 {
                self.rings.resize(self.points.len(), ring as u32);
            }
        }
        self.count = self.points.len();
        Ok(())
    }

    /// Appends the points of a ring, without repetitions.
    fn append(&mut self, points: &[Point], first: u32) {
        let mut before = points[points.len() - 1];
        for (&point, vertex) in points.iter().zip(first..) {
            if point != before {
                self.points.push(point);
                self.vertices.push(vertex);
            }
            before = point;
        }
    }

    /// Links the corners from `begin` on to a ring.
    fn link(&mut self, begin: u32) {
        let end = self.points.len() as u32;
        self.links.extend((begin..end).map(|i| [i.wrapping_sub(1), i + 1]));
        self.links[begin as usize][0] = end - 1;
        self.links[end as usize - 1][1] = begin;
    }

    /// The mark of a corner.
    #[inline]
    pub(super) fn mark(&self, corner: u32) -> Mark {
        Mark { point: self.points[corner as usize], vertex: self.vertices[corner as usize], corner }
    }

    /// Adds a corner at the point of another one.
    pub(super) fn add_beside(&mut self, corner: u32) -> u32 {
        let added = self.points.len() as u32;
        self.points.push(self.points[corner as usize]);
        self.vertices.push(self.vertices[corner as usize]);
        added
    }

    /// The vertices at the ends of a side.
    pub(super) fn side(&self, side: u32) -> [u32; 2] {
        [side, self.links[side as usize][1]].map(|c| self.vertices[c as usize])
    }
}
