//! Step 2: which bad triangle is next.

mod boundary_shortest_edge;
mod first;
mod manual;
mod shortest_edge;
mod shortest_sq;
mod smallest_angle;
mod smallest_circumradius;

use std::sync::Arc;

use super::recipe::{Recipe, Select};
use super::steps::SelectStep;
use boundary_shortest_edge::BoundaryShortestEdge;
use first::First;
use manual::Manual;
use shortest_edge::ShortestEdge;
use smallest_angle::SmallestAngle;
use smallest_circumradius::SmallestCircumradius;

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
