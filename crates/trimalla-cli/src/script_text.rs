//! What a script shows: messages, and lines with what is wrong with them.

use std::io::{self, IsTerminal as _};

use ariadne::{Config, IndexType, Label, Report, ReportKind, Source};
use trimalla_workbench::script::ScriptError;
use trimalla_workbench::{Interface, MessageKind};

use crate::exit::Failure;
use crate::{console, progress};

/// A text without control characters, which shall not reach a terminal.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\n' { ' ' } else { c }).collect()
}

/// The text of a script, to show lines of it.
pub(crate) struct Lines<'a> {
    name: &'a str,
    source: Source<String>,
}

impl<'a> Lines<'a> {
    pub(crate) fn new(name: &'a str, text: &str) -> Self {
        Self { name, source: Source::from(plain(text)) }
    }

    /// Shows what is wrong with a line, with the line.
    pub(crate) fn show(&mut self, error: &ScriptError) {
        let first = self.source.line(error.line - 1).map_or(0, |line| line.offset());
        let length = error.text.trim_end().chars().count();
        let (column, width) = error.error.place().unwrap_or((1, length));
        // What is missing at the end of a line is shown at its last character.
        let start = first + (column - 1).min(length.saturating_sub(1));
        let place = (self.name, start..first + (column - 1 + width).clamp(1, length.max(1)));
        let config = Config::default().with_color(io::stderr().is_terminal()).with_index_type(IndexType::Char);
        let report = Report::build(ReportKind::Error, place.clone())
            .with_config(config)
            .with_message(plain(error.error.message()))
            .with_label(Label::new(place).with_message("here"))
            .finish();
        let mut shown = Vec::new();
        if report.write((self.name, &self.source), &mut shown).is_ok() {
            console::note_plain(&String::from_utf8_lossy(&shown));
        }
    }
}

/// Messages on standard output; errors are shown with their lines.
#[derive(Debug)]
pub(crate) struct Shown {
    echoes: bool,
    is_quiet: bool,
    /// Why messages could not be written.
    failed: Option<Failure>,
}

impl Shown {
    pub(crate) fn new(echoes: bool, is_quiet: bool) -> Self {
        Self { echoes, is_quiet, failed: None }
    }

    /// Whether all messages could be written.
    pub(crate) fn end(&mut self) -> Result<(), Failure> {
        self.failed.take().map_or(Ok(()), Err)
    }
}

impl Interface for Shown {
    fn message(&mut self, kind: MessageKind, text: &str) {
        let is_terminal = io::stdout().is_terminal();
        let line = match kind {
            MessageKind::Command if self.echoes => format!("> {text}\n"),
            // Blue, as the source has it, where colours are shown.
            MessageKind::Information if is_terminal => format!("\u{1b}[34m{text}\u{1b}[0m\n"),
            MessageKind::Information => format!("{text}\n"),
            MessageKind::Command | MessageKind::Error => return,
        };
        if !self.is_quiet && self.failed.is_none() {
            self.failed = console::print(&line).err();
        }
    }

    fn is_cancelled(&self) -> bool {
        progress::is_interrupted()
    }
}
