//! Which rooms of the crate a Rust source names, read from its tokens.
#![allow(dead_code, reason = "every test uses a part of it")]

/// A word or a single sign; comments, strings and characters are left out.
type Token = String;

/// The first names after `crate::`, or after as many `super::` as lead to the root, in order.
///
/// # Shape
/// `depth` is how many modules deep the file lies: 1 for `room.rs` and `room/mod.rs`. Groups count
/// once for each of their branches. What stands in a module marked `#[cfg(test)]` does not count.
pub(crate) fn rooms_named(source: &str, depth: usize) -> Vec<String> {
    names_below("", source, depth)
}

/// The first names after `crate::room::`, or after as many `super::` as lead to that room, in order.
///
/// # Shape
/// As for [`rooms_named`]; `depth` counts from the room: 0 for its `mod.rs`, 1 for a file or folder in it.
pub(crate) fn folders_named(room: &str, source: &str, depth: usize) -> Vec<String> {
    names_below(room, source, depth)
}

/// The first names after the path of a room (or of the crate, without one), in order.
fn names_below(room: &str, source: &str, depth: usize) -> Vec<String> {
    let tokens = without_test_modules(tokens(source));
    let mut names = Vec::new();
    for at in 0..tokens.len() {
        let rest = &tokens[at..];
        let fresh = at < 3 || tokens[at - 3] != "super" || tokens[at - 2] != ":";
        let steps = supers(rest);
        if rest[0] == "crate" && is_path_sign(&rest[1..]) {
            if room.is_empty() {
                names.extend(branches(&rest[3..]));
            } else if rest.len() > 6 && rest[3] == room && is_path_sign(&rest[4..]) {
                names.extend(branches(&rest[6..]));
            }
        } else if rest[0] == "super" && fresh && steps == depth {
            names.extend(branches(&rest[3 * steps..]));
        }
    }
    names
}

/// A name that a `use` item brings in.
pub(crate) struct Use {
    /// The path, name by name, from `crate`, `super`, `self` or a module on.
    pub(crate) path: Vec<String>,
    /// Whether the item hands the name on: `pub use`.
    pub(crate) is_handed_on: bool,
}

/// The names that the `use` items of a source bring in; those of modules marked `#[cfg(test)]` do not count.
pub(crate) fn uses(source: &str) -> Vec<Use> {
    let tokens = without_test_modules(tokens(source));
    let mut found = Vec::new();
    for at in (0..tokens.len()).filter(|&at| tokens[at] == "use") {
        let end = tokens[at..].iter().position(|t| t == ";").map_or(tokens.len(), |length| at + length);
        // Before it stands `pub`, or `pub(…)`.
        let is_handed_on = at > 0 && (tokens[at - 1] == "pub" || tokens[at - 1] == ")");
        let mut paths = Vec::new();
        add_paths(&tokens[at + 1..end], &[], &mut paths);
        found.extend(paths.into_iter().map(|path| Use { path, is_handed_on }));
    }
    found
}

/// Adds the paths of a use tree, each with a prefix before it.
fn add_paths(tree: &[Token], prefix: &[String], paths: &mut Vec<Vec<String>>) {
    let mut path = prefix.to_vec();
    for (at, token) in tree.iter().enumerate() {
        match token.as_str() {
            ":" => {}
            "as" => break,
            "{" => {
                let mut depth = 0;
                let mut start = at + 1;
                for (end, token) in tree.iter().enumerate().skip(at) {
                    depth += i32::from(token == "{") - i32::from(token == "}");
                    if depth == 0 || depth == 1 && token == "," {
                        if start < end {
                            add_paths(&tree[start..end], &path, paths);
                        }
                        start = end + 1;
                    }
                    if depth == 0 {
                        return;
                    }
                }
            }
            name => path.push(name.to_owned()),
        }
    }
    paths.push(path);
}

/// The names of modules that a source declares under `#[cfg(test)]` without a body.
pub(crate) fn test_files(source: &str) -> Vec<String> {
    let tokens = tokens(source);
    let marks = (0..tokens.len()).filter(|&i| is_test_mark(&tokens[i..]));
    let after = marks.map(|i| &tokens[i + TEST_MARK.len()..]);
    after.filter(|t| t.len() > 2 && t[0] == "mod" && t[2] == ";").map(|t| t[1].clone()).collect()
}

/// The tokens of `#[cfg(test)]`.
const TEST_MARK: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];

fn is_test_mark(tokens: &[Token]) -> bool {
    tokens.len() > TEST_MARK.len() && tokens.iter().zip(TEST_MARK).all(|(t, mark)| t == mark)
}

fn is_path_sign(tokens: &[Token]) -> bool {
    tokens.len() > 1 && tokens[0] == ":" && tokens[1] == ":"
}

/// How many `super::` the tokens begin with.
fn supers(tokens: &[Token]) -> usize {
    let steps = tokens.chunks(3).take_while(|t| t[0] == "super" && is_path_sign(&t[1..]));
    steps.count()
}

/// The name that begins a path, or the names that begin the branches of a group.
fn branches(tokens: &[Token]) -> Vec<String> {
    if tokens.first().is_none_or(|t| t != "{") {
        return tokens.iter().take(1).cloned().collect();
    }
    let (mut names, mut depth) = (Vec::new(), 0);
    for pair in tokens.windows(2) {
        match pair[0].as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            break;
        }
        if depth == 1 && (pair[0] == "{" || pair[0] == ",") && pair[1] != "}" {
            names.push(pair[1].clone());
        }
    }
    names
}

/// Leaves out the bodies of modules marked `#[cfg(test)]`.
fn without_test_modules(tokens: Vec<Token>) -> Vec<Token> {
    let mut kept = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        if is_test_mark(&tokens[at..]) {
            at = end_of_item(&tokens, at + TEST_MARK.len());
        } else {
            kept.push(tokens[at].clone());
            at += 1;
        }
    }
    kept
}

/// The place after the item that begins at `at`: after its `;` or its matching brace.
fn end_of_item(tokens: &[Token], at: usize) -> usize {
    let mut depth = 0;
    for (i, token) in tokens.iter().enumerate().skip(at) {
        match token.as_str() {
            "{" => depth += 1,
            "}" if depth == 1 => return i + 1,
            "}" => depth -= 1,
            ";" if depth == 0 => return i + 1,
            _ => {}
        }
    }
    tokens.len()
}

/// Splits a source into words and signs.
fn tokens(source: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = source;
    while let Some(c) = rest.chars().next() {
        let length = skipped(rest);
        if length > 0 {
            rest = &rest[length..];
            continue;
        }
        let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        let length = word.max(c.len_utf8());
        if !c.is_whitespace() {
            tokens.push(rest[..length].to_owned());
        }
        rest = &rest[length..];
    }
    tokens
}

/// The length of the comment, string, character or raw string that the text begins with, or 0.
fn skipped(text: &str) -> usize {
    if text.starts_with("//") {
        text.find('\n').unwrap_or(text.len())
    } else if text.starts_with("/*") {
        block_comment(text)
    } else if text.starts_with('"') {
        quoted(text, '"')
    } else if text.starts_with("r\"") || text.starts_with("r#") {
        raw_string(text)
    } else if text.starts_with("'\\") || text.chars().nth(2) == Some('\'') && text.starts_with('\'') {
        quoted(text, '\'')
    } else {
        0
    }
}

/// The length of a block comment; they nest.
fn block_comment(text: &str) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while let Some(sign) = text.as_bytes().get(at..at + 2) {
        match sign {
            b"/*" => depth += 1,
            b"*/" => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

/// The length of a text between two equal quotes, a backslash hiding what follows it.
fn quoted(text: &str, quote: char) -> usize {
    let mut hidden = false;
    for (i, c) in text.char_indices().skip(1) {
        if c == quote && !hidden {
            return i + 1;
        }
        hidden = c == '\\' && !hidden;
    }
    text.len()
}

/// The length of a raw string; 0 for a raw name.
fn raw_string(text: &str) -> usize {
    let hashes = text[1..].chars().take_while(|&c| c == '#').count();
    if !text[1 + hashes..].starts_with('"') {
        return 0;
    }
    let end = format!("\"{}", "#".repeat(hashes));
    let body = 2 + hashes;
    text[body..].find(&end).map_or(text.len(), |i| body + i + end.len())
}
