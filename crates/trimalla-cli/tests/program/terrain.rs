//! `interpolate`, `contour` and `voronoi`: what they write and what they refuse.

use crate::common::{ELE, NODE, Scratch};

/// The files of the notes' example.
fn notes(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/terrain");
    for file in ["notes.node", "bad.node", "bad.ele", "place.node"] {
        scratch.write(file, std::fs::read(folder.join(file)).unwrap());
    }
    scratch
}

/// A pyramid of height 8.
const PYRAMID: &str = "5 2 2 0\n1 0 0 7 0\n2 4 0 7 0\n3 4 4 7 0\n4 0 4 7 0\n5 2 2 7 8\n";

#[test]
fn the_bad_triangulation_says_53_metres_and_the_good_one_106() {
    let scratch = notes("notes");
    let height = |source: &str| {
        let table = scratch.run(&format!("interpolate {source} place.node -o - --quiet")).expect(0).stdout;
        let row = table.strip_prefix("x,y,height\n0,6,").unwrap_or_else(|| panic!("{table}"));
        row.trim().parse::<f64>().unwrap().round()
    };
    assert_eq!((height("bad.ele"), height("notes.node")), (53.0, 106.0));
}

#[test]
fn a_place_outside_has_no_height() {
    let scratch = notes("outside");
    scratch.write("places.node", "3 2 0 0\n1 0 0\n2 500 500\n3 6 10.5\n");
    for method in ["linear", "natural-neighbour", "laplace"] {
        let line = format!("interpolate notes.node places.node --method {method} -o heights.csv --json");
        let report: serde_json::Value = serde_json::from_str(&scratch.run(&line).expect(0).stdout).unwrap();
        assert_eq!((&report["places"], &report["outside"]), (&3.into(), &1.into()));
        assert_eq!(scratch.read("heights.csv"), "x,y,height\n0,0,100\n500,500,\n6,10.5,110\n");
    }
}

#[test]
fn natural_neighbours_keep_to_the_domain_of_a_mesh() {
    let scratch = Scratch::new("natural");
    // A square without its right triangle.
    scratch.write("ell.node", "5 2 1 0\n1 0 0 1\n2 4 0 2\n3 4 4 3\n4 0 4 4\n5 2 2 5\n");
    scratch.write("ell.ele", "3 3 0\n1 1 2 5\n2 3 4 5\n3 4 1 5\n");
    scratch.write("places.node", "2 2 0 0\n1 3 2\n2 1 2\n");
    let table = scratch.run("interpolate ell.ele places.node -o - --method natural-neighbour -q").expect(0).stdout;
    let rows: Vec<&str> = table.lines().collect();
    assert!(rows[1] == "3,2," && rows[2].starts_with("1,2,") && rows[2].len() > 4, "{table}");
}

#[test]
fn contours_are_written_as_pictures_drawings_and_tables() {
    let scratch = Scratch::new("contours");
    scratch.write("pyramid.node", PYRAMID);
    let line = "contour pyramid.node --attribute 2 --levels 2,4 -o lines.poly -o lines.csv -o lines.svg -o lines.png";
    let report = scratch.run(line).expect(0).stdout;
    assert!(report.contains("2 (2 closed), 8 points"), "{report}");
    let poly = scratch.read("lines.poly");
    // Four corners of the boundary, and a square at each of two levels, with heights and markers.
    assert!(poly.lines().any(|l| l.split_whitespace().eq(["12", "2", "1", "0"])), "{poly}");
    let csv = scratch.read("lines.csv");
    assert!(csv.starts_with("level,line,x,y\n2,1,") && csv.lines().count() == 11, "{csv}");
    assert!(scratch.read("lines.svg").starts_with("<svg"));
    let step = scratch.run("contour pyramid.node --attribute 2 --step 4 --json").expect(0).stdout;
    let report: serde_json::Value = serde_json::from_str(&step).unwrap();
    assert_eq!((&report["lines"], &report["highest"]), (&1.into(), &8.0.into()));
    let unasked = scratch.run("contour pyramid.node --attribute 2").expect(0).stdout;
    assert!(unasked.contains("15 with lines"), "{unasked}");
}

#[test]
fn what_contours_write_can_be_triangulated() {
    let scratch = Scratch::new("contours-again");
    scratch.write("pyramid.node", PYRAMID);
    scratch.run("contour pyramid.node --attribute 2 --step 1 -o lines.poly").expect(0);
    scratch.run("contour lines.poly --step 2 -o again.poly").expect(0);
    scratch.run("triangulate again.poly").expect(0);
}

#[test]
fn cells_are_written_as_pictures_drawings_and_tables() {
    let scratch = Scratch::new("cells");
    scratch.write("pyramid.node", PYRAMID);
    for (clip, area) in [("box", 4.8 * 4.8), ("hull", 16.0), ("domain", 16.0)] {
        let line = format!("voronoi pyramid.node --clip {clip} -o cells.poly -o cells.csv -o cells.svg --json");
        let report: serde_json::Value = serde_json::from_str(&scratch.run(&line).expect(0).stdout).unwrap();
        assert_eq!((&report["cells"], &report["bounded_cells"]), (&5.into(), &1.into()));
        assert!((report["area"].as_f64().unwrap() - area).abs() < 1e-12, "{report}");
        let csv = scratch.read("cells.csv");
        assert_eq!(csv.lines().filter(|l| l.starts_with("5,1,0,")).count(), 4, "{csv}");
        // The points are dots, the corners of cells are not.
        assert_eq!(scratch.read("cells.svg").matches("h0").count(), 5);
        scratch.run("triangulate cells.poly").expect(0);
    }
}

#[test]
fn a_domain_with_a_hole_clips_cells() {
    let scratch = Scratch::new("cells-domain");
    let rings = "8 2 0 0\n1 0 0\n2 9 0\n3 9 9\n4 0 9\n5 3 3\n6 6 3\n7 6 6\n8 3 6\n\
        8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 4.5 4.5\n";
    scratch.write("ring.poly", rings);
    let report = scratch.run("voronoi ring.poly --clip domain --json -o ring.1.svg").expect(0).stdout;
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    assert_eq!((&report["area"], &report["clipped_cells"]), (&72.0.into(), &8.into()));
}

#[test]
fn wrong_heights_and_levels_are_refused_before_anything_is_written() {
    let scratch = Scratch::with_square("terrain-faults");
    scratch.write("pyramid.node", PYRAMID);
    scratch.write("flat.node", NODE);
    scratch.write("flat.ele", ELE);
    let before = scratch.files();
    for (line, status, word) in [
        ("interpolate square.poly pyramid.node -o out.csv", 3, "no attribute 1"),
        ("interpolate pyramid.node missing.node -o out.csv", 3, "missing.node"),
        ("interpolate pyramid.node pyramid.node --attribute 3 -o out.csv", 3, "no attribute 3"),
        ("interpolate pyramid.node pyramid.node -o pyramid.node", 2, "overwrite"),
        ("contour flat.ele -o out.svg", 3, "no attribute 1"),
        ("contour pyramid.node --step 0 -o out.svg", 2, "not positive"),
        ("contour pyramid.node --attribute 2 --step 1e-300 -o out.svg", 2, "levels"),
        ("contour pyramid.node --levels NaN -o out.svg", 2, "not finite"),
        ("contour pyramid.node --step 1 --levels 2", 2, "cannot be used with"),
        ("contour pyramid.node --step 1 -o out.ele", 4, "out.ele"),
        ("voronoi pyramid.node -o out.csv -o out.csv", 2, "overwrite"),
        ("voronoi missing.node -o out.svg", 3, "missing.node"),
        ("voronoi pyramid.node --clip moon", 2, "moon"),
    ] {
        let run = scratch.run(line).expect(status);
        assert!(run.stderr.contains(word), "{line}: {}", run.stderr);
        assert_eq!(scratch.files(), before, "{line}");
    }
}
