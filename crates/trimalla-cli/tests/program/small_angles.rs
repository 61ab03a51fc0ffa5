//! Small angles and what nearly touches, as the program tells of them.

use crate::common::Scratch;

/// A box of side 1000 with two segments a millionth of a thousandth apart over a short stretch.
const NEARLY_TOUCHING: &str = "\
8 2 0 0\n0 0 0\n1 1000 0\n2 1000 1000\n3 0 1000\n4 300 500\n5 500 500\n6 499.9 500.0004\n7 700 500.0004\n\
6 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 6 7\n0\n";

/// A box with two vertices an ulp apart.
const AN_ULP_APART: &str = "\
6 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 2 2\n5 2 2.0000000000000004\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n";

#[test]
fn edges_that_nearly_coincide_are_told_before_the_work() {
    let scratch = Scratch::new("nearly-touching");
    scratch.write("near.poly", NEARLY_TOUCHING);
    let run = scratch.run("mesh near.poly").expect(0);
    for text in [
        "warning: near.poly: most of about ",
        "triangles are needed for the gap of 0.0004 between ",
        "if the two are meant to touch, let them share a vertex",
    ] {
        assert!(run.stderr.contains(text), "{text}: {run:#?}");
    }
    scratch.write("apart.poly", NEARLY_TOUCHING.replace("500.0004", "510"));
    assert_eq!(scratch.run("mesh apart.poly --json").expect(0).stderr, "");
}

#[test]
fn vertices_within_rounding_are_named_with_their_distance() {
    let scratch = Scratch::new("within-rounding");
    scratch.write("two.poly", AN_ULP_APART);
    let run = scratch.run("mesh two.poly").expect(0);
    let named = "warning: two.poly: the gap of 4.4409e-16 between vertex 4 and vertex 5 near (2, 2) is within rounding";
    assert!(run.stderr.contains(named), "{run:#?}");
    assert!(!run.stderr.contains("does not force it"), "{run:#?}");
    let run = scratch.run("mesh two.poly --json -q").expect(0).json();
    assert_eq!(run["reasons"]["input gap"].as_u64(), Some(2), "{run:?}");
}

/// Two segments that leave vertex 4 for ends an ulp apart.
const NEEDLE: &str = "\
7 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 1 1\n5 3 2\n6 3 2.0000000000000004\n\
6 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 4 6\n0\n";

#[test]
fn a_needle_within_rounding_is_an_input_angle_and_its_ends_are_named() {
    let scratch = Scratch::new("needle");
    scratch.write("needle.poly", NEEDLE);
    let run = scratch.run("mesh needle.poly --min-angle 30").expect(0);
    let named = "the gap of 4.4409e-16 between vertex 5 and vertex 6 near (3, 2) is within rounding";
    assert!(run.stderr.contains(named) && !run.stderr.contains("does not force it"), "{run:#?}");
    let run = scratch.run("mesh needle.poly --min-angle 30 --json -q").expect(0).json();
    let reasons = run["reasons"].as_object().expect("reasons");
    assert!(reasons.keys().all(|key| key.contains("input angle")), "{run:?}");
}

#[test]
fn parts_that_nearly_touch_and_ends_of_an_open_outline_are_named() {
    let scratch = Scratch::new("parts");
    let squares = "8 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 1.0000000001 0\n5 2 0\n6 2 1\n7 1.0000000001 1\n\
        8 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 5 6\n6 6 7\n7 7 4\n0\n";
    scratch.write("parts.poly", squares);
    for rule in ["seeds", "nesting"] {
        let run = scratch.run(&format!("mesh parts.poly --domain {rule}")).expect(0);
        assert!(run.stderr.contains("vertex 1 at (1, 0) is 1e-10 from vertex 4, across what is outside"), "{run:#?}");
    }
    scratch
        .write("open.poly", "5 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 0 2.4e-16\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 4\n0\n");
    let run = scratch.run("mesh open.poly").expect(3);
    assert!(run.stderr.contains("just one ends at vertex 0, (0, 0), the next at vertex 4, 2.4e-16 away"), "{run:#?}");
}

#[test]
fn a_joint_inside_a_segment_forces_its_small_angle() {
    let scratch = Scratch::new("joint");
    let drawing = "4 2 0 0\n0 0 0\n1 9 0\n2 9 1\n3 2 0\n4 0\n0 0 1\n1 1 2\n2 2 0\n3 3 2\n0\n";
    scratch.write("joint.poly", drawing);
    let run = scratch.run("mesh joint.poly --json").expect(0).json();
    assert!(run["vertices"].as_u64().unwrap() <= 110, "{run:?}");
    assert!(run["complete"].as_bool().unwrap(), "{run:?}");
    scratch.run("mesh joint.poly -o one.ele").expect(0);
    scratch.run("refine one.ele --input joint.poly -o two.ele").expect(0);
    for file in ["node", "ele", "poly"] {
        assert_eq!(scratch.read(&format!("one.{file}")), scratch.read(&format!("two.{file}")), "{file}");
    }
}
