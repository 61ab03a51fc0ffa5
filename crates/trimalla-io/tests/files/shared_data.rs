//! Real files: everything in the `triangle` family of the shared data.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]
#![allow(clippy::print_stderr, reason = "a skipped test says so")]

use std::fs;
use std::path::PathBuf;

use crate::common::{bits, scratch, shared_data};
use trimalla_io::{WriteOptions, read_mesh_numbered, read_pslg, read_pslg_numbered, write_mesh, write_pslg};

/// The files of the family with one ending, or nothing (and a line that says so) without the shared data.
fn family(ending: &str) -> Vec<PathBuf> {
    let Some(data) = shared_data() else {
        eprintln!("skipped: no shared data (set TRIMALLA_SHARED to its folder)");
        return Vec::new();
    };
    let entries = fs::read_dir(data.join("triangle")).unwrap().map(|e| e.unwrap().path());
    let mut files: Vec<_> = entries.filter(|p| p.extension().is_some_and(|e| e == ending)).collect();
    files.sort();
    assert!(!files.is_empty(), "no .{ending} file");
    files
}

#[test]
fn every_drawing_is_read_and_written_back() {
    let directory = scratch("shared-drawings");
    for file in family("poly").into_iter().chain(family("node")) {
        let drawing = read_pslg_numbered(&file).unwrap_or_else(|e| panic!("{e}"));
        assert!(!drawing.value.points.is_empty());
        let options = WriteOptions::default().with_first_index(drawing.first_index);
        write_pslg(directory.join("again.poly"), &drawing.value, &options).unwrap();
        let again = read_pslg_numbered(directory.join("again.poly")).unwrap();
        assert_eq!((&again.value, again.first_index), (&drawing.value, drawing.first_index), "{}", file.display());
        assert_eq!(bits(&again.value.points, &[]), bits(&drawing.value.points, &[]));
    }
}

#[test]
fn every_mesh_is_read_and_written_back() {
    let directory = scratch("shared-meshes");
    for file in family("ele") {
        let mesh = read_mesh_numbered(&file).unwrap_or_else(|e| panic!("{e}"));
        assert!(!mesh.value.triangles.is_empty());
        write_mesh(
            directory.join("again.ele"),
            &mesh.value,
            &WriteOptions::default().with_first_index(mesh.first_index),
        )
        .unwrap();
        let again = read_mesh_numbered(directory.join("again.ele")).unwrap();
        assert_eq!((&again.value, again.first_index), (&mesh.value, mesh.first_index), "{}", file.display());
    }
}

#[test]
fn counts_are_those_of_the_catalogue() {
    let Some(data) = shared_data() else { return };
    for (name, points, segments, holes) in [
        ("A.poly", 29, 29, 1),
        ("box.poly", 8, 5, 1),
        ("dots.node", 100, 0, 0),
        ("double_hex.poly", 96, 96, 2),
        ("face.poly", 26, 22, 3),
        ("spiral.node", 15, 0, 0),
        ("square_circle_hole.poly", 826, 135, 1),
        ("double_hex2.poly", 48, 48, 2),
    ] {
        let pslg = read_pslg(data.join("triangle").join(name)).unwrap();
        assert_eq!((pslg.points.len(), pslg.segments.len(), pslg.holes.len()), (points, segments, holes), "{name}");
    }
}
