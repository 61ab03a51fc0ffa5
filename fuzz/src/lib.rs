//! Random inputs for every door of trimalla, and what must hold of the answers.
//!
//! A [target](targets::Target) makes an [`Input`](input::Input) from bytes, and judges what the library makes of it.
//! The bytes come from libFuzzer (`fuzz_targets/`), or from a seed and a number (the plain program, `main.rs`): the
//! same bytes make the same input everywhere.
//!
//! * [`draws`]: random numbers from bytes
//! * [`drawings`], [`settings`], [`texts`]: random drawings, options, files
//! * [`input`]: what a target is given, as one readable file
//! * [`judge`]: what must hold of a mesh
//! * [`targets`]: one file for each door
//! * [`trial`]: one input tried, panics caught
//! * [`worker`], [`supervisor`]: many inputs tried, by children that may hang or die
//! * [`reduce`]: smaller inputs with the same fault

pub mod drawings;
pub mod draws;
pub mod input;
pub mod judge;
pub mod reduce;
pub mod settings;
pub mod supervisor;
pub mod targets;
pub mod texts;
pub mod trial;
pub mod worker;

/// Counts what is allocated.
#[global_allocator]
pub static MEMORY: peak_alloc::PeakAlloc = peak_alloc::PeakAlloc;
