//! `trimalla clean` and `mesh --snap`.

use serde_json::Value;

use crate::common::{SQUARE, Scratch};

/// An outline of four corners whose last is a hair away from its first, a segment that ends nowhere, and two that
/// cross.
const OPEN: &str = "9 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 0 1e-9\n6 1 1\n7 2 2\n8 2 1\n9 1 2\n\
    6 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 5 1\n5 6 7 2\n6 8 9 2\n0\n";

#[test]
fn faults_are_named_with_their_places() {
    let scratch = Scratch::new("clean");
    scratch.write("open.poly", OPEN);
    scratch.write("square.poly", SQUARE);
    assert_eq!(scratch.run("clean square").expect(0).stdout, "square.poly: no faults, tolerance 1e-6\n");
    let run = scratch.run("clean open.poly").expect(1);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines[0], "open.poly: crossing: segments 5, 6, at (1.5, 1.5)");
    assert_eq!(lines.iter().filter(|line| line.starts_with("open.poly: dangling: vertex ")).count(), 4);
    assert_eq!(lines[5], "open.poly: gap: vertices 1, 5, at (0, 5e-10), gap 1e-9");
    assert_eq!(lines[6], "open.poly: 6 faults (crossing 1, dangling 4, gap 1), tolerance 4e-6");

    let object = scratch.run("clean open --json --picture faults.svg").expect(1).json();
    let faults = object["faults"].as_array().unwrap();
    assert_eq!((faults.len(), &object["counts"]["gap"], &object["changes"]), (6, &Value::from(1), &Value::Null));
    assert_eq!((&faults[5]["kind"], &faults[5]["size"]), (&Value::from("gap"), &Value::from(1e-9)));
    let picture = scratch.read("faults.svg");
    assert!(picture.matches("<svg ").count() == 2 + 6 && picture.contains("gap 1.000e-9"), "{picture}");
    assert!(picture.ends_with("</svg>\n"), "whole");
}

#[test]
fn mended_drawings_are_written_and_mesh() {
    let scratch = Scratch::new("mend");
    scratch.write("open.poly", OPEN);
    let run = scratch.run("clean open.poly --tolerance 1e-6 --mend -o mended.poly").expect(1);
    assert!(run.stdout.contains("mended: vertex 5 at (0, 1e-9) became one with vertex 1, 1e-9 away"), "{run:#?}");
    assert!(run.stdout.contains("mended: segments 5 and 6 were split at their crossing (1.5, 1.5)"), "{run:#?}");
    let mended = scratch.read("mended.poly");
    assert!(mended.starts_with("9 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 1 1\n"), "{mended}");
    scratch.run("mesh mended.poly -q -o mended.1.ele").expect(0);
    scratch.run("check mended.1.ele --input mended.poly").expect(0);
    // The same in passing, and the advice where it is not asked for.
    let failed = scratch.run("mesh open.poly --crossings split").expect(3);
    assert!(failed.stderr.contains("hint: vertices 1 and 5 at (0, 5e-10) are 1e-9 apart: --snap 2e-9"), "{failed:#?}");
    let snapped = scratch.run("mesh open.poly --snap 2e-9 -o snapped.msh").expect(0);
    assert!(snapped.stderr.contains("warning: open.poly: snapped: vertex 5 at"), "{snapped:#?}");
    assert!(snapped.stdout.contains("--snap 0.000000002"), "{snapped:#?}");
    scratch.run("check snapped.msh").expect(0);
}

#[test]
fn wrong_use_of_clean() {
    let scratch = Scratch::with_square("clean-wrong");
    for line in
        ["clean square -o a.poly", "clean square --mend", "clean square --tolerance -1", "clean square --tiny-angle 61"]
    {
        scratch.run(line).expect(2);
    }
    scratch.write("nan.poly", "0 2\n0\n0\n");
    scratch.run("clean nan.poly").expect(3);
    assert!(scratch.run("clean square --tolerance 1 --mend --picture p.svg -o p.svg").status == Some(2));
}
