//! Further inputs from given ones: turned, moved, shaken, reordered, resampled.

use trimalla::drawing::{Pslg, Region};
use trimalla::geometry::Point;

use super::rng::SplitMix64;

/// The drawing turned about the origin by an angle in radians, every coordinate rounded once more.
#[must_use]
pub fn rotated(pslg: &Pslg, angle: f64) -> Pslg {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    mapped(pslg, |p| Point::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos))
}

/// The drawing moved, rounded.
#[must_use]
pub fn moved(pslg: &Pslg, by: Point) -> Pslg {
    mapped(pslg, |p| Point::new(p.x + by.x, p.y + by.y))
}

/// The drawing at an UTM offset (A23): 500000 east, 4649776 north.
#[must_use]
pub fn moved_to_utm(pslg: &Pslg) -> Pslg {
    moved(pslg, Point::new(500_000.0, 4_649_776.0))
}

/// The drawing times a factor; exact for powers of two, as long as nothing leaves the range.
#[must_use]
pub fn scaled(pslg: &Pslg, factor: f64) -> Pslg {
    mapped(pslg, |p| Point::new(p.x * factor, p.y * factor))
}

/// The drawing with each point moved by up to `amplitude` in x and y; seeds of holes and regions
/// stay.
///
/// # Guarantees
/// Points that were equal move together.
#[must_use]
pub fn noisy(pslg: &Pslg, amplitude: f64, seed: u64) -> Pslg {
    let mut rng = SplitMix64::new(seed);
    let mut shaken = pslg.clone();
    let first = crate::oracles::representatives(&pslg.points);
    for (i, &f) in first.iter().enumerate() {
        let p = pslg.points[i];
        let by = Point::new(rng.range(-amplitude, amplitude), rng.range(-amplitude, amplitude));
        let own = f as usize == i;
        shaken.points[i] = if own { Point::new(p.x + by.x, p.y + by.y) } else { shaken.points[f as usize] };
    }
    shaken
}

/// The drawing with points, segments and the ends of segments in random order, and where each old
/// point went.
#[must_use]
pub fn permuted(pslg: &Pslg, seed: u64) -> (Pslg, Vec<u32>) {
    let mut rng = SplitMix64::new(seed);
    let mut order: Vec<usize> = (0..pslg.points.len()).collect();
    rng.shuffle(&mut order);
    let mut new_from_old = vec![0; order.len()];
    for (new, &old) in (0..).zip(&order) {
        new_from_old[old] = new;
    }
    let mut segments: Vec<[u32; 2]> = pslg.segments.iter().map(|s| s.map(|v| new_from_old[v as usize])).collect();
    segments.iter_mut().filter(|_| rng.below(2) == 0).for_each(|s| s.reverse());
    rng.shuffle(&mut segments);
    let points = order.iter().map(|&old| pslg.points[old]).collect();
    let (holes, regions) = (pslg.holes.clone(), pslg.regions.clone());
    (Pslg { points, segments, holes, regions, ..Pslg::default() }, new_from_old)
}

/// The drawing with `k` rounded points on each segment, which becomes `k + 1` segments.
///
/// # Guarantees
/// Input points keep their indices. The new points are mostly an ulp off the segment: what a
/// straight side of a real drawing looks like after somebody else resampled it.
#[must_use]
pub fn resampled(pslg: &Pslg, k: usize) -> Pslg {
    let mut out = Pslg { segments: Vec::new(), segment_markers: Vec::new(), ..pslg.clone() };
    (out.point_markers, out.point_attributes, out.attributes_per_point) = (Vec::new(), Vec::new(), 0);
    for (i, &[a, b]) in pslg.segments.iter().enumerate() {
        let (p, q) = (pslg.points[a as usize], pslg.points[b as usize]);
        let mut last = a;
        for step in 1..=k {
            let t = step as f64 / (k + 1) as f64;
            let next = u32::try_from(out.points.len()).unwrap();
            out.points.push(Point::new((1.0 - t) * p.x + t * q.x, (1.0 - t) * p.y + t * q.y));
            out.segments.push([last, next]);
            last = next;
        }
        out.segments.push([last, b]);
        let marker = pslg.segment_markers.get(i).copied();
        out.segment_markers.extend(marker.into_iter().cycle().take(k + 1));
    }
    out
}

/// The drawing with every coordinate pair mapped.
fn mapped(pslg: &Pslg, f: impl Fn(Point) -> Point) -> Pslg {
    let region = |r: &Region| Region { seed: f(r.seed), ..*r };
    Pslg {
        points: pslg.points.iter().map(|&p| f(p)).collect(),
        holes: pslg.holes.iter().map(|&p| f(p)).collect(),
        regions: pslg.regions.iter().map(region).collect(),
        ..pslg.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::{PslgKind, pslg};

    #[test]
    fn counts_stay_or_grow_as_said() {
        let square = pslg(PslgKind::NestedSquares, 8, 0);
        assert_eq!(rotated(&square, 0.3).segments, square.segments);
        assert_eq!(rotated(&square, 0.0), square);
        let fine = resampled(&square, 3);
        assert_eq!(fine.points.len(), square.points.len() + 3 * square.segments.len());
        assert_eq!(fine.segments.len(), 4 * square.segments.len());
        assert_eq!(noisy(&square, 1e-3, 5), noisy(&square, 1e-3, 5));
        assert_ne!(noisy(&square, 1e-3, 5), noisy(&square, 1e-3, 6));
        assert_eq!(moved_to_utm(&square).points[0].y, square.points[0].y + 4_649_776.0);
        assert_eq!(scaled(&scaled(&square, 4.0), 0.25), square);
    }

    #[test]
    fn permutation_says_where_points_went() {
        let gear = pslg(PslgKind::Gear, 32, 0);
        let (mixed, new_from_old) = permuted(&gear, 3);
        assert!(gear.points.iter().zip(&new_from_old).all(|(&p, &new)| mixed.points[new as usize] == p));
        assert_eq!(mixed.segments.len(), gear.segments.len());
        assert_ne!(mixed.points, gear.points);
    }
}
