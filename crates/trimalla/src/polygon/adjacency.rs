//! Which triangles share an edge.
//!
//! Half-edge `3 t + k` runs from corner `k` of triangle `t` to the next one.

/// No half-edge.
pub(super) const NONE: u32 = u32::MAX;

/// The other half-edge of the edge of each, or [`NONE`] at the boundary. Keeps its memory from one list of triangles to
/// the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Twins {
    pub(super) twins: Vec<u32>,
    /// The half-edges by the vertices at their ends.
    sorted: Vec<(u64, u32)>,
}

impl Twins {
    /// Finds those of triangles of which no two have an edge in the same direction.
    pub(super) fn find(&mut self, triangles: &[[u32; 3]]) {
        self.sorted.clear();
        for h in 0..3 * triangles.len() as u32 {
            let (from, to) = (origin(triangles, h), origin(triangles, next(h)));
            self.sorted.push((u64::from(from.min(to)) << 32 | u64::from(from.max(to)), h));
        }
        self.sorted.sort_unstable();
        self.twins.clear();
        self.twins.resize(3 * triangles.len(), NONE);
        for pair in self.sorted.windows(2) {
            let [(one, h), (other, g)] = [pair[0], pair[1]];
            if one == other {
                (self.twins[h as usize], self.twins[g as usize]) = (g, h);
            }
        }
    }
}

/// The neighbours of triangles of which no two have an edge in the same direction: across the edge from corner `k` to
/// the next, the triangle, and the place of the edge in it. [`NONE`] at the boundary.
pub(super) fn neighbours(triangles: &[[u32; 3]]) -> Vec<[(u32, u8); 3]> {
    let mut adjacency = Twins::default();
    adjacency.find(triangles);
    let neighbour = |g: u32| if g == NONE { (NONE, 0) } else { (g / 3, (g % 3) as u8) };
    adjacency.twins.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(neighbour)).collect()
}

/// The half-edge after one in its triangle.
pub(super) fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// The half-edge before one in its triangle.
pub(super) fn previous(h: u32) -> u32 {
    if h % 3 == 0 { h + 2 } else { h - 1 }
}

/// The vertex at which a half-edge starts.
pub(super) fn origin(triangles: &[[u32; 3]], h: u32) -> u32 {
    triangles[(h / 3) as usize][(h % 3) as usize]
}
