//! All pairs of segments that cross, exactly.

use super::error::CrossingPair;
use crate::geometry::{BoundingBox, Point, Segment, segments_cross_properly, strictly_between};

/// Every pair of segments whose interiors cross in one point that is no vertex, sorted; the lower index first.
///
/// Segments that touch, overlap or share an end do not cross, nor do those that meet in a vertex exactly on both.
/// Indices beyond the points are passed over.
///
/// # Complexity
/// O(n log n + k), with k the pairs whose boxes overlap in x: a sweep in x over boxes, and the exact test for pairs
/// whose boxes meet; for those that cross, also the points within both boxes' range in x.
#[must_use]
pub fn crossing_pairs(points: &[Point], segments: &[[u32; 2]]) -> Vec<CrossingPair> {
    let ends = |i: usize| segments[i].map(|v| points.get(v as usize).copied());
    let mut boxes: Vec<(BoundingBox, usize)> = (0..segments.len())
        .filter_map(|i| match ends(i) {
            [Some(a), Some(b)] => BoundingBox::of([a, b]).map(|bounds| (bounds, i)),
            _ => None,
        })
        .collect();
    boxes.sort_by(|(a, i), (b, k)| a.min.x.total_cmp(&b.min.x).then(i.cmp(k)));
    let vertices = ByAbscissa::new(points);
    let mut active: Vec<(BoundingBox, usize)> = Vec::new();
    let mut pairs = Vec::new();
    for (bounds, i) in boxes {
        active.retain(|(other, _)| other.max.x >= bounds.min.x);
        for &(_, k) in active.iter().filter(|(other, _)| other.meets(bounds)) {
            let (i, k) = (i.min(k), i.max(k));
            pairs.extend(crossing(ends(i), ends(k), &vertices).map(|at| CrossingPair { segments: [i, k], at }));
        }
        active.push((bounds, i));
    }
    pairs.sort_by_key(|p| p.segments);
    pairs
}

/// Where two segments cross, rounded; `None` where they do not, or do in a vertex.
fn crossing(first: [Option<Point>; 2], second: [Option<Point>; 2], vertices: &ByAbscissa) -> Option<Point> {
    let ([Some(a), Some(b)], [Some(c), Some(d)]) = (first, second) else { return None };
    if !segments_cross_properly(a, b, c, d) {
        return None;
    }
    let from = a.x.min(b.x).max(c.x.min(d.x));
    let to = a.x.max(b.x).min(c.x.max(d.x));
    let meet = vertices.between(from, to).iter().any(|&p| strictly_between(a, b, p) && strictly_between(c, d, p));
    (!meet).then(|| Segment::new(a, b).crossing_point(Segment::new(c, d)).unwrap_or_else(|| Point::midpoint(c, d)))
}

/// Points sorted by x.
struct ByAbscissa(Vec<Point>);

impl ByAbscissa {
    fn new(points: &[Point]) -> Self {
        let mut sorted = points.to_vec();
        sorted.sort_unstable_by(|a, b| a.x.total_cmp(&b.x));
        Self(sorted)
    }

    fn between(&self, from: f64, to: f64) -> &[Point] {
        let start = self.0.partition_point(|p| p.x < from);
        let end = self.0.partition_point(|p| p.x <= to);
        self.0.get(start..end).unwrap_or_default()
    }
}
