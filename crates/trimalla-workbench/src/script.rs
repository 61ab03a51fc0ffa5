//! Scripts: the commands of a document as a text, one a line.

use std::fmt;

use crate::document::Document;
use crate::error::CommandError;
use crate::messages::Interface;

/// A command of a script that was refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScriptError {
    /// The line, counted from 1.
    pub line: usize,
    /// The text of that line.
    pub text: String,
    /// What is wrong with it.
    pub error: CommandError,
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.line)?;
        if let Some((column, _)) = self.error.place() {
            write!(f, "{column}:")?;
        }
        write!(f, " {}", self.error)
    }
}

impl std::error::Error for ScriptError {}

/// Runs the lines of a script up to the first that is refused, or with `keeps_going` all of them; returns those that
/// were refused.
///
/// # Examples
/// ```
/// use trimalla_workbench::{Document, Quiet, script};
///
/// let mut document = Document::new();
/// let refused = script::run(&mut document, "V 0 0 0 # a corner\n\nV 0 1 1\n", false, &mut Quiet);
/// assert_eq!(refused[0].to_string(), "3:3: the index must be above 0, the highest there is");
/// ```
pub fn run(document: &mut Document, text: &str, keeps_going: bool, interface: &mut dyn Interface) -> Vec<ScriptError> {
    let mut refused = Vec::new();
    for (line, text) in (1..).zip(text.lines()) {
        if let Err(error) = document.run(text, interface) {
            refused.push(ScriptError { line, text: text.to_owned(), error });
            if !keeps_going {
                break;
            }
        }
    }
    refused
}
