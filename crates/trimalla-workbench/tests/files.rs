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
fn what_was_read_is_not_replaced_by_whatever_name() {
    let scratch = Scratch::new("spared");
    let drawing = scratch.path().join("a drawing #1.poly");
    let text = "3 2 0 0\n0 0 0\n1 4 0\n2 0 3\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n";
    fs::write(&drawing, text).expect("written");
    let name = script::word(&drawing.display().to_string());
    let mut document = Document::new();
    document.run(&format!("Load {name} # with blanks"), &mut Quiet).expect("a drawing");
    assert_eq!(document.figures().vertices, 3);
    let other = scratch.path().join("other.poly");
    fs::hard_link(&drawing, &other).expect("a link");
    for line in [format!("Export {name}"), format!("Save {name}"), format!("Export {}", other.display())] {
        let error = document.run(&line, &mut Quiet).expect_err("it was read");
        assert!(error.message().contains("was read"), "{line}: {error}");
    }
    document.run("Clear", &mut Quiet).expect("cleared");
    document.run(&format!("Save {name}"), &mut Quiet).expect_err("it was read before");
    assert_eq!(fs::read_to_string(&drawing).expect("the drawing"), text);
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
