//! Random files: valid ones, damaged ones, words without sense.

use trimalla::drawing::IndexedMesh;
use trimalla_io::{Format, WriteOptions};

use crate::draws::Draws;
use crate::{drawings, settings};

/// Words that files are made of, and some that they are not.
const WORDS: [&str; 60] = [
    "0",
    "1",
    "2",
    "3",
    "4",
    "5",
    "8",
    "-1",
    "+1",
    "1.5",
    "-0",
    "-0.0",
    "1e3",
    "1E-3",
    "1e400",
    "5e-324",
    "nan",
    "inf",
    "-inf",
    "1e",
    ".",
    "0x10",
    "1_000",
    "4294967295",
    "4294967296",
    "18446744073709551616",
    "99999999999999999999999",
    "1,5",
    "1d3",
    "\n",
    "\n",
    "\r\n",
    "\r",
    "\t",
    " ",
    "#",
    "# words\n",
    "\u{feff}",
    "\0",
    "é",
    "=",
    "\"",
    "[limits]",
    "vertices",
    "{",
    "[",
    "]",
    "\"coordinates\":",
    "((",
    ")",
    "POLYGON",
    "EMPTY",
    "<path d='M0 0",
    "A1 1 0 0 1",
    "/>",
    "transform='scale(1e300)'",
    "0\nINSERT\n2\nB\n",
    "40\n1e9\n",
    "42\n-1e-9\n",
    ";",
];

/// A small drawing in each format of another program's.
const SEEDS: [(&str, &[u8]); 8] = [
    (
        "geojson",
        br#"{"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"use":1},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,0]],[[2,1],[3,1],[3,2],[2,1]]]}},
{"type":"Feature","properties":{"use":"a"},"geometry":{"type":"MultiPolygon","coordinates":[[[[4,0],[8,0],[4,4],[4,0]]]]}},
{"type":"Feature","properties":null,"geometry":{"type":"GeometryCollection","geometries":[
{"type":"LineString","coordinates":[[1,1,5],[2,2,6]]},{"type":"MultiPoint","coordinates":[[0,9],[9,9]]}]}}]}"#,
    ),
    (
        "dxf",
        b"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nA\n70\n0\n62\n7\n0\nENDSEC\n\
          0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n1\n20\n1\n0\nCIRCLE\n10\n1\n20\n1\n40\n1\n0\nENDBLK\n0\nENDSEC\n\
          0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nA\n70\n1\n10\n0\n20\n0\n42\n0.5\n10\n9\n20\n0\n10\n9\n20\n9\n\
          0\nINSERT\n2\nB\n10\n6\n20\n3\n41\n0.5\n42\n0.5\n50\n30\n70\n2\n44\n4\n0\nARC\n10\n0\n20\n0\n40\n2\n50\n10\n51\n80\n\
          0\nELLIPSE\n10\n0\n20\n0\n11\n3\n21\n1\n40\n0.5\n0\nPOLYLINE\n70\n1\n0\nVERTEX\n10\n0\n20\n0\n0\nVERTEX\n10\n3\n20\n0\n42\n1\n\
          0\nVERTEX\n10\n3\n20\n3\n0\nSEQEND\n0\nSPLINE\n70\n8\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n\
          10\n0\n20\n0\n10\n1\n20\n2\n10\n2\n20\n0\n0\nTEXT\n1\nhello\n0\nENDSEC\n0\nEOF\n",
    ),
    (
        "svg",
        b"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><style>.a{fill:none} #b > path{fill:red}</style>\
          <defs><circle id='c' r='1'/></defs><g id='b' transform='rotate(30) scale(2) skewX(9)'><path d='M0 0 C1 2 3 2 4 0 A2 1 20 1 0 0 0z'/></g>\
          <use href='#c' x='3'/><rect class='a' stroke='blue' width='9' height='8' rx='1'/><polygon points='1,1 2,1 2,2'/>\
          <path d='m1 1q1 1 2 0t2 0s1 1 2 2h1v1l1 1' fill='none' stroke='#000'/><text>a</text></svg>",
    ),
    (
        "wkt",
        b"SRID=4326;POLYGON ((0 0, 4 0, 4 4, 0 0), (2 1, 3 1, 3 2, 2 1))\nLINESTRING Z (0 0 1, 1 1 2)\nMULTIPOINT ((1 1), 2 2)\n\
          GEOMETRYCOLLECTION (POINT EMPTY, MULTIPOLYGON (((9 9, 8 9, 9 8, 9 9))))\n",
    ),
    (
        "shp",
        b"\0\0\x27\x0a\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x5a\xe8\x03\0\0\x01\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\
          \0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\
          \0\0\0\x01\0\0\0\x0a\x01\0\0\0\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\0\x40",
    ),
    ("csv", b"id;x;y;z\n1;0;0;3\n2;4;0;5\n3;0;4;1.5\n"),
    ("xyz", b"0 0 1\n4 0 2\n0 4 3\n5 5 5\n"),
    ("las", b"LASF\0\0\0\0"),
];

/// Words one after the other.
fn words(d: &mut Draws<'_>) -> Vec<u8> {
    let n = d.within(0, 30);
    let mut text = String::new();
    for _ in 0..n {
        text.push_str(d.pick(&WORDS));
        text.push_str(d.pick(&[" ", " ", " ", "\n", ""]));
    }
    text.into_bytes()
}

/// Bytes without sense.
fn noise(d: &mut Draws<'_>) -> Vec<u8> {
    (0..d.within(0, 64)).map(|_| d.below(256) as u8).collect()
}

/// A file of a mesh or drawing in a format of [`Format`]: `node`, `ele`, …; nothing for other names.
fn valid(d: &mut Draws<'_>, format: &str) -> Vec<u8> {
    if let Some(seed) = SEEDS.iter().find(|seed| seed.0 == format) {
        return seed.1.to_vec();
    }
    let drawing = drawings::drawing(d);
    let options = WriteOptions::default().with_first_index(d.below(2) as u32);
    let mut bytes = Vec::new();
    let known = Format::ALL.into_iter().find(|f| f.extension() == format).unwrap_or(Format::Node);
    if known == Format::Area {
        return (0..d.below(9))
            .fold(b"4\n".to_vec(), |text, i| [text, format!("{i} {}\n", d.unit()).into_bytes()].concat());
    }
    if d.once_in(2) && trimalla_io::write_pslg_to(&mut bytes, known, &drawing, &options).is_ok() {
        return bytes;
    }
    bytes.clear();
    let mesh =
        trimalla::triangulate(&drawing, &settings::domain(d)).map_or_else(|_| IndexedMesh::default(), |made| made.mesh);
    let _ = trimalla_io::write_mesh_to(&mut bytes, known, &mesh, &options);
    bytes
}

/// A file for the readers of a format: valid, damaged, or without sense.
#[must_use]
pub fn file(d: &mut Draws<'_>, format: &str) -> Vec<u8> {
    let mut bytes = match d.below(8) {
        0 => noise(d),
        1 | 2 => words(d),
        _ => valid(d, format),
    };
    if !d.once_in(4) {
        for _ in 0..d.within(1, 3) {
            damage(d, &mut bytes);
        }
    }
    bytes
}

/// One change: a bit, a byte, a word, a line, the end.
pub fn damage(d: &mut Draws<'_>, bytes: &mut Vec<u8>) {
    let n = bytes.len();
    let at = d.below(n + 1);
    match d.below(9) {
        0 if at < n => bytes[at] ^= 1 << d.below(8),
        1 => bytes.truncate(at),
        2 => drop(bytes.splice(at..at, d.pick(&WORDS).bytes())),
        3 if n > 0 => {
            let end = (at + d.below(9)).min(n);
            bytes.drain(at.min(end)..end);
        }
        4 => {
            // A word becomes another.
            let is_space = |b: &u8| b.is_ascii_whitespace();
            let start = bytes[..at].iter().rposition(is_space).map_or(0, |i| i + 1);
            let end = bytes[at..].iter().position(is_space).map_or(n, |i| at + i);
            bytes.splice(start..end, d.pick(&WORDS).bytes());
        }
        5 => {
            // A line goes, or comes twice.
            let mut lines: Vec<Vec<u8>> = bytes.split_inclusive(|b| *b == b'\n').map(<[u8]>::to_vec).collect();
            if let Some(i) = lines.len().checked_sub(1).map(|last| d.within(0, last)) {
                if d.once_in(2) {
                    lines.remove(i);
                } else {
                    let line = lines[i].clone();
                    lines.insert(d.within(0, i), line);
                }
            }
            *bytes = lines.concat();
        }
        6 if at < n => bytes[at] = d.below(256) as u8,
        7 => *bytes = String::from_utf8_lossy(bytes).replace('\n', d.pick(&["\r\n", "\r", " "])).into_bytes(),
        _ => bytes.extend(d.pick(&WORDS).bytes()),
    }
}
