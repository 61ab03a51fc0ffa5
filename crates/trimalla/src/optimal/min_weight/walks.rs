//! The faces that the certain edges leave, as walks along their boundaries.
//!
//! A face is bounded by one walk or several: its outline, and one around each component of certain edges inside. A walk
//! may pass an edge on both of its sides, and a vertex several times; each time is a *corner* of its own:
//!
//! ```text
//!      out ↗                    the face lies between `out` and `back`, counter-clockwise;
//!        v  ) the face          the half-edges of v between them that are possible
//!      back ↘                   are the diagonals of this corner
//! ```
//!
//! No possible edge crosses a certain one, so each lies in one face, and each of its half-edges belongs to one corner.

use super::fans::Fans;
use super::lengths::Lengths;
use crate::geometry::Point;

/// The edges, and what is known about them.
#[derive(Clone, Debug)]
pub(super) struct Plane<'a> {
    pub(super) points: &'a [Point],
    pub(super) lengths: &'a Lengths<'a>,
    pub(super) fans: &'a Fans,
    /// For each edge.
    pub(super) is_possible: Vec<bool>,
    /// For each edge.
    pub(super) is_certain: Vec<bool>,
}

/// A vertex of a walk.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    /// The half-edge to the next corner and the one to the corner before; none at a vertex without certain edges.
    sides: Option<[u32; 2]>,
}

/// Where a walk can be found again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// A certain half-edge with the face on its left.
    Half(u32),
    /// A vertex without certain edges.
    Lone(u32),
}

impl Plane<'_> {
    fn is_certain(&self, h: u32) -> bool {
        self.is_certain[self.fans.edge[h as usize] as usize]
    }

    /// Whether a half-edge belongs to an edge that is possible and not certain.
    pub(super) fn is_open(&self, h: u32) -> bool {
        self.is_possible[self.fans.edge[h as usize] as usize] && !self.is_certain(h)
    }

    /// The next certain half-edge along the face to the left of one.
    pub(super) fn next_along(&self, h: u32) -> u32 {
        let v = self.fans.to[h as usize];
        let mut next = self.fans.before(v, self.fans.twin[h as usize]);
        while !self.is_certain(next) {
            next = self.fans.before(v, next);
        }
        next
    }

    /// The corners of a walk.
    pub(super) fn walk(&self, start: Start) -> Vec<Corner> {
        let first = match start {
            Start::Lone(vertex) => return vec![Corner { vertex, sides: None }],
            Start::Half(h) => h,
        };
        let mut corners = Vec::new();
        let mut h = first;
        loop {
            let next = self.next_along(h);
            let vertex = self.fans.to[h as usize];
            corners.push(Corner { vertex, sides: Some([next, self.fans.twin[h as usize]]) });
            h = next;
            if h == first {
                return corners;
            }
        }
    }

    /// The half-edges of the diagonals of a corner, counter-clockwise.
    pub(super) fn diagonals_at(&self, corner: Corner) -> impl Iterator<Item = u32> + '_ {
        let v = corner.vertex;
        let range = self.fans.of(v);
        let (first, count) = match corner.sides {
            None => (range.start, range.len() as u32),
            Some([out, back]) => {
                let turn = if back > out { back - out } else { back + range.len() as u32 - out };
                (self.fans.after(v, out), turn - 1)
            }
        };
        let (start, degree) = (range.start, range.len() as u32);
        let around = (0..count).map(move |i| start + (first - start + i) % degree);
        around.filter(|&h| self.is_open(h))
    }
}
