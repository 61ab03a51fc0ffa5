//! Patches: triangles for a region beside an edge, before they are faces of a mesh.

use crate::half_edge::{FaceId, HalfEdgeId};

/// Triangles that fill a region beside an edge, the *base*, named without the ids of any mesh.
///
/// Boundary vertices are numbered along the boundary from one end of the base to the other, the region on the left;
/// *rim* `i` is the edge of the boundary between vertices `i` and `i + 1`.
#[derive(Clone, Debug)]
pub(crate) struct Patch {
    pub(crate) triangles: Vec<Triangle>,
    /// The side along each rim.
    pub(crate) rim: Vec<Side>,
    /// The side along the base.
    pub(crate) base: Side,
}

/// A triangle of a patch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    /// Boundary vertices, counter-clockwise.
    pub(crate) corners: [u32; 3],
    /// What lies across the sides that start at them.
    pub(crate) across: [Side; 3],
}

/// A side of a triangle of a patch, directed from its corner to the next one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Side(u32);

impl Side {
    /// What lies across the sides on the boundary: no side.
    pub(crate) const BOUNDARY: Self = Self(u32::MAX);

    /// The side of a triangle that starts at its corner `k`, 0 to 2.
    #[inline]
    pub(crate) const fn new(triangle: u32, k: u32) -> Self {
        Self(triangle << 2 | k)
    }

    /// The number of its triangle.
    #[inline]
    pub(crate) const fn triangle(self) -> u32 {
        self.0 >> 2
    }

    /// The corner that it starts at, 0 to 2.
    #[inline]
    pub(crate) const fn corner(self) -> usize {
        (self.0 & 3) as usize
    }

    /// The next side of the triangle, counter-clockwise.
    #[inline]
    pub(crate) const fn next(self) -> Self {
        if self.0 & 3 == 2 { Self(self.0 - 2) } else { Self(self.0 + 1) }
    }

    /// The previous side of the triangle, counter-clockwise.
    #[inline]
    pub(crate) const fn prev(self) -> Self {
        if self.0 & 3 == 0 { Self(self.0 + 2) } else { Self(self.0 - 1) }
    }

    /// The half-edge that the side becomes in these faces; none for [`BOUNDARY`](Self::BOUNDARY).
    #[inline]
    pub(super) fn half_edge(self, faces: &[FaceId]) -> HalfEdgeId {
        faces.get(self.triangle() as usize).map_or(HalfEdgeId::NONE, |f| f.half_edge(self.0 & 3))
    }
}

impl Default for Patch {
    fn default() -> Self {
        Self { triangles: Vec::new(), rim: Vec::new(), base: Side::BOUNDARY }
    }
}

impl Patch {
    /// No triangles yet beside a boundary of that many vertices.
    pub(crate) fn start(&mut self, boundary: usize) {
        self.triangles.clear();
        self.rim.clear();
        self.rim.resize(boundary - 1, Side::BOUNDARY);
        self.base = Side::BOUNDARY;
    }

    /// Number of triangles.
    pub(crate) fn len(&self) -> usize {
        self.triangles.len()
    }

    /// The boundary vertex at which a side starts.
    #[inline]
    pub(crate) fn origin(&self, side: Side) -> u32 {
        self.triangles[side.triangle() as usize].corners[side.corner()]
    }

    /// What lies across a side.
    #[inline]
    pub(crate) fn across(&self, side: Side) -> Side {
        self.triangles[side.triangle() as usize].across[side.corner()]
    }

    /// Writes what lies across a side; the caller does the same on the other one.
    #[inline]
    pub(crate) fn set_across(&mut self, side: Side, other: Side) {
        self.triangles[side.triangle() as usize].across[side.corner()] = other;
    }

    /// The edges that these faces have between them, one half-edge each.
    pub(crate) fn inner_edges(&self, faces: &[FaceId]) -> impl Iterator<Item = HalfEdgeId> {
        let sides = (0..self.triangles.len() as u32).flat_map(|t| [0, 1, 2].map(|k| Side::new(t, k)));
        let inner = sides.filter(|&side| side < self.across(side) && self.across(side) != Side::BOUNDARY);
        inner.map(move |side| side.half_edge(faces))
    }
}
