//! A document of planar triangulation that is changed by commands only: the model under a program, a prompt and a
//! graphical tool.
//!
//! ```
//! use trimalla_workbench::{Document, Quiet};
//!
//! let mut document = Document::new();
//! for line in ["V 0 0 0", "V 1 4 0", "V 2 0 3", "Triangulate", "LEPP 25 CEN"] {
//!     document.run(line, &mut Quiet)?;
//! }
//! assert!(document.figures().min_angle_deg >= 25.0);
//! document.run("Undo", &mut Quiet)?;
//! assert_eq!(document.figures().triangles, 1);
//! # Ok::<(), trimalla_workbench::CommandError>(())
//! ```
//!
//! | module | holds |
//! |---|---|
//! | [`Document`] | input, triangulation, options and selection; read by methods, changed by [`Document::run`] |
//! | [`Running`] | a command at work, slice by slice, for programs without threads |
//! | [`COMMANDS`] | every command: name, arguments, help |
//! | [`EdgePlan`] | what inserting an edge would do, step by step |
//! | [`numbers`] | messages and picks in the numbers of a file |
//! | [`refining`] | a refinement from its input to its outcome, for programs that run one and end |
//! | [`RunInformation`] | what a run of a refinement was asked, and what it did |
//! | [`script`] | many commands as a text |
//! | [`record`] | the steps of a run as lines, as pictures, and on a page that plays them |
//! | [`Interface`] | what a program shows: messages of three kinds and two events |
//!
//! # Guarantees
//! * A command is done as a whole, or reports an error and changes nothing.
//! * [`Undo`](Document::run) restores the document before a command exactly, by the records of what was overwritten.
//! * The same commands lead to the same document, bit for bit.
//!
//! # Source
//! The controller of `[Valenzuela09]`, sections 6.3 to 6.5 and appendix A.

mod arguments;
mod building;
mod changes;
mod commands;
mod document;
mod edge_plan;
mod error;
mod figures;
mod history;
mod lessons;
mod mesh;
mod messages;
mod names;
pub mod numbers;
pub mod record;
pub mod refining;
mod running;
mod runs;
pub mod script;
mod state;

pub use commands::{COMMANDS, CommandRow, EXAMPLES};
pub use document::Document;
pub use edge_plan::{EdgePlan, NamedPoint, PlanSide};
pub use error::CommandError;
pub use figures::Figures;
pub use messages::{Interface, MessageKind, Quiet};
pub use running::{Advanced, Running};
pub use runs::RunInformation;
pub use state::Construction;
