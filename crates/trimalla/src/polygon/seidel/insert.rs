//! Vertices and sides are inserted into the trapezoids, one after the other.

use std::cmp::Ordering;

use super::structure::{Cell, LEFT, NONE, Node, Place, RIGHT, ROOT, Side, Structure, replace, upwards};
use crate::geometry::{Orientation, Point, Segment, orient2d, segments_cross_properly};
use crate::polygon::PolygonError;
use crate::trace::{Shape, Trace};

/// Inserts into a structure, and finds the next trapezoid of each vertex.
#[derive(Debug)]
pub(super) struct Inserter<'a, 't, T: ?Sized> {
    pub(super) structure: Structure<'a>,
    /// The vertex that stands for each point: itself, the first inserted point at the same place, or none yet.
    pub(super) same: Vec<u32>,
    /// A node whose part of the plane holds the point and what is beside it.
    pub(super) hints: Vec<u32>,
    /// Vertices inside sides: the side by its origin, and the vertex.
    pub(super) touches: Vec<(u32, u32)>,
    /// The point after each point in its ring.
    pub(super) next: Vec<u32>,
    pub(super) trace: &'t mut T,
}

impl<T: Trace + ?Sized> Inserter<'_, '_, T> {
    /// Inserts the side that leaves from a point.
    pub(super) fn insert(&mut self, origin: u32, inside_is_right: bool) -> Result<(), PolygonError> {
        let [p, q] = [origin, self.next[origin as usize]].map(|v| self.insert_vertex(v));
        let is_up = upwards(self.structure.point(q), self.structure.point(p)) == Ordering::Greater;
        let [lower, upper] = if is_up { [p, q] } else { [q, p] };
        let ends = [lower, upper].map(|v| self.structure.point(v));
        let inside_is_right = inside_is_right == is_up;
        self.insert_side(Side { lower, upper, ends, inside_is_right, is_touched: false, origin })
    }

    /// Inserts a point, unless one at its place is there: its trapezoid is divided by a horizontal line. Returns the
    /// vertex that stands for it.
    pub(super) fn insert_vertex(&mut self, i: u32) -> u32 {
        let known = self.same[i as usize];
        if known != NONE {
            return known;
        }
        let p = self.structure.point(i);
        let (cell, vertex) = match self.locate(self.hints[i as usize], p, LEFT) {
            Place::Vertex(vertex) => (NONE, vertex),
            Place::In { cell, .. } => (cell, i),
        };
        self.same[i as usize] = vertex;
        if cell == NONE {
            return vertex;
        }
        let sides = self.structure.cell(cell).sides;
        let touched = [LEFT, RIGHT].into_iter().find(|&hand| self.structure.is_on(i, sides[hand]));
        if let Some(hand) = touched {
            // The trapezoid on the other side of the touched side is divided too.
            if let Place::In { cell: other, .. } = self.locate(ROOT, p, hand) {
                self.divide(other, i, Some(1 - hand));
            }
            let side = &mut self.structure.sides[sides[hand] as usize];
            side.is_touched = true;
            self.touches.push((side.origin, i));
        } else {
            // All around the point is below this node from now on.
            self.hints[i as usize] = self.structure.cell(cell).node;
        }
        self.divide(cell, i, touched);
        i
    }

    fn locate(&mut self, from: u32, p: Point, hand: usize) -> Place {
        let mut steps = 0;
        let place = self.structure.locate(from, p, hand, &mut steps);
        self.structure.steps += steps;
        place
    }

    /// Divides a trapezoid by the horizontal line through a vertex in it, or on its side of the given hand.
    fn divide(&mut self, upper: u32, vertex: u32, touched_hand: Option<usize>) {
        let s = &mut self.structure;
        let old = *s.cell(upper);
        let lower = s.add_cell(Cell { top: vertex, above: [upper; 2], ..old });
        for cell in old.below.into_iter().filter(|&cell| cell != NONE) {
            replace(&mut s.cell_mut(cell).above, upper, lower);
        }
        s.set_leaf(upper);
        let cell = s.cell_mut(upper);
        (cell.bottom, cell.below) = (vertex, [lower; 2]);
        let (above, below) = (cell.node, s.cell(lower).node);
        s.nodes[old.node as usize] = Node::Vertex { vertex, at: s.point(vertex), below, above };
        self.trace.add(Shape::Vertex(vertex), "the end of a side");
        for hand in [LEFT, RIGHT] {
            if touched_hand != Some(hand) {
                if let Some(line) = self.line(vertex, old.sides[hand]) {
                    self.trace.add(line, "horizontal, as far as the next side");
                }
            }
        }
    }

    /// The horizontal line from a vertex to a side.
    #[inline]
    fn line(&self, vertex: u32, side: u32) -> Option<Shape> {
        let p = *self.structure.points.get(vertex as usize)?;
        Some(Shape::Line([p, Point::new(self.structure.abscissa(side, p.y)?, p.y)]))
    }

    /// Inserts a side, whose ends are inserted, piece by piece between the vertices that it touches.
    fn insert_side(&mut self, side: Side) -> Result<(), PolygonError> {
        self.trace.look(Shape::Edge([side.lower, side.upper]), "the next side");
        let mut rest = Some(side);
        while let Some(piece) = rest {
            rest = self.insert_piece(piece)?;
        }
        self.trace.add(Shape::Edge([side.lower, side.upper]), "divides the trapezoids along it");
        Ok(())
    }

    /// Inserts a side from its upper end as far as the first vertex on it, and returns what is left.
    fn insert_piece(&mut self, piece: Side) -> Result<Option<Side>, PolygonError> {
        let [lower, upper] = piece.ends;
        let from = self.hints[piece.upper as usize];
        let first = self.structure.locate_leaving(from, upper, lower).map_err(|other| self.crossing(&piece, other))?;
        let side = self.structure.sides.len() as u32;
        self.structure.sides.push(piece);
        let mut at = first;
        let mut old = *self.structure.cell(at);
        self.refuse_crossing(&piece, old.sides)?;
        let mut parts = self.begin(side, at, &old);
        loop {
            self.structure.steps += 1;
            let children = parts.map(|part| self.structure.cell(part).node);
            self.structure.nodes[old.node as usize] = Node::Side { side, children };
            let vertex = old.bottom;
            let hand = match self.hand(&piece, vertex) {
                Some(hand) => hand,
                None => {
                    self.end(parts, at, &old);
                    let rest = self.structure.cut(side, vertex);
                    self.touches.extend(rest.map(|rest| (rest.origin, vertex)));
                    break Ok(rest);
                }
            };
            // The part on the vertex's hand ends at its line, and the other one goes on.
            let other = 1 - hand;
            let next = old.below[other];
            let after = *self.structure.cell(next);
            for k in [LEFT, RIGHT] {
                if after.sides[k] != old.sides[k] {
                    self.refuse_crossing(&piece, [after.sides[k], NONE])?;
                }
            }
            if let Some(line) = self.line(vertex, old.sides[other]) {
                self.trace.remove(line, "ends at the new side");
            }
            if let Some(line) = self.line(vertex, side) {
                self.trace.add(line, "horizontal, as far as the next side");
            }
            parts[hand] = self.go_on(side, hand, parts[hand], [at, next], &old, &after);
            (at, old) = (next, after);
        }
    }

    /// On which hand of a side a vertex is; none if it is on it.
    fn hand(&self, side: &Side, vertex: u32) -> Option<usize> {
        if vertex == side.lower {
            return None;
        }
        let [lower, upper] = side.ends;
        match orient2d(lower, upper, self.structure.point(vertex)) {
            Orientation::CounterClockwise => Some(LEFT),
            Orientation::Clockwise => Some(RIGHT),
            Orientation::Collinear => None,
        }
    }

    /// Divides the first trapezoid: what is left of the side keeps its number. Returns both parts.
    fn begin(&mut self, side: u32, at: u32, old: &Cell) -> [u32; 2] {
        let s = &mut self.structure;
        let is_corner = old.sides.map(|bound| s.is_on(old.top, bound));
        let mut parts = [at, NONE];
        for hand in [LEFT, RIGHT] {
            let mut part = Cell { bottom: NONE, below: [NONE; 2], ..*old };
            part.sides[1 - hand] = side;
            part.above = if is_corner[hand] { [NONE; 2] } else { [old.above[hand]; 2] };
            if hand == LEFT {
                *s.cell_mut(at) = part;
                s.set_leaf(at);
            } else {
                parts[RIGHT] = s.add_cell(part);
            }
        }
        let [upper_left, upper_right] = old.above;
        if is_corner == [false, false] && upper_left == upper_right {
            if upper_left != NONE {
                s.cell_mut(upper_left).below = parts;
            }
        } else {
            for hand in [LEFT, RIGHT] {
                if !is_corner[hand] && old.above[hand] != NONE {
                    replace(&mut s.cell_mut(old.above[hand]).below, at, parts[hand]);
                }
            }
        }
        parts
    }

    /// Ends the part on one hand of a side at the line to the next trapezoid, in which a new part begins. Returns it.
    fn go_on(&mut self, side: u32, hand: usize, part: u32, [at, next]: [u32; 2], old: &Cell, after: &Cell) -> u32 {
        let s = &mut self.structure;
        let ended = s.cell_mut(part);
        (ended.bottom, ended.below) = (old.bottom, old.below);
        if old.below[hand] != next {
            replace(&mut s.cell_mut(old.below[hand]).above, at, part);
        }
        let mut begun = Cell { bottom: NONE, below: [NONE; 2], above: [part; 2], ..*after };
        begun.sides[1 - hand] = side;
        if after.above[hand] != at {
            begun.above[hand] = after.above[hand];
        }
        *s.cell_mut(next) = begun;
        s.set_leaf(next);
        next
    }

    /// Ends both parts of a side at its last vertex.
    fn end(&mut self, parts: [u32; 2], at: u32, old: &Cell) {
        let s = &mut self.structure;
        let is_corner = old.sides.map(|bound| s.is_on(old.bottom, bound));
        for hand in [LEFT, RIGHT] {
            let part = s.cell_mut(parts[hand]);
            part.bottom = old.bottom;
            part.below = if is_corner[hand] { [NONE; 2] } else { [old.below[hand]; 2] };
        }
        if is_corner == [false, false] && old.below[LEFT] == old.below[RIGHT] {
            if old.below[LEFT] != NONE {
                s.cell_mut(old.below[LEFT]).above = parts;
            }
        } else {
            for hand in [LEFT, RIGHT] {
                if !is_corner[hand] && old.below[hand] != NONE {
                    replace(&mut s.cell_mut(old.below[hand]).above, at, parts[hand]);
                }
            }
        }
    }

    /// Refuses a side that crosses one of two others.
    pub(super) fn refuse_crossing(&self, side: &Side, others: [u32; 2]) -> Result<(), PolygonError> {
        let [a, b] = side.ends;
        for other in others.into_iter().filter(|&other| other != NONE) {
            let Side { lower, upper, ends: [c, d], .. } = self.structure.sides[other as usize];
            let share_an_end = side.lower == lower || side.upper == upper;
            if !share_an_end && segments_cross_properly(a, b, c, d) {
                return Err(self.crossing(side, other));
            }
        }
        Ok(())
    }

    /// Refuses two sides that have one vertex inside: they cross there.
    pub(super) fn refuse_crossings_at_vertices(&mut self) -> Result<(), PolygonError> {
        self.touches.sort_unstable_by_key(|&(origin, vertex)| (vertex, origin));
        self.touches.dedup();
        let same_vertex = |pair: &&[(u32, u32)]| pair[0].1 == pair[1].1;
        match self.touches.windows(2).find(same_vertex) {
            Some(pair) => Err(self.crossing_of([pair[0].0, pair[1].0], pair[0].1)),
            None => Ok(()),
        }
    }

    /// Two sides cross or overlap.
    pub(super) fn crossing(&self, side: &Side, other: u32) -> PolygonError {
        self.crossing_of([self.structure.sides[other as usize].origin, side.origin], side.upper)
    }

    /// Two sides cross, or overlap from a vertex on.
    fn crossing_of(&self, origins: [u32; 2], vertex: u32) -> PolygonError {
        let sides = origins.map(|origin| [origin, self.next[origin as usize]]);
        let [one, two] = sides.map(|[a, b]| Segment::new(self.structure.point(a), self.structure.point(b)));
        let at = one.crossing_point(two).unwrap_or_else(|| self.structure.point(vertex));
        PolygonError::Crossing { sides, at }
    }
}

impl Structure<'_> {
    /// Cuts the last piece at a vertex on it, and returns what is below.
    fn cut(&mut self, side: u32, vertex: u32) -> Option<Side> {
        let at = self.point(vertex);
        let piece = &mut self.sides[side as usize];
        let rest = Side { upper: vertex, ends: [piece.ends[0], at], ..*piece };
        (piece.lower, piece.ends[0]) = (vertex, at);
        (vertex != rest.lower).then_some(rest)
    }
}
