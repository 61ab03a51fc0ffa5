//! What can be seen from a point of a polygon: the visibility polygon, by looking through triangles.
//!
//! Stand in a triangle of the triangulated polygon and look through one of its edges. What is seen lies in a cone
//! between the ends of the edge. The cone goes on into the triangle behind: its far corner lies in the cone, left of it
//! or right of it, and either divides the cone or leaves it as it is. At a side of the polygon the cone ends.
//!
//! ```text
//!        b---------c          From x, through the edge a b, into the triangle a c b:
//!       / \       /           c lies right of the cone's left limit b and left of its right
//!      /   \     /            limit a, and divides it. What is left of c goes on through
//!     /     \   /             c b, what is right of c through a c.
//!    / x     \ /
//!    ----------a
//! ```
//!
//! # Steps
//! 1. Triangulate the polygon, once for all points.
//! 2. Find the triangles that have the point inside or on their boundary. The edges that do not hold the point open a
//!    cone each, counter-clockwise.
//! 3. Take the rightmost open cone. If there is a triangle behind its edge, divide the cone, or narrow it, at the far
//!    corner, and go on with the parts that have a width.
//! 4. If there is none, the cone ends on a side of the polygon: the part of the side within the cone is seen. Its ends
//!    are corners of the visibility polygon.
//!
//! # Degenerate cases
//! All limits of cones are vertices of the polygon, so every question is an orientation of three given points, and
//! which corners there are is exact. A corner that is no vertex is known by the side that it is on and the vertex past
//! which it is seen; only its coordinates are rounded. What is seen along a line only, without width, is left out: a
//! *needle* has no area. A point on the boundary is itself a corner; where parts of the polygon touch in it, it is one
//! several times.
//!
//! # Complexity
//! O(n) a point for a polygon without holes, as every triangle is entered once; O(n h) with h holes, as each may be
//! seen past both sides of a hole. Usually far less: triangles that are not seen are not visited. The search for the
//! triangle that holds the point is linear.
//!
//! # Source
//! `[BungiuEtAl14]`, triangular expansion.

use super::adjacency::{NONE, neighbours};
use super::angles::clockwise;
use super::{Polygon, PolygonError, seidel};
use crate::geometry::math::power_of_two_scale;
use crate::geometry::{BoundingBox, Orientation, Point, collinear, orient2d};
use crate::trace::{Shape, Trace};

/// A corner of a visibility polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SeenCorner {
    /// The point from which is looked; it is on the boundary.
    Viewpoint(Point),
    /// A vertex of the polygon.
    Vertex {
        /// The vertex.
        vertex: u32,
        /// Its coordinates.
        at: Point,
    },
    /// The point of a side that is seen past a vertex.
    OnSide {
        /// The side, or a piece of it between vertices on it, the inside on its left.
        side: [u32; 2],
        /// The vertex past which it is seen: the corner is on the line from the viewpoint through it.
        past: u32,
        /// The point, rounded.
        at: Point,
    },
}

impl SeenCorner {
    /// Where the corner is.
    #[must_use]
    pub const fn at(&self) -> Point {
        match *self {
            Self::Viewpoint(at) | Self::OnSide { at, .. } | Self::Vertex { at, .. } => at,
        }
    }
}

/// A triangulated polygon, of which visibility polygons are asked.
#[doc(alias = "polígono de visibilidad")]
#[derive(Clone, Debug)]
pub struct Visibility<'a> {
    points: &'a [Point],
    triangles: Vec<[u32; 3]>,
    neighbours: Vec<[(u32, u8); 3]>,
}

/// What is seen through an edge of a triangle.
#[derive(Clone, Copy)]
struct Cone {
    triangle: u32,
    /// The edge from this corner to the next.
    place: u8,
    /// The vertices on the right and the left limit.
    right: u32,
    left: u32,
}

impl<'a> Visibility<'a> {
    /// Triangulates a polygon to look around in it.
    ///
    /// # Errors
    /// A ring without area, sides that cross or overlap, a hole that is not in the outline, cancelled.
    ///
    /// # Complexity
    /// O(n log n), for the neighbours.
    pub fn new(polygon: Polygon<'a>, trace: &mut (impl Trace + ?Sized)) -> Result<Self, PolygonError> {
        let triangles = seidel(polygon, trace)?;
        let neighbours = neighbours(&triangles);
        Ok(Self { points: polygon.points(), triangles, neighbours })
    }

    /// The visibility polygon of a point: the corners of the part of the polygon that it sees, counter-clockwise,
    /// without needles.
    ///
    /// # Shape
    /// Empty for a point outside of the polygon. Corners may lie on one line.
    ///
    /// # Errors
    /// [`PolygonError::Cancelled`].
    ///
    /// # Complexity
    /// O(n) without holes, O(n h) with h of them.
    ///
    /// # Source
    /// `[BungiuEtAl14]`
    ///
    /// # Examples
    /// ```
    /// use trimalla::Point;
    /// use trimalla::polygon::{Polygon, SeenCorner, Visibility};
    /// use trimalla::trace::NoTrace;
    ///
    /// let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)].map(|(x, y)| Point::new(x, y));
    /// let polygon = Polygon::new(&points, &[5])?;
    /// let seen = Visibility::new(polygon, &mut NoTrace)?.seen_from(Point::new(0.0, 3.0), &mut NoTrace)?;
    /// assert!(seen.contains(&SeenCorner::OnSide { side: [0, 1], past: 3, at: Point::new(3.0, 0.0) }));
    /// assert_eq!(seen.len(), 5);
    /// # Ok::<(), trimalla::polygon::PolygonError>(())
    /// ```
    pub fn seen_from(&self, x: Point, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<SeenCorner>, PolygonError> {
        let mut corners = Vec::new();
        let wedges = self.wedges(x);
        for (number, wedge) in wedges.iter().enumerate() {
            for &cone in wedge {
                self.look_through(x, cone, &mut corners, trace)?;
            }
            let next = &wedges[if number + 1 == wedges.len() { 0 } else { number + 1 }];
            let is_followed = wedge.last().map(|cone| cone.left) == next.first().map(|cone| cone.right);
            if !is_followed {
                corners.push(SeenCorner::Viewpoint(x));
            }
        }
        corners.dedup();
        while corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        for (number, corner) in corners.iter().enumerate() {
            let next = &corners[if number + 1 == corners.len() { 0 } else { number + 1 }];
            trace.add(Shape::Line([corner.at(), next.at()]), "boundary of what is seen");
        }
        Ok(corners)
    }

    /// The triangles around a point, counter-clockwise: of each the edges that do not hold the point.
    fn wedges(&self, x: Point) -> Vec<Vec<Cone>> {
        let mut wedges: Vec<Vec<Cone>> = Vec::new();
        if !x.is_finite() {
            return wedges;
        }
        for (triangle, corners) in (0..).zip(&self.triangles) {
            let [a, b, c] = corners.map(|v| self.points[v as usize]);
            let turns = [orient2d(a, b, x), orient2d(b, c, x), orient2d(c, a, x)];
            if turns.contains(&Orientation::Clockwise) {
                continue;
            }
            let opens = |&place: &usize| turns[place] == Orientation::CounterClockwise;
            // The first edge follows one that does not open, if there is one.
            let begin = (0..3).find(|&place| opens(&place) && !opens(&((place + 2) % 3))).unwrap_or(0);
            let cone = |place: usize| Cone {
                triangle,
                place: place as u8,
                right: corners[place],
                left: corners[(place + 1) % 3],
            };
            wedges.push((0..3).map(|k| (begin + k) % 3).filter(opens).map(cone).collect());
        }
        if let Some(first) = wedges.first().and_then(|wedge| wedge.first()).map(|cone| self.points[cone.right as usize])
        {
            let right = |wedge: &Vec<Cone>| wedge.first().map_or(first, |cone| self.points[cone.right as usize]);
            wedges.sort_by(|one, two| clockwise(x, first, right(two), right(one)));
        }
        wedges
    }

    /// Steps 3 and 4, for one edge.
    fn look_through(
        &self,
        x: Point,
        cone: Cone,
        corners: &mut Vec<SeenCorner>,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<(), PolygonError> {
        let mut open = vec![cone];
        while let Some(cone) = open.pop() {
            if trace.is_cancelled() {
                return Err(PolygonError::Cancelled);
            }
            let (behind, place) = self.neighbours[cone.triangle as usize][usize::from(cone.place)];
            if behind == NONE {
                corners.extend(self.seen_part(x, cone));
                continue;
            }
            let triangle = self.triangles[behind as usize];
            trace.look(Shape::Triangle(triangle), "seen through its edge");
            let far = triangle[usize::from(place + 2) % 3];
            let point = |vertex: u32| self.points[vertex as usize];
            let is_left_of_right = orient2d(x, point(cone.right), point(far)) == Orientation::CounterClockwise;
            let is_right_of_left = orient2d(x, point(cone.left), point(far)) == Orientation::Clockwise;
            if is_right_of_left {
                let right = if is_left_of_right { far } else { cone.right };
                open.push(Cone { triangle: behind, place: (place + 2) % 3, right, left: cone.left });
            }
            if is_left_of_right {
                let left = if is_right_of_left { far } else { cone.left };
                open.push(Cone { triangle: behind, place: (place + 1) % 3, right: cone.right, left });
            }
        }
        Ok(())
    }

    /// The ends of the part of a side that is in a cone.
    fn seen_part(&self, x: Point, cone: Cone) -> [SeenCorner; 2] {
        let corners = self.triangles[cone.triangle as usize];
        let side = [0, 1].map(|k| corners[(usize::from(cone.place) + k) % 3]);
        let [a, b] = side.map(|v| self.points[v as usize]);
        let end = |vertex: u32, past: u32| {
            let (p, limit) = (self.points[vertex as usize], self.points[past as usize]);
            if vertex == past || collinear(x, limit, p) {
                SeenCorner::Vertex { vertex, at: p }
            } else {
                SeenCorner::OnSide { side, past, at: meeting_point(x, limit, a, b) }
            }
        };
        [end(side[0], cone.right), end(side[1], cone.left)]
    }
}

/// Where the line through `x` and `p` meets the segment `ab`, rounded.
fn meeting_point(x: Point, p: Point, a: Point, b: Point) -> Point {
    let largest = BoundingBox::around(x).including(p).including(a).including(b).largest_coordinate();
    let scale = power_of_two_scale(largest);
    let [x, p, c, d] = [x, p, a, b].map(|p| Point::new(p.x * scale, p.y * scale));
    let (from_a, from_b) = ((p - x).cross(c - x), (p - x).cross(d - x));
    let t = from_a / (from_a - from_b);
    Point::lerp(a, b, if t.is_nan() { 0.5 } else { t.clamp(0.0, 1.0) })
}
