//! Drawings of other programs, with one command each.

use crate::common::Scratch;

const ZONES: &str = r#"{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"use": 20}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},
{"type": "Feature", "properties": {"use": 10}, "geometry": {"type": "Polygon", "coordinates": [[[4,0],[9,0],[9,4],[4,4],[4,0]]]}}]}"#;

const DISK: &str = "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nPLATE\n10\n0\n20\n0\n40\n5\n0\nCIRCLE\n8\nHOLE\n10\n1\n20\n0\n40\n1\n\
                    0\nTEXT\n8\nNOTES\n1\nhello\n0\nENDSEC\n0\nEOF\n";

#[test]
fn a_drawing_is_meshed_told_about_and_checked() {
    let scratch = Scratch::new("drawings");
    scratch.write("zones.geojson", ZONES);
    scratch.write("disk.dxf", DISK);
    let run = scratch.run("mesh zones.geojson --property use -o zones.1.ele").expect(0);
    for line in ["  read as GeoJSON: 2 rings", "  by property use: 1 '20' (region 20), 2 '10' (region 10)"] {
        assert!(run.stdout.lines().any(|l| l == line), "{line}: {run:#?}");
    }
    assert!(run.stdout.contains("--property use --algorithm"), "the command is repeated whole: {run:#?}");
    let elements = scratch.read("zones.1.ele");
    assert!(elements.lines().next().unwrap().ends_with(" 3 1"), "{elements}");
    scratch.run("check zones.1.ele --input zones.geojson --property use --min-angle 29.9").expect(0);

    let run = scratch.run("mesh disk.dxf --flatten 0.01 -o disk.1.ele").expect(0);
    assert!(run.stdout.contains("2 curves as straight lines, at most "), "{run:#?}");
    assert!(run.stderr.contains("disk.dxf: 1 TEXT entities skipped, in line 26"), "{run:#?}");
    scratch.run("check disk.1.ele --input disk.dxf --flatten 0.01").expect(0);
    // Other lines in place of the curves are another drawing.
    scratch.run("check disk.1.ele --input disk.dxf --flatten 0.1").expect(1);
    scratch.run("convert disk.dxf disk.poly --rings each").expect(0);
    let poly = scratch.read("disk.poly");
    assert!(poly.contains("\n0\n2\n"), "no hole and two regions: {poly}");
}

#[test]
fn formats_are_known_by_their_content_and_from_standard_input() {
    let scratch = Scratch::new("drawings-content");
    scratch.write("zones", ZONES);
    scratch.write("disk.old", DISK);
    scratch.run("triangulate zones -o zones.svg").expect(0);
    scratch.run("triangulate disk.old").expect(0);
    let run = scratch
        .run_with("triangulate - --json", "<svg xmlns='http://www.w3.org/2000/svg'><rect width='3' height='2'/></svg>");
    assert_eq!(run.expect(0).json()["triangles"], 2);
    let points =
        scratch.run_with("triangulate -", "POINT (0 0)\nPOINT (3 0)\nPOINT (0 4)\nLINESTRING (1 1, 1 1.5)").expect(0);
    assert!(points.stdout.contains("no outline: the convex hull is the domain"), "{points:#?}");
}

#[test]
fn crossings_name_the_features_that_they_come_from() {
    let scratch = Scratch::new("drawings-crossings");
    scratch.write("a.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOLYGON ((2 2, 6 2, 6 6, 2 6))\n");
    let run = scratch.run("mesh a.wkt -o a.1.ele").expect(3);
    assert!(run.stderr.contains("segments 2 and 5 cross near (4, 2) (from line 1 and line 2)"), "{run:#?}");
    assert!(run.stderr.contains("--crossings split"), "{run:#?}");
    let made = scratch.run("mesh a.wkt --crossings split -o a.1.ele").expect(0);
    assert!(made.stdout.contains("rings each"), "{made:#?}");
    let wrong = scratch.run("mesh a.wkt --flatten 0").expect(2);
    assert!(wrong.stderr.contains("expected a number above 0"), "{wrong:#?}");
    let unknown = scratch.run("mesh a.wkt --layer roads").expect(3);
    assert!(
        unknown.stderr.contains("expected a layer named 'roads', found 'geometry 1', 'geometry 2'"),
        "{unknown:#?}"
    );
}
