//! Every way in which points and segments of a drawing can touch, by comparing all with all.

use core::cmp::Ordering;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::delaunay::representatives;
use super::exact::{lexicographic, on_open_segment, orient};

/// The contacts of a drawing, all exact. Segments are named by index, in pairs with the smaller
/// first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contacts {
    /// Points equal to an earlier one, with that one.
    pub duplicate_points: Vec<(usize, usize)>,
    /// Segments whose ends are equal points.
    pub zero_length: Vec<usize>,
    /// Segments with the same two ends as an earlier one, with that one.
    pub repeated: Vec<(usize, usize)>,
    /// Pairs of segments whose interiors meet in one point.
    pub crossings: Vec<(usize, usize)>,
    /// Pairs of segments that share a piece and are not the same segment.
    pub overlaps: Vec<(usize, usize)>,
    /// Distinct points that lie inside a segment: point, segment.
    pub points_inside: Vec<(usize, usize)>,
}

impl Contacts {
    /// Whether a constrained triangulation can keep every segment as one edge: nothing crosses,
    /// overlaps or has a vertex inside. Duplicates and repetitions are harmless.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.crossings.is_empty() && self.overlaps.is_empty() && self.points_inside.is_empty()
    }
}

/// All pairs of segments whose interiors meet in exactly one point, sorted.
///
/// # Complexity
/// O(n²) with a box test first; repeated segments are not joined.
#[must_use]
pub fn crossing_pairs(pslg: &Pslg) -> Vec<(usize, usize)> {
    contacts(pslg).crossings
}

/// Finds every contact by comparing all points and segments with all segments.
///
/// # Complexity
/// O(n²) with a box test first: a few seconds for 20 000 segments.
#[must_use]
pub fn contacts(pslg: &Pslg) -> Contacts {
    let first = representatives(&pslg.points);
    let spans: Vec<Span> = pslg.segments.iter().map(|&s| Span::new(&pslg.points, s, &first)).collect();
    let mut found = Contacts::default();
    for (i, &f) in first.iter().enumerate() {
        if f as usize != i {
            found.duplicate_points.push((f as usize, i));
        }
    }
    for (j, t) in spans.iter().enumerate() {
        if t.key[0] == t.key[1] {
            found.zero_length.push(j);
            continue;
        }
        for (i, s) in spans[..j].iter().enumerate() {
            if s.key[0] != s.key[1] && s.near(t) {
                sort_pair(&mut found, (i, s), (j, t));
            }
        }
        for (i, &p) in pslg.points.iter().enumerate() {
            if first[i] as usize == i && t.holds(p) && on_open_segment(p, t.a, t.b) {
                found.points_inside.push((i, j));
            }
        }
    }
    found.crossings.sort_unstable();
    found
}

/// Adds the contact of two segments, if any, to the list it belongs to.
fn sort_pair(found: &mut Contacts, (i, s): (usize, &Span), (j, t): (usize, &Span)) {
    if s.key == t.key {
        if !found.repeated.iter().any(|&(_, again)| again == j) {
            found.repeated.push((i, j));
        }
    } else if crosses(s, t) {
        found.crossings.push((i, j));
    } else if overlaps(s, t) {
        found.overlaps.push((i, j));
    }
}

/// A segment with its box.
struct Span {
    /// One end.
    a: Point,
    /// The other end.
    b: Point,
    /// Representatives of the ends, the smaller first.
    key: [u32; 2],
    /// Smallest and largest abscissa, smallest and largest ordinate.
    bounds: [f64; 4],
}

impl Span {
    /// The span of a segment.
    fn new(points: &[Point], segment: [u32; 2], first: &[u32]) -> Self {
        let [a, b] = segment.map(|v| points[v as usize]);
        let mut key = segment.map(|v| first[v as usize]);
        key.sort_unstable();
        Self { a, b, key, bounds: [a.x.min(b.x), a.x.max(b.x), a.y.min(b.y), a.y.max(b.y)] }
    }

    /// Whether the two boxes share a point.
    fn near(&self, other: &Self) -> bool {
        let ([l, r, d, u], [ol, or, od, ou]) = (self.bounds, other.bounds);
        l <= or && ol <= r && d <= ou && od <= u
    }

    /// Whether the point is in the box.
    fn holds(&self, p: Point) -> bool {
        let [l, r, d, u] = self.bounds;
        l <= p.x && p.x <= r && d <= p.y && p.y <= u
    }

    /// The ends in lexicographic order.
    fn sorted(&self) -> (Point, Point) {
        if lexicographic(self.a, self.b) == Ordering::Greater { (self.b, self.a) } else { (self.a, self.b) }
    }
}

/// Whether the interiors meet in exactly one point.
fn crosses(s: &Span, t: &Span) -> bool {
    orient(s.a, s.b, t.a) * orient(s.a, s.b, t.b) < 0 && orient(t.a, t.b, s.a) * orient(t.a, t.b, s.b) < 0
}

/// Whether the two segments lie on one line and share more than a point.
fn overlaps(s: &Span, t: &Span) -> bool {
    let ((sl, sh), (tl, th)) = (s.sorted(), t.sorted());
    orient(s.a, s.b, t.a) == 0
        && orient(s.a, s.b, t.b) == 0
        && lexicographic(sl, th) == Ordering::Less
        && lexicographic(tl, sh) == Ordering::Less
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawing(points: &[(f64, f64)], segments: &[[u32; 2]]) -> Pslg {
        Pslg {
            points: points.iter().map(|&(x, y)| Point::new(x, y)).collect(),
            segments: segments.to_vec(),
            ..Pslg::default()
        }
    }

    #[test]
    fn proper_crossing_and_touches() {
        // An X, a T that only touches, a shared end.
        let x = drawing(
            &[(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (0.5, 0.0), (0.5, 1.0)],
            &[[0, 1], [2, 3], [4, 5], [3, 5]],
        );
        let found = contacts(&x);
        assert_eq!(found.crossings, [(0, 1)]);
        assert_eq!(found.points_inside, [(4, 0)]);
        assert!(found.overlaps.is_empty());
        assert_eq!(crossing_pairs(&x), [(0, 1)]);
    }

    #[test]
    fn overlaps_repetitions_and_duplicates() {
        let line =
            drawing(&[(0.0, 0.0), (3.0, 0.0), (1.0, 0.0), (4.0, 0.0), (0.0, 0.0)], &[[0, 1], [2, 3], [1, 4], [0, 4]]);
        let found = contacts(&line);
        assert_eq!(found.overlaps, [(0, 1), (1, 2)]);
        assert_eq!(found.repeated, [(0, 2)]);
        assert_eq!(found.zero_length, [3]);
        assert_eq!(found.duplicate_points, [(0, 4)]);
        assert!(!found.is_clean());
    }
}
