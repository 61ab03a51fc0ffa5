//! No files use each other in a circle: inside `refine`, and in the program.
//!
//! A `use` item is an arrow from its file to the file that defines the name; a module that only hands a name on with
//! `pub use` is passed through.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::paths::{Use, test_files, uses};

/// A module, by the names that lead to it from the root of the folder.
type Module = Vec<String>;

/// The files of a folder, by their modules, and what they use.
struct Folder {
    /// The path of the folder itself, from the root of its crate.
    root: Module,
    files: BTreeMap<Module, Vec<Use>>,
}

#[test]
fn no_files_of_refine_use_each_other_in_a_circle() {
    let folder = Folder::read("src/refine", &["refine"]);
    assert!(folder.files.len() > 60, "only {} files were found", folder.files.len());
    assert_eq!(folder.circles(), Vec::<Vec<String>>::new());
}

#[test]
fn no_files_of_the_program_use_each_other_in_a_circle() {
    let folder = Folder::read("../trimalla-cli/src", &[]);
    assert!(folder.files.len() > 30, "only {} files were found", folder.files.len());
    assert_eq!(folder.circles(), Vec::<Vec<String>>::new());
}

#[test]
fn a_circle_is_found() {
    let file = |name: &str, text: &str| (vec![name.to_owned()], uses(text));
    let files = BTreeMap::from([
        (Vec::new(), uses("mod a; mod b; pub use b::B;")),
        file("a", "use crate::{B, c::C};"),
        file("b", "use super::c::{self, C};"),
        file("c", "#[cfg(test)] mod tests { use super::super::a::A; }"),
    ]);
    assert_eq!(Folder { root: Vec::new(), files }.circles(), Vec::<Vec<String>>::new());
    let file = |name: &str, text: &str| (vec![name.to_owned()], uses(text));
    let files = BTreeMap::from([
        (Vec::new(), uses("mod a; mod b; pub(crate) use b::B;")),
        file("a", "use crate::{B, c::C};"),
        file("b", "use super::c::{self, C};"),
        file("c", "use super::a::A as Other;"),
    ]);
    assert_eq!(Folder { root: Vec::new(), files }.circles(), [["a", "b", "c"]]);
}

impl Folder {
    /// The shipped files below a folder of the crate.
    fn read(folder: &str, root: &[&str]) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        let mut files = BTreeMap::new();
        add_files(&folder, &folder, &mut files);
        Self { root: root.iter().map(|&name| name.to_owned()).collect(), files }
    }

    /// The module in which a path of a file lies, with the names after it; `None` for what is outside of the folder.
    fn resolved(&self, file: &Module, path: &[String]) -> Option<Module> {
        let first = path.first()?;
        if first == "crate" {
            return path[1..].strip_prefix(&self.root[..]).map(<[String]>::to_vec);
        }
        let supers = path.iter().take_while(|name| *name == "super").count();
        if supers > 0 {
            let above = file.len().checked_sub(supers)?;
            return Some([&file[..above], &path[supers..]].concat());
        }
        let inner = [&file[..], path].concat();
        (first != "self" && self.files.contains_key(&inner[..=file.len()])).then_some(inner)
    }

    /// The file that defines what a path from the root of the folder names, through modules that hand it on.
    fn definition(&self, path: &[String], depth: usize) -> Option<&Module> {
        let length = (0..=path.len()).rev().find(|&length| self.files.contains_key(&path[..length]))?;
        let (module, uses) = self.files.get_key_value(&path[..length])?;
        let handed_on = path.get(length).and_then(|name| {
            let uses = uses.iter().filter(|used| used.is_handed_on && used.path.last() == Some(name));
            uses.filter_map(|used| self.resolved(module, &used.path)).next()
        });
        match handed_on {
            Some(path) if depth < 8 => self.definition(&path, depth + 1),
            _ => Some(module),
        }
    }

    /// The files that a file uses.
    fn used_by(&self, file: &Module) -> BTreeSet<&Module> {
        let own = self.files[file].iter().filter(|used| !used.is_handed_on);
        let paths = own.filter_map(|used| self.resolved(file, &used.path));
        paths.filter_map(|path| self.definition(&path, 0)).filter(|&used| used != file).collect()
    }

    /// Files that reach each other, by their names: no group where there is no circle.
    fn circles(&self) -> Vec<Vec<String>> {
        let reached: BTreeMap<&Module, BTreeSet<&Module>> =
            self.files.keys().map(|file| (file, self.reached_from(file))).collect();
        let mut circles = BTreeSet::new();
        for (file, others) in &reached {
            if others.contains(file) {
                let back = others.iter().filter(|other| reached[**other].contains(file));
                circles.insert(back.map(|module| module.join("/")).collect::<Vec<String>>());
            }
        }
        circles.into_iter().collect()
    }

    fn reached_from(&self, file: &Module) -> BTreeSet<&Module> {
        let mut reached = BTreeSet::new();
        let mut open: Vec<&Module> = self.used_by(file).into_iter().collect();
        while let Some(next) = open.pop() {
            if reached.insert(next) {
                open.extend(self.used_by(next));
            }
        }
        reached
    }
}

/// Adds the files of a folder that are not for tests only.
fn add_files(root: &Path, folder: &Path, files: &mut BTreeMap<Module, Vec<Use>>) {
    let read = fs::read_dir(folder).expect("a folder");
    let entries: Vec<PathBuf> = read.map(|entry| entry.expect("an entry").path()).collect();
    let is_rust = |path: &&PathBuf| path.extension().is_some_and(|ending| ending == "rs");
    let texts: Vec<(&PathBuf, String)> =
        entries.iter().filter(is_rust).map(|path| (path, fs::read_to_string(path).expect("a source file"))).collect();
    let tests: BTreeSet<String> = texts.iter().flat_map(|(_, text)| test_files(text)).collect();
    let is_shipped = |path: &Path| !tests.contains(&*path.file_stem().unwrap_or_default().to_string_lossy());
    for (path, text) in texts.iter().filter(|(path, _)| is_shipped(path)) {
        let inner = path.strip_prefix(root).expect("a file below the root").with_extension("");
        let mut module: Module =
            inner.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
        if module.last().is_some_and(|name| name == "mod" || name == "main" && module.len() == 1) {
            module.pop();
        }
        files.insert(module, uses(text));
    }
    for below in entries.iter().filter(|path| path.is_dir() && is_shipped(path)) {
        add_files(root, below, files);
    }
}
