//! The sides of the triangles of an indexed mesh, found by their ends.

use super::indexed::IndexedMesh;

/// A directed side of a triangle, which lies to its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Side {
    /// Where it starts.
    pub(crate) origin: u32,
    /// Where it ends.
    pub(crate) dest: u32,
    /// The corner opposite.
    pub(crate) apex: u32,
    /// The triangle.
    pub(crate) triangle: usize,
}

/// All sides of the sound triangles, sorted by their ends.
///
/// # Shape
/// A triangle is sound here if its indices are in range and differ; others are left out.
#[derive(Clone, Debug)]
pub(crate) struct Sides {
    /// Sorted by origin, then destination, then triangle.
    sides: Vec<Side>,
    /// Where the sides of each origin begin; one entry more than there are vertices.
    begin: Vec<usize>,
}

impl Sides {
    /// Collects and sorts the sides.
    ///
    /// # Complexity
    /// Linear, and n log n in the degree of each vertex.
    pub(crate) fn of(mesh: &IndexedMesh) -> Self {
        Self::of_triangles(mesh, |_| true)
    }

    /// The sides of those sound triangles that are wanted.
    pub(crate) fn of_triangles(mesh: &IndexedMesh, wanted: impl Fn(&[u32; 3]) -> bool) -> Self {
        let vertices = mesh.points.len();
        let every_side = |mesh| every_side(mesh).filter(|s: &Side| wanted(&mesh.triangles[s.triangle]));
        let mut begin = vec![0_usize; vertices + 1];
        for side in every_side(mesh) {
            begin[side.origin as usize + 1] += 1;
        }
        for v in 0..vertices {
            begin[v + 1] += begin[v];
        }
        let mut next = begin.clone();
        let blank = Side { origin: 0, dest: 0, apex: 0, triangle: 0 };
        let mut sides = vec![blank; begin[vertices]];
        for side in every_side(mesh) {
            let slot = &mut next[side.origin as usize];
            sides[*slot] = side;
            *slot += 1;
        }
        for v in 0..vertices {
            sides[begin[v]..begin[v + 1]].sort_unstable_by_key(|s| (s.dest, s.triangle));
        }
        Self { sides, begin }
    }

    /// All sides, by origin and destination.
    pub(crate) fn iter(&self) -> std::slice::Iter<'_, Side> {
        self.sides.iter()
    }

    /// The sides that start at a vertex, by destination; none for an index out of range.
    pub(crate) fn from(&self, v: u32) -> &[Side] {
        let v = v as usize;
        if v + 1 < self.begin.len() { &self.sides[self.begin[v]..self.begin[v + 1]] } else { &[] }
    }

    /// The first side from one vertex to another.
    pub(crate) fn find(&self, origin: u32, dest: u32) -> Option<&Side> {
        let from = self.from(origin);
        from.get(from.partition_point(|s| s.dest < dest)).filter(|s| s.dest == dest)
    }

    /// The side from one vertex to another, where there is just one.
    pub(super) fn only(&self, origin: u32, dest: u32) -> Option<&Side> {
        let from = self.from(origin);
        let first = from.partition_point(|s| s.dest < dest);
        match &from[first..] {
            [one, next, ..] if one.dest == dest && next.dest != dest => Some(one),
            [one] if one.dest == dest => Some(one),
            _ => None,
        }
    }

    /// Whether two vertices are joined by an edge.
    pub(crate) fn joins(&self, a: u32, b: u32) -> bool {
        self.find(a, b).or_else(|| self.find(b, a)).is_some()
    }

    /// Whether a vertex is a corner of a sound triangle.
    pub(crate) fn is_used(&self, v: u32) -> bool {
        !self.from(v).is_empty()
    }

    /// The sides that no triangle adjoins on their right.
    pub(crate) fn boundary(&self) -> impl Iterator<Item = &Side> {
        self.iter().filter(|s| self.find(s.dest, s.origin).is_none())
    }

    /// Each edge once, by one of its sides.
    pub(crate) fn edges(&self) -> impl Iterator<Item = &Side> {
        let first = |s: &&Side| self.find(s.origin, s.dest).is_some_and(|f| f.triangle == s.triangle);
        let lone = |s: &&Side| s.origin < s.dest || self.find(s.dest, s.origin).is_none();
        self.iter().filter(first).filter(lone)
    }
}

/// Whether the indices of a triangle are in range and differ.
pub(crate) fn is_sound(&[a, b, c]: &[u32; 3], vertices: usize) -> bool {
    let in_range = [a, b, c].into_iter().all(|v| (v as usize) < vertices);
    in_range && a != b && b != c && c != a
}

/// The sides of all sound triangles, in order.
fn every_side(mesh: &IndexedMesh) -> impl Iterator<Item = Side> + '_ {
    let vertices = mesh.points.len();
    let sound = mesh.triangles.iter().enumerate().filter(move |(_, t)| is_sound(t, vertices));
    sound.flat_map(|(triangle, t)| {
        let side = move |k: usize| (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
        [0, 1, 2].map(side).map(|(origin, dest, apex)| Side { origin, dest, apex, triangle })
    })
}
