//! `--pick`: triangles by their numbers, and no others.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::common::{Run, Scratch};

/// A directory with the drawing of a key, and its triangulation as `m`.
fn with_key(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    let key = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes/key.poly");
    scratch.write("key.poly", fs::read_to_string(key).unwrap());
    scratch.run("triangulate key -o m.ele").expect(0);
    scratch
}

/// The vertices of a triangle, by its number in a file, counted from 0 and ascending.
fn vertices_of(scratch: &Scratch, file: &str, number: usize) -> Vec<u64> {
    let ele = scratch.read(file);
    let first: u64 = ele.lines().nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap();
    let line = ele.lines().nth(1 + number - first as usize).unwrap();
    let mut vertices: Vec<u64> =
        line.split_whitespace().skip(1).take(3).map(|v| v.parse::<u64>().unwrap() - first).collect();
    vertices.sort_unstable();
    vertices
}

/// The triangles that were selected.
fn selected(scratch: &Scratch) -> Vec<Vec<u64>> {
    let trace = scratch.read("t.jsonl");
    let lines = trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    let numbers = |list: &Value| list.as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect();
    lines.filter(|line| line["selected"].is_array()).map(|line| numbers(&line["selected"])).collect()
}

#[test]
fn what_is_picked_is_treated_and_nothing_else() {
    let scratch = with_key("pick");
    let number = |offset: usize| {
        let first = scratch.read("m.ele").lines().nth(1).unwrap().split_whitespace().next().unwrap().to_owned();
        first.parse::<usize>().unwrap() + offset
    };
    let (a, b) = (number(40), number(7));
    for command in ["mesh key", "refine m --input key"] {
        let line = format!(
            "{command} --algorithm lepp-centroid --until-destroyed false --pick {a},{b} --trace t.jsonl --save-recipe r.toml"
        );
        let run = scratch.run(&line).expect(1);
        assert!(run.stdout.contains("(not picked "), "{run:#?}");
        assert_eq!(run.stderr, "", "what was not picked is no news");
        assert_eq!(
            selected(&scratch),
            [vertices_of(&scratch, "m.ele", a), vertices_of(&scratch, "m.ele", b)],
            "{command}"
        );
        assert!(scratch.read("r.toml").contains("select = \"manual\""));
    }
    // A recipe holds the order, not the picks: those belong to one mesh.
    let run: Run = scratch.run("mesh key --recipe r.toml").expect(1);
    assert!(run.stdout.contains("(0 added)") && run.stderr.contains("no triangle is picked"), "{run:#?}");
}

#[test]
fn wrong_picks_are_named() {
    let scratch = with_key("pick-wrong");
    let before = scratch.files();
    scratch
        .run("mesh key --pick 5,9999 -o a.ele")
        .expect(2)
        .says("error: there is no triangle 9999 to pick: there are 213 triangles to start from, numbered from 0 on");
    scratch
        .run("refine m --input key --pick 213 -o a.ele")
        .expect(2)
        .says("error: there is no triangle 213 to pick: there are 213 triangles to start from, numbered from 0 on");
    scratch
        .run("mesh key --pick 5 --select first -o a.ele")
        .expect(2)
        .says("error: --pick goes with --select manual, not with --select first");
    scratch.run("mesh key --pick five").expect(2);
    scratch.run("mesh key --pick -1").expect(2);
    assert_eq!(scratch.files(), before);
}

#[test]
fn a_triangle_that_is_flipped_away_first_cannot_be_picked() {
    let scratch = Scratch::new("pick-flipped");
    scratch.write("m.node", "4 2 0 0\n1 0 0\n2 4 -1\n3 8 0\n4 4 1\n");
    scratch.write("m.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
    let run = scratch.run("refine m --pick 1 -o n.ele").expect(2);
    assert!(run.stderr.starts_with("error: triangle 1 is no more when refinement begins"), "{run:#?}");
    assert!(run.stderr.contains("--initial given") && !scratch.files().contains_key("n.ele"), "{run:#?}");
    scratch.run("refine m --pick 1 --initial given --algorithm lepp-bisection -o n.ele --trace t.jsonl");
    assert_eq!(selected(&scratch)[0], [0, 1, 2]);
}
