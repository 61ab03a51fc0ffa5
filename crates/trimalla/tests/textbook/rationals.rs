//! Points of rationals.

use dashu_ratio::RBig;
use trimalla::geometry::Point;

/// A point of rationals.
pub(crate) type Place = [RBig; 2];

pub(crate) fn exact(p: Point) -> Place {
    [p.x, p.y].map(|c| RBig::try_from(c).expect("finite"))
}

pub(crate) fn square(x: &RBig) -> RBig {
    x * x
}

/// A convex polygon cut along a bisector: what is nearer to `a` than to `b`, or as near.
pub(crate) fn nearer(polygon: &[Place], a: &Place, b: &Place) -> Vec<Place> {
    let (dx, dy) = (&b[0] - &a[0], &b[1] - &a[1]);
    let limit = (square(&b[0]) + square(&b[1]) - square(&a[0]) - square(&a[1])) / RBig::from(2);
    let beyond = |p: &Place| &p[0] * &dx + &p[1] * &dy - &limit;
    let mut kept = Vec::new();
    for (p, q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (at_p, at_q) = (beyond(p), beyond(q));
        if at_p <= RBig::ZERO {
            kept.push(p.clone());
        }
        if (at_p < RBig::ZERO && at_q > RBig::ZERO) || (at_p > RBig::ZERO && at_q < RBig::ZERO) {
            let t = &at_p / (&at_p - &at_q);
            kept.push([&p[0] + (&q[0] - &p[0]) * &t, &p[1] + (&q[1] - &p[1]) * &t]);
        }
    }
    kept
}
