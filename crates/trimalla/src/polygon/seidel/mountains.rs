//! From trapezoids to triangles, through one monotone piece a side.

use super::TrapezoidMap;
use super::structure::{Cell, LEFT, NONE, RIGHT};
use crate::geometry::{Orientation, orient2d};
use crate::polygon::PolygonError;
use crate::trace::{Shape, Trace};

impl TrapezoidMap<'_> {
    /// The triangles of the polygon: `n - 2 + 2h` for `n` corners and `h` holes, if no rings touch.
    ///
    /// # Shape
    /// Indices into the points of the polygon, each triangle counter-clockwise by the exact test. Of points at one
    /// place one stands for all. A vertex that touches a side is a corner of the triangles on both sides of it.
    ///
    /// # Errors
    /// [`PolygonError::Cancelled`].
    ///
    /// # Complexity
    /// Linear.
    pub fn triangles(&self, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
        for [a, b] in self.diagonals() {
            trace.add(Shape::Edge([a, b]), "from the top to the bottom of a trapezoid");
        }
        let mut mountain = Mountain::default();
        for (count, &at) in self.inside.iter().enumerate() {
            if count % 1024 == 0 && trace.is_cancelled() {
                return Err(PolygonError::Cancelled);
            }
            let cell = self.structure.cell(at);
            for hand in [LEFT, RIGHT] {
                if self.next_along(cell.above[hand], cell.sides[hand], hand).is_none() {
                    self.take_mountain(at, hand, &mut mountain, trace);
                }
            }
        }
        Ok(mountain.triangles)
    }

    /// The edges that divide the polygon into monotone pieces: from the top to the bottom of each trapezoid whose top
    /// and bottom are not the ends of one side.
    pub fn diagonals(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.inside.iter().map(|&at| self.structure.cell(at)).filter_map(|cell| {
            let along = |hand: usize| {
                let side = cell.sides[hand];
                self.structure.is_on(cell.top, side) && self.structure.is_on(cell.bottom, side)
            };
            (!along(LEFT) && !along(RIGHT)).then_some([cell.top, cell.bottom])
        })
    }

    /// A neighbour, if it lies along the same side.
    fn next_along(&self, neighbour: u32, side: u32, hand: usize) -> Option<&Cell> {
        let cell = (neighbour != NONE).then(|| self.structure.cell(neighbour))?;
        (cell.sides[hand] == side).then_some(cell)
    }

    /// Triangulates the piece along one side of the polygon, from its highest trapezoid down.
    fn take_mountain(&self, highest: u32, hand: usize, mountain: &mut Mountain, trace: &mut (impl Trace + ?Sized)) {
        let mut cell = self.structure.cell(highest);
        let side = cell.sides[hand];
        let is_touched = self.structure.sides[side as usize].is_touched;
        mountain.chain.clear();
        mountain.chain.push(cell.top);
        loop {
            self.push(cell.bottom, hand, mountain, trace);
            if is_touched && self.structure.is_on(cell.bottom, side) {
                // The side ends here as far as the piece is concerned.
                mountain.chain.clear();
                mountain.chain.push(cell.bottom);
            }
            match self.next_along(cell.below[hand], side, hand) {
                Some(below) => cell = below,
                None => break,
            }
        }
    }

    /// Adds a vertex to the chain that is not cut off yet, and cuts off every corner that is convex now.
    fn push(&self, vertex: u32, hand: usize, mountain: &mut Mountain, trace: &mut (impl Trace + ?Sized)) {
        // Down a chain right of the side, the inside is on the right.
        let convex = if hand == LEFT { Orientation::Clockwise } else { Orientation::CounterClockwise };
        while let [.., a, b] = mountain.chain[..] {
            if orient2d(self.structure.point(a), self.structure.point(b), self.structure.point(vertex)) != convex {
                break;
            }
            let triangle = if hand == LEFT { [vertex, b, a] } else { [a, b, vertex] };
            trace.add(Shape::Triangle(triangle), "a convex corner of a monotone piece");
            mountain.triangles.push(triangle);
            mountain.chain.pop();
        }
        mountain.chain.push(vertex);
    }
}

/// The corners of a monotone piece that are not cut off, and all triangles cut off so far.
#[derive(Debug, Default)]
struct Mountain {
    chain: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}
