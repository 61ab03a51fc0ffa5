//! The planar straight-line graph a mesh is made from.

use super::error::DrawingError;
use crate::geometry::Point;

/// A region seed: the region around it gets an attribute and, where given, an area bound.
#[doc(alias = "región")]
#[doc(alias = "material")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Region {
    /// A point inside the region.
    pub seed: Point,
    /// The attribute that the region's triangles get.
    pub attribute: f64,
    /// The largest area of a triangle in the region, in squared coordinate units.
    pub max_area: Option<f64>,
}

/// A planar straight-line graph: points, segments between them, hole and region seeds.
///
/// # Shape
/// Marker and attribute columns are empty or have one entry (`attributes_per_point` entries) an element.
/// A `Pslg` holds what a caller or a file says, unchecked; [`validate`](Self::validate) and triangulation check it.
#[doc(alias = "planar straight-line graph")]
#[doc(alias = "polygon")]
#[doc(alias = "grafo")]
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Pslg {
    /// Input vertices; a vertex is named by its index here, always.
    pub points: Vec<Point>,
    /// Boundary marker a vertex; empty or `points.len()` entries.
    pub point_markers: Vec<i32>,
    /// Number of attributes a vertex carries.
    pub attributes_per_point: usize,
    /// Vertex attributes, row after row.
    pub point_attributes: Vec<f64>,
    /// Input segments as pairs of vertex indices.
    pub segments: Vec<[u32; 2]>,
    /// Marker a segment; empty or `segments.len()` entries. Where several segments run along one edge of the mesh, the
    /// edge gets the marker of the first of them whose marker is not 0.
    pub segment_markers: Vec<i32>,
    /// Hole seeds: what can be reached from them without crossing a segment is removed.
    pub holes: Vec<Point>,
    /// Region seeds.
    pub regions: Vec<Region>,
}

impl Pslg {
    /// The attributes of a vertex: 0 if the column is empty, whatever `attributes_per_point` says.
    pub(crate) fn attribute_width(&self) -> usize {
        if self.point_attributes.is_empty() { 0 } else { self.attributes_per_point }
    }

    /// Checks the lengths of columns, and that seeds are finite. Points and segments are checked where they are
    /// triangulated.
    ///
    /// # Errors
    /// [`DrawingError`] names the first fault.
    pub fn validate(&self) -> Result<(), DrawingError> {
        let columns = [
            ("the column of point markers", self.point_markers.len(), self.points.len(), true),
            (
                "the table of point attributes",
                self.point_attributes.len(),
                self.points.len().saturating_mul(self.attributes_per_point),
                false,
            ),
            ("the column of segment markers", self.segment_markers.len(), self.segments.len(), true),
        ];
        for (what, found, expected, may_be_empty) in columns {
            if found != expected && !(may_be_empty && found == 0) {
                return Err(DrawingError::Column { what, found, expected });
            }
        }
        let holes = self.holes.iter().enumerate().map(|(i, &p)| ("hole", i, p));
        let regions = self.regions.iter().enumerate().map(|(i, r)| ("region", i, r.seed));
        match holes.chain(regions).find(|(_, _, p)| !p.is_finite()) {
            Some((what, seed, at)) => Err(DrawingError::SeedNotFinite { what, seed, at }),
            None => Ok(()),
        }
    }
}
