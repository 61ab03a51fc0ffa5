//! Random files: valid ones, damaged ones, words without sense.

use trimalla::drawing::IndexedMesh;
use trimalla_io::{Format, WriteOptions};

use crate::draws::Draws;
use crate::{drawings, settings};

/// Words that files are made of, and some that they are not.
const WORDS: [&str; 44] = [
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
