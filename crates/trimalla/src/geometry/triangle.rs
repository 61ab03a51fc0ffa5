//! A triangle and its measures.

use super::frame::Frame;
use super::math::atan2;
use super::predicates::{Orientation, on_segment, orient2d};
use super::{Angle, Circle, Containment, Point, Segment, Vector, lexicographically_less};

/// A triangle; edge `i` is the one opposite corner `i`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Triangle {
    /// The corners.
    pub corners: [Point; 3],
}

impl Triangle {
    /// The triangle with the given corners.
    #[must_use]
    #[inline]
    pub const fn new(a: Point, b: Point, c: Point) -> Self {
        Self { corners: [a, b, c] }
    }

    /// The turn that the corners make. Exact.
    #[must_use]
    #[inline]
    pub fn orientation(&self) -> Orientation {
        let [a, b, c] = self.corners;
        orient2d(a, b, c)
    }

    /// The edge opposite corner `i % 3`, directed as the corners run.
    #[must_use]
    #[inline]
    pub const fn edge(&self, i: usize) -> Segment {
        Segment::new(self.corners[(i + 1) % 3], self.corners[(i + 2) % 3])
    }

    /// The area, positive where the corners run counter-clockwise, rounded.
    ///
    /// Its sign may be lost to rounding; [`orientation`](Self::orientation) is exact.
    #[must_use]
    pub fn signed_area(&self) -> f64 {
        let view = View::of(self);
        view.frame.area(0.5 * view.cross())
    }

    /// The area, rounded.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.signed_area().abs()
    }

    /// The angles at the three corners, rounded; a corner that coincides with another one has angle zero.
    #[must_use]
    pub fn angles(&self) -> [Angle; 3] {
        let [a, b, c] = self.corners;
        [angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)]
    }

    /// The smallest angle, rounded.
    #[must_use]
    pub fn min_angle(&self) -> Angle {
        let [a, b, c] = self.angles().map(Angle::radians);
        Angle::from_radians(a.min(b).min(c))
    }

    /// The largest angle, rounded.
    #[must_use]
    pub fn max_angle(&self) -> Angle {
        let [a, b, c] = self.angles().map(Angle::radians);
        Angle::from_radians(a.max(b).max(c))
    }

    /// The squared lengths of the edges, `dx * dx + dy * dy` each, rounded and unscaled.
    #[must_use]
    #[inline]
    pub fn edge_lengths_sq(&self) -> [f64; 3] {
        core::array::from_fn(|i| self.edge(i).length_sq())
    }

    /// The index of the longest edge by rounded lengths, the first of equal ones.
    ///
    /// Callers that must not depend on where the corners start break ties by vertex ids.
    #[doc(alias = "getLongestEdge")]
    #[doc(alias = "arista más larga")]
    #[must_use]
    pub fn longest_edge(&self) -> usize {
        let lengths = self.local_lengths_sq();
        (1..3).fold(0, |best, i| if lengths[i] > lengths[best] { i } else { best })
    }

    /// The index of the shortest edge by rounded lengths, the first of equal ones.
    #[must_use]
    pub fn shortest_edge(&self) -> usize {
        let lengths = self.local_lengths_sq();
        (1..3).fold(0, |best, i| if lengths[i] < lengths[best] { i } else { best })
    }

    /// The centroid of the corners, rounded.
    ///
    /// # Guarantees
    /// Finite for finite corners.
    #[doc(alias = "barycenter")]
    #[doc(alias = "centroide")]
    #[must_use]
    pub fn centroid(&self) -> Point {
        let view = View::of(self);
        let (u, v) = (view.u, view.v);
        view.frame.point(Vector::new((u.x + v.x) / 3.0, (u.y + v.y) / 3.0))
    }

    /// The center of the inscribed circle, rounded: the mean of the corners, each weighed by the length of the edge
    /// opposite.
    ///
    /// # Guarantees
    /// Finite for finite corners. The result does not depend on the order of the corners. It may lie on the boundary of
    /// a triangle that is thin within rounding.
    ///
    /// # Source
    /// Section 2.2 of `[MeshSuite]`, figure 1.
    ///
    /// # Examples
    /// ```
    /// use trimalla::geometry::{Point, Triangle};
    ///
    /// let [a, b, c] = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]].map(Point::from);
    /// assert_eq!(Triangle::new(a, b, c).incenter(), Point::new(1.0, 1.0));
    /// ```
    #[doc(alias = "incentro")]
    #[must_use]
    pub fn incenter(&self) -> Point {
        let view = View::of(self);
        let [u, v, w] = [view.u, view.v, view.opposite()].map(|edge| edge.length_sq().sqrt());
        let perimeter = u + v + w;
        if perimeter == 0.0 {
            return self.corners[0];
        }
        let (at_u, at_v) = (view.u.scaled(v / perimeter), view.v.scaled(u / perimeter));
        view.frame.point(Vector::new(at_u.x + at_v.x, at_u.y + at_v.y))
    }

    /// The center of the circle through the corners, rounded.
    ///
    /// # Guarantees
    /// `None` if the corners are collinear (exactly), or so nearly that the center is not a finite point. The result
    /// does not depend on the order of the corners.
    #[doc(alias = "circuncentro")]
    #[must_use]
    pub fn circumcenter(&self) -> Option<Point> {
        let view = View::of(self);
        let center = view.frame.point(self.center_in(&view)?);
        center.is_finite().then_some(center)
    }

    /// The squared radius of the circle through the corners, rounded; `None` as for
    /// [`circumcenter`](Self::circumcenter).
    #[must_use]
    pub fn circumradius_sq(&self) -> Option<f64> {
        let view = View::of(self);
        let radius_sq = view.frame.area(self.center_in(&view)?.length_sq());
        radius_sq.is_finite().then_some(radius_sq)
    }

    /// The circle through the corners, rounded; `None` as for [`circumcenter`](Self::circumcenter).
    #[must_use]
    pub fn circumcircle(&self) -> Option<Circle> {
        let view = View::of(self);
        let center_local = self.center_in(&view)?;
        let center = view.frame.point(center_local);
        let radius = view.frame.length(center_local.length_sq().sqrt());
        (center.is_finite() && radius.is_finite()).then_some(Circle::new(center, radius))
    }

    /// The radius of the inscribed circle, rounded; zero for a degenerate triangle.
    #[must_use]
    pub fn inradius(&self) -> f64 {
        let view = View::of(self);
        let perimeter = view.u.length_sq().sqrt() + view.v.length_sq().sqrt() + view.opposite().length_sq().sqrt();
        if perimeter == 0.0 {
            return 0.0;
        }
        view.frame.length(view.cross().abs() / perimeter)
    }

    /// Tells where a point lies with respect to the closed triangle, whichever way it is oriented. Exact.
    #[must_use]
    pub fn locate(&self, p: Point) -> Containment {
        let orientation = self.orientation();
        let sides = [0, 1, 2].map(|i| orient2d(self.edge(i).start, self.edge(i).end, p));
        if orientation == Orientation::Collinear {
            let on = |i| on_segment(self.edge(i).start, self.edge(i).end, p);
            return if (0..3).any(on) { Containment::On } else { Containment::Outside };
        }
        if sides.contains(&orientation.reversed()) {
            Containment::Outside
        } else if sides.contains(&Orientation::Collinear) {
            Containment::On
        } else {
            Containment::Inside
        }
    }

    /// Tells whether a point lies in the closed triangle. Exact.
    #[must_use]
    pub fn contains(&self, p: Point) -> bool {
        self.locate(p) != Containment::Outside
    }

    /// The squared edge lengths in a frame in which they neither overflow nor vanish.
    fn local_lengths_sq(&self) -> [f64; 3] {
        let [a, b, c] = self.corners;
        let frame = Frame::new(a, [b, c]);
        let (b, c) = (frame.local(b), frame.local(c));
        [Vector::new(c.x - b.x, c.y - b.y), c, b].map(Vector::length_sq)
    }

    /// The squared edge lengths from plain differences, where these are good enough, as nearly always: then no other
    /// frame than a plain one is needed at any corner.
    #[inline]
    fn plain_lengths_sq(&self) -> Option<[f64; 3]> {
        let [a, b, c] = self.corners;
        let (u, v) = (b - a, c - a);
        let (u_sq, v_sq) = (u.length_sq(), v.length_sq());
        let is_plain = Frame::is_plain_at(a) && PLAIN_SQ.contains(&u_sq) && PLAIN_SQ.contains(&v_sq);
        is_plain.then(|| [Vector::new(v.x - u.x, v.y - u.y).length_sq(), v_sq, u_sq])
    }

    /// The vector in the frame from its origin to the circumcenter.
    fn center_in(&self, view: &View) -> Option<Vector> {
        if self.orientation() == Orientation::Collinear {
            return None;
        }
        let (u, v) = (view.u, view.v);
        let (u_sq, v_sq, twice) = (u.length_sq(), v.length_sq(), 2.0 * view.cross());
        let center = Vector::new((v.y * u_sq - u.y * v_sq) / twice, (u.x * v_sq - v.x * u_sq) / twice);
        (center.x.is_finite() && center.y.is_finite()).then_some(center)
    }
}

/// The angle at `apex` between the rays to `u` and `v`.
fn angle_at(apex: Point, u: Point, v: Point) -> Angle {
    let frame = Frame::new(apex, [u, v]);
    let (u, v) = (frame.local(u), frame.local(v));
    Angle::from_radians(atan2(u.cross(v).abs(), u.dot(v)))
}

/// Squares of two edge lengths for which a plain frame does at every corner: the longest edge is neither below them nor
/// much above.
const PLAIN_SQ: core::ops::RangeInclusive<f64> =
    f64::from_bits((1023 - 380) << 52)..=f64::from_bits((1023 + 380) << 52); // 2^-380, 2^380

/// The corner opposite the longest edge; of those opposite equal ones the lexicographically smallest.
#[inline]
fn opposite_longest(lengths: [f64; 3], corners: [Point; 3]) -> usize {
    let [p, q, r] = lengths;
    if (p == q) | (q == r) | (r == p) {
        return opposite_longest_of_equals(lengths, corners);
    }
    // A selection instead of a branch, which would be unpredictable.
    let (longer, of_two) = if q > p { (q, 1) } else { (p, 0) };
    if r > longer { 2 } else { of_two }
}

#[cold]
#[inline(never)]
fn opposite_longest_of_equals(lengths: [f64; 3], corners: [Point; 3]) -> usize {
    let better = |i: usize, j: usize| {
        lengths[i] > lengths[j] || (lengths[i] == lengths[j] && lexicographically_less(corners[i], corners[j]))
    };
    (1..3).fold(0, |best, i| if better(i, best) { i } else { best })
}

/// A triangle in a frame at one of its corners, seen as the two edges that leave it.
///
/// The corner is the one opposite the longest edge, where the cross product loses least; of equal ones the
/// lexicographically smallest, so that the view does not depend on which corner is called the first.
struct View {
    frame: Frame,
    u: Vector,
    v: Vector,
}

impl View {
    fn of(triangle: &Triangle) -> Self {
        let plain = triangle.plain_lengths_sq();
        let lengths = plain.unwrap_or_else(|| triangle.local_lengths_sq());
        let corners = triangle.corners;
        let origin = opposite_longest(lengths, corners);
        let Segment { start, end } = triangle.edge(origin);
        let frame = match plain {
            Some(_) => Frame::plain(corners[origin]),
            None => Frame::new(corners[origin], [start, end]),
        };
        Self { u: frame.local(start), v: frame.local(end), frame }
    }

    /// Twice the signed area in the frame.
    fn cross(&self) -> f64 {
        self.u.cross(self.v)
    }

    /// The edge opposite the origin.
    fn opposite(&self) -> Vector {
        Vector::new(self.v.x - self.u.x, self.v.y - self.u.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn right_triangle(s: f64) -> Triangle {
        Triangle::new(Point::new(0.0, 0.0), Point::new(4.0 * s, 0.0), Point::new(0.0, 3.0 * s))
    }

    #[test]
    fn the_measures_of_the_egyptian_triangle() {
        let t = right_triangle(1.0);
        assert_eq!(t.signed_area(), 6.0);
        assert_eq!(t.inradius(), 1.0);
        assert_eq!(t.circumcenter(), Some(Point::new(2.0, 1.5)));
        assert_eq!(t.circumradius_sq(), Some(6.25));
        assert_eq!(t.edge_lengths_sq(), [25.0, 9.0, 16.0]);
        assert_eq!((t.longest_edge(), t.shortest_edge()), (0, 1));
        assert!((t.max_angle().degrees() - 90.0).abs() < 1e-13);
        let sum: f64 = t.angles().iter().map(|a| a.degrees()).sum();
        assert!((sum - 180.0).abs() < 1e-12);
        assert!((t.centroid().x - 4.0 / 3.0).abs() < 1e-15);
    }

    #[test]
    fn measures_scale_without_overflow() {
        for exponent in [-1000, -500, 500, 1000] {
            let s = 2.0_f64.powi(exponent);
            let t = right_triangle(s);
            assert_eq!(t.circumcenter(), Some(Point::new(2.0 * s, 1.5 * s)));
            assert_eq!(t.circumcircle().map(|c| c.radius), Some(2.5 * s));
            assert_eq!(t.inradius(), s);
            assert_eq!(t.angles(), right_triangle(1.0).angles());
            assert_eq!(t.longest_edge(), 0);
        }
        let huge = Triangle::new(
            Point::new(-f64::MAX, -f64::MAX),
            Point::new(f64::MAX, -f64::MAX),
            Point::new(f64::MAX, f64::MAX),
        );
        assert_eq!(huge.circumcenter(), Some(Point::new(0.0, 0.0)));
        assert!(huge.centroid().is_finite());
        assert_eq!(huge.area(), f64::INFINITY);
    }

    #[test]
    fn a_circumcenter_does_not_depend_on_the_order_of_corners() {
        let [a, b, c] = [(0.1, 0.3), (7.7, 0.9), (3.3, 5.1)].map(|(x, y)| Point::new(x, y));
        let expected = Triangle::new(a, b, c).circumcenter();
        for [a, b, c] in [[b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]] {
            assert_eq!(Triangle::new(a, b, c).circumcenter(), expected);
        }
    }

    #[test]
    fn points_are_located_exactly() {
        let t = right_triangle(1.0);
        let flipped = Triangle::new(t.corners[0], t.corners[2], t.corners[1]);
        for t in [t, flipped] {
            assert_eq!(t.locate(Point::new(1.0, 1.0)), Containment::Inside);
            assert_eq!(t.locate(Point::new(2.0, 1.5)), Containment::On);
            assert_eq!(t.locate(Point::new(4.0, 0.0)), Containment::On);
            assert_eq!(t.locate(Point::new(2.0, 1.5 + f64::EPSILON)), Containment::Outside);
        }
        let flat = Triangle::new(t.corners[0], t.corners[1], Point::new(2.0, 0.0));
        assert!(flat.contains(Point::new(3.0, 0.0)) && !flat.contains(Point::new(5.0, 0.0)));
        assert_eq!(flat.circumcenter(), None);
        assert_eq!(flat.inradius(), 0.0);
        assert_eq!(Triangle::default().angles(), [Angle::default(); 3]);
    }
}
