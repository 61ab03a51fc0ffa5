//! Damaged files: cut off anywhere, any bit flipped, random words. Nothing panics, and every fault has a place in the
//! file.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use crate::common::{AREA, EDGE, ELE, MESHSUITE, NEIGH, NODE, POLY, SOUP, read_poly, sample_nodes};
use proptest::prelude::*;
use trimalla_io::{Format, IoError, area, edge, ele, meshsuite, neigh, node, poly, read_mesh_bytes, soup};

/// Reads `bytes` as every format; each result as an error or nothing.
fn read_all(bytes: &[u8]) -> [Result<(), IoError>; 11] {
    let range = sample_nodes().range();
    [
        node::read(bytes, "f").map(drop),
        read_poly(bytes, "f").map(drop),
        poly::read_unnamed(bytes, "f").map(drop),
        poly::read_with_mesh(bytes, "f", range).map(drop),
        ele::read(bytes, "f", range).map(drop),
        edge::read(bytes, "f", range).map(drop),
        neigh::read(bytes, "f").map(drop),
        area::read(bytes, "f").map(drop),
        meshsuite::read(bytes, "f").map(drop),
        meshsuite::read_mesh(bytes, "f").map(drop),
        soup::read(bytes, "f").map(drop),
    ]
}

/// Checks that a fault points into the file or to its end.
fn check(bytes: &[u8]) {
    read_all(bytes).into_iter().filter_map(Result::err).for_each(|error| check_fault(bytes, &error));
}

/// Checks that a fault of a mesh in one format points into the file or to its end.
pub(crate) fn check_mesh_file(format: Format, bytes: &[u8]) {
    if let Err(error) = read_mesh_bytes(format, bytes, "f") {
        check_fault(bytes, &error);
    }
}

fn check_fault(bytes: &[u8], error: &IoError) {
    let lines: Vec<&[u8]> = split_lines(bytes);
    let fault = error.fault().expect("reading bytes fails at a place only");
    let line = lines.get(fault.place.line as usize - 1).expect("the line exists");
    assert!((1..=line.len() as u64 + 1).contains(&fault.place.column), "{error} in {bytes:?}");
    assert!(error.to_string().len() < 300, "{error}");
}

fn split_lines(bytes: &[u8]) -> Vec<&[u8]> {
    let mut lines = vec![];
    let (mut start, mut at) = (0, 0);
    while at < bytes.len() {
        let step = if bytes[at..].starts_with(b"\r\n") { 2 } else { 1 };
        if matches!(bytes[at], b'\r' | b'\n') {
            lines.push(&bytes[start..at]);
            start = at + step;
        }
        at += step;
    }
    lines.push(&bytes[start..]);
    lines
}

const SAMPLES: [&str; 8] = [NODE, ELE, POLY, EDGE, NEIGH, AREA, MESHSUITE, SOUP];

#[test]
fn samples_are_read() {
    let (triangle_files, others) = (
        [(0, NODE), (1, POLY), (2, POLY), (2, NODE), (4, ELE), (5, EDGE), (6, NEIGH)],
        [(7, AREA), (8, MESHSUITE), (9, MESHSUITE), (10, SOUP)],
    );
    for (i, sample) in triangle_files.into_iter().chain(others) {
        assert!(read_all(sample.as_bytes())[i].is_ok(), "{sample}");
    }
}

#[test]
fn cut_off_at_every_byte() {
    for sample in SAMPLES {
        for text in [sample.to_owned(), sample.replace('\n', "\r\n")] {
            (0..=text.len()).for_each(|end| check(&text.as_bytes()[..end]));
        }
    }
}

/// Only the section of regions may be missing.
#[test]
fn a_drawing_that_lost_lines_is_refused() {
    let lines: Vec<&str> = POLY.split_inclusive('\n').collect();
    let before_regions = lines.len() - 3;
    for kept in 0..=lines.len() {
        let result = read_poly(lines[..kept].concat().as_bytes(), "f");
        let whole = kept == before_regions || kept == lines.len();
        assert_eq!(result.is_ok(), whole, "{kept} lines: {result:?}");
    }
}

#[test]
fn every_bit_flipped() {
    for sample in SAMPLES {
        let mut bytes = sample.as_bytes().to_vec();
        for i in 0..bytes.len() {
            for bit in 0..8 {
                bytes[i] ^= 1 << bit;
                check(&bytes);
                bytes[i] ^= 1 << bit;
            }
        }
    }
}

#[test]
fn headers_promise_in_vain() {
    for header in ["4294967295", "4294967295 2 4294967295 1", "4294967295 3 4294967295", "4294967295 6 4294967295"] {
        check(header.as_bytes());
        check(format!("{header}\n1 1 2 3 4 5 6 7\n").as_bytes());
        check(format!("3\n1 0 0\n2 1 0\n3 0 1\n{header}\n").as_bytes());
    }
}

fn word() -> impl Strategy<Value = String> {
    prop_oneof![
        6 => (-2_i64..6).prop_map(|n| n.to_string()),
        2 => any::<f64>().prop_map(|x| format!("{x:e}")),
        1 => prop::sample::select(vec!["#", "\r", "\r\n", "x", "1e400", "nan", "-", "18446744073709551616", "\u{feff}", "\0", "é", ",", "1,5", ", "]).prop_map(str::to_owned),
        3 => Just("\n".to_owned()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn words_in_any_order(words in prop::collection::vec(word(), 0..60)) {
        check(words.join(" ").as_bytes());
    }

    #[test]
    fn bytes_in_any_order(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        check(&bytes);
    }

    #[test]
    fn a_sample_with_words_replaced(sample in 0..SAMPLES.len(), spots in prop::collection::vec((0_usize..80, word()), 1..4)) {
        let mut words: Vec<String> = SAMPLES[sample].split(' ').map(str::to_owned).collect();
        for (spot, new) in spots {
            let index = spot % words.len();
            words[index] = new;
        }
        check(words.join(" ").as_bytes());
    }
}
