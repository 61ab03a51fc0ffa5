//! The edges that the sweep line crosses, from the lowest to the highest.
//!
//! The edges are the nodes of a search tree, and of a list beside it, so that the edges next to a known one are found
//! at once. The tree is a treap: a node has a priority that is a hash of its index, and no child has a higher priority
//! than its parent, which keeps the tree as flat as one that was built in random order.
//!
//! ```text
//!          |           the list:  BOTTOM - a - b - c - d - BOTTOM
//!      ----+---- d
//!      ----+---- c     a node stands for its edge, and for the gap between
//!      ----+---- b     its edge and the one above
//!      ----+---- a
//!          |
//! ```

use crate::geometry::{Orientation, Point, orient2d};

/// The node below all edges, whose gap is outside; also the end of the list, and no child.
pub(super) const BOTTOM: u32 = 0;

/// No piece.
pub(super) const NONE: u32 = u32::MAX;

/// An edge that the sweep line crosses, and the gap above it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The ends of the edge, the left one first.
    pub(super) ends: [Point; 2],
    children: [u32; 2],
    parent: u32,
    pub(super) below: u32,
    pub(super) above: u32,
    /// The edge.
    pub(super) edge: u32,
    /// The piece that the gap above belongs to: the lower one, if there are two.
    pub(super) piece: u32,
    /// The upper one of two pieces, which meet in the merge vertex that was last seen in the gap; or none.
    pub(super) upper_piece: u32,
    /// Whether the gap above is inside the polygon.
    pub(super) inside: bool,
}

impl Node {
    /// A node for an edge.
    pub(super) const fn new(ends: [Point; 2], edge: u32, inside: bool, piece: u32) -> Self {
        let links = BOTTOM;
        Self {
            ends,
            children: [BOTTOM; 2],
            parent: links,
            below: links,
            above: links,
            edge,
            piece,
            upper_piece: NONE,
            inside,
        }
    }

    /// On which side of the edge a point lies: counter-clockwise for above.
    #[inline]
    pub(super) fn side(&self, p: Point) -> Orientation {
        orient2d(self.ends[0], self.ends[1], p)
    }
}

/// Where a point is between the edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// The edge below the point, or one through it.
    pub(super) node: u32,
    /// Whether the edge passes through the point.
    pub(super) on: bool,
}

/// The edges that the sweep line crosses.
#[derive(Clone, Debug, Default)]
pub(super) struct Status {
    nodes: Vec<Node>,
    free: Vec<u32>,
    root: u32,
}

impl std::ops::Index<u32> for Status {
    type Output = Node;

    #[inline]
    fn index(&self, node: u32) -> &Node {
        &self.nodes[node as usize]
    }
}

impl std::ops::IndexMut<u32> for Status {
    #[inline]
    fn index_mut(&mut self, node: u32) -> &mut Node {
        &mut self.nodes[node as usize]
    }
}

impl Status {
    /// Forgets all edges.
    pub(super) fn clear(&mut self) {
        self.nodes.clear();
        self.free.clear();
        self.nodes.push(Node::new([Point::default(); 2], NONE, false, NONE));
        self.root = BOTTOM;
    }

    /// Finds the edge below a point.
    #[inline]
    pub(super) fn find(&self, p: Point) -> Place {
        let (mut below, mut at) = (BOTTOM, self.root);
        while at != BOTTOM {
            let node = &self[at];
            match node.side(p) {
                Orientation::CounterClockwise => {
                    below = at;
                    at = node.children[1];
                }
                Orientation::Clockwise => at = node.children[0],
                Orientation::Collinear => return Place { node: at, on: true },
            }
        }
        Place { node: below, on: false }
    }

    /// Inserts an edge above another one.
    pub(super) fn insert_above(&mut self, below: u32, mut node: Node) -> u32 {
        let above = self[below].above;
        (node.below, node.above) = (below, above);
        let (parent, hand) = if below != BOTTOM && self[below].children[1] == BOTTOM { (below, 1) } else { (above, 0) };
        node.parent = parent;
        let added = if let Some(free) = self.free.pop() {
            self[free] = node;
            free
        } else {
            self.nodes.push(node);
            self.nodes.len() as u32 - 1
        };
        self[below].above = added;
        self[above].below = added;
        if parent == BOTTOM {
            self.root = added;
            return added;
        }
        self[parent].children[hand] = added;
        while self[added].parent != BOTTOM && priority(self[added].parent) < priority(added) {
            self.rotate_up(added);
        }
        added
    }

    /// Removes an edge.
    pub(super) fn remove(&mut self, node: u32) {
        let Node { below, above, .. } = self[node];
        self[below].above = above;
        self[above].below = below;
        loop {
            let [left, right] = self[node].children;
            if left == BOTTOM || right == BOTTOM {
                self.replace(node, if left == BOTTOM { right } else { left });
                break;
            }
            self.rotate_up(if priority(left) < priority(right) { right } else { left });
        }
        self.free.push(node);
    }

    /// Puts a child, or nothing, into the place of its parent.
    #[inline]
    fn replace(&mut self, node: u32, child: u32) {
        let parent = self[node].parent;
        if child != BOTTOM {
            self[child].parent = parent;
        }
        if parent == BOTTOM {
            self.root = child;
        } else {
            let hand = usize::from(self[parent].children[1] == node);
            self[parent].children[hand] = child;
        }
    }

    /// Exchanges a node with its parent, which becomes its child.
    fn rotate_up(&mut self, node: u32) {
        let parent = self[node].parent;
        let hand = usize::from(self[parent].children[1] == node);
        let inner = self[node].children[1 - hand];
        self.replace(parent, node);
        self[parent].children[hand] = inner;
        if inner != BOTTOM {
            self[inner].parent = parent;
        }
        self[node].children[1 - hand] = parent;
        self[parent].parent = node;
    }
}

/// The priority of a node: a hash of its index.
#[inline]
const fn priority(node: u32) -> u32 {
    let mixed = (node ^ (node >> 16)).wrapping_mul(0x7feb_352d);
    let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x846c_a68b);
    mixed ^ (mixed >> 16)
}
