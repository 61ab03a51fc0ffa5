//! Rings and chains of points as segments.

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

/// Adds the points, joined in a row.
pub(super) fn push_chain(pslg: &mut Pslg, chain: &[Point]) {
    let first = u32::try_from(pslg.points.len()).unwrap();
    let last = first + u32::try_from(chain.len()).unwrap();
    pslg.points.extend_from_slice(chain);
    pslg.segments.extend((first + 1..last).map(|v| [v - 1, v]));
}

/// Adds the points, joined in a circle: without the last if it repeats the first, and with one
/// segment only where two points are left.
pub(super) fn push_ring(pslg: &mut Pslg, ring: &[Point]) {
    let closed = ring.len() > 1 && ring.first() == ring.last();
    let ring = if closed { &ring[..ring.len() - 1] } else { ring };
    let first = u32::try_from(pslg.points.len()).unwrap();
    push_chain(pslg, ring);
    if ring.len() > 2 {
        let last = u32::try_from(pslg.points.len() - 1).unwrap();
        pslg.segments.push([last, first]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_and_closed_rings() {
        let p = |x: f64| Point::new(x, x * x);
        let count = |ring: &[Point]| {
            let mut pslg = Pslg::default();
            push_ring(&mut pslg, ring);
            (pslg.points.len(), pslg.segments.len())
        };
        assert_eq!(count(&[]), (0, 0));
        assert_eq!(count(&[p(0.0)]), (1, 0));
        assert_eq!(count(&[p(0.0), p(0.0)]), (1, 0));
        assert_eq!(count(&[p(0.0), p(1.0)]), (2, 1));
        assert_eq!(count(&[p(0.0), p(1.0), p(0.0)]), (2, 1));
        assert_eq!(count(&[p(0.0), p(1.0), p(2.0)]), (3, 3));
        assert_eq!(count(&[p(0.0), p(1.0), p(2.0), p(0.0)]), (3, 3));
    }
}
