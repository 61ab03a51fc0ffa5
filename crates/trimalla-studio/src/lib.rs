//! The studio of trimalla: a window on a [document](trimalla_workbench::Document), which it changes by commands only.
//!
//! | module | holds |
//! |---|---|
//! | [`app`] | the window: which panel is where, and what its buttons run |
//! | [`worker`] | commands at work on a thread of their own, which can be cancelled |
//! | [`scene`] | what is drawn of the document, as plain arrays |
//! | [`view`] | the part of the plane that is seen |
//! | [`viewer`] | the drawing: triangles, edges, the picked triangle, its path and its circle |
//! | [`inspector`], [`configuration`], [`console`] | the panels |
//!
//! Whatever a click does appears in the console as the command it is.

pub mod app;
mod configuration;
mod console;
mod inspector;
mod scene;
mod view;
mod viewer;
mod worker;

pub use app::Studio;
