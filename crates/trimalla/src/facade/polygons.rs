//! The polygons of a domain: what algorithms for polygons get of a triangulated drawing.

use crate::drawing::IndexedMesh;
use crate::geometry::Point;
use crate::polygon::{Polygon, PolygonError, SeenCorner, Visibility, visible};
use crate::trace::Trace;

/// One part of a domain, joined along edges: its outline and its holes as a polygon, with vertices numbered anew.
#[derive(Clone, Debug, PartialEq)]
pub struct DomainPolygon {
    points: Vec<Point>,
    ring_ends: Vec<u32>,
    corners: Vec<u32>,
}

impl DomainPolygon {
    /// The polygons of a mesh, one for each part that is joined along edges.
    ///
    /// # Complexity
    /// That of [`IndexedMesh::outlines`].
    #[must_use]
    pub fn all_of(domain: &IndexedMesh) -> Vec<Self> {
        let of_rings = |rings: Vec<Vec<u32>>| {
            let corners: Vec<u32> = rings.concat();
            let mut end = 0;
            let ring_ends = rings.iter().map(|ring| {
                end += ring.len() as u32;
                end
            });
            let ring_ends = ring_ends.collect();
            let points = corners.iter().map(|&v| domain.points[v as usize]).collect();
            Self { points, ring_ends, corners }
        };
        domain.outlines().into_iter().map(|outline| of_rings(outline.rings)).collect()
    }

    /// The polygon.
    ///
    /// # Errors
    /// A coordinate that is not finite, too many points: never for the polygons of a triangulated drawing.
    pub fn polygon(&self) -> Result<Polygon<'_>, PolygonError> {
        Polygon::new(&self.points, &self.ring_ends)
    }

    /// The vertex of the mesh that each point of the polygon is. A vertex in which rings touch is there several times.
    #[must_use]
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// Whether two points of this part see each other: see [`visible`].
    ///
    /// # Errors
    /// Those of [`DomainPolygon::polygon`].
    pub fn is_visible(&self, x: Point, y: Point) -> Result<bool, PolygonError> {
        Ok(visible(self.polygon()?, x, y))
    }

    /// What a point of this part sees of it, its vertices named as in the mesh: see [`Visibility::seen_from`].
    ///
    /// # Errors
    /// Those of [`DomainPolygon::polygon`]; cancelled.
    pub fn seen_from(&self, x: Point, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<SeenCorner>, PolygonError> {
        let seen = Visibility::new(self.polygon()?, trace)?.seen_from(x, trace)?;
        let number = |v: u32| self.corners[v as usize];
        let renamed = seen.into_iter().map(|corner| match corner {
            SeenCorner::Vertex { vertex, at } => SeenCorner::Vertex { vertex: number(vertex), at },
            SeenCorner::OnSide { side, past, at } => {
                SeenCorner::OnSide { side: side.map(number), past: number(past), at }
            }
            other => other,
        });
        Ok(renamed.collect())
    }
}
