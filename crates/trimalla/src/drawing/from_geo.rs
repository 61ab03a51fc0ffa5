//! Drawings made of the shapes of `geo-types`, and meshes as its triangles.

use geo_types::{Coord, LineString, MultiPolygon, Polygon, Triangle};

use super::{IndexedMesh, Pslg};
use crate::geometry::Point;

impl From<Coord<f64>> for Point {
    fn from(given: Coord<f64>) -> Self {
        Self::new(given.x, given.y)
    }
}

impl From<geo_types::Point<f64>> for Point {
    fn from(given: geo_types::Point<f64>) -> Self {
        given.0.into()
    }
}

impl From<Point> for Coord<f64> {
    fn from(own: Point) -> Self {
        Self { x: own.x, y: own.y }
    }
}

impl From<Point> for geo_types::Point<f64> {
    fn from(own: Point) -> Self {
        Self(own.into())
    }
}

/// A closed line is a ring; in an open one each point is joined to the next.
impl From<&LineString<f64>> for Pslg {
    fn from(line: &LineString<f64>) -> Self {
        let mut drawing = Self::of_ring(line.coords().copied());
        if !line.is_closed() && line.0.len() > 1 {
            drawing.segments.pop();
        }
        drawing
    }
}

/// The rings of a polygon: the domain is what lies between them under
/// [`DomainRule::Nesting`](crate::domain::DomainRule::Nesting), which needs no hole seeds.
///
/// # Examples
/// ```
/// use geo_types::polygon;
/// use trimalla::domain::DomainRule;
/// use trimalla::{DomainOptions, Pslg, triangulate};
///
/// let frame = polygon!(
///     exterior: [(x: 0.0, y: 0.0), (x: 9.0, y: 0.0), (x: 9.0, y: 9.0), (x: 0.0, y: 9.0)],
///     interiors: [[(x: 3.0, y: 3.0), (x: 6.0, y: 3.0), (x: 6.0, y: 6.0), (x: 3.0, y: 6.0)]],
/// );
/// let nested = DomainOptions { rule: DomainRule::Nesting, ..DomainOptions::default() };
/// let mesh = triangulate(&Pslg::from(&frame), &nested)?.mesh;
/// let triangles: Vec<geo_types::Triangle<f64>> = mesh.geo_triangles().collect();
/// assert_eq!(triangles.len(), 8);
/// # Ok::<(), trimalla::domain::DomainError>(())
/// ```
impl From<&Polygon<f64>> for Pslg {
    fn from(polygon: &Polygon<f64>) -> Self {
        Self::of_rings(rings(polygon))
    }
}

/// The rings of all polygons. Where two of them share a side or overlap, even–odd decides what is inside.
impl From<&MultiPolygon<f64>> for Pslg {
    fn from(polygons: &MultiPolygon<f64>) -> Self {
        Self::of_rings(polygons.iter().flat_map(rings))
    }
}

fn rings(polygon: &Polygon<f64>) -> impl Iterator<Item = impl Iterator<Item = Coord<f64>>> {
    std::iter::once(polygon.exterior()).chain(polygon.interiors()).map(|ring| ring.coords().copied())
}

impl IndexedMesh {
    /// Its triangles, counter-clockwise, in order; those with an index out of range are passed over.
    pub fn geo_triangles(&self) -> impl Iterator<Item = Triangle<f64>> {
        let corner = |v: u32| self.points.get(v as usize).map(|&point| Coord::from(point));
        self.triangles.iter().filter_map(move |&[a, b, c]| Some(Triangle::new(corner(a)?, corner(b)?, corner(c)?)))
    }
}
