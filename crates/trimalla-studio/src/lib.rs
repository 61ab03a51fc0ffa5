//! The studio of trimalla: a window on a [document](trimalla_workbench::Document), which it changes by commands only.
//!
//! | module | holds |
//! |---|---|
//! | `app` | the window: which panel is where, and what its buttons run |
//! | `worker` | commands at work on a thread of their own, which can be cancelled |
//! | `scene` | what is drawn of the document, as plain arrays |
//! | `viewer` | the drawing: triangles by the graphics card, all else above them |
//! | `tools` | what clicks and drags into the drawing do |
//! | `panels` | inspector, options, console |
//! | `compare` | recipes side by side |
//!
//! Whatever a click does appears in the console as the command it is.

mod app;
mod compare;
mod panels;
mod scene;
mod tools;
mod viewer;
mod worker;

pub use app::Studio;
