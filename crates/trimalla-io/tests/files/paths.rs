//! Paths: which files belong together, what is no file, and output that appears whole or not at all.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};

use crate::common::{ELE, NODE, POLY, grid, names_in, scratch};
use trimalla_io::{Format, IoError, WriteOptions, files_of_mesh, read_mesh, read_pslg, write_mesh, write_pslg};

fn options() -> WriteOptions {
    WriteOptions::default()
}

/// Checks that writing a mesh fails as an output error and that the directory is left as it was.
fn refused(path: &Path, directory: &Path) -> String {
    let before = names_in(directory);
    let error = write_mesh(path, &grid(2), &options()).unwrap_err();
    assert!(error.is_output(), "{error}");
    assert_eq!(names_in(directory), before, "nothing new, nothing gone");
    error.to_string()
}

#[test]
fn companions_are_found_and_missed() {
    let dir = scratch("companions");
    fs::write(dir.join("a.poly"), "0 2 0 1\n1 0\n1 1 2\n0\n").unwrap();
    let error = read_pslg(dir.join("a.poly")).unwrap_err();
    assert!(
        matches!(&error, IoError::Missing { path, needed_by: Some(by) } if path.ends_with("a.node") && by.ends_with("a.poly"))
    );
    assert!(error.to_string().contains("a.node: no such file, needed by "), "{error}");
    fs::write(dir.join("a.node"), NODE).unwrap();
    assert_eq!(read_pslg(dir.join("a.poly")).unwrap().points.len(), 4);
    assert_eq!(read_pslg(dir.join("a")).unwrap().segments, [[0, 1]]);

    fs::write(dir.join("a.ele"), ELE).unwrap();
    assert_eq!(read_mesh(dir.join("a")).unwrap().segments, [[0, 1]]);
    fs::write(dir.join("a.poly"), POLY).unwrap();
    assert!(
        read_mesh(dir.join("a.ele")).unwrap().segments.is_empty(),
        "a drawing of the same stem is no part of the mesh"
    );

    fs::rename(dir.join("a.ele"), dir.join("B.ELE")).unwrap();
    fs::rename(dir.join("a.node"), dir.join("B.NODE")).unwrap();
    assert_eq!(read_mesh(dir.join("B.ELE")).unwrap().triangles.len(), 2);
}

#[test]
fn companions_must_agree() {
    let dir = scratch("agree");
    fs::write(dir.join("a.node"), "3\n0 0 0\n1 1 0\n2 0 1\n").unwrap();
    fs::write(dir.join("a.ele"), "1 3 0\n1 1 2 3\n").unwrap();
    let error = read_mesh(dir.join("a.ele")).unwrap_err().to_string();
    assert!(error.ends_with("a.ele:2:7: expected a vertex index between 0 and 2, found '3'"), "{error}");
    fs::write(dir.join("a.ele"), "1 3 0\n0 0 1 2\n").unwrap();
    fs::write(dir.join("a.poly"), "0\n1\n0 1 3\n0\n").unwrap();
    let error = read_mesh(dir.join("a.ele")).unwrap_err().to_string();
    assert!(error.ends_with("a.poly:3:5: expected a vertex index between 0 and 2, found '3'"), "{error}");
}

#[test]
fn what_is_no_file_is_named() {
    let dir = scratch("nofile");
    fs::create_dir(dir.join("d.poly")).unwrap();
    symlink("loop.node", dir.join("loop.node")).unwrap();
    symlink("/dev/zero", dir.join("zero.node")).unwrap();
    for (name, expected) in [
        ("d.poly", "is a directory"),
        ("loop.node", "symbolic links"),
        ("zero.node", "zero.node:1:1: expected text, found a NUL byte"),
        ("none.node", "none.node: no such file"),
        ("none", "expected a name that ends in .poly, .node, .mesh, .meshsuite, .geojson, .dxf"),
        ("none.svg", "none.svg: no such file"),
    ] {
        let error = read_pslg(dir.join(name)).unwrap_err();
        assert!(!error.is_output() && error.to_string().contains(expected), "{error}");
    }
    assert!(matches!(read_mesh(dir.join("d.poly")), Err(IoError::UnknownInput { .. })));
    assert!(read_pslg(dir.join("x".repeat(4096) + ".node")).is_err());
    assert!(read_pslg(dir.join("nul\0.node")).is_err());
}

#[test]
fn a_pipe_can_be_read() {
    let dir = scratch("pipe");
    let pipe = dir.join("pipe.poly");
    if !std::process::Command::new("mkfifo").arg(&pipe).status().is_ok_and(|s| s.success()) {
        return;
    }
    let writer = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::write(pipe, POLY)
    });
    assert_eq!(read_pslg(&pipe).unwrap().regions.len(), 2);
    writer.join().unwrap().unwrap();
}

#[test]
fn a_mesh_is_three_files_and_no_more() {
    let dir = scratch("three");
    write_mesh(dir.join("m.1.ele"), &grid(2), &options()).unwrap();
    assert_eq!(names_in(&dir), ["m.1.ele", "m.1.node", "m.1.poly"]);
    let mut files = files_of_mesh(&dir.join("m.1.ele"), &options());
    files.sort();
    assert_eq!(files, ["m.1.ele", "m.1.node", "m.1.poly"].map(|name| dir.join(name)));
    assert_eq!(files_of_mesh(Path::new("m.svg"), &options()), [PathBuf::from("m.svg")]);
    assert!(matches!(write_mesh(dir.join("m.area"), &grid(2), &options()), Err(IoError::UnknownOutput { .. })));
    for format in Format::ALL.into_iter().filter(|&format| format != Format::Area) {
        let path = dir.join("one").with_extension(format.extension());
        write_mesh(&path, &grid(2), &options()).unwrap();
        assert!(path.is_file());
    }
}

#[test]
fn targets_that_cannot_be_written() {
    let dir = scratch("unwritable");
    fs::create_dir(dir.join("d.node")).unwrap();
    assert!(refused(&dir.join("d.node"), &dir).contains("is a directory"));
    assert!(refused(&dir.join("none/m.node"), &dir).contains("No such file"));
    assert!(refused(&dir.join("d.node/"), &dir).contains("is a directory"));
    assert!(refused(&dir.join("m.txt"), &dir).contains("expected a name that ends in"));
    assert!(refused(&dir.join("m"), &dir).contains("expected a name that ends in"));
    // Not even root creates files here.
    assert!(refused(Path::new("/proc/m.node"), &dir).contains("/proc/m.node"));
    symlink("loop.node", dir.join("loop.node")).unwrap();
    assert!(refused(&dir.join("loop.node"), &dir).contains("link"));
}

#[test]
fn old_files_survive_a_failure() {
    let dir = scratch("survive");
    for name in ["m.node", "m.ele"] {
        fs::write(dir.join(name), "old").unwrap();
    }
    fs::create_dir(dir.join("m.poly")).unwrap();
    refused(&dir.join("m.ele"), &dir);
    fs::remove_dir(dir.join("m.poly")).unwrap();

    fs::write(dir.join("m.poly"), "old").unwrap();
    fs::set_permissions(dir.join("m.poly"), fs::Permissions::from_mode(0o444)).unwrap();
    assert!(refused(&dir.join("m.ele"), &dir).contains("read-only"));

    fs::remove_file(dir.join("m.poly")).unwrap();
    symlink("/dev/full", dir.join("m.poly")).unwrap();
    assert!(refused(&dir.join("m.ele"), &dir).contains("No space left"));
    for name in ["m.node", "m.ele"] {
        assert_eq!(fs::read_to_string(dir.join(name)).unwrap(), "old");
    }
}

#[test]
fn a_full_device_is_an_error() {
    let error = write_mesh("/dev/full", &grid(2), &options().with_format(Format::Svg)).unwrap_err();
    assert!(error.is_output() && error.to_string().contains("No space left"), "{error}");
    write_mesh("/dev/null", &grid(2), &options().with_format(Format::Ele)).unwrap();
}

#[test]
fn links_stay_and_permissions_are_kept() {
    let dir = scratch("links");
    fs::create_dir(dir.join("real")).unwrap();
    fs::write(dir.join("real/m.poly"), "old").unwrap();
    fs::set_permissions(dir.join("real/m.poly"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("real/m.poly", dir.join("link.poly")).unwrap();
    symlink("real/new.poly", dir.join("dangling.poly")).unwrap();
    let pslg = crate::common::read_poly(POLY.as_bytes(), "p").unwrap();
    for name in ["link.poly", "dangling.poly"] {
        write_pslg(dir.join(name), &pslg, &options()).unwrap();
        assert!(fs::symlink_metadata(dir.join(name)).unwrap().is_symlink());
        assert_eq!(read_pslg(dir.join(name)).unwrap(), pslg);
    }
    assert_eq!(fs::metadata(dir.join("real/m.poly")).unwrap().permissions().mode() & 0o777, 0o640);
    assert_eq!(names_in(&dir.join("real")), ["m.poly", "new.poly"]);
}

#[test]
fn many_writers_leave_one_whole_file() {
    let dir = scratch("writers");
    let path = dir.join("m.poly");
    let pslg = crate::common::read_poly(POLY.as_bytes(), "p").unwrap();
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| write_pslg(&path, &pslg, &options()).unwrap());
        }
    });
    assert_eq!(read_pslg(&path).unwrap(), pslg);
    assert_eq!(names_in(&dir), ["m.poly"]);
}
