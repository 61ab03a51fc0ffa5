//! What holds always: the laws of each room, of the layers, of the errors.

#[path = "../common/mod.rs"]
mod common;

mod angle_floor;
mod attempts;
mod check_mesh;
mod circles;
mod comments;
mod constrained_edits;
mod edits;
mod elementary;
mod features;
mod fields;
mod fill;
mod forecast;
mod glossary;
mod history;
mod improve;
mod layers;
mod library_errors;
mod operators;
mod options;
#[cfg(feature = "conformance")]
mod own_steps;
mod plans;
mod predicates;
mod quality;
mod references;
mod refine_mesh;
mod regions;
mod size;
mod sizing;
mod steps;
mod textbook;
