//! Files between the user and the memory of a page: those that are dropped or chosen come in, those that commands write
//! go out as downloads.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use trimalla_io::Memory;

/// A file: its name, and what it holds.
pub type File = (PathBuf, Arc<[u8]>);

/// The files of a page, and which of them the user has.
#[derive(Debug, Default)]
pub struct Exchange {
    memory: Memory,
    /// Those that came from the user, or were offered.
    known: BTreeMap<PathBuf, Arc<[u8]>>,
}

/// Which of several files is opened: those before in this list refer to those behind.
const OPENED: [&str; 10] = ["tri", "ele", "poly", "msh", "vtu", "mesh", "meshsuite", "soup", "txt", "node"];

impl Exchange {
    /// Files in a memory, which commands read and write.
    #[must_use]
    pub fn new(memory: Memory) -> Self {
        Self { memory, known: BTreeMap::new() }
    }

    /// Takes files that came together; the one that is to be opened.
    pub fn arrive(&mut self, files: Vec<(PathBuf, Vec<u8>)>) -> Option<PathBuf> {
        let rank = |name: &Path| {
            let ending = name.extension()?.to_str()?.to_ascii_lowercase();
            OPENED.iter().position(|opened| *opened == ending)
        };
        for (name, content) in &files {
            self.memory.put(name, content);
            self.known.extend(self.memory.get(name).map(|content| (name.clone(), content)));
        }
        files.into_iter().map(|(name, _)| name).min_by_key(|name| rank(name).unwrap_or(OPENED.len()))
    }

    /// The files that commands have written since the last call, by name.
    pub fn written(&mut self) -> Vec<File> {
        let all =
            self.memory.names().into_iter().filter_map(|name| self.memory.get(&name).map(|content| (name, content)));
        let is_new = |(name, content): &File| !self.known.get(name).is_some_and(|known| Arc::ptr_eq(known, content));
        let written: Vec<File> = all.filter(is_new).collect();
        self.known.extend(written.iter().cloned());
        written
    }
}

#[cfg(test)]
mod tests {
    use trimalla_io::Files;
    use trimalla_workbench::{Document, Quiet, script};

    use super::*;

    fn names(files: &[File]) -> Vec<String> {
        files.iter().map(|(name, _)| name.display().to_string()).collect()
    }

    #[test]
    fn what_comes_in_is_opened_and_what_is_written_goes_out_once() {
        let memory = Memory::default();
        let mut exchange = Exchange::new(memory.clone());
        let node = (PathBuf::from("m.node"), b"3 2 0 0\n1 0 0\n2 4 0\n3 0 3\n".to_vec());
        let ele = (PathBuf::from("m.ele"), b"1 3 0\n1 1 2 3\n".to_vec());
        assert_eq!(exchange.arrive(vec![node, ele]).as_deref(), Some(Path::new("m.ele")));
        assert_eq!(names(&exchange.written()), [""; 0], "the user has them");
        let mut document = Document::new().with_files(Files::Memory(memory));
        let run = |document: &mut Document, text: &str| {
            assert_eq!(script::run(document, text, false, &mut Quiet), [], "{text}");
        };
        run(&mut document, "Load m.ele\nExport out.ele\nSave out.tri\n");
        assert_eq!(names(&exchange.written()), ["out.ele", "out.node", "out.poly", "out.tri"]);
        assert_eq!(names(&exchange.written()), [""; 0], "each is offered once");
        run(&mut document, "Save out.tri\n");
        assert_eq!(names(&exchange.written()), ["out.tri"], "it was written again");
    }

    #[test]
    fn of_several_files_the_one_that_names_the_others_is_opened() {
        let open = |names: &[&str]| {
            let files = names.iter().map(|name| (PathBuf::from(name), Vec::new())).collect();
            Exchange::default().arrive(files).map(|name| name.display().to_string())
        };
        assert_eq!(open(&["a.node", "a.poly"]).as_deref(), Some("a.poly"));
        assert_eq!(open(&["a.png", "b.NODE"]).as_deref(), Some("b.NODE"));
        assert_eq!(open(&["a.poly", "run.tri"]).as_deref(), Some("run.tri"));
        assert_eq!(open(&["strange"]).as_deref(), Some("strange"), "'Load' says what is wrong with it");
        assert_eq!(open(&[]), None);
    }
}
