//! From edge records to the flat half-edge structure.
//!
//! # Idea
//! The flat structure wants faces: three half-edges each, numbered `3f, 3f + 1, 3f + 2` counter-clockwise. Each
//! directed edge with a triangle on its left is one half-edge of that triangle. Each directed edge `ab` with the
//! outer face on its left gets a *ghost face* to itself, which joins it to the vertex at infinity:
//!
//! ```text
//!                 ∞                     ghost of ab:    3f      a -> b     twin: ba, in its triangle or its ghost
//!               . : .                                   3f + 1  b -> ∞     twin: ∞ -> b of the ghost of next(ab)
//!             .   :   .                                 3f + 2  ∞ -> a     twin: a -> ∞ of the ghost before
//!           .     :     .
//!         c <---- b <---- a             ab, bc: edges of the outer face, which is above them
//!            \   / \   /
//!             \ /   \ /                 triangles below
//! ```
//!
//! # Steps
//! 1. Mark the directed edges of the outer face.
//! 2. Go through the records; at the first edge of each face, number the three half-edges of that face.
//! 3. Pair each half-edge with the one of the twin edge.
//! 4. Pair the ghosts with each other along the outer face.
//!
//! # Degenerate cases
//! A collinear chain of k vertices has its outer face on both sides of each edge: 2(k − 1) ghosts, paired across the
//! edges and, by step 4, all around. One vertex or none: no faces.

use super::edge_records::{Edge, EdgeRecords};

/// The name of the vertex at infinity.
pub(crate) const INFINITY: u32 = u32::MAX;

/// A triangulation as arrays of half-edges: half-edge `h` belongs to face `h / 3`, and follows `h - 1` in it
/// counter-clockwise.
///
/// # Shape
/// Both arrays have three entries a face. For `n >= 2` vertices there are `2n - 2` faces, ghosts included. A ghost
/// face is `a -> b`, `b -> ∞`, `∞ -> a`, in this order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct HalfEdges {
    /// The vertex from which each half-edge leaves; [`INFINITY`] for the last of each ghost.
    pub(crate) origin: Vec<u32>,
    /// The half-edge that runs the other way between the same two vertices.
    pub(crate) twin: Vec<u32>,
}

impl EdgeRecords {
    /// Turns the edges into half-edges; faces in the order of the first record of each.
    ///
    /// # Guarantees
    /// Every half-edge has a twin, and the twin of its twin is itself.
    pub(crate) fn into_half_edges(self) -> HalfEdges {
        let mut conversion = Conversion::new(&self);
        conversion.mark_outer_face();
        conversion.number_faces();
        conversion.pair_edges();
        conversion.pair_ghosts();
        conversion.half_edges
    }
}

/// Mark of a directed edge whose face has no number yet.
const UNNUMBERED: u32 = u32::MAX;
/// Mark of a directed edge that waits for its ghost.
const OUTER: u32 = u32::MAX - 1;

/// A conversion under way.
#[derive(Debug)]
struct Conversion<'a> {
    records: &'a EdgeRecords,
    /// For each directed edge its half-edge, or a mark.
    half_edge_of: Vec<u32>,
    half_edges: HalfEdges,
}

impl<'a> Conversion<'a> {
    fn new(records: &'a EdgeRecords) -> Self {
        // A half-edge for each directed edge, and two more for each ghost.
        let room = records.len() + 2 * records.outer_face().count();
        let half_edges = HalfEdges { origin: Vec::with_capacity(room), twin: Vec::new() };
        Self { records, half_edge_of: vec![UNNUMBERED; records.slots()], half_edges }
    }

    /// Step 1.
    fn mark_outer_face(&mut self) {
        for e in self.records.outer_face() {
            self.half_edge_of[e.index()] = OUTER;
        }
    }

    /// Step 2.
    fn number_faces(&mut self) {
        for e in self.records.edges() {
            match self.half_edge_of[e.index()] {
                UNNUMBERED => self.add_triangle(e),
                OUTER => self.add_ghost(e),
                _ => {}
            }
        }
    }

    fn add_triangle(&mut self, ab: Edge) {
        let bc = self.records.next(ab);
        let ca = self.records.next(bc);
        for e in [ab, bc, ca] {
            self.half_edge_of[e.index()] = self.add_half_edge(self.records.origin(e));
        }
    }

    fn add_ghost(&mut self, ab: Edge) {
        self.half_edge_of[ab.index()] = self.add_half_edge(self.records.origin(ab));
        self.add_half_edge(self.records.dest(ab));
        self.add_half_edge(INFINITY);
    }

    /// Numbers fit into 32 bits because there are six half-edges a point, of `MAX_POINTS` at most.
    fn add_half_edge(&mut self, origin: u32) -> u32 {
        let h = self.half_edges.origin.len() as u32;
        self.half_edges.origin.push(origin);
        h
    }

    /// Step 3.
    fn pair_edges(&mut self) {
        self.half_edges.twin = vec![UNNUMBERED; self.half_edges.origin.len()];
        for e in self.records.edges() {
            let h = self.half_edge_of(e);
            self.half_edges.twin[h as usize] = self.half_edge_of(e.twin());
        }
    }

    /// Step 4: the ghost of `ab` and the ghost of the next edge share `b` and infinity.
    fn pair_ghosts(&mut self) {
        for ab in self.records.outer_face() {
            let to_infinity = self.half_edge_of(ab) + 1;
            let from_infinity = self.half_edge_of(self.records.next(ab)) + 2;
            self.half_edges.twin[to_infinity as usize] = from_infinity;
            self.half_edges.twin[from_infinity as usize] = to_infinity;
        }
    }

    fn half_edge_of(&self, e: Edge) -> u32 {
        self.half_edge_of[e.index()]
    }
}
