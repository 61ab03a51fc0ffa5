//! The studio of trimalla: a window on a [document](trimalla_workbench::Document), which it changes by commands only.
//!
//! | module | holds |
//! |---|---|
//! | `app` | the studio: which panel is where, and what its buttons run |
//! | [`dialog`] | file dialogs: what one is to ask for, and what came of it |
//! | `window` | the studio in a window of the desktop, which opens the dialogs |
//! | `worker` | commands at work on a thread of their own or slice by slice, which can be cancelled |
//! | `scene` | what is drawn of the document, as plain arrays |
//! | `told` | what an algorithm has told until one of its steps |
//! | `viewer` | the drawing: triangles by the graphics card, all else above them |
//! | `tools` | what clicks and drags into the drawing do |
//! | `panels` | inspector, options, console |
//! | `compare` | recipes side by side |
//! | `learn` | the welcome page, lessons that play |
//! | [`link`], [`exchange`], `web` | the studio in a browser: links that carry scripts, files in memory, the page |
//!
//! Whatever a click does appears in the console as the command it is.

mod app;
mod compare;
pub mod dialog;
pub mod exchange;
mod learn;
pub mod link;
mod panels;
mod scene;
mod told;
mod tools;
mod viewer;
#[cfg(target_arch = "wasm32")]
pub mod web;
#[cfg(not(target_arch = "wasm32"))]
mod window;
mod worker;

pub use app::Studio;
#[cfg(not(target_arch = "wasm32"))]
pub use window::Window;
