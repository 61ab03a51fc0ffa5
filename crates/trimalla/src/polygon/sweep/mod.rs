//! The sweep that proves a polygon valid and divides it into monotone pieces.
//!
//! A vertical line sweeps the plane from left to right. It stops at every corner, and keeps the edges that it crosses
//! in order ([`status`]). The inside of the polygon between two of these edges is a *gap*, and belongs to one piece
//! that is not finished, or to two that meet in a merge vertex.
//!
//! 1. Sort the corners by x, then by y. Corners at one point are one stop.
//! 2. At a stop, find the edges that end there, and those that begin there; all others pass above or below.
//! 3. Tell the pieces of the gaps beside the corner that they have another corner:
//!
//! ```text
//!   start  <   end  >   upper -.-   lower -.-   split  :::<    merge  >:::
//!                       chain :::   chain                ^ diagonal     ^ diagonal to the
//!                                                        to the last    next corner of the
//!                                                        corner of      gap
//!                                                        the gap
//! ```
//!
//! 4. Replace the edges that end by those that begin.
//! 5. Edges that are neighbours now must not cross further right: the one that ends first must end on its own side of
//!    the other one.
//!
//! *Why no crossing is missed.* Take the leftmost point in which two sides cross. Left of it the order of the edges is
//! right, and just left of it the two are neighbours. They became so at a stop, and step 5 compared them there
//! (`[ShamosHoey76]`).
//!
//! *Ties.* Points are ordered by x and then by y, which is the order of x after all has been turned by an angle that is
//! smaller than any positive number. So no edge is vertical, and no two points are at one stop unless they are the
//! same.
//!
//! *Degenerate cases.* A corner without a neighbour at its point takes the short way in this file. Everything else (a
//! point with several corners, a vertex inside a side) is a *crowd*, [`crowd`]: the edges around the point are sorted
//! by angle, and each part of the inside between two of them gets one corner.
//!
//! # Complexity
//! Expected O(n log n) time, O(n) memory. Two tests of orientation a corner, where the chain goes on; O(log n) at the
//! others.
//!
//! # Source
//! `[GareyEtAl78]` for the pieces, `[ShamosHoey76]` for the crossings. The notes `[Triangulaciones]` draw the
//! diagonals of merge vertices in a second sweep from right to left; here the gap remembers the merge vertex, and the
//! next corner of the gap draws the same diagonal.

mod crowd;
mod order;
mod pieces;
mod status;

use super::PolygonError;
use super::corners::{Corners, Mark};
use crate::geometry::{Orientation, Point, Segment, lexicographically_less, orient2d};
pub use pieces::{Cause, VertexKind};
pub(super) use pieces::{Chain, Pieces};
use status::{BOTTOM, NONE, Node, Place, Status};

/// How many stops pass before the sweep asks whether somebody has cancelled.
const STOPS_BETWEEN_QUESTIONS: usize = 1024;

/// The memory of a sweep, which can be used again.
#[derive(Clone, Debug, Default)]
pub(super) struct Sweep {
    keys: Vec<(u64, u32)>,
    order: Vec<u32>,
    status: Status,
    /// The node of each side that the line crosses.
    nodes: Vec<u32>,
    /// The sides of the edges that begin inside a side: edge `corners.count + i` is a part of side `parts[i]`.
    parts: Vec<u32>,
    /// Whether a vertex was seen inside a side, and of which corners that is true.
    any_touched: bool,
    touched: Vec<bool>,
    /// Whether a ring was seen; empty if there is one ring.
    seen: Vec<bool>,
    crowd: crowd::Crowd,
}

impl Sweep {
    /// Sweeps a polygon, and tells its pieces.
    ///
    /// # Errors
    /// Sides that cross or overlap, holes that are not inside the outline, and `Cancelled`.
    pub(super) fn run(&mut self, corners: &mut Corners, pieces: &mut impl Pieces) -> Result<(), PolygonError> {
        self.prepare(corners);
        let mut begin = 0;
        let mut stops = 0;
        while begin < corners.count {
            stops += 1;
            if stops % STOPS_BETWEEN_QUESTIONS == 0 && pieces.is_cancelled() {
                return Err(PolygonError::Cancelled);
            }
            let first = self.order[begin];
            let point = corners.points[first as usize];
            let mut end = begin + 1;
            while end < corners.count && corners.points[self.order[end] as usize] == point {
                end += 1;
            }
            let touched = self.any_touched && self.order[begin..end].iter().any(|&c| self.touched[c as usize]);
            if end - begin > 1 || touched {
                self.crowd(corners, begin..end, pieces)?;
            } else {
                self.single(corners, begin, pieces)?;
            }
            begin = end;
        }
        Ok(())
    }

    /// Makes ready for another polygon.
    fn prepare(&mut self, corners: &Corners) {
        order::sort(&corners.points, &mut self.keys, &mut self.order);
        self.status.clear();
        self.nodes.resize(corners.count, NONE);
        self.parts.clear();
        self.any_touched = false;
        self.seen.clear();
        self.seen
            .resize(if corners.rings.is_empty() { 0 } else { corners.rings[corners.count - 1] as usize + 1 }, false);
    }

    /// A corner that has its point for itself.
    #[inline]
    fn single(&mut self, corners: &mut Corners, stop: usize, pieces: &mut impl Pieces) -> Result<(), PolygonError> {
        let at = corners.mark(self.order[stop]);
        let [before, after] = corners.links[at.corner as usize];
        let (p, q) = (corners.points[before as usize], corners.points[after as usize]);
        match (lexicographically_less(at.point, p), lexicographically_less(at.point, q)) {
            (false, true) => self.passes(corners, at, [before, at.corner], q, pieces),
            (true, false) => self.passes(corners, at, [at.corner, before], p, pieces),
            (false, false) => {
                let nodes = [before, at.corner].map(|edge| self.nodes[edge as usize]);
                if self.status[nodes[0]].above == nodes[1] {
                    self.closes(corners, at, nodes, pieces)
                } else if self.status[nodes[1]].above == nodes[0] {
                    self.closes(corners, at, [nodes[1], nodes[0]], pieces)
                } else {
                    self.crowd(corners, stop..stop + 1, pieces)
                }
            }
            (true, true) => {
                let place = self.status.find(at.point);
                if place.on {
                    return self.crowd(corners, stop..stop + 1, pieces);
                }
                self.opens(corners, at, place, [(before, p), (at.corner, q)], pieces)
            }
        }
    }

    /// One edge ends in a corner, and one begins there.
    #[inline]
    fn passes(
        &mut self,
        corners: &Corners,
        at: Mark,
        [left, right]: [u32; 2],
        to: Point,
        pieces: &mut impl Pieces,
    ) -> Result<(), PolygonError> {
        let n = self.nodes[left as usize];
        let Node { below, above, inside, .. } = self.status[n];
        if inside {
            pieces.visit(at, VertexKind::Lower);
            self.grows_below(n, at, pieces);
        } else {
            pieces.visit(at, VertexKind::Upper);
            self.grows_above(below, at, pieces);
        }
        pieces.edge(self.status[n].edge, at.corner, !inside);
        pieces.edge(right, at.corner, inside);
        let node = &mut self.status[n];
        node.ends = [at.point, to];
        node.edge = right;
        self.nodes[right as usize] = n;
        self.compare(corners, below, n)?;
        self.compare(corners, n, above)
    }

    /// Two edges begin in a corner: a start or a split vertex.
    fn opens(
        &mut self,
        corners: &Corners,
        at: Mark,
        place: Place,
        mut edges: [(u32, Point); 2],
        pieces: &mut impl Pieces,
    ) -> Result<(), PolygonError> {
        match orient2d(at.point, edges[0].1, edges[1].1) {
            Orientation::CounterClockwise => {}
            Orientation::Clockwise => edges.swap(0, 1),
            Orientation::Collinear => return Err(self.crossing(corners, edges[0].0, edges[1].0)),
        }
        let below = place.node;
        let above = self.status[below].above;
        let splits = self.status[below].inside;
        self.check_nesting(corners, at, edges[0].0, !splits)?;
        let piece = if splits {
            pieces.visit(at, VertexKind::Split);
            self.split(below, at, pieces)
        } else {
            pieces.visit(at, VertexKind::Start);
            pieces.begin(at)
        };
        let pieces_above = if splits { [NONE, piece] } else { [piece, NONE] };
        let mut last = below;
        for (i, &(edge, to)) in edges.iter().enumerate() {
            let inside = splits == (i == 1);
            pieces.edge(edge, at.corner, inside);
            last = self.status.insert_above(last, Node::new([at.point, to], edge, inside, pieces_above[i]));
            self.nodes[edge as usize] = last;
        }
        let first = self.status[last].below;
        self.compare(corners, below, first)?;
        self.compare(corners, last, above)
    }

    /// Two edges end in a corner: an end or a merge vertex.
    fn closes(
        &mut self,
        corners: &Corners,
        at: Mark,
        [lower, upper]: [u32; 2],
        pieces: &mut impl Pieces,
    ) -> Result<(), PolygonError> {
        let (below, above) = (self.status[lower].below, self.status[upper].above);
        let ends = self.status[lower].inside;
        for n in [lower, upper] {
            let Node { edge, inside, .. } = self.status[n];
            pieces.edge(edge, at.corner, !inside);
        }
        if ends {
            pieces.visit(at, VertexKind::End);
            self.finish(lower, at, pieces);
        } else {
            pieces.visit(at, VertexKind::Merge);
            self.grows_above(below, at, pieces);
            self.grows_below(upper, at, pieces);
            self.status[below].upper_piece = self.status[upper].piece;
        }
        self.status.remove(lower);
        self.status.remove(upper);
        self.compare(corners, below, above)
    }

    /// The gap above a node has another corner on its upper side.
    #[inline]
    fn grows_above(&mut self, node: u32, at: Mark, pieces: &mut impl Pieces) {
        let gap = &mut self.status[node];
        if gap.upper_piece != NONE {
            pieces.diagonal(pieces.last(gap.piece).0, at, Cause::Merge);
            pieces.finish(gap.upper_piece, at);
            gap.upper_piece = NONE;
        }
        pieces.extend(gap.piece, at, Chain::Upper);
    }

    /// The gap above a node has another corner on its lower side.
    #[inline]
    fn grows_below(&mut self, node: u32, at: Mark, pieces: &mut impl Pieces) {
        let gap = &mut self.status[node];
        if gap.upper_piece != NONE {
            pieces.diagonal(pieces.last(gap.piece).0, at, Cause::Merge);
            pieces.finish(gap.piece, at);
            gap.piece = gap.upper_piece;
            gap.upper_piece = NONE;
        }
        pieces.extend(gap.piece, at, Chain::Lower);
    }

    /// The gap above a node ends.
    fn finish(&mut self, node: u32, at: Mark, pieces: &mut impl Pieces) {
        let gap = self.status[node];
        if gap.upper_piece != NONE {
            pieces.diagonal(pieces.last(gap.piece).0, at, Cause::Merge);
            pieces.finish(gap.upper_piece, at);
        }
        pieces.finish(gap.piece, at);
    }

    /// The gap above a node is split: the node keeps the lower part, and the piece of the upper part is returned.
    fn split(&mut self, node: u32, at: Mark, pieces: &mut impl Pieces) -> u32 {
        let gap = &mut self.status[node];
        let (helper, chain) = pieces.last(gap.piece);
        if gap.upper_piece != NONE {
            pieces.diagonal(helper, at, Cause::Both);
            let upper = gap.upper_piece;
            gap.upper_piece = NONE;
            pieces.extend(gap.piece, at, Chain::Upper);
            pieces.extend(upper, at, Chain::Lower);
            return upper;
        }
        pieces.diagonal(helper, at, Cause::Split);
        let other = pieces.begin(helper);
        let (lower, upper) = if chain == Chain::Upper { (gap.piece, other) } else { (other, gap.piece) };
        gap.piece = lower;
        pieces.extend(lower, at, Chain::Upper);
        pieces.extend(upper, at, Chain::Lower);
        upper
    }

    /// A ring that is seen for the first time must have its inside where rings of its kind have it.
    #[inline]
    fn check_nesting(&mut self, corners: &Corners, at: Mark, edge: u32, inside: bool) -> Result<(), PolygonError> {
        if self.seen.is_empty() || edge as usize >= corners.count {
            return Ok(());
        }
        let ring = corners.rings[edge as usize] as usize;
        if !self.seen[ring] && inside != (ring == 0) {
            return Err(PolygonError::Nesting { ring, vertex: at.vertex, at: at.point });
        }
        self.seen[ring] = true;
        Ok(())
    }

    /// Two neighbours must not cross further right.
    #[inline]
    fn compare(&mut self, corners: &Corners, lower: u32, upper: u32) -> Result<(), PolygonError> {
        if lower == BOTTOM || upper == BOTTOM {
            return Ok(());
        }
        let (e, f) = (&self.status[lower], &self.status[upper]);
        let (p, q) = (e.ends[1], f.ends[1]);
        let (side, expected, edge, end) = if lexicographically_less(p, q) {
            (f.side(p), Orientation::Clockwise, e.edge, p)
        } else if p != q {
            (e.side(q), Orientation::CounterClockwise, f.edge, q)
        } else {
            return Ok(());
        };
        if side == expected {
            return Ok(());
        }
        if side == Orientation::Collinear {
            self.touch(corners, edge, end);
            return Ok(());
        }
        Err(self.crossing(corners, e.edge, f.edge))
    }

    /// Remembers that the right end of an edge lies inside another one.
    #[cold]
    fn touch(&mut self, corners: &Corners, edge: u32, end: Point) {
        if !self.any_touched {
            self.any_touched = true;
            self.touched.clear();
            self.touched.resize(corners.count, false);
        }
        let side = self.side_of(corners, edge);
        let other = corners.links[side as usize][1];
        let corner = if corners.points[side as usize] == end { side } else { other };
        self.touched[corner as usize] = true;
    }

    /// The side that an edge is a part of.
    fn side_of(&self, corners: &Corners, edge: u32) -> u32 {
        (edge as usize).checked_sub(corners.count).map_or(edge, |part| self.parts[part])
    }

    /// Says that two edges cross or overlap, and where.
    #[cold]
    fn crossing(&self, corners: &Corners, e: u32, f: u32) -> PolygonError {
        let sides = [e, f].map(|edge| self.side_of(corners, edge));
        let segments = sides.map(|s| {
            let [a, b] = [s, corners.links[s as usize][1]].map(|c| corners.points[c as usize]);
            if lexicographically_less(a, b) { Segment::new(a, b) } else { Segment::new(b, a) }
        });
        let [s, t] = segments;
        let begin = if lexicographically_less(s.start, t.start) { t.start } else { s.start };
        let at = s.crossing_point(t).unwrap_or(begin);
        PolygonError::Crossing { sides: sides.map(|s| corners.side(s)), at }
    }
}
