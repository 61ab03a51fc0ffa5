//! Counts of a triangle list, for Euler's formula.

use std::collections::BTreeMap;

/// Counts of a triangle list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Euler {
    /// Vertices that a triangle uses.
    pub vertices: usize,
    /// Edges, each once.
    pub edges: usize,
    /// Triangles.
    pub faces: usize,
    /// Edges with one triangle.
    pub boundary_edges: usize,
    /// Connected components; a common vertex connects.
    pub components: usize,
}

impl Euler {
    /// `V − E + F`: components minus holes.
    #[must_use]
    pub fn characteristic(&self) -> i64 {
        let signed = |n: usize| i64::try_from(n).unwrap();
        signed(self.vertices) - signed(self.edges) + signed(self.faces)
    }

    /// Holes, if the triangles form a planar mesh: components minus the characteristic.
    #[must_use]
    pub fn holes(&self) -> i64 {
        i64::try_from(self.components).unwrap() - self.characteristic()
    }
}

/// Counts vertices, edges, faces and components of a triangle list.
#[must_use]
pub fn euler(triangles: &[[u32; 3]]) -> Euler {
    let mut faces_of_edge: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    let mut root: BTreeMap<u32, u32> = BTreeMap::new();
    for t in triangles {
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            *faces_of_edge.entry([a.min(b), a.max(b)]).or_default() += 1;
            root.entry(a).or_insert(a);
        }
        for k in 1..3 {
            let (a, b) = (find(&mut root, t[0]), find(&mut root, t[k]));
            root.insert(a, b);
        }
    }
    Euler {
        vertices: root.len(),
        edges: faces_of_edge.len(),
        faces: triangles.len(),
        boundary_edges: faces_of_edge.values().filter(|&&n| n == 1).count(),
        components: root.iter().filter(|(vertex, up)| vertex == up).count(),
    }
}

/// The root of a vertex in the union–find forest; halves the path on the way.
fn find(root: &mut BTreeMap<u32, u32>, vertex: u32) -> u32 {
    let mut at = vertex;
    while root[&at] != at {
        let up = root[&root[&at]];
        root.insert(at, up);
        at = up;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_and_one_apart() {
        let e = euler(&[[0, 1, 2], [0, 2, 3], [4, 5, 6]]);
        assert_eq!(e, Euler { vertices: 7, edges: 8, faces: 3, boundary_edges: 7, components: 2 });
        assert_eq!(e.holes(), 0);
    }

    #[test]
    fn a_ring_has_one_hole() {
        let ring: Vec<[u32; 3]> =
            (0..3).flat_map(|i| [[i, (i + 1) % 3, i + 3], [(i + 1) % 3, (i + 1) % 3 + 3, i + 3]]).collect();
        assert_eq!(euler(&ring).holes(), 1);
    }
}
