//! What the words of a command line mean where clap would not see it.
//!
//! | typed | meant |
//! |---|---|
//! | `trimalla A.poly …` | `trimalla mesh A.poly …` |
//! | `trimalla -pq30a0.1 A`, and a program called `triangle` | `trimalla triangle -pq30a0.1 A` |
//! | `trimalla mesh A -q30 -a0.1` | `trimalla mesh A --min-angle=30 --max-area=0.1` |

use std::ffi::{OsStr, OsString};
use std::path::Path;

use trimalla_io::Format;
use trimalla_triangle::{SwitchError, Switches};

use crate::exit::Failure;

/// The words that clap is to see.
pub(crate) fn of(words: impl IntoIterator<Item = OsString>) -> Result<Vec<OsString>, Failure> {
    let mut words: Vec<OsString> = words.into_iter().collect();
    let is_triangle = words.first().is_some_and(|name| Path::new(name).file_stem() == Some(OsStr::new("triangle")));
    if is_triangle {
        words.splice(..1, ["trimalla", "triangle"].map(OsString::from));
        return Ok(words);
    }
    match words.get(1) {
        Some(first) if is_cluster(first) => words.insert(1, "triangle".into()),
        Some(first) if is_drawing(first) => words.insert(1, "mesh".into()),
        _ => {}
    }
    if words.get(1).is_some_and(|word| word == "mesh" || word == "refine") {
        let (subcommand, rest) = (words[1].to_string_lossy().into_owned(), words.split_off(2));
        for word in rest {
            match bounds(&word, &subcommand)? {
                Some(options) => words.extend(options),
                None => words.push(word),
            }
        }
    }
    Ok(words)
}

/// Whether a word is a cluster of Triangle's switches. `-h` and `-V` alone are ours.
fn is_cluster(word: &OsStr) -> bool {
    let Some(letters) = word.to_str().and_then(|word| word.strip_prefix('-')) else { return false };
    let is_ours = matches!(letters, "" | "h" | "V") || letters.starts_with('-');
    !is_ours && !matches!(Switches::default().add(letters), Err(SwitchError::Unknown { .. }))
}

/// Whether a word names a drawing: by its ending, or because there is such a file.
fn is_drawing(word: &OsStr) -> bool {
    let path = Path::new(word);
    Format::from_path(path).is_some() || (path.extension().is_some() && path.is_file())
}

/// The options that a word such as `-q30` or `-pq30a0.1` stands for; `None` for any other word.
fn bounds(word: &OsStr, subcommand: &str) -> Result<Option<Vec<OsString>>, Failure> {
    let Some(letters) = word.to_str().and_then(|word| word.strip_prefix('-')) else { return Ok(None) };
    let has_number = letters.bytes().any(|byte| byte.is_ascii_digit());
    if !has_number || !letters.starts_with(['p', 'q', 'a']) {
        return Ok(None);
    }
    let refused = |message: String| {
        let hint = format!("'trimalla triangle -{letters} FILE' takes all of Triangle's switches");
        Failure::wrong_use(message).hint(hint).hint("'trimalla mesh FILE --min-angle DEGREES --max-area AREA'")
    };
    let switches = Switches::parse(letters).map_err(|error| refused(error.to_string()))?;
    let understood = Switches {
        drawing: switches.drawing,
        min_angle_deg: switches.min_angle_deg,
        max_area: switches.max_area,
        ..Switches::default()
    };
    if switches != understood {
        return Err(refused(format!("'trimalla {subcommand}' takes -q and -a with a number, not '-{letters}'")));
    }
    let angle = switches.min_angle_deg.map(|degrees| format!("--min-angle={degrees}"));
    let area = switches.max_area.map(|area| format!("--max-area={area}"));
    Ok(Some(angle.into_iter().chain(area).map(OsString::from).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn assert_meant(typed: &str, meant: &str) {
        let found = of(typed.split(' ').map(OsString::from)).unwrap();
        assert_eq!(found, meant.split(' ').map(OsString::from).collect::<Vec<_>>());
    }

    #[test]
    fn first_words_name_a_subcommand() {
        assert_meant("trimalla A.poly -o x.svg", "trimalla mesh A.poly -o x.svg");
        assert_meant("trimalla -pq30a0.1 A", "trimalla triangle -pq30a0.1 A");
        assert_meant("trimalla -p A", "trimalla triangle -p A");
        assert_meant("bin/triangle -q A", "trimalla triangle -q A");
        for typed in ["trimalla", "trimalla -h", "trimalla -V", "trimalla --help", "trimalla frob", "trimalla list"] {
            assert_meant(typed, typed);
        }
    }

    #[test]
    fn bounds_stick_to_letters() {
        assert_meant("trimalla mesh A -q30 -a0.1", "trimalla mesh A --min-angle=30 --max-area=0.1");
        assert_meant("trimalla A.poly -pq33a2", "trimalla mesh A.poly --min-angle=33 --max-area=2");
        assert_meant("trimalla refine A.1 -q -a.5", "trimalla refine A.1 -q --max-area=0.5");
        assert!(of(["trimalla", "mesh", "A", "-pq30De"].map(OsString::from)).is_err());
    }
}
