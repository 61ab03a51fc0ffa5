//! The traps that every text format has, by their ids in the catalogue of nasty inputs: E01 to E09, F01, F02 and F10.
//!
//! E03 is in `damage.rs`, E10 in `paths.rs`, E11 in the tests of the program, where the memory of a process can be
//! bounded.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use crate::common::{AREA, EDGE, ELE, MESHSUITE, NEIGH, NODE, POLY, SOUP, read_poly, sample_nodes};
use trimalla::geometry::Point;
use trimalla_io::{IoError, area, edge, ele, meshsuite, neigh, node, poly, soup};

/// A format, a sample of it, and whether its reader takes some bytes.
type Format = (&'static str, &'static str, fn(&[u8]) -> Result<(), IoError>);

const FORMATS: [Format; 8] = [
    ("node", NODE, |bytes| node::read(bytes, "f").map(drop)),
    ("ele", ELE, |bytes| ele::read(bytes, "f", sample_nodes().range()).map(drop)),
    ("poly", POLY, |bytes| read_poly(bytes, "f").map(drop)),
    ("edge", EDGE, |bytes| edge::read(bytes, "f", sample_nodes().range()).map(drop)),
    ("neigh", NEIGH, |bytes| neigh::read(bytes, "f").map(drop)),
    ("area", AREA, |bytes| area::read(bytes, "f").map(drop)),
    ("mesh", MESHSUITE, |bytes| meshsuite::read(bytes, "f").map(drop)),
    ("soup", SOUP, |bytes| soup::read(bytes, "f").map(drop)),
];

/// The message of a fault, which has a place in the file.
fn refusal(result: Result<(), IoError>) -> Option<String> {
    let error = result.err()?;
    assert!(error.fault().is_some() && !error.is_output(), "{error}");
    Some(error.to_string())
}

#[test]
fn e01_what_is_no_text_and_what_is_empty() {
    for (format, sample, read) in FORMATS {
        let headless = format == "soup"; // An empty soup is a soup.
        for nothing in ["", "\u{feff}", "# only a comment", "\n\r\n \t\n"] {
            assert_eq!(refusal(read(nothing.as_bytes())).is_none(), headless, "{format} {nothing:?}");
        }
        for byte in (0..=255_u8).filter(|b| !b.is_ascii_digit() && !b" \t\n\r\x0b\x0c#".contains(b)) {
            assert!(refusal(read(&[byte])).is_some(), "{format} {byte}");
        }
        let utf16: Vec<u8> = [0xff, 0xfe].into_iter().chain(sample.encode_utf16().flat_map(u16::to_le_bytes)).collect();
        assert_eq!(refusal(read(&utf16)).unwrap(), "f:1:1: expected text, found UTF-16", "{format}");
        let latin = [b"# Stra\xdfe\n", sample.as_bytes(), b"# \xe9"].concat();
        assert_eq!(refusal(read(&latin)), None, "{format}");
        let nul = sample.replacen(' ', "\0", 1);
        assert!(refusal(read(nul.as_bytes())).unwrap().ends_with("found a NUL byte"), "{format}");
    }
}

#[test]
fn e02_line_ends_and_blanks() {
    for (format, sample, read) in FORMATS {
        let mixed = sample.replacen('\n', "\r", 1).replacen('\n', "\r\n", 1);
        for (what, text) in [
            ("CR LF", sample.replace('\n', "\r\n")),
            ("lone CR", sample.replace('\n', "\r")),
            ("mixed", mixed),
            ("no final newline", sample.trim_end().to_owned()),
            ("tabs and form feeds", sample.replace(' ', "\t\x0c")),
            ("blank lines", sample.replace('\n', &"\n".repeat(1000))),
            ("a long comment", format!("#{}\n{sample}", "x".repeat(1 << 20))),
        ] {
            assert_eq!(refusal(read(text.as_bytes())), None, "{format}, {what}");
        }
    }
}

/// A number of each format, and what is put in its place.
#[test]
fn e04_numbers_that_are_none() {
    let places = [
        ("node", ".5", "@"),
        ("ele", "0.5", "@"),
        ("poly", "2.5", "@"),
        ("area", "0.25", "@"),
        ("mesh", "4e0", "@"),
        ("soup", "4 0 4 4", "4 0 @ 4"),
    ];
    for (format, number, place) in places {
        let (_, sample, read) = FORMATS.into_iter().find(|row| row.0 == format).unwrap();
        for text in ["1e400", "-1e400", "nan", "inf", "0x1p3", "1.0D+03", "--1", "1_000", "1e99999999999", "1'5", "½"]
        {
            let bad = sample.replacen(number, &place.replace('@', text), 1);
            assert!(refusal(read(bad.as_bytes())).unwrap().contains(text), "{format} {text}");
        }
        for text in ["+.5", "5.", "1e-400", &format!("0.{}1", "0".repeat(800)), "1.00000000000000011102230246251565404"]
        {
            let good = sample.replacen(number, &place.replace('@', text), 1);
            assert_eq!(refusal(read(good.as_bytes())), None, "{format} {text}");
        }
    }
    // Halfway between 1 and the next double, and just above.
    let x = |text: &str| node::read(format!("1\n1 {text} 0\n").as_bytes(), "f").unwrap().points[0].x;
    assert_eq!(x("1.00000000000000011102230246251565404"), 1.0);
    assert_eq!(x("1.00000000000000011102230246251565405"), 1.0 + f64::EPSILON);
}

#[test]
fn e05_integers_that_are_none() {
    const BAD: [&str; 7] =
        ["-1", "2147483648", "4294967297", "9223372036854775808", "18446744073709551616", "3.0", "1e0"];
    for text in BAD {
        for (format, bad) in [
            ("ele", ELE.replace("1 1 2 3", &format!("1 1 2 {text}"))),
            ("poly", POLY.replace("3 3 0 8", &format!("3 {text} 0 8"))),
            ("edge", EDGE.replace("1 1 2 1", &format!("1 {text} 2 1"))),
            ("mesh", MESHSUITE.replace("0 0 1 2", &format!("0 0 {text} 2"))),
        ] {
            let read = FORMATS.into_iter().find(|row| row.0 == format).unwrap().2;
            assert!(refusal(read(bad.as_bytes())).unwrap().contains(text), "{format} {text}");
        }
    }
    assert_eq!(ele::read(b"01 3\n1 001 +2 03\n", "f", sample_nodes().range()).unwrap().triangles, [[0, 1, 2]]);
}

#[test]
fn e06_counts_that_are_wrong() {
    for (format, sample, read) in FORMATS.into_iter().filter(|row| row.0 != "soup") {
        let (before, header) = if sample.starts_with('#') { ("# four\n", &sample[7..]) } else { ("", sample) };
        let rest = header.trim_start_matches(|c: char| c.is_ascii_digit());
        for count in ["1000000000000000000", "4294967295", "9"] {
            assert!(refusal(read(format!("{before}{count}{rest}").as_bytes())).is_some(), "{format} {count}");
        }
        assert!(refusal(read(format!("{before}1{rest}").as_bytes())).is_some(), "{format}: more rows than declared");
    }
}

#[test]
fn e07_too_much_and_out_of_order() {
    for (format, sample, read) in FORMATS.into_iter().filter(|row| row.0 != "soup") {
        assert!(refusal(read(format!("{sample}{sample}").as_bytes())).is_some(), "{format}: twice");
        for tail in ["x", "0", "\u{1a}", "1 2 3"] {
            assert!(refusal(read(format!("{sample}{tail}").as_bytes())).is_some(), "{format}: {tail:?} at the end");
        }
    }
    let (points, sections) = POLY.split_at(POLY.find("# edges").unwrap());
    assert!(refusal(read_poly(format!("{sections}{points}").as_bytes(), "f").map(drop)).is_some(), "odd order");
}

#[test]
fn e08_numbers_of_records() {
    for (format, sample, read) in FORMATS.into_iter().filter(|row| row.0 != "soup") {
        let rows: Vec<&str> = sample.lines().collect();
        let first = rows.iter().position(|row| row.starts_with(['0', '1']) && row.contains(' ')).unwrap();
        let with_row = |at: usize, number: &str| {
            let mut rows = rows.clone();
            let row = rows[at].split_once(' ').map(|(_, rest)| format!("{number} {rest}")).unwrap();
            rows[at] = &row;
            rows.join("\n")
        };
        for (at, number) in [(first, "5"), (first, "-1"), (first, "x"), (first + 1, "7"), (first + 1, "0")] {
            assert!(refusal(read(with_row(at, number).as_bytes())).is_some(), "{format}: row {at} numbered {number}");
        }
    }
}

#[test]
fn e09_columns() {
    for text in ["1 2 1\n1 0 0\n", "1 2 1 1\n1 0 0 5\n", "2 2 0 1\n1 0 0 1\n2 1 1\n", "1 2 1000000000\n1 0 0 1 2 3\n"] {
        assert!(
            refusal(node::read(text.as_bytes(), "f").map(drop)).unwrap().contains("the end of the line"),
            "{text:?}"
        );
    }
    let more = node::read(b"1 2 1 0\n1 0 0 5 6 7\n", "f").unwrap();
    assert_eq!((more.attributes, more.notes.len()), (vec![5.0], 1));
}

#[test]
fn f01_poly_files() {
    let beside = || node::read(b"3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n", "beside.node");
    let read = |text: &str| poly::read(text.as_bytes(), "f", beside).map(poly::Poly::into_pslg);
    let found = read("0 2 0 0 # beside\n1 1 # with markers\n0 0 0 -2147483648\n0\n").unwrap();
    assert_eq!((found.points.len(), found.segments, found.segment_markers), (3, vec![[0, 0]], vec![i32::MIN]));
    assert!(read("0 2\n1 0\n0 0 1\n").is_err(), "holes are missing");
    assert!(read("0 2\n1 0\n0 0 1\n0\n").is_ok(), "regions may be missing");
    for bad in ["0 3\n0\n0\n", "-1 2\n0\n0\n", "0 2\n-1\n0\n", "0 2\n0\n-1\n", "0 2\n0\n0\n-1\n"] {
        assert!(refusal(read(bad).map(drop)).is_some(), "{bad:?}");
    }
    let missing = || -> Result<node::Nodes, IoError> {
        Err(IoError::Missing { path: "f.node".into(), needed_by: Some("f.poly".into()) })
    };
    let error = poly::read(b"0 2\n0\n0\n", "f.poly", missing).unwrap_err();
    assert_eq!(error.to_string(), "f.node: no such file, needed by f.poly");
}

/// What is a fault of the mesh, not of the file, is read: `check` judges it.
#[test]
fn f02_ele_files() {
    let read = |text: &str| ele::read(text.as_bytes(), "f", sample_nodes().range()).map(|found| found.triangles);
    assert_eq!(read("1 6\n1 1 2 3 4 4 4\n").unwrap(), [[0, 1, 2]]);
    assert_eq!(read("3 3\n1 1 3 2\n2 1 1 2\n3 1 3 2\n").unwrap(), [[0, 2, 1], [0, 0, 1], [0, 2, 1]]);
    assert!(read("1 3\n1 0 1 2\n").is_err(), "vertex 0 where numbers start at 1");
}

#[test]
fn f10_numbers_come_back_bit_for_bit() {
    let xs =
        [5e-324, -5e-324, -0.0, 1.0 / 3.0, 9_007_199_254_740_993_u64 as f64, f64::MAX, f64::MIN_POSITIVE, 1e22, 1e23];
    let points: Vec<Point> = xs.iter().flat_map(|&x| xs.map(|y| Point::new(x, y))).collect();
    let mesh = trimalla::drawing::IndexedMesh { input_points: points.len(), points, ..Default::default() };
    let mut text = Vec::new();
    node::write(&mut text, &mesh, 1).unwrap();
    let bits = |points: &[Point]| points.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect::<Vec<_>>();
    assert_eq!(bits(&node::read(&text, "f").unwrap().points), bits(&mesh.points));
}
