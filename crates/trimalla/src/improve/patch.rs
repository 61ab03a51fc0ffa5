//! A part of a mesh in arrays of its own, in which vertices move and edges flip without a trace in the mesh.

use crate::geometry::Point;
use crate::half_edge::VertexId;

/// No triangle.
pub(super) const NONE: u32 = u32::MAX;

/// How a vertex of a patch may move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Freedom {
    /// Not at all.
    Fixed,
    /// Anywhere.
    Plane,
    /// Along a segment, from its start to its end; it is at this parameter.
    Segment { start: Point, end: Point, t: f64 },
}

/// A vertex of a patch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// Which vertex of the mesh it stands for.
    pub(super) id: VertexId,
    pub(super) at: Point,
    pub(super) freedom: Freedom,
    /// Whether it has moved.
    pub(super) has_moved: bool,
    /// One of its triangles.
    triangle: u32,
}

/// A triangle of a patch; what belongs to corner `i` belongs to the edge opposite it, too.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [u32; 3],
    /// The triangles across the edges; [`NONE`] at the rim of the patch.
    across: [u32; 3],
    /// Whether the edges are constrained.
    is_locked: [bool; 3],
}

/// The triangles around some vertices that may move.
#[derive(Clone, Debug, Default)]
pub(super) struct Patch {
    corners: Vec<Corner>,
    triangles: Vec<Triangle>,
    /// Scratch: the half-edges that wait for their twin.
    open: Vec<([u32; 2], u32, u8)>,
}

impl Patch {
    pub(super) fn clear(&mut self) {
        self.corners.clear();
        self.triangles.clear();
    }

    /// Adds a vertex; returns its number.
    pub(super) fn add_corner(&mut self, id: VertexId, at: Point, freedom: Freedom) -> u32 {
        self.corners.push(Corner { id, at, freedom, has_moved: false, triangle: NONE });
        self.corners.len() as u32 - 1
    }

    /// Adds a counter-clockwise triangle; `is_locked` tells which edges opposite its corners are constrained.
    pub(super) fn add_triangle(&mut self, corners: [u32; 3], is_locked: [bool; 3]) {
        let number = self.triangles.len() as u32;
        for v in corners {
            self.corners[v as usize].triangle = number;
        }
        self.triangles.push(Triangle { corners, across: [NONE; 3], is_locked });
    }

    /// Finds which triangles lie across which edges, once all are there.
    pub(super) fn join(&mut self) {
        let mut open = std::mem::take(&mut self.open);
        open.clear();
        for (t, triangle) in (0..).zip(&self.triangles) {
            for i in 0..3 {
                let [a, b] = [triangle.corners[(i + 1) % 3], triangle.corners[(i + 2) % 3]];
                open.push(([a.min(b), a.max(b)], t, i as u8));
            }
        }
        open.sort_unstable();
        for pair in open.windows(2) {
            let [(edge, t, i), (other, n, j)] = [pair[0], pair[1]];
            if edge == other {
                self.triangles[t as usize].across[usize::from(i)] = n;
                self.triangles[n as usize].across[usize::from(j)] = t;
            }
        }
        self.open = open;
    }

    pub(super) fn corners(&self) -> &[Corner] {
        &self.corners
    }

    pub(super) fn corner(&self, v: u32) -> &Corner {
        &self.corners[v as usize]
    }

    pub(super) fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// The places of a triangle's corners.
    pub(super) fn places(&self, t: u32) -> [Point; 3] {
        self.triangles[t as usize].corners.map(|v| self.corners[v as usize].at)
    }

    /// Moves a vertex.
    pub(super) fn place(&mut self, v: u32, at: Point, t: f64) {
        let corner = &mut self.corners[v as usize];
        corner.at = at;
        corner.has_moved = true;
        if let Freedom::Segment { t: old, .. } = &mut corner.freedom {
            *old = t;
        }
    }

    /// Lists the edges opposite a vertex, of all triangles at it.
    pub(super) fn link(&self, v: u32, link: &mut Vec<[Point; 2]>) {
        link.clear();
        let first = self.corners[v as usize].triangle;
        if first == NONE {
            return;
        }
        let mut at = first;
        // Counter-clockwise to the rim or around; then clockwise from the first.
        loop {
            at = self.push_link(v, at, 1, link);
            if at == first {
                return;
            }
            if at == NONE {
                break;
            }
        }
        at = self.next_around(v, first, 2);
        while at != NONE {
            at = self.push_link(v, at, 2, link);
        }
    }

    fn push_link(&self, v: u32, t: u32, turn: usize, link: &mut Vec<[Point; 2]>) -> u32 {
        let triangle = &self.triangles[t as usize];
        let i = triangle.place_of(v);
        let ends = [triangle.corners[(i + 1) % 3], triangle.corners[(i + 2) % 3]];
        link.push(ends.map(|w| self.corners[w as usize].at));
        triangle.across[(i + turn) % 3]
    }

    /// The next triangle around a vertex: across the edge opposite the first corner after it (1: counter-clockwise) or
    /// the second (2: clockwise).
    fn next_around(&self, v: u32, t: u32, turn: usize) -> u32 {
        let triangle = &self.triangles[t as usize];
        triangle.across[(triangle.place_of(v) + turn) % 3]
    }

    /// Both neighbours of a vertex along its segment: the far ends of the constrained edges at it.
    pub(super) fn along_segment(&self, v: u32) -> [Option<u32>; 2] {
        let mut found = [None; 2];
        let mut note = |w: u32| {
            if found[0].is_none() {
                found[0] = Some(w);
            } else if found[0] != Some(w) {
                found[1] = Some(w);
            }
        };
        for triangle in self.triangles.iter().filter(|triangle| triangle.corners.contains(&v)) {
            let i = triangle.place_of(v);
            for k in [1, 2] {
                if triangle.is_locked[(i + k) % 3] {
                    note(triangle.corners[(i + 3 - k) % 3]);
                }
            }
        }
        found
    }

    /// The places around the edge opposite a corner, if it may flip: the corner, the edge's ends, the corner across.
    pub(super) fn quadrilateral(&self, t: u32, i: usize) -> Option<[Point; 4]> {
        let triangle = &self.triangles[t as usize];
        let across = triangle.across[i];
        if across == NONE || triangle.is_locked[i] {
            return None;
        }
        let other = &self.triangles[across as usize];
        let d = other.corners[other.place_across(t)];
        let [a, b, c] = [0, 1, 2].map(|k| triangle.corners[(i + k) % 3]);
        Some([a, b, c, d].map(|v| self.corners[v as usize].at))
    }

    /// Flips the edge opposite a corner.
    ///
    /// ```text
    ///         a                 a
    ///       /   \             / | \        t: a b c  ──>  a b d
    ///      b ─── c    ──>    b  │  c       n: d c b  ──>  a d c
    ///       \   /             \ | /
    ///         d                 d
    /// ```
    pub(super) fn flip(&mut self, t: u32, i: usize) {
        let old = self.triangles[t as usize];
        let n = old.across[i];
        let other = self.triangles[n as usize];
        let j = other.place_across(t);
        let [a, b, c] = [0, 1, 2].map(|k| old.corners[(i + k) % 3]);
        let d = other.corners[j];
        let side = |triangle: &Triangle, k: usize| (triangle.across[k % 3], triangle.is_locked[k % 3]);
        let ([ca, ab], [bd, dc]) = ([side(&old, i + 1), side(&old, i + 2)], [side(&other, j + 1), side(&other, j + 2)]);
        let made = |corners, sides: [(u32, bool); 3]| Triangle {
            corners,
            across: sides.map(|side| side.0),
            is_locked: sides.map(|side| side.1),
        };
        self.triangles[t as usize] = made([a, b, d], [bd, (n, false), ab]);
        self.triangles[n as usize] = made([a, d, c], [dc, ca, (t, false)]);
        for (side, from, to) in [(bd.0, n, t), (ca.0, t, n)] {
            if side != NONE {
                let k = self.triangles[side as usize].place_across(from);
                self.triangles[side as usize].across[k] = to;
            }
        }
        for (v, triangle) in [(a, t), (b, t), (d, t), (c, n)] {
            self.corners[v as usize].triangle = triangle;
        }
    }
}

impl Triangle {
    /// Which corner a vertex is.
    fn place_of(&self, v: u32) -> usize {
        self.corners.iter().position(|&w| w == v).unwrap_or(0)
    }

    /// The corner opposite the edge to a triangle.
    fn place_across(&self, t: u32) -> usize {
        self.across.iter().position(|&n| n == t).unwrap_or(0)
    }
}
