//! Links that carry a script: `index.html#script=` and the commands, percent-encoded, between newlines or `;`.
//!
//! What stands behind `#` stays in the browser: the server never sees it. Commands from a link reach the document and
//! files in memory, and nothing else.

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

/// What stands before the commands.
const KEY: &str = "script=";

/// A longer link is not made: browsers take many more characters, and what links are sent through often does not.
pub const LONGEST: usize = 8000;

/// What is written as it is.
const ENCODED: &AsciiSet =
    &NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'~').remove(b'/').remove(b',').remove(b';');

/// The script that a link carries, one command a line; `fragment` is what stands from `#` on.
///
/// ```
/// use trimalla_studio::link;
///
/// let script = link::script_of("#script=Generate%20grid%209;Triangulate");
/// assert_eq!(script.as_deref(), Some("Generate grid 9\nTriangulate\n"));
/// ```
#[must_use]
pub fn script_of(fragment: &str) -> Option<String> {
    let fragment = fragment.strip_prefix('#').unwrap_or(fragment);
    let encoded = fragment.split('&').find_map(|part| part.strip_prefix(KEY))?;
    let text = percent_decode_str(encoded).decode_utf8_lossy();
    Some(text.lines().flat_map(commands_of).map(|command| format!("{}\n", command.trim())).collect())
}

/// The commands of a line: it is split at `;`, but within quotes and comments.
fn commands_of(line: &str) -> Vec<&str> {
    let (mut commands, mut start, mut is_quoted, mut before) = (Vec::new(), 0, false, ' ');
    for (at, c) in line.char_indices() {
        match c {
            '"' => is_quoted = !is_quoted,
            '#' if !is_quoted && (before.is_whitespace() || before == ';') => break,
            ';' if !is_quoted => {
                commands.push(&line[start..at]);
                start = at + 1;
            }
            _ => {}
        }
        before = c;
    }
    commands.push(&line[start..]);
    commands
}

/// The fragment of a link that carries a script.
///
/// # Errors
/// How many characters it would take, if these are more than [`LONGEST`].
///
/// ```
/// use trimalla_studio::link;
///
/// let fragment = link::fragment_of("Load \"a;b.poly\"\nTriangulate\n")?;
/// assert_eq!(fragment, "#script=Load%20%22a;b.poly%22%0ATriangulate");
/// # Ok::<(), usize>(())
/// ```
pub fn fragment_of(script: &str) -> Result<String, usize> {
    let fragment = format!("#{KEY}{}", utf8_percent_encode(script.trim_end(), ENCODED));
    if fragment.len() > LONGEST { Err(fragment.len()) } else { Ok(fragment) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_gives_back_its_script() {
        let scripts = [
            "Generate random 50 3\nTriangulate\nRefine\n",
            "Load \"a drawing; 100% (2).poly\"\nV 0 1e-3 -2.5 # a note; with more\n",
            "Save \"ñandú & co.tri\"\n",
        ];
        for script in scripts {
            let fragment = fragment_of(script).expect("it is short");
            assert!(fragment.is_ascii() && !fragment[1..].contains(['#', ' ', '"', '\n', '&']), "{fragment}");
            assert_eq!(script_of(&fragment).as_deref(), Some(script));
        }
    }

    #[test]
    fn fragments_of_others_carry_nothing() {
        for fragment in ["", "#", "#section", "#scripts=V", "#x=script="] {
            assert_eq!(script_of(fragment), None, "{fragment}");
        }
        assert_eq!(script_of("#theme=dark&script=Clear;;Undo").as_deref(), Some("Clear\n\nUndo\n"));
        assert_eq!(script_of("#script=%ff%0A%").as_deref(), Some("\u{fffd}\n%\n"), "what is no text is shown as such");
    }

    #[test]
    fn what_is_too_long_is_refused_with_its_length() {
        let script = "V 0 0 0\n".repeat(1000);
        let length = fragment_of(&script).expect_err("it is long");
        assert!(length > LONGEST, "{length}");
    }
}
