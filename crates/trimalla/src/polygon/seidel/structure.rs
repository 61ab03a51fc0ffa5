//! Trapezoids with their neighbours, and the query structure that finds them.

use std::cmp::Ordering;

use super::map::abscissa;
use crate::geometry::{Orientation, Point, collinear, orient2d};

/// No vertex, side, trapezoid.
pub(super) const NONE: u32 = u32::MAX;

/// The first node of the query structure.
pub(super) const ROOT: u32 = 0;

/// Index 0 is left, index 1 is right.
pub(super) const LEFT: usize = 0;
pub(super) const RIGHT: usize = 1;

/// The order of points upwards: by y, and of equal y by x, as if the plane were tilted by less than any angle.
#[inline]
pub(super) fn upwards(p: Point, q: Point) -> Ordering {
    let number = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    number(p.y, q.y).then(number(p.x, q.x))
}

/// A side of the polygon, or a piece of one that ends where the side touches a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    pub(super) lower: u32,
    pub(super) upper: u32,
    /// Where the lower and the upper end are.
    pub(super) ends: [Point; 2],
    /// Whether the inside of the polygon is on the right, looking up.
    pub(super) inside_is_right: bool,
    /// Whether it has vertices between its ends.
    pub(super) is_touched: bool,
    /// The side of the polygon, by the point from which it leaves.
    pub(super) origin: u32,
}

/// A trapezoid of the plane. It is as wide as it can be between two sides, and as high between the lines through two
/// vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) top: u32,
    pub(super) bottom: u32,
    /// The sides on its left and right.
    pub(super) sides: [u32; 2],
    /// The trapezoids above the left and the right end of its upper edge: none if that is a point.
    pub(super) above: [u32; 2],
    /// The trapezoids below the left and the right end of its lower edge.
    pub(super) below: [u32; 2],
    /// Its leaf in the query structure.
    pub(super) node: u32,
}

/// A node of the query structure.
#[derive(Clone, Copy, Debug)]
pub(super) enum Node {
    /// A trapezoid.
    Leaf(u32),
    /// Is the point below or above this vertex?
    Vertex { vertex: u32, at: Point, below: u32, above: u32 },
    /// Is the point left or right of this side?
    Side { side: u32, children: [u32; 2] },
}

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// At this vertex.
    Vertex(u32),
    /// In this trapezoid, or on the side.
    In { cell: u32, on: u32 },
}

/// The trapezoids of the sides that are inserted.
#[derive(Clone, Debug)]
pub(super) struct Structure<'a> {
    pub(super) points: &'a [Point],
    pub(super) sides: Vec<Side>,
    pub(super) cells: Vec<Cell>,
    pub(super) nodes: Vec<Node>,
    /// How many nodes and trapezoids were visited.
    pub(super) steps: u64,
}

impl<'a> Structure<'a> {
    /// One trapezoid: the plane.
    pub(super) fn new(points: &'a [Point]) -> Self {
        let n = points.len();
        let plane = Cell { top: NONE, bottom: NONE, sides: [NONE; 2], above: [NONE; 2], below: [NONE; 2], node: ROOT };
        // A vertex adds one trapezoid and two leaves, a side one trapezoid and two leaves and one for each vertex
        // passed.
        let mut structure = Self {
            points,
            sides: Vec::with_capacity(n),
            cells: Vec::with_capacity(2 * n + 1),
            nodes: Vec::with_capacity(8 * n + 1),
            steps: 0,
        };
        structure.cells.push(plane);
        structure.nodes.push(Node::Leaf(0));
        structure
    }

    #[inline]
    pub(super) fn point(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    #[inline]
    pub(super) fn cell(&self, cell: u32) -> &Cell {
        &self.cells[cell as usize]
    }

    #[inline]
    pub(super) fn cell_mut(&mut self, cell: u32) -> &mut Cell {
        &mut self.cells[cell as usize]
    }

    /// Adds a trapezoid with a leaf of its own.
    pub(super) fn add_cell(&mut self, cell: Cell) -> u32 {
        let id = self.cells.len() as u32;
        self.cells.push(cell);
        self.set_leaf(id);
        id
    }

    /// Gives a trapezoid a new leaf.
    pub(super) fn set_leaf(&mut self, cell: u32) {
        self.cell_mut(cell).node = self.nodes.len() as u32;
        self.nodes.push(Node::Leaf(cell));
    }

    /// The lower and the upper end of a side.
    #[inline]
    pub(super) fn ends(&self, side: u32) -> [Point; 2] {
        self.sides[side as usize].ends
    }

    /// Whether a vertex no lower and no higher than a side lies on it.
    pub(super) fn is_on(&self, vertex: u32, side: u32) -> bool {
        if side == NONE {
            return false;
        }
        let Side { lower, upper, ends: [a, b], .. } = self.sides[side as usize];
        vertex == lower || vertex == upper || collinear(a, b, self.point(vertex))
    }

    /// Where a point is, looked up from a node whose part of the plane holds it. A point on a side counts as on the
    /// given hand of it.
    pub(super) fn locate(&self, from: u32, p: Point, hand: usize, steps: &mut u64) -> Place {
        let (mut at, mut on) = (from, NONE);
        loop {
            *steps += 1;
            at = match self.nodes[at as usize] {
                Node::Leaf(cell) => return Place::In { cell, on },
                Node::Vertex { vertex, at, below, above } => match upwards(p, at) {
                    Ordering::Less => below,
                    Ordering::Greater => above,
                    Ordering::Equal => return Place::Vertex(vertex),
                },
                Node::Side { side, children } => {
                    let [lower, upper] = self.ends(side);
                    match orient2d(lower, upper, p) {
                        Orientation::CounterClockwise => children[LEFT],
                        Orientation::Clockwise => children[RIGHT],
                        Orientation::Collinear => {
                            on = side;
                            children[hand]
                        }
                    }
                }
            };
        }
    }

    /// The trapezoid into which the segment from `p` to `q` leaves, or the side along which it runs, looked up from a
    /// node whose part of the plane holds both sides of `p`.
    pub(super) fn locate_leaving(&mut self, from: u32, p: Point, q: Point) -> Result<u32, u32> {
        let is_down = upwards(q, p) == Ordering::Less;
        let mut at = from;
        loop {
            self.steps += 1;
            at = match self.nodes[at as usize] {
                Node::Leaf(cell) => return Ok(cell),
                Node::Vertex { at, below, above, .. } => match upwards(p, at) {
                    Ordering::Less => below,
                    Ordering::Greater => above,
                    Ordering::Equal if is_down => below,
                    Ordering::Equal => above,
                },
                Node::Side { side, children } => {
                    let [lower, upper] = self.ends(side);
                    let turn = match orient2d(lower, upper, p) {
                        Orientation::Collinear => orient2d(lower, upper, q),
                        turn => turn,
                    };
                    match turn {
                        Orientation::CounterClockwise => children[LEFT],
                        Orientation::Clockwise => children[RIGHT],
                        Orientation::Collinear => return Err(side),
                    }
                }
            };
        }
    }

    /// The abscissa of a side at a height, rounded: to draw with. None for no side. It cannot panic, so that it costs
    /// nothing where nobody draws.
    #[inline]
    pub(super) fn abscissa(&self, side: u32, y: f64) -> Option<f64> {
        let [lower, upper] = self.sides.get(side as usize)?.ends;
        Some(abscissa(lower, upper, y))
    }
}

/// Replaces a neighbour.
pub(super) fn replace(neighbours: &mut [u32; 2], old: u32, new: u32) {
    for neighbour in neighbours.iter_mut().filter(|n| **n == old) {
        *neighbour = new;
    }
}
