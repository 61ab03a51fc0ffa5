//! What is said before the work: angles out of reach, meshes too large for the budget, and the floor afterwards.

use crate::common::Scratch;

/// A box of side 1000, numbered from 1, with a segment this far above its bottom.
fn gap_box(gap: &str) -> String {
    let vertices = format!("6 2 0 0\n1 0 0\n2 1000 0\n3 1000 1000\n4 0 1000\n5 250 {gap}\n6 750 {gap}\n");
    format!("{vertices}5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n0\n")
}

const WEDGE: &str = "3 2 0 0\n1 0 0\n2 10 0\n3 9.9 1.2\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";

#[test]
fn a_small_gap_is_foreseen_named_and_stopped_at_the_budget() {
    let scratch = Scratch::new("gap");
    for (gap, midway, triangles) in
        [("0.01", "0.005", "150,000"), ("0.001", "0.0005", "1,500,000"), ("1e-6", "5e-7", "1.5e9")]
    {
        scratch.write("gap.poly", gap_box(gap));
        let run = scratch.run("mesh gap.poly --max-vertices 10000 -o out.ele").expect(1);
        let run = run.says(&format!(
            "warning: gap.poly: about {triangles} triangles are needed, more than the budget of 10,000 vertices allows: \
             the gap of {gap} between vertex 6 and segment 1 (line 9) near (750, {midway}) is the cause; \
             the mesh will stop at the budget"
        ));
        assert!(run.stderr.starts_with("warning: gap.poly: about"), "before the work: {run:#?}");
        assert!(run.stdout.contains("(budget "), "{run:#?}");
        assert!(scratch.read("out.node").starts_with("10000 "), "the budget is used");
        scratch.run("check out --input gap.poly").expect(0);
    }
}

#[test]
fn a_budget_that_will_do_is_not_mentioned() {
    let scratch = Scratch::new("gap-fits");
    scratch.write("gap.poly", gap_box("1"));
    let run = scratch.run("mesh gap.poly --json").expect(0);
    assert_eq!(run.stderr, "");
    let object = run.json();
    let (foreseen, found) = (object["forecast_triangles"].as_f64().unwrap(), object["triangles"].as_f64().unwrap());
    assert!((1.0 / 3.0..3.0).contains(&(foreseen / found)), "{foreseen} for {found}");
    assert_eq!(object["angle_ceiling"], 45.0);
    assert_eq!(object["warnings"].as_array().unwrap().len(), 0);
}

#[test]
fn an_area_bound_may_be_the_cause() {
    let scratch = Scratch::with_square("area-cause");
    let run = scratch.run("mesh square.poly --max-area 1e-6 --max-vertices 100 --json").expect(1);
    let warnings = run.json()["warnings"].clone();
    assert_eq!(warnings.as_array().unwrap().len(), 1);
    assert!(warnings[0].as_str().unwrap().contains("the area bound is the cause"), "{warnings}");
    let quiet = scratch.run("mesh square.poly --max-area 1e-6 --max-vertices 100 --quiet").expect(1);
    assert_eq!((quiet.stdout.as_str(), quiet.stderr.as_str()), ("", ""));
}

#[test]
fn an_angle_out_of_reach_is_said_with_its_corner() {
    let scratch = Scratch::new("ceiling");
    scratch.write("box.poly", gap_box("500"));
    let run = scratch.run("mesh box.poly --min-angle 46 --max-vertices 500").expect(1);
    run.says("warning: box.poly: no mesh has all angles at 46 degrees or above: the corner of 90 degrees at vertex 1, (0, 0), allows 45, which is the bound now");
    let run = scratch.run("mesh box.poly --min-angle 45 --max-vertices 500");
    assert!(!run.stderr.contains("no mesh has"), "{run:#?}");
    scratch.write("wedge.poly", WEDGE);
    let run = scratch.run("mesh wedge.poly --json").expect(0);
    let ceiling = run.json()["angle_ceiling"].as_f64().unwrap();
    assert!((ceiling - 6.9112).abs() < 1e-4, "the wedge itself: {ceiling}");
    assert!(run.stderr.contains("at vertex 1, (0, 0), allows 6.9112"), "{run:#?}");
}

#[test]
fn the_floor_is_said_where_its_argument_holds() {
    let scratch = Scratch::new("floor");
    scratch.write("wedge.poly", WEDGE);
    let floor = "no mesh angle need be below 3.43 degrees: the floor for the smallest input angle 6.91 at vertex 1";
    let says = |options: &str| scratch.run(&format!("mesh wedge.poly {options}")).expect(0).stdout.contains(floor);
    assert!(says("--algorithm circumcenter --min-angle 26"));
    assert!(!says("--algorithm circumcenter --min-angle 30"), "the argument ends at 26.45");
    assert!(!says("--algorithm off-center --min-angle 26"), "the argument is for circumcenters");
    assert!(!says("--algorithm circumcenter --min-angle 5"), "nothing is left below the bound");
}
