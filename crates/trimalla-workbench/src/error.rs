//! Why a command is refused.

use std::fmt;

use trimalla::refine::OptionError;

/// Why a command is refused: nothing has changed then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommandError {
    /// What is wrong.
    message: String,
    /// Where in the line: the first column, counted in characters from 1, and how many characters.
    place: Option<(usize, usize)>,
}

impl CommandError {
    /// A command that cannot be done on the present document.
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), place: None }
    }

    /// A fault in the text of a command.
    pub(crate) fn at(column: usize, width: usize, message: impl Into<String>) -> Self {
        Self { message: message.into(), place: Some((column, width)) }
    }

    /// A command that somebody cancelled.
    pub(crate) fn cancelled() -> Self {
        Self::new("cancelled; nothing has changed")
    }

    /// A command that needs a triangulation.
    pub(crate) fn nothing_triangulated() -> Self {
        Self::new("nothing is triangulated yet: 'Triangulate' comes first")
    }

    /// What is wrong.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.message
    }

    /// Where in the line the fault is: the first column, counted in characters from 1, and how many characters; `None`
    /// where the command is well formed and cannot be done.
    #[must_use]
    pub const fn place(&self) -> Option<(usize, usize)> {
        self.place
    }
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for CommandError {}

impl From<OptionError> for CommandError {
    fn from(error: OptionError) -> Self {
        Self::new(error.to_string())
    }
}
