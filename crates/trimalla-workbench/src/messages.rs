//! What a document tells the program around it.

use trimalla::constrained::ConstrainedTriangulation;

/// What a message is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageKind {
    /// The echo of a command.
    Command,
    /// Information, such as the index of a new vertex.
    Information,
    /// An error.
    Error,
}

/// What a program or a graphical tool does with messages and events.
///
/// # Source
/// `DisplayMessageFunctor` and `EventHandler` of `[Valenzuela09]`, section 6.4.1.
pub trait Interface {
    /// Shows a message of one line.
    fn message(&mut self, kind: MessageKind, text: &str);

    /// All triangles are replaced: ids that were kept are void.
    fn reset(&mut self) {}

    /// Something that is shown has changed.
    fn update(&mut self) {}

    /// A long command is at work: the triangulation as it is now. The document has it when the command is done.
    fn progress(&mut self, _triangulation: &ConstrainedTriangulation) {}

    /// Whether the command at work is to stop; asked between insertions. What was done until then is taken back.
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// Shows nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Quiet;

impl Interface for Quiet {
    fn message(&mut self, _: MessageKind, _: &str) {}
}
