//! `refine`: meshes taken up again.

use std::fs;

use crate::common::{ELE, NODE, SQUARE, Scratch};

/// A directory with the square, and its mesh as `m`.
fn with_mesh(name: &str, bounds: &str) -> Scratch {
    let scratch = Scratch::with_square(name);
    scratch.run(&format!("mesh square -o m.ele {bounds}")).expect(0);
    scratch
}

#[test]
fn a_mesh_that_meets_the_bounds_comes_back() {
    let scratch = with_mesh("refine-back", "--max-area 0.01");
    let run = scratch.run("refine m --input square --max-area 0.01 -o n.ele").expect(0);
    assert_eq!(run.stderr, "");
    assert!(run.stdout.contains("(0 added)"), "{run:#?}");
    for ending in ["node", "ele", "poly"] {
        assert_eq!(scratch.read(&format!("n.{ending}")), scratch.read(&format!("m.{ending}")), "{ending}");
    }
    let without = scratch.run("refine m.ele --max-area 0.01").expect(0);
    assert!(without.stdout.contains("(0 added)"), "{without:#?}");
    assert!(without.stderr.starts_with("warning: m.ele: "), "{without:#?}");
    assert!(without.stderr.contains(" were joined into 5 chains"), "{without:#?}");
}

#[test]
fn a_tighter_bound_only_adds_and_the_check_is_clean() {
    let scratch = with_mesh("refine-adds", "--max-area 0.1");
    let run = scratch.run("refine m --input square --max-area 0.005 --json -o n.ele").expect(0);
    let object = run.json();
    let old: Vec<String> = scratch.read("m.node").lines().skip(1).map(str::to_owned).collect();
    let new: Vec<String> = scratch.read("n.node").lines().skip(1).map(str::to_owned).collect();
    assert!(new.len() > old.len() && new[..old.len()] == old);
    assert_eq!(object["vertices"].as_u64(), Some(new.len() as u64));
    assert_eq!(object["steiner_points"].as_u64(), Some(new.len() as u64 - 4));
    let keys = |line: &str| scratch.run(line).expect(0).json().keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys("refine m --json"), keys("mesh square --json"));
    scratch.run("check n --input square").expect(0);
}

#[test]
fn area_bounds_beside_the_mesh_are_read() {
    let scratch = Scratch::new("refine-area");
    scratch.write("m.node", NODE);
    scratch.write("m.ele", ELE);
    scratch.write("m.area", "2\n1 0.01\n2 -1\n");
    let run = scratch.run("refine m --json").expect(0);
    assert!(run.json()["triangles"].as_u64() > Some(50), "{run:#?}");
    let run = scratch.run("refine m -o m.area").expect(2);
    assert!(run.stderr.contains("would overwrite the input"), "{run:#?}");
    scratch.write("m.area", "1\n1 0.01\n");
    scratch
        .run("refine m")
        .expect(3)
        .says("error: m.area:1:1: expected area bounds for the 2 triangles of the mesh, found 1");
    fs::remove_file(scratch.path().join("m.area")).unwrap();
    assert_eq!(scratch.run("refine m --json").expect(0).json()["triangles"].as_u64(), Some(2));
}

#[test]
fn attributes_are_handed_down() {
    let scratch = Scratch::new("refine-attributes");
    scratch.write("m.node", NODE);
    scratch.write("m.ele", "2 3 1\n1 1 2 3 5\n2 1 3 4 -7\n");
    scratch
        .run("refine m --max-area 0.02 -o n.ele")
        .expect(0)
        .says("warning: m.ele: 1 edges part triangles with different attributes and are kept, though they are not listed as segments");
    let text = scratch.read("n.ele");
    let last: Vec<&str> = text.lines().skip(1).filter_map(|line| line.split_whitespace().last()).collect();
    assert!(last.len() > 40 && last.iter().all(|a| ["5", "-7"].contains(a)), "{last:?}");
}

#[test]
fn what_is_no_mesh_is_named_in_file_numbers() {
    let scratch = Scratch::with_square("refine-faults");
    scratch.write("m.node", NODE);
    scratch.write("m.ele", "2 3 0\n1 1 2 3\n2 1 4 3\n");
    let run = scratch.run("refine m.ele -o n.ele").expect(3);
    run.says("error: m.ele: triangle 2 with vertices 1 at (0, 0), 4 at (0, 1) and 3 at (1, 1) is clockwise");
    scratch.write("m.ele", ELE);
    scratch.write("other.poly", SQUARE.replace("\n3 1 1\n", "\n3 2 1\n"));
    let run = scratch.run("refine m.ele --input other -o n.ele").expect(3);
    run.says("error: m.ele: vertex 3 of other.poly lies at (2, 1), but at (1, 1) in the mesh");
    scratch.write("crossed.poly", SQUARE.replace("\n5 1 3\n", "\n5 2 4\n"));
    let run = scratch.run("refine m.ele --input crossed -o n.ele").expect(3);
    assert!(run.stderr.starts_with("error: m.ele: input segment 5 from vertex 2 at (1, 0)"), "{run:#?}");
    scratch
        .run("refine square.poly")
        .expect(3)
        .says("hint: a .poly file is a drawing; 'trimalla mesh' makes a mesh of it");
    scratch.run("refine nowhere.ele").expect(3);
    assert!(!scratch.files().contains_key("n.ele"));
}

#[test]
fn flips_are_counted_and_bisection_makes_none() {
    let scratch = Scratch::new("refine-flips");
    scratch.write("m.node", "4 2 0 0\n1 0 0\n2 4 -1\n3 8 0\n4 4 1\n");
    scratch.write("m.ele", ELE);
    scratch
        .run("refine m --min-angle 0 -o n.ele")
        .expect(0)
        .says("warning: m.ele: the mesh was not constrained Delaunay: it took 1 flips to make it so");
    let run = scratch.run("refine m --min-angle 0 --algorithm lepp-bisection -o k.ele").expect(0);
    assert_eq!(run.stderr, "");
    assert_eq!(scratch.read("k.ele").lines().nth(1), Some("1 1 2 3"));
}

#[test]
fn inputs_are_never_overwritten_and_limits_end_with_one() {
    let scratch = with_mesh("refine-inputs", "");
    let before = scratch.files();
    for out in ["m.ele", "m.node", "m.poly", "square.poly", "./m.ele"] {
        let run = scratch.run(&format!("refine m --input square -o {out}")).expect(2);
        assert!(run.stderr.contains("would overwrite the input"), "{out}: {run:#?}");
    }
    scratch.run("refine m --min-angle 61").expect(2);
    scratch.run("refine m --max-area -1").expect(2);
    scratch.run("refine m -o nowhere/n.ele").expect(4);
    assert_eq!(scratch.files(), before);
    scratch.run("refine m --max-area 1e-4 --max-vertices 100 -o n.ele").expect(1);
    assert!(scratch.files().contains_key("n.ele"));
}
