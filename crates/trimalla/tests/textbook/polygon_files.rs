//! Polygons of the shared real inputs: the valid ones are triangulated, the others refused with the place.

#![allow(clippy::print_stdout, reason = "tables for those who look")]

use std::path::Path;

use crate::polygon_cases::Case;
use trimalla::drawing::Pslg;
use trimalla::geometry::{Containment, Point, Ring, SegmentContact, segment_contact};
use trimalla::polygon::{Polygon, PolygonError, PolygonMethod, Triangulator};
use trimalla::trace::NoTrace;
use trimalla_testkit::readers::{ReadmeRow, earcut_rings, read_input, read_readme};
use trimalla_testkit::shared_data_or_skip;

/// Earcut's files that are no valid polygons, and a word of what is said about each.
///
/// `bad-hole`: a hole crosses the outline. `degenerate`: a ring without area.
/// `empty-square`: the hole is the outline. `water`: holes overlap. `water-huge`: has holes of one side.
/// (`hourglass` and `outside-ring` only touch themselves in vertices, and are valid.)
const INVALID: [(&str, &str); 5] = [
    ("bad-hole.json", "cross"),
    ("degenerate.json", "cross"),
    ("empty-square.json", "cross"),
    ("water.json", "cross"),
    ("water-huge.json", "no area"),
];

/// From this many points on, only the triangles of one method are looked at; the others must be as many.
const LARGE: usize = 3000;

/// Triangulates by every method; all agree on whether the polygon is valid.
fn triangulate(name: &str, case: &Case) -> Result<usize, PolygonError> {
    let polygon = Polygon::new(&case.points, &case.ring_ends)?;
    let first = Triangulator::new().triangulate(polygon).map(<[_]>::to_vec);
    for method in [PolygonMethod::Monotone, PolygonMethod::Ears] {
        let found = method.triangulate(polygon, &mut NoTrace);
        match (&found, &first) {
            (Ok(triangles), Ok(others)) => {
                let fault = if case.points.len() < LARGE { case.fault(triangles) } else { None };
                assert_eq!(fault, None, "{name} {method}");
                assert_eq!(triangles.len(), others.len(), "{name} {method}");
            }
            _ => assert_eq!(found, first, "{name} {method}"),
        }
    }
    if let Err(PolygonError::Crossing { sides, at }) = &first {
        let [[a, b], [c, d]] = sides.map(|s| s.map(|v| case.points[v as usize]));
        assert_ne!(segment_contact(a, b, c, d), SegmentContact::Apart, "{name}: the sides {sides:?} meet");
        assert!(at.is_finite(), "{name}: the place is told");
    }
    let triangles = first?;
    assert_eq!(case.fault(&triangles), None, "{name}");
    Ok(triangles.len())
}

fn rows(data: &Path, families: &[&str]) -> Vec<ReadmeRow> {
    let rows = read_readme(&data.join("README.md")).into_iter();
    rows.filter(|row| row.points.is_some() && families.contains(&&*row.family)).collect()
}

#[test]
fn polygons_of_earcut_have_its_counts() {
    let data = shared_data_or_skip!();
    let rows = rows(&data, &["earcut"]);
    assert!(rows.len() > 10, "only {} files", rows.len());
    let mut differ = Vec::new();
    for row in rows {
        let case = Case::of(&earcut_rings(&row.path(&data)));
        let expected: usize = row.peer.split([' ', ';']).nth(1).and_then(|n| n.parse().ok()).unwrap_or(0);
        match (triangulate(&row.name, &case), INVALID.iter().find(|(name, _)| *name == row.name)) {
            (Ok(count), None) if count == expected => {}
            (Ok(count), None) => differ.push((row.name, expected, count)),
            (Err(e), Some((_, why))) => assert!(e.to_string().contains(why), "{}: {e}", row.name),
            (found, _) => panic!("{}: {found:?}", row.name),
        }
    }
    // 790 corners and 29 holes are 846 triangles; earcut leaves out flat corners. In a square 4 points make 2 triangles
    // each; earcut leaves out one of three that are in line.
    assert_eq!(differ, [("issue35.json".to_owned(), 844, 846), ("steiner.json".to_owned(), 9, 10)]);
}

/// The rings of a drawing all of whose segments are rings.
fn rings_of(drawing: &Pslg) -> Option<Vec<Vec<Point>>> {
    let mut next = vec![Vec::new(); drawing.points.len()];
    for &[a, b] in &drawing.segments {
        next[a as usize].push(b);
        next[b as usize].push(a);
    }
    let mut seen = vec![false; next.len()];
    let mut rings = Vec::new();
    for first in 0..next.len() {
        if seen[first] || next[first].is_empty() {
            continue;
        }
        let (mut ring, mut before, mut at) = (Vec::new(), u32::MAX, first as u32);
        while !seen[at as usize] {
            seen[at as usize] = true;
            ring.push(drawing.points[at as usize]);
            let &[p, q] = &next[at as usize][..] else { return None };
            (before, at) = (at, if p == before { q } else { p });
        }
        rings.push(ring);
    }
    Some(rings)
}

/// Whether ring `a` lies inside ring `b`, by the first corner that tells.
fn is_inside(a: &[Point], b: &[Point]) -> bool {
    let box_of = |ring: &[Point]| {
        let x = ring.iter().fold([f64::MAX, f64::MIN], |[l, h], p| [l.min(p.x), h.max(p.x)]);
        let y = ring.iter().fold([f64::MAX, f64::MIN], |[l, h], p| [l.min(p.y), h.max(p.y)]);
        [x, y]
    };
    let ([ax, ay], [bx, by]) = (box_of(a), box_of(b));
    if ax[0] < bx[0] || ax[1] > bx[1] || ay[0] < by[0] || ay[1] > by[1] {
        return false;
    }
    a.iter().map(|&p| Ring::new(b).locate(p)).find(|&c| c != Containment::On) == Some(Containment::Inside)
}

/// The polygons of a drawing of rings, which are told by what is inside what.
fn by_nesting(drawing: &Pslg) -> Vec<Case> {
    let rings = rings_of(drawing).unwrap_or_default();
    let depths: Vec<usize> = rings.iter().map(|a| rings.iter().filter(|b| is_inside(a, b)).count()).collect();
    let outlines = rings.iter().zip(&depths).filter(|(_, depth)| **depth % 2 == 0);
    let polygon = |(outline, depth): (&Vec<Point>, &usize)| {
        let holes = rings.iter().zip(&depths).filter(|(r, d)| **d == depth + 1 && is_inside(r, outline));
        Case::of(&[outline].into_iter().chain(holes.map(|(r, _)| r)).cloned().collect::<Vec<_>>())
    };
    outlines.map(polygon).collect()
}

/// The polygons of a file of well-known text.
fn polygons_of_wkt(path: &Path) -> Vec<Case> {
    let text = std::fs::read_to_string(path).expect("a file");
    let point = |pair: &str| {
        let mut numbers = pair.split_whitespace().filter_map(|n| n.parse().ok());
        Some(Point::new(numbers.next()?, numbers.next()?))
    };
    let ring = |text: &str| text.trim_end_matches([',', ' ', ')']).split(',').filter_map(point).collect::<Vec<_>>();
    let polygon = |text: &str| text.split('(').map(ring).filter(|ring| ring.len() > 2).collect::<Vec<_>>();
    let polygons = text.split("))").map(polygon).filter(|rings| !rings.is_empty());
    polygons.map(|rings| Case::of(&rings)).collect()
}

#[test]
fn other_polygons_are_triangulated_or_refused_with_the_place() {
    let data = shared_data_or_skip!();
    let (mut valid, mut refused) = (0, Vec::new());
    for row in rows(&data, &["poly2tri", "salzburg", "geo"]) {
        let path = row.path(&data);
        let cases = if row.name.ends_with(".wkt") { polygons_of_wkt(&path) } else { by_nesting(&read_input(&path).0) };
        for case in cases {
            match triangulate(&row.name, &case) {
                Ok(_) => valid += 1,
                Err(e) => refused.push((row.name.clone(), e.to_string())),
            }
        }
    }
    assert!(valid > 500, "only {valid} polygons are valid");
    println!("{valid} valid, refused {refused:#?}");
    let mut names: Vec<&str> = refused.iter().map(|(name, _)| &**name).collect();
    names.dedup();
    assert_eq!(names, REFUSED, "of {valid}");
}

/// The files with polygons that cross or touch along sides, as the table of the shared inputs counts them too.
const REFUSED: [&str; 4] = ["custom.dat", "sketchup.dat", "js-issue13.dat", "js-map_invalid.dat"];
