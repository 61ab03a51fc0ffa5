//! What is written, and what is left alone.

use std::fs;
use std::path::Path;
use std::process::Stdio;

use crate::common::{ELE, NODE, Run, SQUARE, Scratch};

#[test]
fn a_group_and_a_picture_at_once() {
    let scratch = Scratch::with_square("several");
    let run = scratch.run("mesh square.poly -o square.1.ele -o square.svg -o e.edge -o n.neigh").expect(0);
    assert!(run.stdout.contains("square.1.node, square.1.ele, square.1.poly, square.svg"), "{run:#?}");
    let files = scratch.files();
    let names: Vec<_> = files.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        ["e.edge", "n.neigh", "square.1.ele", "square.1.node", "square.1.poly", "square.poly", "square.svg"]
    );
    assert_eq!(scratch.read("square.poly"), SQUARE);
}

#[test]
fn numbering_follows_the_input() {
    let scratch = Scratch::new("numbering");
    scratch.write("nought.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
    scratch.write("one.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
    for (name, number) in [("nought", '0'), ("one", '1')] {
        scratch.run(&format!("triangulate {name} -o {name}.1.ele")).expect(0);
        let first = scratch.read(&format!("{name}.1.ele")).lines().nth(1).unwrap().to_owned();
        assert!(first.starts_with(number), "{first}");
    }
}

#[test]
fn standard_streams() {
    let scratch = Scratch::with_square("streams");
    let run = scratch.run_with("mesh - -o - --format poly", SQUARE).expect(0);
    assert!(run.stdout.contains("\n1 0 0") && run.stderr.starts_with("-: 4 vertices, 5 segments\n"), "{run:#?}");
    let again = scratch.run_with("triangulate - --json", &run.stdout).expect(0);
    assert_eq!(again.json()["vertices"].as_u64(), run.stdout.split(' ').next().unwrap().parse().ok());
    let svg = scratch.run("convert square.poly - --format svg").expect(0).stdout;
    assert!(svg.contains("<svg") && svg.ends_with("</svg>\n"), "{svg}");
}

#[test]
fn conversions() {
    let scratch = Scratch::with_square("convert");
    scratch.write("m.node", NODE);
    scratch.write("m.ele", ELE);
    for line in [
        "convert m.ele m.svg",
        "convert m m.neigh",
        "convert m.ele m.off",
        "mesh square.poly -q -o s.off",
        "convert m.ele n.ele",
        "convert square.poly p.poly",
        "convert square p.svg",
        "convert m.ele m.png",
        "convert square p.png",
        "mesh square.poly -q -o s.png",
        "triangulate square.poly -q -o t.png",
    ] {
        let run = scratch.run(line).expect(0);
        assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", ""), "{line}");
    }
    assert_eq!(scratch.read("n.ele").lines().nth(1), Some("1 1 2 3"));
    let files = scratch.files();
    for png in ["m.png", "p.png", "s.png", "t.png"] {
        assert!(files[png].starts_with(b"\x89PNG\r\n\x1a\n") && files[png].ends_with(b"IEND\xaeB`\x82"), "{png}");
    }
    for off in ["m.off", "s.off"] {
        assert!(scratch.read(off).starts_with("OFF\n"), "{off}");
    }
    for line in ["convert square.poly square.neigh", "convert square.poly square.off"] {
        let run = scratch.run(line).expect(4);
        run.says("hint: a drawing has no triangles; 'trimalla triangulate' makes them");
    }
}

#[test]
fn the_input_is_never_overwritten() {
    let scratch = Scratch::with_square("overwrite");
    scratch.write("two.poly", "0 2 0 0\n0\n0\n");
    scratch.write("two.node", NODE);
    fs::create_dir(scratch.path().join("sub")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("square.poly", scratch.path().join("link.poly")).unwrap();
    let before = scratch.files();
    let lines = [
        "mesh square.poly -o square.poly",
        "mesh square -o square.ele",
        "mesh ./square.poly -o sub/../square.ele",
        "triangulate two.poly -o two.node",
        "convert two.node two.node",
        #[cfg(unix)]
        "mesh link.poly -o square.poly",
        #[cfg(unix)]
        "mesh square.poly -o link.poly",
    ];
    for line in lines {
        let run = scratch.run(line).expect(2);
        assert!(run.stderr.contains("would overwrite the input"), "{line}: {run:#?}");
    }
    assert_eq!(scratch.files(), before);
}

#[test]
fn a_companion_that_was_not_read_is_no_input() {
    let scratch = Scratch::with_square("companion");
    scratch.run("mesh square.poly -o square.node").expect(0);
    scratch.run("mesh square.poly -o square.node").expect(0);
}

#[test]
fn unwritable_outputs_end_with_four_and_leave_everything() {
    let scratch = Scratch::with_square("unwritable");
    scratch.write("old.svg", "old picture");
    scratch.write("locked.svg", "locked");
    let locked = scratch.path().join("locked.svg");
    let mut permissions = fs::metadata(&locked).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&locked, permissions).unwrap();
    fs::create_dir(scratch.path().join("directory.svg")).unwrap();
    let before = scratch.files();
    for bad in ["nowhere/out.ele", "directory.svg", "locked.svg", "out.xyz", "out", "square.poly/out.svg"] {
        let run = scratch.run(&format!("mesh square.poly -o old.svg -o new.ele -o {bad}")).expect(4);
        assert!(run.stderr.starts_with("error: cannot write "), "{run:#?}");
        assert_eq!(scratch.files(), before, "{bad}");
    }
}

#[test]
fn a_full_disk_ends_with_four_and_leaves_everything() {
    if !Path::new("/dev/full").exists() {
        eprintln!("skipped: no /dev/full here");
        return;
    }
    let scratch = Scratch::with_square("full");
    scratch.write("old.svg", "old picture");
    let before = scratch.files();
    scratch.run("mesh square.poly -o old.svg -o /dev/full --format poly").expect(4);
    for line in [
        "mesh square.poly -o old.svg",
        "mesh square.poly -o new.ele --json",
        "list",
        "check m",
        "mesh square.poly -o - --format svg",
    ] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let run = scratch.command(line.split_whitespace()).stdout(full).output().unwrap();
        Run::of(run).expect(if line == "check m" { 3 } else { 4 });
    }
    assert_eq!(scratch.files(), before);
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let scratch = Scratch::with_square("pipe");
    let area = "1e-3"; // Enough output to fill a pipe.
    for line in [
        "list",
        "mesh square.poly",
        "triangulate square.poly --json",
        &format!("mesh square.poly --max-area {area} -o - -o kept.svg --format svg"),
    ] {
        let mut child =
            scratch.command(line.split_whitespace()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let run = Run::of(child.wait_with_output().unwrap()).expect(0);
        assert!(!run.stderr.contains("error"), "{run:#?}");
    }
    assert!(scratch.files().contains_key("kept.svg"));
}

#[test]
fn old_outputs_survive_every_failure() {
    let scratch = Scratch::with_square("survive");
    scratch.run("mesh square.poly -o out.ele -o out.svg -o out.png").expect(0);
    scratch.write("bad.poly", "4 2 0 0\n1 0 0\n");
    let before = scratch.files();
    scratch.run("mesh bad.poly -o out.ele -o out.svg -o out.png").expect(3);
    scratch.run("mesh square.poly -o out.ele -o out.svg -o out.png --min-angle 90").expect(2);
    scratch.run("mesh square.poly -o out.ele -o out.svg -o out.png -o nowhere/x.svg").expect(4);
    scratch.run("mesh square.poly --max-area 0.1 -o out.png -o nowhere/x.png").expect(4);
    scratch.run("mesh nowhere.poly -o out.ele").expect(3);
    assert_eq!(scratch.files(), before);
    // And with success they are replaced, without leftovers.
    scratch.run("mesh square.poly -o out.ele -o out.svg -o out.png").expect(0);
    assert_eq!(scratch.files(), before);
}
