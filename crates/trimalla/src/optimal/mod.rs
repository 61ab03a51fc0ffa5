//! Triangulations of points and polygons that are best by some criterion, and greedy ones.
//!
//! [`OptimalMethod`] chooses an algorithm by its key; [`OptimalInput`] says what is triangulated: points, or a
//! domain with holes, given by any triangulation of it.

mod decompose;
mod edge_insertion;
mod edge_set;
mod error;
mod flips;
mod greedy;
mod input;
mod mesh;
mod method;
mod min_max_length;
mod min_weight;
mod min_weight_polygon;
mod pairs;
mod twofold;

pub use error::OptimalError;
pub use flips::{FlipCriterion, locally_optimal};
pub use input::{Optimal, OptimalInput};
pub use method::OptimalMethod;
pub use min_weight::{MinimumWeight, WeightBudget, minimum_weight};
