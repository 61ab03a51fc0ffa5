//! Traps in text files, one row each: what is accepted, and for what is not, the whole message.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use crate::common::{ELE, NODE, POLY, read_poly, sample_nodes};
use trimalla_io::{IoError, edge, ele, neigh, node, poly};

fn message<T: std::fmt::Debug>(result: Result<T, IoError>) -> String {
    let error = result.unwrap_err();
    assert!(!error.is_output() && error.fault().is_some(), "{error}");
    error.to_string()
}

/// Bytes that are no `.node` file, and what is said about them.
const FAULTY_NODES: &[(&[u8], &str)] = &[
    (b"", "n:1:1: expected the number of vertices, found the end of the file"),
    (b"\xef\xbb\xbf", "n:1:1: expected the number of vertices, found the end of the file"),
    (b"# only\n\n", "n:3:1: expected the number of vertices, found the end of the file"),
    (b"\0\0\0\0", "n:1:1: expected text, found a NUL byte"),
    (b"\xff\xfe1\0", "n:1:1: expected text, found UTF-16"),
    (b"\xff\n", r"n:1:1: expected the number of vertices, found '\xff'"),
    (b"-1 2\n", "n:1:1: expected the number of vertices, found '-1'"),
    (b"3.0 2\n", "n:1:1: expected the number of vertices, found '3.0'"),
    (b"1000000000000000000\n1 0 0\n", "n:1:1: expected the number of vertices, found '1000000000000000000'"),
    (b"4294967295\n1 0 0\n", "n:3:1: expected vertex 2 of 4294967295, found the end of the file"),
    (b"1 3 0 0\n1 0 0 0\n", "n:1:3: expected the dimension 2, found '3'"),
    (b"1 2 -1\n", "n:1:5: expected the number of attributes a vertex, found '-1'"),
    (b"1 2 0 2\n", "n:1:7: expected 0 or 1 markers a vertex, found '2'"),
    (b"1 2 0 0 0\n", "n:1:9: expected the end of the line, found '0'"),
    (b"1 2 1000000000\n1 0 0 1\n", "n:2:8: expected an attribute, found the end of the line"),
    (b"2\n1 0 0\n", "n:3:1: expected vertex 2 of 2, found the end of the file"),
    (b"1\n1 0\n", "n:2:4: expected a y coordinate, found the end of the line"),
    (b"1\n1 0 0 x\n", "n:2:7: expected the end of the line, found 'x'"),
    (b"1\n1,0,0,0\n", "n:2:7: expected the end of the line, found '0'"),
    (b"1\n1,,0,0\n", "n:2:3: expected an x coordinate, found ','"),
    (b"1\n,1 0 0\n", "n:2:1: expected 0 or 1 as the number of the first vertex, found ','"),
    (b"1\n5 0 0\n", "n:2:1: expected 0 or 1 as the number of the first vertex, found '5'"),
    (b"1\n-1 0 0\n", "n:2:1: expected 0 or 1 as the number of the first vertex, found '-1'"),
    (b"2\n0 0 0\n2 0 0\n", "n:3:1: expected vertex number 1, found '2'"),
    (b"2\r\n1 0 0\r\n1 0 0\r\n", "n:3:1: expected vertex number 2, found '1'"),
    (b"2\r1 0 0\r1.0 0 0", "n:3:1: expected vertex number 2, found '1.0'"),
    (b"1\n1 0 0\n1 0 0\n", "n:3:1: expected the end of the file, found '1'"),
    (b"1\n1 0 0 # end\nx", "n:3:1: expected the end of the file, found 'x'"),
    (b"1 2 0 1\n1 0 0\n", "n:2:6: expected a marker between -2147483648 and 2147483647, found the end of the line"),
    (b"1 2 0 1\n1 0 0 2147483648", "n:2:7: expected a marker between -2147483648 and 2147483647, found '2147483648'"),
];

#[test]
fn faulty_node_files() {
    for (bytes, expected) in FAULTY_NODES {
        assert_eq!(message(node::read(bytes, "n")), *expected, "{:?}", String::from_utf8_lossy(bytes));
    }
}

#[test]
fn offending_text_is_shortened() {
    let text = format!("1\n1 0 {}x\n", "9".repeat(800));
    let expected = format!("n:2:5: expected a y coordinate, found '{}'… (801 bytes)", "9".repeat(40));
    assert_eq!(message(node::read(text.as_bytes(), "n")), expected);
}

#[test]
fn faulty_numbers() {
    for text in ["1e400", "-1e400", "nan", "NaN", "inf", "-Infinity", "1e99999999999"] {
        let expected =
            format!("n:2:3: expected an x coordinate, finite and within the range of a double, found '{text}'");
        assert_eq!(message(node::read(format!("1\n1 {text} 0\n").as_bytes(), "n")), expected);
    }
    for text in ["0x1p3", "1.0D+03", "--1", "1_000", "e5", ".", "+", "٣"] {
        let expected = format!("n:2:3: expected an x coordinate, found '{text}'");
        assert_eq!(message(node::read(format!("1\n1 {text} 0\n").as_bytes(), "n")), expected);
    }
}

#[test]
fn unusual_numbers_that_are_numbers() {
    let long = format!("0.{}1", "0".repeat(800));
    for (text, value) in [
        ("+.5", 0.5),
        ("5.", 5.0),
        ("1e-400", 0.0),
        ("-1e-400", -0.0),
        ("1E3", 1000.0),
        (&long, 0.0),
        ("9007199254740993", 9_007_199_254_740_992.0),
        ("2.2250738585072012e-308", f64::MIN_POSITIVE),
        ("007", 7.0),
    ] {
        let nodes = node::read(format!("1\n1 {text} 0\n").as_bytes(), "n").unwrap();
        assert_eq!(nodes.points[0].x.to_bits(), f64::to_bits(value), "{text}");
    }
}

/// Three vertices.
const TRIANGLE: &str = "3\n1 0 0\n2 1 0\n3 0 1\n";

/// What does not go on after [`TRIANGLE`], and what is said about it.
const FAULTY_SECTIONS: &[(&str, &str)] = &[
    ("", "p:5:1: expected the number of segments, found the end of the file"),
    ("1 2\n", "p:5:3: expected 0 or 1 markers a segment, found '2'"),
    ("2\n1 1 2\n", "p:7:1: expected segment 2 of 2, found the end of the file"),
    ("1\n1 1 4\n", "p:6:5: expected a vertex index between 1 and 3, found '4'"),
    ("1\n1 0 1\n", "p:6:3: expected a vertex index between 1 and 3, found '0'"),
    ("1\n1 -1 1\n", "p:6:3: expected a vertex index between 1 and 3, found '-1'"),
    ("1\n1 1 4294967297\n", "p:6:5: expected a vertex index between 1 and 3, found '4294967297'"),
    ("1\n1 1 3.0\n", "p:6:5: expected a vertex index between 1 and 3, found '3.0'"),
    ("1\n0 1 2\n0\n", "p:6:1: expected segment number 1, as vertices are numbered from 1 on, found '0'"),
    ("1\n5 1 2\n0\n", "p:6:1: expected 0 or 1 as the number of the first segment, found '5'"),
    ("2\n0 1 3\n2 1 2\n0\n", "p:7:1: expected segment number 1, found '2'"),
    ("1 0 0\n1 1 2\n0\n", "p:5:5: expected the end of the line, found '0'"),
    ("1\n1 1 2 a\n0\n", "p:6:7: expected the end of the line, found 'a'"),
    ("1\n1 1 2\n", "p:7:1: expected the number of holes (0 where there are none), found the end of the file"),
    ("0\n-1\n", "p:6:1: expected the number of holes, found '-1'"),
    ("0\n1\n1 nan 0\n", "p:7:3: expected an x coordinate, finite and within the range of a double, found 'nan'"),
    ("0\n2\n1 0 0\n1 0 0\n", "p:8:1: expected hole number 2, found '1'"),
    ("0\n0\n1\n1 0 0\n", "p:8:6: expected the attribute of the region, found the end of the line"),
    ("0\n0\n1\n1 0 0 1 big\n", "p:8:9: expected the largest area, found 'big'"),
    ("0\n0\n1\n1 0,5 2 3\n", "p:8:3: expected a point in a decimal number, as commas separate columns, found '0,5'"),
    ("0\n0\n0\n0\n", "p:8:1: expected the end of the file, found '0'"),
];

#[test]
fn faulty_poly_files() {
    for (rest, expected) in FAULTY_SECTIONS {
        assert_eq!(message(read_poly(format!("{TRIANGLE}{rest}").as_bytes(), "p")), *expected, "{rest:?}");
    }
    assert_eq!(
        message(read_poly(format!("{POLY}{POLY}").as_bytes(), "p")),
        "p:17:1: expected the end of the file, found '4'"
    );
    assert_eq!(
        message(read_poly(b"0\n1\n1 1 1\n0\n", "p")),
        "p:3:3: expected no vertex index, as there are no vertices, found '1'"
    );
}

#[test]
fn poly_files_that_are_unusual_but_right() {
    let pslg =
        read_poly(b"1\r\n0 0 0\r\n1 1 #\t\r\n0 0 0 -2147483648\r\n1\r\n1\t.5 .5\r\n2\r\n1 0 0 3 0\r\n2 0 0 3 -1", "p")
            .unwrap();
    assert_eq!((pslg.segments, pslg.segment_markers), (vec![[0, 0]], vec![i32::MIN]));
    assert_eq!(pslg.holes.len(), 1, "holes may be numbered otherwise than vertices");
    assert_eq!(pslg.regions.iter().map(|r| r.max_area).collect::<Vec<_>>(), [None, None]);
}

#[test]
fn faulty_ele_files() {
    let range = sample_nodes().range();
    for (text, expected) in [
        ("1 4\n", "e:1:3: expected 3 or 6 nodes a triangle, found '4'"),
        ("1 3 0\n1 0 1 2\n", "e:2:3: expected a vertex index between 1 and 4, found '0'"),
        ("1 3 0\n0 1 2 3\n", "e:2:1: expected triangle number 1, as vertices are numbered from 1 on, found '0'"),
        ("1 3 0\n1 1 2\n", "e:2:6: expected a vertex index, found the end of the line"),
        ("1 6 0\n1 1 2 3 4 4 5\n", "e:2:13: expected a vertex index between 1 and 4, found '5'"),
        ("1 3 0\n1 1 2 3 one\n", "e:2:9: expected the end of the line, found 'one'"),
        ("1 3 1\n1 1 2 3\n", "e:2:8: expected an attribute, found the end of the line"),
        ("9 3 0\n1 1 2 3\n", "e:3:1: expected triangle 2 of 9, found the end of the file"),
        ("0 3 0\nmore\n", "e:2:1: expected the end of the file, found 'more'"),
    ] {
        assert_eq!(message(ele::read(text.as_bytes(), "e", range)), expected);
    }
    let six = ele::read(b"1 6 0\n1 1 2 3 4 4 4\n", "e", range).unwrap();
    assert_eq!(six.triangles, [[0, 1, 2]]);
    // Orientation and repeated corners are for a check to judge.
    assert_eq!(ele::read(b"1\n1 3 2 2\n", "e", range).unwrap().triangles, [[2, 1, 1]]);
}

#[test]
fn faulty_edge_and_neigh_files() {
    let range = sample_nodes().range();
    let edge = |text: &str| message(edge::read(text.as_bytes(), "e", range));
    assert_eq!(edge("1\n1 1 -1\n"), "e:2:5: expected a vertex index between 1 and 4, found '-1'");
    assert_eq!(
        edge("1 1\n1 1 2\n").split(": ").nth(1),
        Some("expected a marker between -2147483648 and 2147483647, found the end of the line")
    );
    let neigh = |text: &str| message(neigh::read(text.as_bytes(), "g"));
    assert_eq!(neigh("1 3\n1 -1 -1 2\n"), "g:2:9: expected the number of a triangle, or -1, found '2'");
    assert_eq!(neigh("1 3\n1 0 -1 -1\n"), "g:2:3: expected the number of a triangle, or -1, found '0'");
    assert_eq!(neigh("1 3\n1 -2 -1 -1\n"), "g:2:3: expected the number of a triangle, or -1, found '-2'");
    assert_eq!(neigh("1 2\n"), "g:1:3: expected 3 neighbours a triangle, found '2'");
}

#[test]
fn layout_does_not_matter() {
    let plain = node::read(NODE.as_bytes(), "n").unwrap();
    for (what, text) in [
        ("CR LF", NODE.replace('\n', "\r\n")),
        ("lone CR", NODE.replace('\n', "\r")),
        ("no final newline", NODE.trim_end().to_owned()),
        ("tabs", NODE.replace(' ', "\t\t")),
        ("form feeds", NODE.replace(' ', " \x0c\x0b")),
        ("byte order mark", format!("\u{feff}{NODE}")),
        ("blank lines", NODE.replace('\n', "\n\n   \n")),
        ("comments", NODE.replace('\n', "#5 6\n# 7\n")),
        ("commas", NODE.replace(' ', ", ").replace("#, four", "# four").replace("-3, #, corner", "-3 # corner")),
        ("a comma at the end", NODE.replace("\n2 1 0", ",\n2 ,1 0")),
    ] {
        assert_eq!(node::read(text.as_bytes(), "n").unwrap(), plain, "{what}");
    }
    let latin = [b"# Gr\xf6\xdfe\n", NODE.as_bytes()].concat();
    assert_eq!(node::read(&latin, "n").unwrap(), plain, "Latin-1 in a comment");
}

/// A vertex section, and what decimal commas in it are answered with.
#[test]
fn decimal_commas_are_refused() {
    for (text, place) in [
        ("1\n1 1,5 0\n", "n:2:3: expected a point in a decimal number, as commas separate columns, found '1,5'"),
        ("1\n1 -0,5 0,25\n", "n:2:3: expected a point in a decimal number, as commas separate columns, found '-0,5'"),
        ("1\n1;0,5;0,25\n", "n:2:1: expected 0 or 1 as the number of the first vertex, found '1;0'"),
        ("1\n1,0,5,0,25\n", "n:2:7: expected the end of the line, found '0'"),
        (
            "1 2 1\n1 1,5 2,5 7\n",
            "n:2:3: expected a point in a decimal number, as commas separate columns, found '1,5'",
        ),
    ] {
        assert_eq!(message(node::read(text.as_bytes(), "n")), place, "{text:?}");
    }
}

/// Files that Triangle reads, and what is noted of what is ignored in them.
#[test]
fn what_is_ignored_without_ambiguity_is_noted() {
    let notes = |rest: &str| {
        let text = format!("{TRIANGLE}{rest}");
        let poly = poly::read(text.as_bytes(), "p", || unreachable!("it has vertices")).unwrap();
        poly.sections.notes.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(notes("1\n1 1 2\n0\n"), [""; 0]);
    let numbered =
        "p:6:1: segment rows are numbered from 0 on, vertices from 1 on; the numbers of the rows were ignored";
    assert_eq!(notes("2\n0 1 2\n1 2 3\n0\n"), [numbered], "vertex 3 does not exist counted from 0");
    let extra = "p:6:7: 2 segment rows have more columns than their header declares; they were ignored";
    assert_eq!(notes("2\n1 1 2 7\n2 2 3 8 9\n0\n"), [extra]);
    let hole = "p:7:7: 1 hole row has more columns than its header declares; they were ignored";
    assert_eq!(notes("0\n1\n1 0 0 5\n"), [hole]);
    let nodes = node::read(b"2\n0 0 0 0\n1 1 0 0\n", "n").unwrap();
    let vertices = "n:2:7: 2 vertex rows have more columns than their header declares; they were ignored";
    assert_eq!((nodes.points.len(), nodes.notes[0].to_string().as_str()), (2, vertices));
    let triangles = ele::read(b"1 3 0\n0 1 2 4 8\n", "e", sample_nodes().range()).unwrap();
    assert_eq!((triangles.triangles, triangles.notes.len()), (vec![[0, 1, 3]], 2));
}

/// Segments numbered from 1 beside vertices from 0: right where vertex 0 is named, for counted from 1 there is none.
#[test]
fn the_other_base_is_taken_where_only_one_reading_is_possible() {
    let vertices = "3\n0 0 0\n1 1 0\n2 0 1\n";
    let read = |rest: &str| read_poly(format!("{vertices}{rest}").as_bytes(), "p");
    assert_eq!(read("2\n1 0 1\n2 1 2\n0\n").unwrap().segments, [[0, 1], [1, 2]]);
    assert_eq!(
        message(read("1\n1 1 2\n0\n")),
        "p:6:1: expected segment number 0, as vertices are numbered from 0 on, found '1'"
    );
}

#[test]
fn long_lines_and_many_blank_lines_are_quick() {
    let mut long = vec![b'#'; 20 << 20];
    long.extend_from_slice(b"\n");
    long.extend_from_slice(ELE.as_bytes());
    assert!(ele::read(&long, "e", sample_nodes().range()).is_ok());
    let token = vec![b'1'; 10 << 20];
    assert!(message(node::read(&token, "n")).len() < 200);
    let mut blank = vec![b'\n'; 10_000_000];
    blank.push(b'x');
    assert_eq!(message(node::read(&blank, "n")), "n:10000001:1: expected the number of vertices, found 'x'");
}

#[test]
fn names_cannot_reach_the_terminal_as_commands() {
    assert_eq!(
        message(node::read(b"\x1b[2J", "a\nb")),
        r"a\nb:1:1: expected the number of vertices, found '\u{1b}[2J'"
    );
}
