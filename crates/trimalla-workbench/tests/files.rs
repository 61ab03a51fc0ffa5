//! Commands that write files.

use std::fs;
use std::path::{Path, PathBuf};

use trimalla_workbench::{Document, Quiet, script};

/// A folder of its own for a test, removed after it.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("trimalla-workbench-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn what_is_saved_leads_to_the_same_document() {
    let scratch = Scratch::new("saved");
    let path = scratch.path().join("session.tri");
    let mut document = Document::new();
    let text = format!("Generate random 60 4\nTriangulate\nLEPP 20 MID\nDelete 3\nUndo\nSave {}\n", path.display());
    assert_eq!(script::run(&mut document, &text, false, &mut Quiet), []);
    let saved = fs::read_to_string(&path).expect("a script");
    assert_eq!(saved, "Generate random 60 4\nTriangulate\nLEPP 20 MID\n");
    let mut again = Document::new();
    assert_eq!(script::run(&mut again, &saved, false, &mut Quiet), []);
    assert_eq!(again, document);
}

#[test]
fn a_mesh_that_is_exported_is_loaded_as_it_was() {
    let scratch = Scratch::new("exported");
    let (drawing, mesh) = (scratch.path().join("d.poly"), scratch.path().join("m.ele"));
    let mut document = Document::new();
    let text = format!(
        "V 0 0 0\nV 1 4 -1\nV 2 8 0\nV 3 4 1\nExport {}\nTriangulate\nFlip 1 3\nExport {}\nLoad {}\n\
         Expect edge 0 2 yes\nExpect delaunay no\nUndo\nExpect delaunay no\nLoad {}\nExpect triangulated no\n",
        drawing.display(),
        mesh.display(),
        mesh.display(),
        drawing.display()
    );
    assert_eq!(script::run(&mut document, &text, false, &mut Quiet), []);
    let refused = script::run(&mut document, "Load nowhere.poly", false, &mut Quiet);
    assert!(refused[0].to_string().contains("nowhere.poly"), "{refused:?}");
    assert!(document.triangulation().is_none());
}
