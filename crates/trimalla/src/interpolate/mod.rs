//! Values at points of a triangulation, from values at its vertices: heights of a terrain, as the lecture notes have
//! them.
//!
//! ```text
//!        D ·················· E          The height at P by the triangle CDE: 53 m, though the
//!          ·    A      B    ·            measured points near P, A and B, are 110 m high.
//!            ·      P     ·              By the triangle ABC of the Delaunay triangulation: 106 m.
//!                ·  C  ·
//! ```
//!
//! | you want | call |
//! |---|---|
//! | the height at a point, by the triangle it lies in | [`Surface::height_at`], [`Surface::heights_at`] for many |
//! | the slope of a triangle, the mean slope at a vertex | [`Surface::gradient`], [`Surface::gradient_at`] |
//! | lines of equal height | [`Surface::contours`] |
//! | the height at a point, by its natural neighbours | [`NaturalNeighbours`] |
//! | heights at many points by the key of a method | [`interpolate`] |

mod contours;
mod error;
mod locator;
mod natural;
mod surface;

pub use contours::{Contour, Levels};
pub use error::InterpolateError;
pub use natural::{NaturalNeighbours, WeightsBy};
pub use surface::Surface;

use crate::delaunay::Delaunay;
use crate::geometry::Point;
use crate::half_edge::VertexId;

keyed! {
    /// How a value is computed from those at the vertices.
    InterpolationMethod, {
        Linear = "linear", "the plane through the corners of the triangle", "Triangulaciones";
        NaturalNeighbour = "natural-neighbour",
            "each neighbour by the area that the point would take from its Voronoi cell", "Sibson81";
        Laplace = "laplace",
            "each neighbour by the length of the Voronoi edge to it, over its distance", "BelikovEtAl97";
    }
}

/// Values at points, from values at the vertices of a Delaunay triangulation.
///
/// # Shape
/// One entry for each point, in order; `None` outside the convex hull, and for points that are not finite.
///
/// # Guarantees
/// On a vertex the value is that of the vertex, bit for bit; elsewhere it lies between the smallest and the largest of
/// the values it is computed from. Inside or outside is decided exactly.
///
/// # Errors
/// [`InterpolateError::Count`] and [`InterpolateError::Height`].
///
/// # Complexity
/// Points are taken along a space-filling curve, so that each is located from the one before: n log n, and for natural
/// neighbours the number of these.
///
/// # Examples
/// ```
/// use trimalla::delaunay::Delaunay;
/// use trimalla::geometry::Point;
/// use trimalla::interpolate::{InterpolationMethod, interpolate};
///
/// // The example of the lecture notes: A, B, C, D, E.
/// let points = [[-6.0, 9.5], [6.0, 10.5], [0.0, 0.0], [-86.0, 2.0], [84.0, 12.0]].map(Point::from);
/// let heights = [110.0, 110.0, 100.0, 70.0, 20.0];
/// let delaunay = Delaunay::new(&points)?;
/// let p = [Point::new(0.0, 6.0)];
/// let found = interpolate(&delaunay, &heights, &p, InterpolationMethod::Linear)?;
/// assert!((found[0].unwrap() - 106.0).abs() < 1e-9);
/// # Ok::<(), trimalla::interpolate::InterpolateError>(())
/// ```
#[doc(alias = "interpolación")]
pub fn interpolate(
    delaunay: &Delaunay,
    heights: &[f64],
    points: &[Point],
    method: InterpolationMethod,
) -> Result<Vec<Option<f64>>, InterpolateError> {
    let surface = Surface::new(delaunay, heights)?;
    let by = match method {
        InterpolationMethod::Linear => return Ok(surface.heights_at(points)),
        InterpolationMethod::NaturalNeighbour => WeightsBy::Area,
        InterpolationMethod::Laplace => WeightsBy::Length,
    };
    let mut neighbours = NaturalNeighbours::new(delaunay);
    Ok(in_curve_order(points, |p| neighbours.weights(p, by).map(|weights| surface.weighted(weights))))
}

/// Asks for each finite point, along a space-filling curve.
fn in_curve_order(points: &[Point], mut value: impl FnMut(Point) -> Option<f64>) -> Vec<Option<f64>> {
    let mut values = vec![None; points.len()];
    let finite: Vec<usize> = (0..points.len()).filter(|&i| points[i].is_finite()).collect();
    let places: Vec<Point> = finite.iter().map(|&i| points[i]).collect();
    for VertexId(at) in crate::delaunay::along_curve(&places) {
        values[finite[at as usize]] = value(places[at as usize]);
    }
    values
}
