//! Commands that write files.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use trimalla_io::{Files, Memory};
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

/// A document whose files are in memory, with those of a folder of the project.
fn in_memory(folder: &str) -> (Document, Memory) {
    let memory = Memory::default();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for entry in fs::read_dir(root.join(folder)).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = Path::new(folder).join(path.file_name().expect("a name"));
        memory.put(name, fs::read(&path).expect("a file"));
    }
    (Document::new().with_files(Files::Memory(memory.clone())), memory)
}

#[test]
fn scripts_read_and_write_files_in_memory() {
    let (mut document, memory) = in_memory("data/shapes");
    let before = memory.names();
    let text = "Load data/shapes/key.poly\nTriangulate\nSet min-angle 20\nRefine\nExport key.1.ele\nExport key.svg\nExport key.png\n\
                Save key.tri\nLoad key.1.ele\nExpect triangulated yes\n";
    assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
    let new: Vec<String> =
        memory.names().iter().filter(|name| !before.contains(name)).map(|n| n.display().to_string()).collect();
    assert_eq!(new, ["key.1.ele", "key.1.node", "key.1.poly", "key.png", "key.svg", "key.tri"]);
    let saved = script::read_in(document.files(), "key.tri").expect("a script");
    assert_eq!(saved, "Load data/shapes/key.poly\nTriangulate\nSet min-angle 20\nRefine\n");
    let (mut again, _) = in_memory("data/shapes");
    assert_eq!(script::run(&mut again, &saved, false, &mut Quiet), []);
    document.run("Undo", &mut Quiet).expect("undone");
    assert_eq!(again, document, "what was saved leads there again");
    for line in ["Export data/shapes/key.poly", "Save ./data/shapes/key.poly", "Export key.1.ele", "Save key.1.node"] {
        let error = document.run(line, &mut Quiet).expect_err("it was read");
        assert!(error.message().contains("was read"), "{line}: {error}");
    }
    let error = document.run("Load nowhere.poly", &mut Quiet).expect_err("it is not there");
    assert!(error.message().contains("nowhere.poly: no such file"), "{error}");
}

#[test]
fn the_disk_and_the_memory_lead_to_the_same_document() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let scratch = Scratch::new("both");
    for name in ["guitar.poly", "key.poly"] {
        fs::copy(root.join("data/shapes").join(name), scratch.path().join(name)).expect("a copy");
        let (mut held, memory) = in_memory("data/shapes");
        let mut disk = Document::new();
        let folder = scratch.path().display().to_string();
        for (document, folder) in [(&mut held, "data/shapes"), (&mut disk, &*folder)] {
            let text = format!(
                "Load {folder}/{name}\nTriangulate\nRefine\nExport {folder}/out.ele\nExport {folder}/out.vtu\n"
            );
            assert_eq!(script::run(document, &text, false, &mut Quiet), []);
        }
        assert_eq!(held.indexed(), disk.indexed());
        for file in ["out.node", "out.ele", "out.poly", "out.vtu"] {
            let of_disk = fs::read(scratch.path().join(file)).expect("a file");
            assert_eq!(&*memory.get(Path::new("data/shapes").join(file)).expect("a file"), of_disk, "{file}");
        }
    }
}

/// The data of a page.
fn played(path: &Path) -> Value {
    let page = fs::read_to_string(path).expect("a page");
    let (_, after) = page.split_once("id=\"data\">").expect("the data");
    serde_json::from_str(after.split_once("</script>").expect("its end").0).expect("JSON")
}

/// How many triangles there are after the last step, and how many steps.
fn end_of(data: &Value) -> (usize, usize) {
    let steps = data["steps"].as_array().expect("steps");
    let last = &steps.last().expect("a step")["delta"]["triangles"];
    (last.as_u64().expect("a count") as usize, steps.len())
}

#[test]
fn a_player_shows_what_would_come_and_changes_nothing() {
    let scratch = Scratch::new("player");
    let path = scratch.path().join("run.html");
    let write = format!("Player {}", path.display());
    let mut document = Document::new();
    let drawn = "V 0 0 0\nV 1 6 0\nV 2 6 5\nV 3 0 5\nV 5 2 2\nV 6 4 2\nV 7 3 4\nV 8 3 0\nOuter 4 0 1 2 3\nInner 3 5 7 6\n\
                 Edge 8 2\n";
    for text in [drawn, "Clear\nGenerate random 40 5\nEdge 3 17\nEdge 4 20\n"] {
        assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
        document.run(&write, &mut Quiet).expect("a page");
        assert!(document.triangulation().is_none(), "{text}");
        let construction = played(&path);
        document.run("Triangulate", &mut Quiet).expect("triangles");
        assert_eq!(end_of(&construction).0, document.figures().triangles, "{text}");
        for line in ["Set min-angle 28", "Step 3", "Select 0 1 2"] {
            let _ = document.run(line, &mut Quiet); // There may be no such triangle.
            let (before, mesh, undoable) = (document.script(), document.indexed(), document.undoable());
            document.run(&write, &mut Quiet).expect("a page");
            assert_eq!((document.script(), document.indexed(), document.undoable()), (before, mesh, undoable));
            let run = played(&path);
            let start = run["start"]["triangles"].as_array().expect("triangles").len();
            assert_eq!(start, document.figures().triangles, "{text}{line}: from where the steps have got to");
            document.run("Refine", &mut Quiet).expect("refined");
            assert_eq!(end_of(&run).0, document.figures().triangles, "{text}{line}");
            document.run("Undo", &mut Quiet).expect("undone");
        }
    }
}

#[test]
fn a_player_after_a_refinement_plays_that_refinement() {
    let scratch = Scratch::new("player-after");
    let path = scratch.path().join("run.html");
    let mut document = Document::new();
    let text = "Example key\nTriangulate\nSet min-angle 25\nStep 4\nRefine\nSelect\n";
    assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
    document.run(&format!("Player {}", path.display()), &mut Quiet).expect("a page");
    let data = played(&path);
    let start = data["start"]["triangles"].as_array().expect("triangles").len();
    let (triangles, steps) = end_of(&data);
    assert_eq!((start, triangles), (213, document.figures().triangles));
    assert!(steps > 100, "{steps}");
}

#[test]
fn a_player_replaces_nothing_that_was_read() {
    let scratch = Scratch::new("player-spared");
    let drawing = scratch.path().join("d.poly");
    let text = "3 2 0 0\n0 0 0\n1 4 0\n2 0 3\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n";
    fs::write(&drawing, text).expect("written");
    let mut document = Document::new();
    document.run(&format!("Load {}", drawing.display()), &mut Quiet).expect("a drawing");
    let error = document.run(&format!("Player {}", drawing.display()), &mut Quiet).expect_err("it was read");
    assert!(error.message().contains("was read"), "{error}");
    document.run(&format!("Player {}/no/run.html", scratch.path().display()), &mut Quiet).expect_err("no folder");
    assert_eq!(fs::read_to_string(&drawing).expect("the drawing"), text);
}

#[test]
fn a_player_of_extreme_coordinates_holds_numbers() {
    let scratch = Scratch::new("player-extreme");
    let path = scratch.path().join("run.html");
    let mut document = Document::new();
    let text =
        "Set max-vertices 200\nV 0 1e308 0\nV 1 -1e308 1e308\nV 2 0 5e-324\nV 3 0.1 1e17\nV 4 0 0\nV 5 0 0\nEdge 0 1\n";
    assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
    for line in ["Triangulate", "Step 2", "Refine"] {
        document.run(&format!("Player {}", path.display()), &mut Quiet).expect("a page");
        let data = played(&path);
        let steps = data["steps"].as_array().expect("steps");
        let numbers = steps.iter().flat_map(|step| step["delta"]["points"].as_array().expect("a list"));
        assert!(numbers.flat_map(|point| point.as_array().expect("a point")).all(Value::is_number), "before {line}");
        document.run(line, &mut Quiet).expect("done");
    }
}

#[test]
fn a_drawing_that_is_exported_has_its_contours() {
    let memory = Memory::default();
    let mut document = Document::new().with_files(Files::Memory(memory.clone()));
    let text = "V 0 0 0\nV 1 9 0\nV 2 9 9\nV 3 0 9\nV 4 2 2\nV 5 2 7\nV 6 7 2\nV 7 8 8\nOuter 4 0 1 2 3\nInner 3 4 5 6\n\
                Export contours.poly\nTriangulate";
    assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
    let drawn = document.figures();
    let mut loaded = Document::new().with_files(Files::Memory(memory));
    assert_eq!(script::run(&mut loaded, "Load contours.poly\nTriangulate", false, &mut Quiet), []);
    assert_eq!((loaded.drawing().segments.len(), loaded.drawing().holes.len()), (7, 1));
    assert_eq!(loaded.figures(), drawn);
    assert_eq!(loaded.figures().area, 81.0 - 12.5);
}

#[test]
fn a_recipe_that_is_saved_is_read_again() {
    let scratch = Scratch::new("recipe");
    let path = scratch.path().join("mine.toml");
    let mut document = Document::new();
    let text = format!(
        "Set algorithm lepp-centroid\nSet select smallest-circumradius\nSet min-angle 27.5\nSet max-vertices 700\nSaveRecipe {0}\n\
         Set algorithm off-center\nSet min-angle 5\nSet max-area 3\nRecipe {0}\n",
        path.display()
    );
    assert_eq!(script::run(&mut document, &text, false, &mut Quiet), []);
    let mut expected = Document::new();
    let set = text.lines().filter(|line| line.starts_with("Set")).take(4).collect::<Vec<_>>().join("\n");
    assert_eq!(script::run(&mut expected, &set, false, &mut Quiet), []);
    assert_eq!(document.options(), expected.options(), "also what was not set is as it was");
    let before = fs::read(&path).expect("a recipe");
    for line in [format!("SaveRecipe {}", path.display()), format!("Save {}", path.display())] {
        let error = document.run(&line, &mut Quiet).expect_err("it was read");
        assert!(error.message().contains("was read"), "{line}: {error}");
    }
    assert_eq!(fs::read(&path).expect("a recipe"), before);
    fs::write(&path, "min-angle = 77\n").expect("written");
    let error = document.run(&format!("Recipe {}", path.display()), &mut Quiet).expect_err("no recipe");
    assert!(error.message().contains("mine.toml:1"), "{error}");
    assert_eq!(document.options(), expected.options(), "nothing has changed");
}
