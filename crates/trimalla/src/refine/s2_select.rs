//! Step 2: which bad triangle is next.

mod boundary_shortest_edge;
mod first;
mod manual;
mod shortest_edge;
mod smallest_angle;
mod smallest_circumradius;

use std::sync::Arc;

use super::recipe::{Recipe, Select};
use super::ruler::Ruler;
use super::steps::{SelectStep, View};
use crate::geometry::Point;
use crate::half_edge::FaceId;
use boundary_shortest_edge::BoundaryShortestEdge;
use first::First;
use manual::Manual;
use shortest_edge::ShortestEdge;
use smallest_angle::SmallestAngle;
use smallest_circumradius::SmallestCircumradius;

/// The square of the shortest edge of a face.
fn shortest_sq(view: View<'_>, face: FaceId) -> f64 {
    shortest_sq_of(view.ruler, view.cdt.face_points(face))
}

/// The square of the shortest edge of a triangle: the same number whatever the order of its corners.
#[inline]
fn shortest_sq_of(ruler: Ruler, [a, b, c]: [Point; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| ruler.vector(Point::default(), p));
    let lesser = |x: f64, y: f64| if x < y { x } else { y };
    lesser(lesser((b - a).length_sq(), (c - b).length_sq()), (a - c).length_sq())
}

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn SelectStep + Send + Sync> {
    match recipe.select {
        Select::ShortestEdge => Arc::new(ShortestEdge),
        Select::SmallestAngle => Arc::new(SmallestAngle),
        Select::SmallestCircumradius => Arc::new(SmallestCircumradius),
        Select::BoundaryShortestEdge => Arc::new(BoundaryShortestEdge),
        Select::Manual => Arc::new(Manual),
        Select::First => Arc::new(First),
    }
}

#[cfg(test)]
super::conformance::conforms!(select, select: Select {
    shortest_edge => ShortestEdge,
    smallest_angle => SmallestAngle,
    smallest_circumradius => SmallestCircumradius,
    boundary_shortest_edge => BoundaryShortestEdge,
    manual => Manual,
    first => First,
});
