//! The rings are followed through the trapezoids, so that every vertex knows the trapezoid that it is in.

use std::cmp::Ordering;

use super::insert::Inserter;
use super::structure::{LEFT, NONE, RIGHT, ROOT, Side, upwards};
use crate::geometry::{Orientation, orient2d};
use crate::polygon::{Polygon, PolygonError};
use crate::trace::Trace;

impl<T: Trace + ?Sized> Inserter<'_, '_, T> {
    /// Finds the trapezoid of every vertex that is not inserted. `is_inserted` is told of sides by their origin.
    pub(super) fn follow_rings(
        &mut self,
        polygon: Polygon<'_>,
        is_inserted: impl Fn(u32) -> bool,
    ) -> Result<(), PolygonError> {
        for ring in polygon.rings() {
            if self.trace.is_cancelled() {
                return Err(PolygonError::Cancelled);
            }
            let mut here = None;
            for i in ring {
                let i = i as u32;
                here = if is_inserted(i) { None } else { self.follow_side(i, here)? };
            }
        }
        Ok(())
    }

    /// Follows the side that leaves from a point, which lies inside of the trapezoid `here` if that is known. Returns
    /// the trapezoid that has the other end inside.
    fn follow_side(&mut self, i: u32, here: Option<u32>) -> Result<Option<u32>, PolygonError> {
        let j = self.next[i as usize];
        let (p, q) = (self.structure.point(i), self.structure.point(j));
        let direction = upwards(q, p);
        let is_up = direction == Ordering::Greater;
        let (lower, upper) = if is_up { (i, j) } else { (j, i) };
        if direction == Ordering::Equal {
            self.hints[j as usize] = self.hints[i as usize];
            self.same[j as usize] = self.same[i as usize];
            return Ok(here);
        }
        let ends = if is_up { [p, q] } else { [q, p] };
        let side = Side { lower, upper, ends, inside_is_right: false, is_touched: false, origin: i };
        let leave = |this: &mut Self, vertex: u32, p| {
            let hint = this.hints[vertex as usize];
            this.structure.locate_leaving(hint, p, q).map_err(|other| this.crossing(&side, other))
        };
        let start = match self.same[i as usize] {
            NONE => i,
            vertex => vertex,
        };
        let mut at = match here {
            Some(at) => at,
            None => leave(self, start, p)?,
        };
        let mut known = [NONE; 2];
        loop {
            self.structure.steps += 1;
            let cell = *self.structure.cell(at);
            for hand in [LEFT, RIGHT] {
                if cell.sides[hand] != known[hand] {
                    self.refuse_crossing(&side, [cell.sides[hand], NONE])?;
                }
            }
            known = cell.sides;
            let (vertex, ahead) = if is_up { (cell.top, cell.above) } else { (cell.bottom, cell.below) };
            if vertex == NONE {
                return Ok(self.arrive(j, at));
            }
            let w = self.structure.point(vertex);
            let beyond = upwards(q, w);
            if beyond == Ordering::Equal {
                self.same[j as usize] = vertex;
                return Ok(None);
            }
            if beyond != direction {
                return Ok(self.arrive(j, at));
            }
            at = match orient2d(ends[0], ends[1], w) {
                Orientation::CounterClockwise => ahead[RIGHT],
                Orientation::Clockwise => ahead[LEFT],
                Orientation::Collinear => leave(self, vertex, w)?,
            };
        }
    }

    /// A vertex is in a trapezoid. Returns that, unless the vertex is on a side.
    fn arrive(&mut self, vertex: u32, at: u32) -> Option<u32> {
        let cell = *self.structure.cell(at);
        let is_on_side = cell.sides.into_iter().any(|side| self.structure.is_on(vertex, side));
        self.hints[vertex as usize] = if is_on_side { ROOT } else { cell.node };
        (!is_on_side).then_some(at)
    }
}
