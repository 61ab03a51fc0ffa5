//! The prompt of `trimalla run -`: commands with a history and completion.

use rustyline::completion::Completer;
use rustyline::error::ReadlineError;
use rustyline::highlight::Highlighter;
use rustyline::hint::Hinter;
use rustyline::history::DefaultHistory;
use rustyline::validate::Validator;
use rustyline::{Context, Editor, Helper};
use trimalla_workbench::Document;
use trimalla_workbench::script::{ScriptError, completions};

use crate::exit::{Failure, Status};
use crate::script_text::{Lines, Shown};
use crate::{console, progress};

/// Completes the names of commands, and after `Help` too.
#[derive(Debug)]
struct Commands;

impl Helper for Commands {}
impl Highlighter for Commands {}
impl Validator for Commands {}
impl Hinter for Commands {
    type Hint = String;
}

impl Completer for Commands {
    type Candidate = String;

    fn complete(&self, line: &str, at: usize, _: &Context<'_>) -> rustyline::Result<(usize, Vec<String>)> {
        let before = &line[..at];
        let start = before.rfind(char::is_whitespace).map_or(0, |blank| blank + 1);
        let is_name = before[..start].trim().is_empty() || before[..start].trim().eq_ignore_ascii_case("help");
        let names = completions(&before[start..]).filter(|_| is_name);
        Ok((start, names.map(str::to_owned).collect()))
    }
}

/// Reads commands until the end of input.
pub(crate) fn run(document: &mut Document, shown: &mut Shown) -> Result<Status, Failure> {
    let failed = |error: ReadlineError| Failure::bad_input(format!("cannot read commands: {error}"));
    let mut editor: Editor<Commands, DefaultHistory> = Editor::new().map_err(failed)?;
    editor.set_helper(Some(Commands));
    console::print("'Help' lists the commands; Ctrl-D ends.\n")?;
    loop {
        match editor.readline("> ") {
            Ok(text) => {
                let _ = editor.add_history_entry(&text);
                if let Err(error) = document.run(&text, shown) {
                    Lines::new("prompt", &text).show(&ScriptError { line: 1, text: text.clone(), error });
                }
                shown.end()?;
                progress::resume();
            }
            Err(ReadlineError::Interrupted) => {}
            Err(ReadlineError::Eof) => break,
            Err(error) => return Err(failed(error)),
        }
    }
    Ok(Status::Done)
}
