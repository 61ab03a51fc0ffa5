//! Floating-point walks: rounded products say which edge to cross, and only the last face is proved.
//!
//! The steps need no proof: a wrong one only makes the walk longer. Where rounding leaves the last face open, since the
//! point lies on an edge or too near to one, the exact walk goes on.

use super::walk::Locus;
use crate::geometry::{Point, Turn};
use crate::half_edge::FaceId;
use crate::triangulation::Triangulation;

/// A floating-point walk makes no more steps than this: rounding might lead it in circles.
const FLOAT_STEPS: usize = 64;

impl Triangulation {
    /// The floating-point visibility walk; the face at its end is proved. The error is the face at which rounding
    /// leaves the answer open, or the face after [`FLOAT_STEPS`] steps.
    #[inline(always)] // Before each insertion.
    pub(super) fn float_walk(&self, start: FaceId, p: Point) -> Result<Locus, FaceId> {
        let [a, b, _] = self.vertices_in_slot(start).ok_or(start)?.map(|v| self.points.get(v.index()));
        let (Some(&(mut a)), Some(&(mut b))) = (a, b) else { return Err(start) };
        let mut e = start.half_edge(0);
        let mut side = Turn::of(a, b, p);
        if side.seems_clockwise() {
            (e, side) = (self.twin(e), side.reversed());
            (a, b) = (b, a);
        }
        for _ in 0..FLOAT_STEPS {
            let (bc, ca) = (e.next(), e.prev());
            let Some(&c) = self.points.get(self.origin(ca).index()) else {
                // The face is a ghost.
                return if side.is_surely_counter_clockwise() { Ok(Locus::Outside(e)) } else { Err(e.face()) };
            };
            let (side_of_bc, side_of_ca) = (Turn::of(b, c, p), Turn::of(c, a, p));
            if side_of_bc.seems_clockwise() {
                (e, side, a, b) = (self.twin(bc), side_of_bc.reversed(), c, b);
            } else if side_of_ca.seems_clockwise() {
                (e, side, a, b) = (self.twin(ca), side_of_ca.reversed(), a, c);
            } else {
                let is_inside = [side, side_of_bc, side_of_ca].into_iter().all(Turn::is_surely_counter_clockwise);
                return if is_inside { Ok(Locus::Face(e.face())) } else { Err(e.face()) };
            }
        }
        Err(e.face())
    }

    /// The floating-point [`walk_within`](Self::walk_within): the face at which it ends, proved. `None` where rounding
    /// leaves the answer open, or where a constrained edge or the end of the domain is in the way.
    pub(crate) fn float_walk_within(&self, start: FaceId, p: Point) -> Option<FaceId> {
        let [a, b, _] = self.vertices_in_slot(start)?.map(|v| self.points.get(v.index()));
        let (mut a, mut b) = (*a?, *b?);
        let mut e = start.half_edge(0);
        let mut side = Turn::of(a, b, p);
        for _ in 0..FLOAT_STEPS {
            let (next, prev) = e.next_and_prev();
            let c = *self.points.get(self.origin(prev).index())?;
            let sides = [side, Turn::of(b, c, p), Turn::of(c, a, p)];
            let Some(exit) = self.exit(start, p, [e, next, prev], sides.map(Turn::seems_clockwise)) else {
                return sides.into_iter().all(Turn::is_surely_counter_clockwise).then_some(e.face());
            };
            if self.is_marked(exit) {
                return None;
            }
            (side, a, b) = match exit {
                _ if exit == e => (sides[0], b, a),
                _ if exit == next => (sides[1], c, b),
                _ => (sides[2], a, c),
            };
            (e, side) = (self.twin(exit), side.reversed());
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::delaunay::Delaunay;
    use crate::geometry::{Orientation, orient2d};

    /// Points on lines, and points an ulp or so beside those that they make.
    fn near_lines() -> Vec<Point> {
        let third = |x: f64| Point::new(x, x / 3.0);
        let on_line = (0..40_u8).map(|i| third(f64::from(i) * 0.37));
        let around = (0..40_u16).map(|i| Point::new(f64::from(i * 7 % 13) * 1.1, f64::from(i * 5 % 11) * 0.9));
        on_line.chain(around).collect()
    }

    #[test]
    fn floating_point_walks_end_where_exact_ones_do() {
        let points = near_lines();
        let t = Delaunay::new(&points).expect("finite");
        let middles = points.windows(2).map(|p| Point::midpoint(p[0], p[1]));
        let (mut said, mut open) = (0, 0);
        for p in middles.chain(points.iter().copied()).chain([Point::new(-1e3, 2.0), Point::new(1e-9, 0.0)]) {
            for start in (0..t.face_slots()).map(FaceId::from_index) {
                let holds = |f: FaceId| {
                    t.is_real(f) && f.half_edges().into_iter().all(|h| t.side_of(h, p) == Orientation::CounterClockwise)
                };
                match t.float_walk(start, p) {
                    Ok(Locus::Face(f)) => assert!(holds(f), "{p} from {start}"),
                    Ok(Locus::Outside(h)) => {
                        let [a, b] = t.edge_points(h);
                        assert!(t.is_ghost(h.face()) && orient2d(a, b, p) == Orientation::CounterClockwise);
                    }
                    Ok(locus) => panic!("{p} from {start}: {locus:?}"),
                    Err(near) => {
                        assert!(near.index() < t.face_slots());
                        open += 1;
                    }
                }
                if let Some(f) = t.float_walk_within(start, p) {
                    assert!(holds(f), "{p} from {start}");
                    said += 1;
                }
            }
        }
        assert!(said > 1000 && open > 1000, "{said} {open}");
    }

    #[test]
    fn a_slot_that_is_none_is_left_to_the_exact_walk() {
        let t = Delaunay::new(&near_lines()).expect("finite");
        let beyond = FaceId::from_index(t.face_slots() + 7);
        assert_eq!(t.float_walk(beyond, Point::new(1.0, 1.0)), Err(beyond));
        assert_eq!(t.float_walk_within(beyond, Point::new(1.0, 1.0)), None);
        assert_eq!(t.locate_from(beyond, Point::new(1e3, 1e3)), t.locate(Point::new(1e3, 1e3)));
    }
}
