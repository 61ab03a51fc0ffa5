//! Well-known text: points, lines and polygons, several geometries in one file.

use std::path::Path;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::rings::{push_chain, push_ring};
use super::{number, text_of};

/// Reads every geometry of a file; says whether all segments belong to polygons.
///
/// # Shape
/// A list is a pair of parentheses that holds coordinates and no further parentheses. What it is
/// (points, a line, a ring) follows from the last word before it.
#[must_use]
pub fn read_wkt(path: &Path) -> (Pslg, bool) {
    let text = text_of(path);
    let mut pslg = Pslg::default();
    let (mut word, mut list) = (String::new(), Vec::new());
    let (mut polygons, mut lines) = (0, 0);
    for token in tokens(&text) {
        match token {
            "(" => list.clear(),
            ")" if list.is_empty() => {}
            ")" => {
                let points = points_of(&list);
                match word.as_str() {
                    "POINT" | "MULTIPOINT" => pslg.points.extend(points),
                    "LINESTRING" | "MULTILINESTRING" => {
                        lines += 1;
                        push_chain(&mut pslg, &points);
                    }
                    "POLYGON" | "MULTIPOLYGON" => {
                        polygons += 1;
                        push_ring(&mut pslg, &points);
                    }
                    other => panic!("unknown WKT word {other:?}"),
                }
                list.clear();
            }
            _ if token.starts_with(|c: char| c.is_ascii_alphabetic()) => word = token.to_ascii_uppercase(),
            _ => list.push(token),
        }
    }
    (pslg, polygons > 0 && lines == 0)
}

/// Tokens of one character.
const MARKS: [char; 3] = ['(', ')', ','];

/// Words, numbers, commas and parentheses.
fn tokens(text: &str) -> impl Iterator<Item = &str> {
    text.split_inclusive(|c: char| c.is_whitespace() || MARKS.contains(&c)).flat_map(|piece| {
        let (body, mark) = match piece.char_indices().last() {
            Some((at, c)) if MARKS.contains(&c) => piece.split_at(at),
            _ => (piece, ""),
        };
        [body.trim(), mark].into_iter().filter(|t| !t.is_empty())
    })
}

/// The points of `x y , x y , …`.
fn points_of(list: &[&str]) -> Vec<Point> {
    let pairs = list.split(|&t| t == ",").filter(|pair| !pair.is_empty());
    pairs.map(|pair| Point::new(number(pair[0]), number(pair[1]))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_split_at_marks_and_blanks() {
        let all: Vec<&str> = tokens("MULTIPOINT ((1 -2),\n (3 4e-5))").collect();
        assert_eq!(all, ["MULTIPOINT", "(", "(", "1", "-2", ")", ",", "(", "3", "4e-5", ")", ")"]);
        assert_eq!(points_of(&["1", "2", ",", "3", "4"]), [Point::new(1.0, 2.0), Point::new(3.0, 4.0)]);
    }
}
