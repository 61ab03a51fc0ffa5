//! Triangle's text files, 0- or 1-based.

use std::collections::HashMap;
use std::path::Path;

use trimalla::drawing::{Pslg, Region};
use trimalla::geometry::Point;

use super::{index, number, text_of};

/// Lines as tokens, comments and blank lines dropped.
type Rows = std::vec::IntoIter<Vec<String>>;

/// Reads a `.node` file.
#[must_use]
pub fn read_node(path: &Path) -> Pslg {
    let mut pslg = Pslg::default();
    vertices(&mut rows(path), &mut pslg);
    pslg
}

/// Reads a `.poly` file; where it has no vertices they come from the `.node` file of the same stem.
#[must_use]
pub fn read_poly(path: &Path) -> Pslg {
    let mut rows = rows(path);
    let mut pslg = Pslg::default();
    let mut ids = vertices(&mut rows, &mut pslg);
    if pslg.points.is_empty() {
        ids = vertices(&mut self::rows(&path.with_extension("node")), &mut pslg);
    }
    let head = rows.next().unwrap();
    let marked = head.get(1).is_some_and(|m| m != "0");
    for row in rows.by_ref().take(index(&head[0]) as usize) {
        pslg.segments.push([ids[row[1].as_str()], ids[row[2].as_str()]]);
        if marked {
            pslg.segment_markers.push(row[3].parse().unwrap());
        }
    }
    let holes = rows.next().map_or(0, |head| index(&head[0]));
    pslg.holes.extend(rows.by_ref().take(holes as usize).map(|row| point(&row)));
    let regions = rows.next().map_or(0, |head| index(&head[0]));
    pslg.regions.extend(rows.take(regions as usize).map(|row| Region {
        seed: point(&row),
        attribute: row.get(3).map_or(0.0, |a| number(a)),
        max_area: row.get(4).map(|a| number(a)).filter(|&a| a > 0.0),
    }));
    pslg
}

/// Reads the first three corners of each triangle of an `.ele` file, counted from 0.
///
/// # Shape
/// `base` is the id of the first vertex: 0 or 1.
#[must_use]
pub fn read_ele(path: &Path, base: u32) -> Vec<[u32; 3]> {
    let mut rows = rows(path);
    let count = index(&rows.next().unwrap()[0]);
    rows.take(count as usize).map(|row| [1, 2, 3].map(|k| index(&row[k]) - base)).collect()
}

/// Reads a vertex part into points, attributes and markers; gives the index of each id.
fn vertices(rows: &mut Rows, pslg: &mut Pslg) -> HashMap<String, u32> {
    let head = rows.next().unwrap();
    let at = |k: usize| head.get(k).map_or(0, |t| index(t) as usize);
    let (count, attributes, marked) = (at(0), at(2), at(3) > 0);
    pslg.attributes_per_point = attributes;
    let mut ids = HashMap::new();
    for (row, i) in rows.by_ref().take(count).zip(0..) {
        ids.insert(row[0].clone(), i);
        pslg.points.push(point(&row));
        pslg.point_attributes.extend(row[3..3 + attributes].iter().map(|t| number(t)));
        if marked {
            pslg.point_markers.push(row[3 + attributes].parse().unwrap());
        }
    }
    ids
}

/// The point of `id x y …`.
fn point(row: &[String]) -> Point {
    Point::new(number(&row[1]), number(&row[2]))
}

/// The rows of a file.
fn rows(path: &Path) -> Rows {
    let tokens = |line: &str| -> Vec<String> {
        let said = line.split('#').next().unwrap_or_default();
        said.split_whitespace().map(str::to_owned).collect()
    };
    let rows: Vec<Vec<String>> = text_of(path).lines().map(tokens).filter(|r| !r.is_empty()).collect();
    rows.into_iter()
}
