//! `check` and `stats`.

use crate::common::{ELE, NODE, SQUARE, Scratch};

fn mesh(name: &str, ele: &str) -> Scratch {
    let scratch = Scratch::new(name);
    scratch.write("m.node", NODE);
    scratch.write("m.ele", ele);
    scratch
}

#[test]
fn a_sound_mesh_has_no_faults() {
    let scratch = mesh("sound", ELE);
    scratch.write("square.poly", SQUARE);
    for line in ["check m.ele", "check m", "check m.node", "check m --input square --min-angle 45"] {
        let run = scratch.run(line).expect(0);
        assert_eq!(run.stdout, "m.ele: 4 vertices, 2 triangles: no faults\n", "{line}");
    }
}

#[test]
fn what_triangulate_writes_passes_the_check() {
    let scratch = Scratch::with_square("proof");
    scratch.run("triangulate square.poly -o out.ele").expect(0);
    scratch.run("check out --input square.poly").expect(0);
    scratch.run("mesh square.poly -o refined.ele --max-area 0.01").expect(0);
    scratch.run("check refined --input square.poly --min-angle 30").expect(0);
}

#[test]
fn faults_come_one_a_line_in_file_numbers() {
    let scratch = mesh("clockwise", "2 3 0\n1 1 2 3\n2 1 4 3\n");
    let run = scratch.run("check m.ele").expect(1);
    let first = run.stdout.lines().next().unwrap();
    assert_eq!(first, "m.ele: triangle 2 with vertices 1 at (0, 0), 4 at (0, 1) and 3 at (1, 1) is clockwise");
    assert!(run.stdout.lines().all(|line| line.starts_with("m.ele: ")), "{run:#?}");
}

#[test]
fn the_bound_is_exact() {
    let scratch = mesh("bound", ELE);
    scratch.run("check m --min-angle 45").expect(0);
    let run = scratch.run("check m --min-angle 45.0001").expect(1);
    assert!(run.stdout.starts_with("m.ele: triangle 1 at "), "{run:#?}");
    assert!(run.stdout.ends_with("2 faults\n"), "{run:#?}");
}

#[test]
fn another_drawing_is_noticed() {
    let scratch = mesh("other", ELE);
    scratch.write("other.poly", SQUARE.replace("3 1 1", "3 1 2"));
    let run = scratch.run("check m --input other").expect(1);
    assert!(run.stdout.contains("m.ele: input vertex 3 at (1, 2) has become (1, 1)\n"), "{run:#?}");
    scratch.write("diagonal.poly", SQUARE.replace("5 1 3", "5 2 4"));
    let run = scratch.run("check m --input diagonal").expect(1);
    assert!(run.stdout.contains("m.ele: input segment 5 from vertex 2 "), "{run:#?}");
}

#[test]
fn fifty_faults_are_named_and_the_rest_counted() {
    let mut ele = String::from("60 3 0\n");
    (1..=60).for_each(|i| ele += &format!("{i} 1 3 2\n"));
    let run = mesh("many", &ele).run("check m").expect(1);
    assert_eq!(run.stdout.lines().count(), 52, "{run:#?}");
    assert!(run.stdout.lines().nth(50).unwrap().ends_with(" more"), "{run:#?}");
}

#[test]
fn statistics_for_people_and_programs() {
    let scratch = mesh("stats", ELE);
    let text = scratch.run("stats m").expect(0).stdout;
    assert!(text.contains("smallest angle") && text.contains("########"), "{text}");
    let object = scratch.run("stats m.ele --json").expect(0).json();
    assert_eq!((&object["triangles"], &object["edges"]), (&2.into(), &5.into()));
    assert_eq!(object["area"], 1.0);
}
