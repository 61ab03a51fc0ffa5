//! The table of algorithms for polygons.

use super::constrained_delaunay::Flips;
use super::lone_points::LonePoints;
use super::{
    Polygon, PolygonError, art_gallery, constrained_delaunay, diagonals, ears, monotone, seidel, visible_pairs,
};
use crate::trace::Trace;

keyed! {
    /// An algorithm that triangulates polygons.
    PolygonMethod, {
        Monotone = "monotone", "a sweep into monotone pieces, each triangulated with a stack", "GareyEtAl78";
        Ears = "ears", "ears cut off one after the other", "Meisters75";
        Diagonals = "diagonals", "a diagonal divides the polygon in two, again and again", "Meisters75";
        VisiblePairs = "visible-pairs", "vertices that see each other are joined", "Triangulaciones";
        Seidel = "seidel", "trapezoids by random insertion, then monotone pieces", "Seidel91";
        ConstrainedDelaunay = "constrained-delaunay", "any triangulation, then flips of edges that fail the circle test", "LeeLin86";
        ArtGallery = "art-gallery", "Seidel's triangles in three colours: guards at the corners of the rarest one", "Fisk78";
    }
}

impl PolygonMethod {
    /// Triangulates a polygon.
    ///
    /// # Shape
    /// Counter-clockwise triangles of indices into [`Polygon::points`].
    ///
    /// A hole of one point is a corner of triangles, also of those of `art-gallery`; its guards do not need it.
    ///
    /// # Errors
    /// Those of the algorithm: each is at the function that this one calls.
    pub fn triangulate(
        self,
        polygon: Polygon<'_>,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Vec<[u32; 3]>, PolygonError> {
        let Some(apart) = LonePoints::of(polygon) else { return self.of_rings(polygon, trace) };
        let mut triangles = apart.triangulate(polygon, trace, |rings, trace| self.of_rings(rings, trace))?;
        if self == Self::ConstrainedDelaunay {
            Flips::default().legalise(polygon.points(), &mut triangles, trace)?;
        }
        Ok(triangles)
    }

    /// Triangulates a polygon without holes of one point.
    fn of_rings(self, polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
        match self {
            Self::Monotone => monotone(polygon, trace),
            Self::Ears => ears(polygon, trace),
            Self::Diagonals => diagonals(polygon, trace),
            Self::VisiblePairs => visible_pairs(polygon, trace),
            Self::Seidel => seidel(polygon, trace),
            Self::ConstrainedDelaunay => constrained_delaunay(polygon, trace),
            Self::ArtGallery => Ok(art_gallery(polygon, trace)?.triangles),
        }
    }
}
