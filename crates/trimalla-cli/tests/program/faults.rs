//! Bad input: status 3, one clear message, nothing written.

use crate::common::{ELE, NODE, SQUARE, Scratch};

/// Meshes a drawing that is no drawing.
#[track_caller]
fn refused(content: impl AsRef<[u8]>, message: &str) {
    let scratch = Scratch::new(&format!("bad-{:x}", fingerprint(message)));
    scratch.write("bad.poly", content);
    let before = scratch.files();
    let run = scratch.run("mesh bad.poly -o out.ele -o out.svg --json").expect(3);
    assert_eq!(run.stdout, "");
    assert!(run.stderr.starts_with("error: "), "{run:#?}");
    assert!(run.stderr.contains(message), "{message}: {run:#?}");
    assert_eq!(scratch.files(), before);
}

/// A name for a directory: no two tests share one.
fn fingerprint(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3))
}

fn damaged(from: &str, to: &str) -> String {
    assert!(SQUARE.contains(from), "{from}");
    SQUARE.replacen(from, to, 1)
}

#[test]
fn text_faults_name_file_line_and_column() {
    refused("", "error: bad.poly:1:1: expected ");
    refused("# only a comment\n", "found the end of the file");
    refused(&SQUARE[..20], "found the end of the file");
    refused(b"\x7fELF\0\0\0\x01\x02", "expected text, found a NUL byte");
    refused(damaged("4 2", "18000000000000000000 2"), "bad.poly:1:1: ");
    refused(damaged("4 2", "4000000000 2"), "bad.poly:");
    refused(damaged("4 2", "-4 2"), "found '-4'");
    refused(damaged("2 1 0", "2 nan 0"), "bad.poly:3:3: ");
    refused(damaged("2 1 0", "2 1 inf"), "bad.poly:3:5: ");
    refused(damaged("2 1 0", "2 1 1e999"), "found '1e999'");
    refused(damaged("5 1 3", "5 1 9"), "expected a vertex index between 1 and 4, found '9'");
    refused(damaged("5 1 3", "5 0 3"), "expected a vertex index between 1 and 4, found '0'");
    refused(damaged("1 1 2\n", "0 1 2\n"), "bad.poly:8:1: expected segment number 1, found '2'");
    refused(damaged("5 0\n", "-5 0\n"), "found '-5'");
    refused(format!("{SQUARE}0\n7 7 7\n"), "found '7'");
}

#[test]
fn truncation_anywhere_is_no_panic() {
    let scratch = Scratch::new("truncated");
    for length in 0..SQUARE.len() - 2 {
        scratch.write("bad.poly", &SQUARE[..length]);
        let run = scratch.run("mesh bad.poly -o out.ele");
        assert_eq!(run.status, Some(3), "{length}: {run:#?}");
    }
    assert_eq!(scratch.files().len(), 1);
}

#[test]
fn line_ends_and_marks_of_other_systems_are_fine() {
    let scratch = Scratch::new("line-ends");
    scratch.write("crlf.poly", SQUARE.replace('\n', "\r\n"));
    scratch.write("cr.poly", SQUARE.replace('\n', "\r"));
    scratch.write("bom.poly", format!("\u{feff}{SQUARE}"));
    for name in ["crlf", "cr", "bom"] {
        scratch.run(&format!("triangulate {name}")).expect(0);
    }
}

#[test]
fn missing_files_are_named() {
    let scratch = Scratch::new("missing");
    scratch.run("mesh nowhere.poly").expect(3).says("error: nowhere.poly: no such file");
    scratch.run("stats nowhere.ele").expect(3).says("error: nowhere.ele: no such file");
    scratch.write("lone.poly", "0 2 0 0\n0\n0\n");
    scratch.run("mesh lone.poly").expect(3).says("error: lone.node: no such file, needed by lone.poly");
    scratch.run("mesh .").expect(3);
    scratch.write("key.dxf", "");
    scratch.run("mesh key.dxf").expect(3).says("error: key.dxf:1:1: expected a section of DXF, found none");
    scratch.write("key.step", "");
    scratch.run("mesh key.step").expect(3).says(
        "error: cannot read key.step: expected a name that ends in .poly, .node, .mesh, .meshsuite, .geojson, .dxf, .svg, .wkt, .shp, .csv, .xyz or .las",
    );
    scratch
        .run("stats lone.poly")
        .expect(3)
        .says("hint: a .poly file is a drawing; 'trimalla mesh' makes a mesh of it");
}

#[test]
fn every_crossing_is_named_in_the_numbers_and_lines_of_the_file() {
    let scratch = Scratch::new("crossing");
    // Ten horizontal lines and ten vertical ones: a hundred crossings.
    let mut text = String::from("40 2 0 0\n# from nought\n");
    for i in 0..10 {
        text += &format!("{} -1 {i}\n{} 10 {i}\n", 2 * i, 2 * i + 1);
    }
    for i in 10..20 {
        text += &format!("{} {} -1\n{} {} 10\n", 2 * i, i - 10, 2 * i + 1, i - 10);
    }
    text += "20 0\n";
    for i in 0..20 {
        text += &format!("{i} {} {}\n", 2 * i, 2 * i + 1);
    }
    scratch.write("grid.poly", text + "0\n");
    let run = scratch.run("mesh grid.poly --domain hull -o out.ele").expect(3);
    assert_eq!(run.stderr.matches("error: ").count(), 100, "{run:#?}");
    let run = run.says("error: grid.poly: segments 3 and 15 cross near (5, 3) (lines 47 and 59)");
    run.says("hint: --crossings split puts a vertex at each crossing");
    assert_eq!(scratch.files().len(), 1);
    let run = scratch.run("triangulate grid.poly --domain hull --crossings split --json").expect(0);
    assert_eq!(run.json()["steiner_points"], 100);
    run.says("warning: grid.poly: segments cross; they were split at 100 new vertices");
}

#[test]
fn empty_domains_say_what_would_help() {
    let scratch = Scratch::new("open");
    scratch.write("open.poly", SQUARE.replace("5 0\n", "4 0\n").replace("3 3 4\n4 4 1\n5 1 3", "3 3 4\n4 1 3"));
    scratch.write("gap.poly", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n3 0\n0 0 1\n1 1 2\n2 2 3\n0\n");
    let run = scratch.run("mesh gap.poly").expect(3);
    run.says("hint: close the outline, or keep the convex hull with --domain hull");
    scratch.run("triangulate gap.poly --domain hull").expect(0);
    scratch.run("triangulate gap.poly --domain nesting").expect(3);
    scratch.write("line.node", "3 2 0 0\n1 0 0\n2 1 1\n3 2 2\n");
    scratch.run("mesh line").expect(3).says("error: line.node: all 3 vertices lie on one line");
}

#[test]
fn seeds_are_named_by_their_own_numbers_and_lines() {
    let scratch = Scratch::new("seeds");
    let with_holes = |holes: &str| format!("{}{holes}", SQUARE.trim_end_matches("0\n"));
    scratch.write("on.poly", with_holes("1\n0 .5 .5\n"));
    scratch
        .run("mesh on.poly")
        .expect(3)
        .says("error: on.poly:13: hole seed 0 at (0.5, 0.5) lies on a segment, so that its side is not known");
    scratch.write("idle.poly", with_holes("1\n1 7 7\n"));
    scratch
        .run("triangulate idle.poly")
        .expect(0)
        .says("warning: idle.poly:13: hole seed 1 at (7, 7) has no effect: it lies outside, or in another hole");
    let run = scratch.run("triangulate idle.poly --quiet").expect(0);
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", ""));
}

#[test]
fn duplicates_and_segments_without_length_are_warned_of_in_file_numbers() {
    let scratch = Scratch::new("warned");
    scratch.write("twice.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 1 0\n4 0\n1 1 2\n2 2 3\n3 3 1\n4 4 2\n0\n");
    let run = scratch.run("triangulate twice.poly").expect(0);
    let run = run.says("warning: twice.poly: 1 vertex lies exactly on another and stays unused; the first is 4, on 2");
    run.says("warning: twice.poly:10: 1 segment has no length and was left out; the first is 4");
}

#[test]
fn bad_meshes_are_refused() {
    let scratch = Scratch::new("bad-mesh");
    scratch.write("m.node", NODE);
    scratch.write("m.ele", ELE.replace("1 3 4", "1 3 5"));
    let run = scratch.run("check m.ele").expect(3);
    assert!(run.stderr.starts_with("error: m.ele:3:7: "), "{run:#?}");
    scratch.run("stats m").expect(3);
    scratch.run("convert m.ele m.svg").expect(3);
    assert_eq!(scratch.files().len(), 2);
}
