//! poly2tri test beds: pairs of numbers with any separator, holes and Steiner points in the file or
//! beside it.

use std::path::Path;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::rings::push_ring;
use super::{beside, number, text_of};

/// Which list the numbers of a line belong to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum List {
    /// The outline or a hole.
    Ring,
    /// Loose points.
    Steiner,
}

/// Reads a test bed: the outline, then rings after lines `HOLE`, points after lines `STEINER`, then
/// the companion files `…_hole.dat`, `…_holes.dat` (rings separated by blank lines) and
/// `…_steiner.dat`.
#[must_use]
pub fn read_poly2tri(path: &Path) -> Pslg {
    let mut pslg = Pslg::default();
    let mut numbers = Vec::new();
    let mut list = List::Ring;
    for line in text_of(path).lines() {
        let started = match line.trim() {
            "HOLE" => List::Ring,
            "STEINER" => List::Steiner,
            _ => {
                numbers.extend(numbers_of(line));
                continue;
            }
        };
        finish(&mut pslg, &mut numbers, list);
        list = started;
    }
    finish(&mut pslg, &mut numbers, list);
    for ending in ["_hole.dat", "_holes.dat"] {
        for line in companion(path, ending).lines().chain([""]) {
            if line.trim().is_empty() {
                finish(&mut pslg, &mut numbers, List::Ring);
            }
            numbers.extend(numbers_of(line));
        }
    }
    numbers.extend(numbers_of(&companion(path, "_steiner.dat")));
    finish(&mut pslg, &mut numbers, List::Steiner);
    pslg
}

/// Adds the collected numbers as a ring or as points.
fn finish(pslg: &mut Pslg, numbers: &mut Vec<f64>, list: List) {
    assert!(numbers.len() % 2 == 0, "{} numbers are no pairs", numbers.len());
    let points: Vec<Point> = numbers.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect();
    numbers.clear();
    match list {
        List::Ring => push_ring(pslg, &points),
        List::Steiner => pslg.points.extend(points),
    }
}

/// The text of a companion file; empty where there is none.
fn companion(path: &Path, ending: &str) -> String {
    let file = beside(path, ending);
    if file.is_file() { text_of(&file) } else { String::new() }
}

/// All numbers of a text: what is between characters that no number has, if it has a digit. Keys
/// such as `X` vanish.
fn numbers_of(text: &str) -> impl Iterator<Item = f64> {
    let in_number = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    text.split(move |c| !in_number(c)).filter(|t| t.contains(|c: char| c.is_ascii_digit())).map(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_with_any_separator() {
        let all = |text| numbers_of(text).collect::<Vec<f64>>();
        assert_eq!(all("[1, -2.5e-3],"), [1.0, -2.5e-3]);
        assert_eq!(all("{\"X\": +0.5, \"Y\":7}"), [0.5, 7.0]);
        assert_eq!(all("0.55\t-1.06"), [0.55, -1.06]);
    }
}
