//! Whether two points of a polygon see each other.

use std::cmp::Ordering;

use super::Polygon;
use super::angles::clockwise;
use crate::geometry::{
    Containment, Orientation, Point, SegmentContact, collinear, lexicographic, on_segment, segment_contact,
    strictly_between,
};

/// Tells whether two points of a polygon see each other: whether no point of the segment between them is outside of the
/// polygon.
///
/// The lecture notes ask for a segment in the inside. Here the boundary belongs to the polygon, as in the theorem of
/// the art gallery: a segment that touches a vertex, runs along a side, or ends on the boundary is not interrupted. It
/// also passes where two parts of the polygon touch in a vertex. Points outside see nothing, not even themselves.
///
/// # Guarantees
/// Exact for finite points. No panic for a polygon whose sides cross; the answer then has no meaning. A ring without
/// area hides nothing.
///
/// # Complexity
/// O(n + k log k), for k vertices on the segment.
///
/// # Source
/// `[ORourke98]`, where a diagonal is a pair of visible vertices.
///
/// # Examples
/// ```
/// use trimalla::Point;
/// use trimalla::polygon::{Polygon, visible};
///
/// let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)].map(|(x, y)| Point::new(x, y));
/// let polygon = Polygon::new(&points, &[5])?;
/// let at = Point::new;
/// assert!(visible(polygon, at(0.0, 1.0), at(4.0, 1.0)), "past the vertex at (2, 1)");
/// assert!(!visible(polygon, at(0.0, 2.0), at(4.0, 2.0)));
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
#[must_use]
pub fn visible(polygon: Polygon<'_>, x: Point, y: Point) -> bool {
    if !contains(polygon, x) || !contains(polygon, y) {
        return false;
    }
    let mut passing = Vec::new();
    let mut spokes = Vec::new();
    for [a, b] in sides(polygon) {
        spokes.extend(on_segment(x, y, a).then_some(Spoke { at: a, towards: b, inside_is_left: true }));
        spokes.extend(on_segment(x, y, b).then_some(Spoke { at: b, towards: a, inside_is_left: false }));
        match segment_contact(x, y, a, b) {
            SegmentContact::Apart => {}
            SegmentContact::Crossing => passing.push(([a, b], true)),
            SegmentContact::Touching | SegmentContact::Overlapping => passing.push(([a, b], false)),
        }
    }
    // The segment can leave the polygon at its start, at a vertex, and where it crosses a side.
    let mut stops: Vec<Point> = spokes.iter().map(|spoke| spoke.at).chain([x, y]).collect();
    stops.sort_by(|&p, &q| lexicographic(p, q));
    stops.dedup();
    for (side, crosses) in passing {
        let passed = spokes.len();
        spokes.extend(spokes_inside(side, &stops));
        if crosses && spokes.len() == passed {
            return false;
        }
    }
    spokes.sort_by(|one, two| lexicographic(one.at, two.at));
    spokes.chunk_by(|one, two| one.at == two.at).all(|around| around[0].at == y || goes_on(around, y))
}

/// The sides of the rings that have an area, the inside on their left.
fn sides(polygon: Polygon<'_>) -> impl Iterator<Item = [Point; 2]> {
    polygon.rings().enumerate().flat_map(move |(number, ring)| {
        let ring = polygon.ring(ring);
        let turn = ring.orientation();
        let inside_is_left = (turn == Orientation::CounterClockwise) == (number == 0);
        let sides = ring.sides().filter(move |(a, b)| turn != Orientation::Collinear && a != b);
        sides.map(move |(a, b)| if inside_is_left { [a, b] } else { [b, a] })
    })
}

/// Whether a point is in a polygon or on its boundary.
fn contains(polygon: Polygon<'_>, p: Point) -> bool {
    let places = polygon.rings().map(|ring| polygon.ring(ring).locate(p));
    let is_in =
        |(number, place)| if number == 0 { place != Containment::Outside } else { place != Containment::Inside };
    p.is_finite() && polygon.ring_count() > 0 && places.enumerate().all(is_in)
}

/// A side that leaves a point of the segment.
#[derive(Clone, Copy)]
struct Spoke {
    at: Point,
    towards: Point,
    /// Whether the inside is on the left of the side as it leaves.
    inside_is_left: bool,
}

/// The two parts of a side at each of the given points that is inside it. The points are sorted.
fn spokes_inside([a, b]: [Point; 2], stops: &[Point]) -> impl Iterator<Item = Spoke> {
    let (low, high) = if lexicographic(a, b) == Ordering::Less { (a, b) } else { (b, a) };
    let first = stops.partition_point(|&p| lexicographic(p, low) != Ordering::Greater);
    let end = stops.partition_point(|&p| lexicographic(p, high) == Ordering::Less);
    let inside = stops[first..end.max(first)].iter().filter(move |&&p| strictly_between(a, b, p));
    inside.flat_map(move |&at| {
        [Spoke { at, towards: b, inside_is_left: true }, Spoke { at, towards: a, inside_is_left: false }]
    })
}

/// Whether the way from a point on the boundary to `y` begins in the polygon: along a side, or where the next side
/// clockwise has the inside on its left.
fn goes_on(spokes: &[Spoke], y: Point) -> bool {
    let at = spokes[0].at;
    let is_along =
        |spoke: &Spoke| collinear(at, y, spoke.towards) && lexicographic(spoke.towards, at) == lexicographic(y, at);
    let next = spokes.iter().min_by(|one, two| clockwise(at, y, one.towards, two.towards));
    spokes.iter().any(is_along) || next.is_none_or(|spoke| spoke.inside_is_left)
}
