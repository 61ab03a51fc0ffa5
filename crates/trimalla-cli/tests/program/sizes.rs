//! Sizes of triangles on the command line, and bounds on angles that are out of reach.

use crate::common::Scratch;

/// A square with the marker 7 on its first side, and sizes of its points in the second attribute.
const MARKED: &str = "4 2 2 0\n0 0 0 5 0.1\n1 4 0 5 0\n2 4 4 5 0\n3 0 4 5 -1\n\
4 1\n0 0 1 7\n1 1 2 1\n2 2 3 1\n3 3 0 1\n0\n";

fn triangles(scratch: &Scratch, options: &str) -> u64 {
    scratch.run(&format!("mesh marked.poly --json {options}")).expect(0).json()["triangles"].as_u64().unwrap()
}

#[test]
fn a_number_of_triangles_is_asked_for() {
    let scratch = Scratch::new("count");
    scratch.write("marked.poly", MARKED);
    for asked in [100, 3000] {
        let found = triangles(&scratch, &format!("--triangles {asked}"));
        assert!(found.abs_diff(asked) * 10 <= asked, "{asked}: {found}");
    }
    let run = scratch.run("mesh marked.poly --triangles 500 -o m.ele").expect(0);
    assert!(run.stdout.contains("sizes        500 triangles") && run.stdout.contains("--triangles 500"), "{run:#?}");
    scratch.run("check m --input marked.poly --min-angle 30").expect(0);
    let run = scratch.run("mesh marked.poly --triangles 1").expect(0);
    assert!(
        run.stderr.contains("the mesh has 2 triangles, not 1: angles, features and other bounds need them"),
        "{run:#?}"
    );
}

#[test]
fn lengths_are_asked_for_everywhere_at_markers_and_at_points() {
    let scratch = Scratch::new("lengths");
    scratch.write("marked.poly", MARKED);
    let coarse = triangles(&scratch, "");
    let [everywhere, at_marker, at_point] =
        ["--size 0.2", "--size-near 7=0.1", "--point-sizes 2"].map(|options| triangles(&scratch, options));
    assert!(coarse < at_point && at_point < at_marker && at_marker < everywhere + 2000, "{at_point} {at_marker}");
    let slower = triangles(&scratch, "--size-near 7=0.1 --grow 1.1");
    assert!(slower > at_marker, "{slower} {at_marker}");
    let repeated = scratch.run("mesh marked.poly --size-near 7=0.1 --grow 1.1 --json").expect(0).json();
    let command = repeated["command"].as_str().unwrap().to_owned();
    assert!(command.contains("--grow 1.1") && command.contains("--size-near 7=0.1"), "{command}");
}

#[test]
fn sizes_that_cannot_be_meant_are_refused() {
    let scratch = Scratch::new("no-sizes");
    scratch.write("marked.poly", MARKED);
    for (options, text) in [
        ("--size 0", "the size must be positive and finite, not 0"),
        ("--size inf", "the size must be positive and finite, not inf"),
        ("--grow 0.5", "must be finite and at least 1, not 0.5"),
        ("--size-near 8=0.1", "no segment has the marker 8"),
        ("--size-near 7", "expected a marker and a positive length"),
        ("--size-near 7=-1", "expected a marker and a positive length"),
        ("--point-sizes 3", "there is no point attribute 3: the points have 2"),
    ] {
        let run = scratch.run(&format!("mesh marked.poly {options} -o m.ele")).expect(2);
        assert!(run.stderr.contains(text), "{options}: {run:#?}");
        assert!(!scratch.path().join("m.ele").exists());
    }
}

#[test]
fn above_33_degrees_the_best_of_several_runs_is_kept() {
    let scratch = Scratch::new("attempts");
    let plate = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/shapes/plate.poly");
    let run = scratch.run(&format!("mesh {plate} --min-angle 44 -o m.ele")).expect(1);
    for text in ["kept: lepp-centroid at 36 degrees", "--algorithm lepp-centroid --min-angle 36"] {
        assert!(run.stdout.contains(text), "{run:#?}");
    }
    assert!(run.stderr.contains("no run met 44 degrees; the mesh meets 36: ask for that"), "{run:#?}");
    scratch.run(&format!("check m --input {plate} --min-angle 36")).expect(0);
    let json = scratch.run(&format!("mesh {plate} --min-angle 44 --json")).expect(1).json();
    assert_eq!((json["bound_met"].as_f64(), json["algorithm"].as_str()), (Some(36.0), Some("lepp-centroid")));
    let alone =
        scratch.run(&format!("mesh {plate} --min-angle 36 --algorithm lepp-centroid -o a.ele --trace t")).expect(0);
    assert!(!alone.stdout.contains("attempts"), "{alone:#?}");
    assert_eq!(scratch.read("m.node"), scratch.read("a.node"));
    // The steps of the run that is kept are traced, and no others.
    scratch.run(&format!("mesh {plate} --min-angle 37 --trace u -q")).expect(1);
    assert_eq!(scratch.read("t"), scratch.read("u"));
}
