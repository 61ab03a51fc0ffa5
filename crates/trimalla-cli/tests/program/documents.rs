//! docs/documents.md says where each feature of the five documents works: what it names must be there.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::Scratch;

/// Everything that the page may name: the sources by path, and the help of each subcommand.
struct Known {
    sources: Vec<(PathBuf, String)>,
    tests: BTreeSet<String>,
    helps: BTreeMap<String, String>,
}

impl Known {
    fn of(root: &Path) -> Self {
        let mut sources = Vec::new();
        for folder in ["crates", "scripts", "bench"] {
            collect(&root.join(folder), &mut sources);
        }
        let tests = sources.iter().flat_map(|(_, text)| tests_in(text)).collect();
        Self { sources, tests, helps: BTreeMap::new() }
    }

    /// What is wrong with a name in the column of tests.
    fn fault_of_test(&self, name: &str) -> Option<String> {
        let is_there = if name.contains('.') {
            self.sources.iter().any(|(path, _)| path.file_name().is_some_and(|file| file == name))
        } else {
            self.tests.contains(name)
        };
        (!is_there).then(|| format!("no test or program is called {name}"))
    }

    /// What is wrong with something that a user calls.
    fn fault_of_call(&mut self, call: &str) -> Option<String> {
        if let Some(command) = call.strip_prefix("trimalla ") {
            return self.fault_of_command(command);
        }
        if let Some(script) = call.strip_prefix("sh ") {
            let is_there = self.sources.iter().any(|(path, _)| path.ends_with(script));
            return (!is_there).then(|| format!("there is no script {script}"));
        }
        if call.starts_with("cargo ") {
            return None;
        }
        let (owner, name) = call.split_once("::").map_or((None, call), |(owner, name)| (Some(owner), name));
        let is_there = self
            .sources
            .iter()
            .any(|(_, text)| owner.is_none_or(|owner| words(text).any(|word| word == owner)) && defines(text, name));
        (!is_there).then(|| format!("nothing is called {call}"))
    }

    /// What is wrong with the words of a command line: its subcommand and options must be in the help.
    fn fault_of_command(&mut self, command: &str) -> Option<String> {
        let mut words = command.split_whitespace();
        let subcommand = words.next()?.to_owned();
        let help = self
            .helps
            .entry(subcommand.clone())
            .or_insert_with(|| Scratch::new("documents").run(&format!("{subcommand} --help")).expect(0).stdout);
        let options = words.filter(|word| word.starts_with("--"));
        let unknown: Vec<&str> = options.filter(|option| !self::words(help).any(|word| word == *option)).collect();
        (!unknown.is_empty()).then(|| format!("trimalla {subcommand} has no {unknown:?}"))
    }
}

/// The Rust files and scripts below a folder, but what is built.
fn collect(folder: &Path, into: &mut Vec<(PathBuf, String)>) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        if entry.is_dir() && entry.file_name().is_some_and(|name| name != "target") {
            collect(&entry, into);
        } else if entry.extension().is_some_and(|extension| extension == "rs" || extension == "sh") {
            let text = fs::read_to_string(&entry).expect("text");
            into.push((entry, text));
        }
    }
}

/// The names of the tests in a source: the function that follows the attribute.
fn tests_in(text: &str) -> impl Iterator<Item = String> + '_ {
    text.split("#[test]").skip(1).filter_map(|rest| {
        let name = rest.split("fn ").nth(1)?;
        Some(name.split('(').next()?.to_owned())
    })
}

/// The words of a text: letters, digits, underscores and hyphens.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '-')).filter(|word| !word.is_empty())
}

/// Whether a source defines something of that name: a function, a type, a variant, a field or a row of a macro.
fn defines(text: &str, name: &str) -> bool {
    text.lines().map(str::trim_start).any(|line| {
        let line = line.trim_start_matches("pub(crate) ").trim_start_matches("pub ").trim_start_matches("const ");
        let keywords = ["fn ", "struct ", "enum ", "trait ", "type "];
        let rest = keywords.iter().find_map(|keyword| line.strip_prefix(keyword)).unwrap_or(line);
        rest.strip_prefix(name).is_some_and(|rest| {
            // A row or a variant stands alone on its line, or is followed by what belongs to it.
            rest.is_empty() || rest.starts_with([',', '(', '<', ' ', ':', ';', '{'])
        })
    })
}

/// What stands between backticks in a cell.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

#[test]
fn the_page_of_the_documents_names_what_there_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(root.join("docs/documents.md")).expect("the page");
    let mut known = Known::of(&root);
    let rows = page.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| section "));
    let (mut faults, mut count, mut waiting) = (Vec::new(), 0, 0);
    for row in rows {
        let cells: Vec<String> =
            row.trim_matches('|').replace("\\|", "/").split('|').map(|cell| cell.trim().to_owned()).collect();
        let [_, feature, call, test] = &cells[..] else { panic!("four cells: {row}") };
        count += 1;
        let waits = test.starts_with("not yet: ");
        waiting += usize::from(waits);
        let mut found: Vec<String> = quoted(call).filter_map(|call| known.fault_of_call(call)).collect();
        found.extend(quoted(test).filter_map(|name| known.fault_of_test(name)));
        if !waits && quoted(test).next().is_none() {
            found.push("no test".to_owned());
        }
        faults.extend(found.into_iter().map(|fault| format!("{feature}: {fault}")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let told = format!("Of {count} features {} work; {waiting} wait", count - waiting);
    assert!(page.contains(&told), "the page says otherwise than: {told}");
}

#[test]
fn what_is_not_there_is_noticed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut known = Known::of(&root);
    for call in ["Delaunay::no_such_call", "NoSuchType", "trimalla mesh --no-such-option", "sh scripts/none.sh"] {
        assert!(known.fault_of_call(call).is_some(), "{call}");
    }
    for test in ["no_such_test", "no-such-file.rs", "collect"] {
        assert!(known.fault_of_test(test).is_some(), "{test}");
    }
}
