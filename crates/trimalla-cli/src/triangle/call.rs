//! The words of a call: switches behind dashes, and a file.

use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use trimalla_triangle::{ROWS, SwitchError, Switches, Verdict};

use crate::console::shown;
use crate::exit::Failure;

/// A call of `trimalla triangle`.
#[derive(Debug)]
pub(crate) struct Call {
    pub(super) switches: Switches,
    pub(super) file: PathBuf,
    /// The call in words, for the comment at the end of files.
    pub(super) command: String,
}

impl Call {
    /// Reads the words; `None` where they ask for help, or say nothing.
    pub(crate) fn of(words: &[OsString]) -> Result<Option<Self>, Failure> {
        let (mut switches, mut file) = (Switches::default(), None);
        for word in words {
            let text = word.to_string_lossy();
            if text == "--help" {
                return Ok(None);
            }
            if text.starts_with('-') {
                switches.add(&text).map_err(refused)?;
            } else if let Some(first) = file.replace(PathBuf::from(word)) {
                let message = format!("two files: {} and {}", shown(&first), shown(Path::new(word)));
                return Err(Failure::wrong_use(message).hint("a number sticks to its switch: -q30, not -q 30"));
            }
        }
        switches.validate().map_err(refused)?;
        if switches.help || words.is_empty() {
            return Ok(None);
        }
        let Some(file) = file else {
            return Err(Failure::wrong_use("no file").hint("trimalla triangle -pq30 FILE; -h explains the switches"));
        };
        let words: Vec<_> = words.iter().map(|word| shown(Path::new(word))).collect();
        Ok(Some(Self { switches, file, command: format!("trimalla triangle {}", words.join(" ")) }))
    }
}

fn refused(error: SwitchError) -> Failure {
    let is_number = matches!(error, SwitchError::Unknown { letter: '-' | '+' | '0'..='9', .. });
    let failure = Failure::wrong_use(error.to_string());
    let failure = if is_number { failure.hint("a number has no exponent: -a0.00001, not -a1e-5") } else { failure };
    failure.hint("'trimalla triangle -h' explains the switches")
}

/// Every switch in one line each.
pub(crate) fn switches_text() -> String {
    let mut text = String::from("Switches:\n");
    for row in ROWS {
        let note = match row.verdict {
            Verdict::Same => String::new(),
            Verdict::Differs => format!(" ({})", row.note),
            Verdict::Refused => format!(": refused; {}", row.note),
        };
        let _ = writeln!(text, "  {:<10} {}{note}", row.form, row.summary);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(words: &str) -> Result<Option<Call>, Failure> {
        Call::of(&words.split_whitespace().map(OsString::from).collect::<Vec<_>>())
    }

    #[test]
    fn words_are_switches_and_a_file() {
        let found = call("-p -q30 object -a.1").unwrap().unwrap();
        assert_eq!((found.switches.max_area, found.file), (Some(0.1), PathBuf::from("object")));
        assert_eq!(found.command, "trimalla triangle -p -q30 object -a.1");
        assert!(call("-h").unwrap().is_none() && call("").unwrap().is_none());
        for words in ["-pq 30 object", "-pq30", "-pW x", "-rI x"] {
            assert!(call(words).is_err(), "{words}");
        }
    }
}
