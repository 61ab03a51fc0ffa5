//! Triangles that know their neighbours, and the faces that some of their edges make.

use crate::half_edge::EdgeKey;

/// No neighbour.
const NONE: u32 = u32::MAX;

/// Triangles in slots; half-edge `3 t + k` runs from corner `k` of triangle `t` to the next one.
///
/// # Shape
/// The number of triangles never changes: a cavity is filled with as many as it had.
#[derive(Debug)]
pub(crate) struct Mesh {
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The other half-edge of each edge; [`NONE`] where an edge must stay.
    twins: Vec<u32>,
}

impl Mesh {
    /// The mesh of triangles, of which `fixed` edges must stay, besides those of the boundary.
    pub(crate) fn new(triangles: Vec<[u32; 3]>, fixed: &[[u32; 2]]) -> Self {
        let mut mesh = Self { twins: vec![NONE; 3 * triangles.len()], triangles };
        let mut fixed: Vec<EdgeKey<u32>> = fixed.iter().copied().map(EdgeKey::of).collect();
        fixed.sort_unstable();
        let mut edges: Vec<(EdgeKey<u32>, u32)> = (0..mesh.twins.len() as u32).map(|h| (mesh.edge_key(h), h)).collect();
        edges.sort_unstable();
        for pair in edges.windows(2) {
            let [(edge, h), (other, twin)] = [pair[0], pair[1]];
            if edge == other && fixed.binary_search(&edge).is_err() {
                mesh.join(h, twin);
            }
        }
        mesh
    }

    /// The ends of a half-edge.
    pub(crate) fn ends(&self, h: u32) -> [u32; 2] {
        let t = self.triangles[(h / 3) as usize];
        let k = (h % 3) as usize;
        [t[k], t[(k + 1) % 3]]
    }

    /// The corner opposite a half-edge.
    pub(crate) fn apex(&self, h: u32) -> u32 {
        self.triangles[(h / 3) as usize][((h % 3 + 2) % 3) as usize]
    }

    /// The half-edge on the other side, if the edge may go.
    pub(crate) fn twin(&self, h: u32) -> Option<u32> {
        Some(self.twins[h as usize]).filter(|&twin| twin != NONE)
    }

    /// The half-edge after one around its triangle.
    pub(crate) const fn next(h: u32) -> u32 {
        if h % 3 == 2 { h - 2 } else { h + 1 }
    }

    /// The half-edge before one around its triangle.
    pub(crate) const fn prev(h: u32) -> u32 {
        if h % 3 == 0 { h + 2 } else { h - 1 }
    }

    /// The edges of a triangle must stay from now on.
    pub(crate) fn seal(&mut self, slot: u32) {
        for h in [0, 1, 2].map(|k| 3 * slot + k) {
            if let Some(twin) = self.twin(h) {
                self.twins[h as usize] = NONE;
                self.twins[twin as usize] = NONE;
            }
        }
    }

    /// Puts triangles into the slots of others that cover the same place.
    ///
    /// # Complexity
    /// O(k log k) for k triangles.
    pub(crate) fn replace(&mut self, slots: &[u32], new: &[[u32; 3]]) {
        let outer = self.outer_edges(slots);
        for (&slot, &t) in slots.iter().zip(new) {
            self.triangles[slot as usize] = t;
        }
        let mut inner: Vec<([u32; 2], u32)> =
            slots.iter().flat_map(|&slot| [0, 1, 2].map(|k| 3 * slot + k)).map(|h| (self.ends(h), h)).collect();
        inner.sort_unstable();
        for &([a, b], h) in &inner {
            let found =
                |edges: &[([u32; 2], u32)], edge| edges.binary_search_by_key(&edge, |e| e.0).map(|i| edges[i].1);
            let twin = found(&outer, [a, b]).or_else(|_| found(&inner, [b, a])).unwrap_or(NONE);
            self.twins[h as usize] = NONE;
            if twin != NONE {
                self.join(h, twin);
            }
        }
    }

    /// The half-edges of some triangles with none of these beyond, sorted, and what is beyond.
    fn outer_edges(&self, slots: &[u32]) -> Vec<([u32; 2], u32)> {
        let mut sorted = slots.to_vec();
        sorted.sort_unstable();
        let is_outside = |twin: u32| twin == NONE || sorted.binary_search(&(twin / 3)).is_err();
        let all = slots.iter().flat_map(|&slot| [0, 1, 2].map(|k| 3 * slot + k));
        let mut outer: Vec<([u32; 2], u32)> =
            all.map(|h| (self.ends(h), self.twins[h as usize])).filter(|&(_, twin)| is_outside(twin)).collect();
        outer.sort_unstable();
        outer
    }

    fn join(&mut self, h: u32, twin: u32) {
        self.twins[h as usize] = twin;
        self.twins[twin as usize] = h;
    }

    fn edge_key(&self, h: u32) -> EdgeKey<u32> {
        EdgeKey::of(self.ends(h))
    }

    /// The faces between edges of the mesh: the triangles that are joined across edges that are not kept, and the walk
    /// around them. A face with holes comes once for each of its walks.
    ///
    /// # Shape
    /// Edges of the boundary are kept, whatever `is_kept` says.
    ///
    /// # Complexity
    /// Linear, and one question an edge.
    pub(crate) fn faces(&self, is_kept: impl Fn(EdgeKey<u32>) -> bool) -> Vec<Face> {
        let kept: Vec<bool> =
            (0..self.twins.len() as u32).map(|h| self.twin(h).is_none() || is_kept(self.edge_key(h))).collect();
        let piece = self.pieces(&kept);
        let mut count = vec![0; piece.len()];
        for &p in &piece {
            count[p as usize] += 1;
        }
        let mut is_done = vec![false; kept.len()];
        let mut faces = Vec::new();
        for start in 0..kept.len() as u32 {
            if !kept[start as usize] || is_done[start as usize] {
                continue;
            }
            let mut walk = Vec::new();
            let mut h = start;
            loop {
                is_done[h as usize] = true;
                walk.push(self.ends(h)[0]);
                h = self.next_kept(&kept, h);
                if h == start {
                    break;
                }
            }
            faces.push(Face { walk, triangle_count: count[piece[(start / 3) as usize] as usize] });
        }
        faces
    }

    /// The kept half-edge that follows one around its face.
    fn next_kept(&self, kept: &[bool], h: u32) -> u32 {
        let mut next = Self::next(h);
        while !kept[next as usize] {
            next = Self::next(self.twins[next as usize]);
        }
        next
    }

    /// For each triangle the first one of those that it is joined to across edges that are not kept.
    fn pieces(&self, kept: &[bool]) -> Vec<u32> {
        let mut piece = vec![NONE; self.triangles.len()];
        let mut open = Vec::new();
        for first in 0..self.triangles.len() as u32 {
            if piece[first as usize] != NONE {
                continue;
            }
            piece[first as usize] = first;
            open.push(first);
            while let Some(t) = open.pop() {
                for h in [0, 1, 2].map(|k| 3 * t + k).into_iter().filter(|&h| !kept[h as usize]) {
                    let other = self.twins[h as usize] / 3;
                    if piece[other as usize] == NONE {
                        piece[other as usize] = first;
                        open.push(other);
                    }
                }
            }
        }
        piece
    }
}

/// A face between edges of a mesh.
#[derive(Debug)]
pub(crate) struct Face {
    /// Its vertices, the face on the left; those of one walk, if there are several.
    pub(crate) walk: Vec<u32>,
    /// The number of triangles of the mesh in it.
    pub(crate) triangle_count: usize,
}
