//! The arcs of path data, which are given by their ends.

use trimalla::geometry::math::{atan2, cos, hypot, sin};
use trimalla::geometry::{Point, Vector};

use super::super::curve::Arc;
use super::super::sketch::Vertex;

/// The radii, the turn of the first in degrees, and which of the four arcs with them it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given {
    pub(super) rx: f64,
    pub(super) ry: f64,
    pub(super) turn: f64,
    pub(super) is_large: bool,
    pub(super) is_positive: bool,
}

/// The arc between two points; `None` where it is a straight line.
///
/// Radii that are too small are enlarged, as the standard asks for (implementation notes, F.6).
pub(super) fn between(from: Point, to: Point, given: Given) -> Option<Arc> {
    let (mut rx, mut ry) = (given.rx.abs(), given.ry.abs());
    if from == to || !(rx > 0.0 && ry > 0.0) {
        return None;
    }
    let (c, s) = (cos(given.turn.to_radians()), sin(given.turn.to_radians()));
    let (hx, hy) = (0.5 * (from.x - to.x), 0.5 * (from.y - to.y));
    // Half of the chord in the frame of the ellipse, measured in its radii.
    let (px, py) = ((c * hx + s * hy) / rx, (c * hy - s * hx) / ry);
    let half = hypot(px, py);
    if !(half > 0.0 && half.is_finite()) {
        return None;
    }
    let enlarged = half.max(1.0);
    (rx, ry) = (rx * enlarged, ry * enlarged);
    let (px, py, half) = (px / enlarged, py / enlarged, half / enlarged);
    let height = (1.0 - half * half).max(0.0).sqrt() / half;
    let height = if given.is_large == given.is_positive { -height } else { height };
    let (qx, qy) = (height * py, -height * px);
    let start = atan2(py - qy, px - qx);
    let end = atan2(-py - qy, -px - qx);
    let mut sweep = end - start;
    if given.is_positive && sweep < 0.0 {
        sweep += std::f64::consts::TAU;
    } else if !given.is_positive && sweep > 0.0 {
        sweep -= std::f64::consts::TAU;
    }
    let (u, v) = (Vector::new(rx * c, rx * s), Vector::new(-ry * s, ry * c));
    let middle = Point::midpoint(from, to);
    let center = Point::new(middle.x + qx * u.x + qy * v.x, middle.y + qx * u.y + qy * v.y);
    Some(Arc { center, u, v, start, sweep, end: Vertex::flat(to.x, to.y) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_four_arcs_through_two_points_begin_and_end_there() {
        let (from, to) = (Point::new(1.0, 2.0), Point::new(3.0, 2.5));
        for (is_large, is_positive) in [(false, false), (false, true), (true, false), (true, true)] {
            for (rx, ry) in [(2.0, 3.0), (1.5, 1.5), (0.1, 0.2)] {
                let arc = between(from, to, Given { rx, ry, turn: 20.0, is_large, is_positive }).unwrap();
                for (t, p) in [(0.0, from), (arc.sweep, to)] {
                    assert!(Point::distance_sq(arc.at(arc.start + t), p) < 1e-24, "{arc:?}");
                }
                assert_eq!(arc.sweep > 0.0, is_positive);
                let is_half = rx < 1.0;
                assert!(is_half || (arc.sweep.abs() > std::f64::consts::PI) == is_large, "{arc:?}");
            }
        }
        let flat = Given { rx: 0.0, ry: 1.0, turn: 0.0, is_large: false, is_positive: true };
        assert!(between(from, to, flat).is_none());
    }
}
