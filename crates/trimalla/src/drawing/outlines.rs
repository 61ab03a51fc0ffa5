//! The polygons that a mesh covers.

use super::IndexedMesh;
use super::sides::{Side, Sides};
use crate::geometry::Ring;

/// A part of the plane that triangles cover, joined along edges: its outline and its holes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// The vertices of each ring: the outline first, counter-clockwise, then the holes, clockwise.
    pub rings: Vec<Vec<u32>>,
}

impl IndexedMesh {
    /// The polygons that the triangles cover, one for each part that is joined along edges, by the triangles'
    /// order.
    ///
    /// Parts that meet in a vertex alone are polygons of their own. Where a part touches itself in a vertex, its
    /// rings go there as the triangles do: a ring has the part on its left all along.
    ///
    /// # Shape
    /// The mesh is sound ([`check_mesh`](crate::triangulation::check_mesh) finds no fault); of others some rings
    /// are left out.
    ///
    /// # Complexity
    /// Linear, and n log n in the degree of each vertex.
    #[must_use]
    pub fn outlines(&self) -> Vec<Outline> {
        let (part, parts) = self.parts();
        let sides = Sides::of(self);
        let mut outlines = vec![Outline::default(); parts];
        let mut is_taken = vec![false; self.triangles.len() * 3];
        for &first in sides.boundary() {
            let ring = self.ring_from(first, &sides, &mut is_taken);
            if ring.len() > 2 {
                outlines[part[first.triangle]].rings.push(ring);
            }
        }
        // All rings have the part on their left, so that the outer one alone runs counter-clockwise.
        for Outline { rings } in &mut outlines {
            if let Some(outer) = Ring::outline_of(rings, &self.points) {
                rings[..=outer].rotate_right(1);
            }
        }
        outlines.retain(|outline| !outline.rings.is_empty());
        outlines
    }

    /// The ring that a boundary side begins; empty if it was gone along before.
    fn ring_from(&self, first: Side, sides: &Sides, is_taken: &mut [bool]) -> Vec<u32> {
        let slot = |side: &Side| {
            let corner = self.triangles[side.triangle].iter().position(|&v| v == side.origin).unwrap_or(0);
            3 * side.triangle + corner
        };
        let (mut ring, mut side) = (Vec::new(), first);
        while !std::mem::replace(&mut is_taken[slot(&side)], true) {
            ring.push(side.origin);
            side = next_on_boundary(sides, side);
        }
        ring
    }

    /// The part of each triangle, and how many parts there are.
    fn parts(&self) -> (Vec<usize>, usize) {
        let neighbours = self.neighbours();
        let mut part = vec![usize::MAX; self.triangles.len()];
        let (mut parts, mut open) = (0, Vec::new());
        for first in 0..self.triangles.len() {
            if part[first] != usize::MAX {
                continue;
            }
            (part[first], parts) = (parts, parts + 1);
            open.push(first);
            while let Some(t) = open.pop() {
                for next in neighbours[t].into_iter().flatten().map(|t| t as usize) {
                    if part[next] == usize::MAX {
                        part[next] = part[t];
                        open.push(next);
                    }
                }
            }
        }
        (part, parts)
    }
}

/// The boundary side after a boundary side: from its end, turning through the triangles there.
fn next_on_boundary(sides: &Sides, side: Side) -> Side {
    let around = side.dest;
    let mut next = match sides.find(around, side.apex) {
        Some(next) => *next,
        None => return side,
    };
    for _ in sides.from(around) {
        match sides.find(next.dest, around).and_then(|beyond| sides.find(around, beyond.apex)) {
            Some(further) => next = *further,
            None => break,
        }
    }
    next
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;

    fn mesh(points: &[[f64; 2]], triangles: &[[u32; 3]]) -> IndexedMesh {
        let points = points.iter().copied().map(Point::from).collect();
        IndexedMesh { points, triangles: triangles.to_vec(), ..IndexedMesh::default() }
    }

    #[test]
    fn a_square_has_one_ring() {
        let square = mesh(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], &[[0, 1, 2], [0, 2, 3]]);
        assert_eq!(square.outlines(), [Outline { rings: vec![vec![0, 1, 2, 3]] }]);
        assert_eq!(IndexedMesh::default().outlines(), []);
    }

    #[test]
    fn triangles_that_meet_in_a_vertex_are_two_parts() {
        let bow = mesh(&[[0.0, 0.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]], &[[0, 1, 2], [0, 3, 4]]);
        let rings: Vec<_> = bow.outlines().into_iter().map(|o| o.rings).collect();
        assert_eq!(rings, [vec![vec![0, 1, 2]], vec![vec![0, 3, 4]]]);
    }

    #[test]
    fn the_outline_comes_before_its_holes() {
        let outer = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
        let hole = [[3.0, 3.0], [3.0, 6.0], [6.0, 6.0], [6.0, 3.0]];
        let drawing = crate::Pslg::of_rings([hole, outer]);
        let nested =
            crate::DomainOptions { rule: crate::domain::DomainRule::Nesting, ..crate::DomainOptions::default() };
        let made = crate::triangulate(&drawing, &nested).expect("it is a polygon").mesh;
        let [Outline { rings }] = &made.outlines()[..] else { panic!("one part") };
        let mut sets: Vec<Vec<u32>> = rings.clone();
        sets.iter_mut().for_each(|ring| ring.sort_unstable());
        assert_eq!(sets, [[4, 5, 6, 7], [0, 1, 2, 3]]);
    }
}
