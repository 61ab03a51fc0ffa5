//! `visible` and `guards`: what they find, write and refuse.

use crate::common::{Scratch, refused};

/// A comb with three teeth, numbered from 1.
const COMB: &str = "7 2 0 0\n1 0 0\n2 6 0\n3 5 4\n4 4 1\n5 3 4\n6 2 1\n7 1 4\n\
    7 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 7\n7 7 1\n0\n";

/// A square with a square hole, numbered from 1.
const RING: &str = "8 2 0 0\n1 0 0\n2 9 0\n3 9 9\n4 0 9\n5 3 3\n6 6 3\n7 6 6\n8 3 6\n\
    8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 4.5 4.5\n";

fn scratch(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    scratch.write("comb.poly", COMB);
    scratch.write("ring.poly", RING);
    scratch
}

#[test]
fn guards_see_every_triangle_of_the_mesh_that_is_written() {
    let scratch = scratch("guards");
    for (file, triangles, limit) in [("comb.poly", 5, 2), ("ring.poly", 8, 3)] {
        let report = scratch.run(&format!("guards {file} -o g.csv -o g.ele -o g.svg -o g.png --json")).expect(0).json();
        let table = scratch.read("g.csv");
        let guards: Vec<u32> =
            table.lines().skip(1).map(|row| row.split(',').next().unwrap().parse().unwrap()).collect();
        assert!(!guards.is_empty() && guards.len() <= limit, "{table}");
        assert_eq!((&report["guards"], &report["limit"]), (&guards.clone().into(), &limit.into()), "{file}");
        assert_eq!((&report["triangles"], &report["unwatched"]), (&triangles.into(), &serde_json::Value::Null));
        let ele = scratch.read("g.ele");
        let rows: Vec<Vec<u32>> = ele
            .lines()
            .skip(1)
            .filter(|line| !line.starts_with('#'))
            .map(|line| line.split_whitespace().skip(1).map(|word| word.parse().unwrap()).collect())
            .collect();
        assert_eq!(rows.len(), triangles);
        assert!(rows.iter().all(|corners| corners.iter().any(|v| guards.contains(v))), "{ele}");
        // Each guard is a mark: a dot with a ring.
        assert_eq!(scratch.read("g.svg").matches("h0\"/>").count(), 2 * guards.len());
        assert!(std::fs::read(scratch.path().join("g.png")).unwrap().starts_with(b"\x89PNG"));
    }
    let text = scratch.run("guards ring.poly").expect(0).stdout;
    assert!(
        text.contains("the theorem allows 3") && text.contains("1 bridge") && text.contains("everything"),
        "{text}"
    );
}

#[test]
fn the_picture_of_the_art_gallery_has_its_colours_and_guards() {
    let scratch = scratch("gallery-picture");
    scratch.run("triangulate comb.poly --algorithm art-gallery -o a.svg").expect(0);
    scratch.run("guards comb.poly -o g.svg").expect(0);
    let picture = scratch.read("a.svg");
    assert_eq!(picture, scratch.read("g.svg"));
    for colour in ["#f0b8bd", "#a6d3d9", "#f8dfb3"] {
        assert_eq!(picture.matches(colour).count(), 1, "{colour}: {picture}");
    }
    let steps = scratch.run("guards comb.poly --player run.html -q").expect(0);
    assert_eq!(steps.stdout, "");
    assert!(scratch.read("run.html").contains("a guard"), "the page tells where guards are");
}

#[test]
fn the_visibility_polygon_is_written_and_can_be_meshed() {
    let scratch = scratch("visible");
    let line = "visible ring.poly --from 1,4.5 -o v.poly -o v.csv -o v.svg -o v.png --json";
    let report = scratch.run(line).expect(0).json();
    // Hidden: the hole and its shadow, 1.5 (x - 1) high from x = 3 to 7, and everything from x = 7 to 9.
    let hidden = (7.0 - 3.0) * f64::midpoint(3.0, 9.0) + 2.0 * 9.0;
    assert!((report["area"].as_f64().unwrap() - (81.0 - hidden)).abs() < 1e-9, "{report:?}");
    assert_eq!(report["domain_area"], 72.0);
    let table = scratch.read("v.csv");
    assert!(table.starts_with("x,y,kind,vertex,side_from,side_to\n"), "{table}");
    assert_eq!(table.lines().count() - 1, report["corners"].as_u64().unwrap() as usize);
    assert!(table.contains(",vertex,5,,\n") && !table.contains(",vertex,6,,\n"), "{table}");
    let again = scratch.run("visible v.poly --from 1,4.5 --json").expect(0).json();
    let [area, whole] = ["area", "domain_area"].map(|key| again[key].as_f64().unwrap());
    assert!((area - whole).abs() < 1e-12, "a visibility polygon is seen whole: {again:?}");
    scratch.run("mesh v.poly -o v.1.ele").expect(0);
}

#[test]
fn points_are_visible_or_not() {
    let scratch = scratch("visible-to");
    let line = "visible ring.poly --from 0,0 --to 9,0 --to 3,3 --to 6,6 --to 4.5,4.5 --to -1,0 --to 3,6 --json";
    let report = scratch.run(line).expect(0).json();
    let to: Vec<bool> =
        report["to"].as_array().unwrap().iter().map(|sight| sight["visible"].as_bool().unwrap()).collect();
    assert_eq!(to, [true, true, false, false, false, true]);
    let text = scratch.run("visible ring.poly --from -0,4.5 --to 9,4.5").expect(0).stdout;
    assert!(text.contains("(9, 4.5): not visible"), "{text}");
}

#[test]
fn what_cannot_be_answered_is_refused() {
    let scratch = scratch("gallery-faults");
    scratch.write("points.node", "3 2 0 0\n1 0 0\n2 4 0\n3 0 4\n");
    refused(&scratch, 3, "outside of the domain of ring.poly", &["visible ring.poly --from 4.5,4.5 -o out.svg"]);
    refused(&scratch, 3, "no segments", &["guards points.node -o out.svg"]);
    refused(&scratch, 2, "two finite numbers", &["visible ring.poly --from 1", "visible ring.poly --from 1,nan"]);
    refused(&scratch, 2, "--from", &["visible ring.poly"]);
    refused(&scratch, 2, "overwrite", &["guards ring.poly -o ring.poly", "visible ring.poly --from 1,1 -o ring.poly"]);
    refused(&scratch, 2, "one another", &["guards ring.poly -o out.csv -o out.csv"]);
}
