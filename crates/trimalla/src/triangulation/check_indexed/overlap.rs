//! Finds triangles that lie on one another by a sweep over the boundary.
//!
//! Let every triangle be counter-clockwise, and add up their boundaries. Sides of neighbours cancel, what is
//! left is the boundary of the mesh; and how often the boundary winds around a place is how many
//! triangles cover it. (Comparing the sum of the triangles' areas with the area that the boundary encloses
//! finds nothing: by the same addition both are always equal, overlaps counted as often as they occur.)
//! So the triangles cover every place at most once exactly if the boundary winds around every
//! place not at all or once.
//!
//! 1. A line sweeps from left to right over the ends of the boundary edges, in lexicographic order. The edges
//!    that it meets are kept from bottom to top.
//! 2. Two edges that become neighbours may have nothing but an end in common. Edges that cross become
//!    neighbours before, so the first contact is found `[ShamosHoey76]`. A proper crossing implies places
//!    of winding 2 or −1. A vertex on an edge is no overlap, but the triangles do not meet edge to edge.
//! 3. Without contacts the winding changes only across edges. From bottom to top, edges that run to the right
//!    (triangle above) and to the left (triangle below) must alternate, beginning with one to the right.
//!
//! Degenerate cases: vertical edges are swept from their lower end, as if the plane were sheared by an
//! infinitesimal amount; edges that start together are ordered by the turn between them; two that start
//! together in one direction overlap, and whichever order they get, they are neighbours.

use core::cmp::Ordering;
use core::ops::Bound::{Excluded, Unbounded};
use std::collections::BTreeSet;

use super::{MeshFault, ends};
use crate::drawing::{IndexedMesh, Side, Sides};
use crate::geometry::{
    Orientation, Point, SegmentContact, lexicographic, lexicographically_less, orient2d, segment_contact,
};

/// A boundary edge as the sweep sees it.
#[derive(Clone, Copy, Debug)]
struct Edge {
    left: Point,
    right: Point,
    /// Whether its triangle lies above it.
    rightward: bool,
    side: Side,
}

impl Edge {
    fn new(mesh: &IndexedMesh, side: Side) -> Self {
        let [a, b] = [side.origin, side.dest].map(|v| mesh.points[v as usize]);
        let rightward = lexicographically_less(a, b);
        let (left, right) = if rightward { (a, b) } else { (b, a) };
        Self { left, right, rightward, side }
    }

    fn shares_vertex(&self, other: &Self) -> bool {
        let ours = [self.side.origin, self.side.dest];
        ours.contains(&other.side.origin) || ours.contains(&other.side.dest)
    }
}

/// From bottom to top, for edges that a common sweep line meets and that have no contact left of it.
impl Ord for Edge {
    fn cmp(&self, other: &Self) -> Ordering {
        let key = |e: &Self| (e.side.origin, e.side.dest);
        let by_place =
            if lexicographically_less(other.left, self.left) { rank(other, self).reverse() } else { rank(self, other) };
        by_place.then_with(|| key(self).cmp(&key(other)))
    }
}

/// `Less` if `first`, which starts no later, lies below `second`.
fn rank(first: &Edge, second: &Edge) -> Ordering {
    let side = |p: Point| match orient2d(first.left, first.right, p) {
        Orientation::CounterClockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Greater,
    };
    side(second.left).then_with(|| side(second.right))
}

impl PartialOrd for Edge {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Edge {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Edge {}

/// The first place where triangles of a mesh overlap or do not meet edge to edge.
///
/// # Shape
/// Every triangle is sound, finite and counter-clockwise; no directed edge is used twice; no two used
/// vertices lie on one place.
///
/// # Complexity
/// O(b log b) for b boundary edges.
pub(super) fn overlap_fault(mesh: &IndexedMesh, sides: &Sides) -> Option<MeshFault> {
    let edges: Vec<Edge> = sides.boundary().map(|&s| Edge::new(mesh, s)).collect();
    let mut starts: Vec<usize> = (0..edges.len()).collect();
    starts.sort_unstable_by(|&a, &b| lexicographic(edges[a].left, edges[b].left).then(a.cmp(&b)));
    let mut stops: Vec<usize> = (0..edges.len()).collect();
    stops.sort_unstable_by(|&a, &b| lexicographic(edges[a].right, edges[b].right).then(a.cmp(&b)));
    let (mut starts, mut stops) = (starts.into_iter().peekable(), stops.into_iter().peekable());
    let mut sweep = Sweep { mesh, met: BTreeSet::new() };
    // Every edge starts before it stops: when all have stopped, all have started.
    while let Some(&next) = stops.peek() {
        let stop = edges[next].right;
        let here = starts.peek().map_or(stop, |&s| earlier(edges[s].left, stop));
        let mut stopped = None;
        while let Some(e) = stops.next_if(|&e| edges[e].right == here) {
            sweep.met.remove(&edges[e]);
            stopped = Some(edges[e]);
        }
        let mut started = Vec::new();
        while let Some(e) = starts.next_if(|&e| edges[e].left == here) {
            sweep.met.insert(edges[e]);
            started.push(edges[e]);
        }
        // Contacts first: where edges overlap, the order between them means nothing.
        let pairs = sweep.new_neighbours(&started, stopped);
        let contact = pairs.iter().find_map(|&pair| sweep.contact_fault(pair));
        let fault = contact.or_else(|| pairs.iter().find_map(|&pair| sweep.winding_fault(pair)));
        if fault.is_some() {
            return fault;
        }
    }
    None
}

/// The lexicographically smaller point.
fn earlier(a: Point, b: Point) -> Point {
    if lexicographically_less(a, b) { a } else { b }
}

/// An edge and the one above it; nothing stands for the void below or above all edges.
type Neighbours = (Option<Edge>, Option<Edge>);

/// The edges that the sweep line meets.
struct Sweep<'a> {
    mesh: &'a IndexedMesh,
    met: BTreeSet<Edge>,
}

impl Sweep<'_> {
    fn below(&self, edge: &Edge) -> Option<Edge> {
        self.met.range((Unbounded, Excluded(edge))).next_back().copied()
    }

    fn above(&self, edge: &Edge) -> Option<Edge> {
        self.met.range((Excluded(edge), Unbounded)).next().copied()
    }

    /// The neighbours of edges that have just started, or else those between which edges have stopped.
    fn new_neighbours(&self, started: &[Edge], stopped: Option<Edge>) -> Vec<Neighbours> {
        if let (Some(gone), []) = (stopped, started) {
            return vec![(self.below(&gone), self.above(&gone))];
        }
        let beside = |&e: &Edge| [(self.below(&e), Some(e)), (Some(e), self.above(&e))];
        started.iter().flat_map(beside).collect()
    }

    /// Neighbours that do not alternate.
    fn winding_fault(&self, (below, above): Neighbours) -> Option<MeshFault> {
        // The triangle of an edge to the right lies above it.
        let covered_from_below = below.is_some_and(|e| e.rightward);
        let covered_from_above = above.is_some_and(|e| !e.rightward);
        if covered_from_below == covered_from_above {
            return None;
        }
        let edge = below.or(above)?;
        Some(MeshFault::Overlap { triangle: edge.side.triangle, edge: ends(self.mesh, &edge.side) })
    }

    /// Neighbours that have more in common than an end.
    fn contact_fault(&self, (below, above): Neighbours) -> Option<MeshFault> {
        let (one, two) = (below?, above?);
        let contact = segment_contact(one.left, one.right, two.left, two.right);
        let fine = match contact {
            SegmentContact::Apart => true,
            SegmentContact::Touching => one.shares_vertex(&two),
            SegmentContact::Crossing | SegmentContact::Overlapping => false,
        };
        (!fine).then(|| MeshFault::BoundaryContact {
            edges: [ends(self.mesh, &one.side), ends(self.mesh, &two.side)],
            triangles: [one.side.triangle, two.side.triangle],
            contact,
        })
    }
}
