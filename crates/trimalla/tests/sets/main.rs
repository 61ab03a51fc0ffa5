//! Random and real inputs, family by family: all algorithms agree, and every mesh keeps its promises.

#[path = "../common/mod.rs"]
mod common;

mod constrained_sets;
mod damaged_drawings;
mod hostile_refinement;
mod meshsuite_a;
mod random_sets;
mod real_inputs;
mod real_points;
mod rotated;
