//! The shared real inputs, read and counted, and the oracles against what others stored with them.
//!
//! Every test is skipped, saying so, where the shared folder is not found.

#![allow(clippy::unwrap_used, reason = "helpers outside the test functions: a broken fixture should stop the test")]

use std::fs;
use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla_testkit::oracles::{
    DelaunayRule, RBig, brute_force_cdt, brute_force_delaunay, canonical, check_indexed_with, contacts,
    delaunay_triangle_count, doubled_area, euler, in_circle, orient, orient_rational, representatives,
};
use trimalla_testkit::readers::{
    CdtExpected, all_inputs, read_cdt, read_cdt_expected, read_ele, read_meshsuite_tables, read_node,
    read_orient_cases, read_poly, read_readme, read_triangle_soup,
};
use trimalla_testkit::shared_data_or_skip;

/// Segments beyond which comparing all with all takes too long for a test.
const ALL_PAIRS_LIMIT: usize = 20_000;

#[test]
fn points_and_segments_are_as_many_as_the_readme_says() {
    let data = shared_data_or_skip!();
    let rows = read_readme(&data.join("README.md"));
    let rows: Vec<_> = rows.into_iter().filter(|r| r.points.is_some()).collect();
    let inputs = all_inputs(&data);
    assert!(inputs.len() > 80, "only {} inputs", inputs.len());
    let mut mismatches = Vec::new();
    for (row, input) in rows.iter().zip(&inputs) {
        let counted = (Some(input.pslg.points.len()), input.pslg.segments.len());
        let listed = (row.points, row.segments.unwrap_or(0));
        if counted != listed {
            mismatches.push(format!("{}/{}: {counted:?} read, {listed:?} listed", row.family, row.name));
        }
    }
    assert!(mismatches.is_empty(), "{mismatches:#?}");
}

#[test]
fn every_listed_file_of_every_family_is_an_input() {
    let data = shared_data_or_skip!();
    let families: std::collections::BTreeSet<String> = all_inputs(&data).into_iter().map(|i| i.family).collect();
    let wanted =
        ["cdt", "cgshop", "crossing", "delaunator", "earcut", "geo", "points", "poly2tri", "salzburg", "triangle"];
    assert!(families.iter().eq(wanted), "{families:?}");
}

#[test]
fn troubles_are_as_many_as_the_readme_says() {
    let data = shared_data_or_skip!();
    let rows = read_readme(&data.join("README.md"));
    let rows: Vec<_> = rows.into_iter().filter(|r| r.points.is_some()).collect();
    let mut mismatches = Vec::new();
    for (row, input) in rows.iter().zip(all_inputs(&data)) {
        if input.pslg.segments.len() > ALL_PAIRS_LIMIT {
            continue;
        }
        let found = contacts(&input.pslg);
        // The README counts each point and each pair of different segments once, however often they
        // are listed.
        let first = representatives(&input.pslg.points);
        let class = |segment: usize| {
            let mut ends = input.pslg.segments[segment].map(|v| first[v as usize]);
            ends.sort_unstable();
            ends
        };
        let counts = [
            ("duplicate points", found.duplicate_points.len()),
            ("zero-length segments", found.zero_length.len()),
            ("repeated segments", found.repeated.len()),
            ("proper crossings", distinct(found.crossings.iter().map(|&(i, j)| [class(i), class(j)]))),
            ("collinear overlaps", distinct(found.overlaps.iter().map(|&(i, j)| [class(i), class(j)]))),
            ("points exactly inside a segment", distinct(found.points_inside.iter().map(|&(point, _)| [point]))),
        ];
        for (words, counted) in counts {
            if counted != row.counted(words) {
                mismatches.push(format!(
                    "{}/{}: {counted} {words}, {} listed",
                    row.family,
                    row.name,
                    row.counted(words)
                ));
            }
        }
    }
    assert!(mismatches.is_empty(), "{mismatches:#?}");
}

#[test]
fn orientation_signs_of_others_are_ours() {
    let data = shared_data_or_skip!();
    let cases = read_orient_cases(&data.join("predicates/orient2d.txt"));
    assert_eq!(cases.len(), 1000);
    for case in cases {
        let [a, b, c] = case.points;
        assert_eq!(orient(a, b, c), case.sign, "{case:?}");
        assert_eq!(orient_rational(a, b, c), case.sign, "{case:?}");
    }
}

#[test]
fn soup_of_seed_002_is_as_described() {
    let data = shared_data_or_skip!();
    let soup = read_triangle_soup(&data.join("seeds/Triangles1.txt"));
    assert_eq!(soup.len(), 18);
    let (points, triangles) = joined(&soup);
    assert_eq!(points.len(), 12);
    let e = euler(&triangles);
    assert_eq!((e.edges - e.boundary_edges, e.boundary_edges), (25, 4));
    let area = doubled_area(&points, &triangles);
    assert_eq!(if area < RBig::ZERO { -area } else { area }, RBig::from(2 * 1280 * 720));
}

#[test]
fn meshsuite_tables_are_read_whole() {
    let data = shared_data_or_skip!();
    let rows = read_meshsuite_tables(&data.join("seeds/meshsuite-tables.csv"));
    assert_eq!(rows.len(), 503);
    assert!(rows.iter().any(|r| r.vertices.is_none()));
    assert!(rows.iter().all(|r| r.program == "Triangle" || r.program == "framework"));
}

#[test]
fn stored_results_of_cdt_pass_the_checker() {
    let data = shared_data_or_skip!();
    let mut faulty = Vec::new();
    for path in stored_results(&data) {
        let stored = read_cdt_expected(&path);
        let input = read_cdt(&data.join(format!("cdt/{}.txt", stored.input)));
        if stored.crossings != "ignore" || stored.erased == "all" || stored.triangles.is_empty() {
            continue;
        }
        let mesh = mesh_of(&input, &stored);
        let faults = check_indexed_with(&mesh, Some(&input), DelaunayRule::Delaunay);
        if !faults.is_empty() {
            faulty.push(format!("{}: {faults:?}", path.display()));
        }
    }
    assert!(faulty.is_empty(), "{faulty:#?}");
}

#[test]
fn stored_hull_results_of_cdt_agree_with_brute_force_up_to_ties() {
    let data = shared_data_or_skip!();
    let mut compared = 0;
    for path in stored_results(&data) {
        let stored = read_cdt_expected(&path);
        let input = read_cdt(&data.join(format!("cdt/{}.txt", stored.input)));
        let small = input.points.len() <= 40 && contacts(&input).is_clean();
        if stored.erased != "super" || !small {
            continue;
        }
        let ours = brute_force_cdt(&input.points, &input.segments);
        assert_eq!(ours.len(), delaunay_triangle_count(&input.points), "{}", path.display());
        let theirs = canonical(&stored.triangles);
        let strange: Vec<&[u32; 3]> =
            theirs.iter().filter(|t| !ours.contains(t) && !is_tied(&input, &ours, **t)).collect();
        assert!(strange.is_empty(), "{}: {strange:?} of {theirs:?}, ours {ours:?}", path.display());
        compared += 1;
    }
    assert!(compared >= 5, "only {compared} compared");
}

#[test]
fn stored_meshes_of_triangle_pass_the_checker() {
    let data = shared_data_or_skip!().join("triangle");
    for stem in ["A", "box", "face", "double_hex2"] {
        let input = read_poly(&data.join(format!("{stem}.poly")));
        let points = read_node(&data.join(format!("{stem}.1.node"))).points;
        let triangles = read_ele(&data.join(format!("{stem}.1.ele")), 1);
        let mesh = IndexedMesh { input_points: points.len(), points, triangles, ..IndexedMesh::default() };
        let faults = check_indexed_with(&mesh, Some(&input), DelaunayRule::Delaunay);
        assert!(faults.is_empty(), "{stem}: {faults:?}");
    }
}

#[test]
fn stored_delaunay_of_the_spiral_is_the_brute_force_one() {
    let data = shared_data_or_skip!().join("triangle");
    let points = read_node(&data.join("spiral.node")).points;
    let stored = read_ele(&data.join("spiral.1.ele"), 1);
    assert_eq!(canonical(&stored), brute_force_delaunay(&points));
}

/// Number of different items, pairs taken in any order.
fn distinct<T: Ord, const N: usize>(items: impl Iterator<Item = [T; N]>) -> usize {
    let sorted = items.map(|mut item| {
        item.sort_unstable();
        item
    });
    sorted.collect::<std::collections::BTreeSet<_>>().len()
}

/// The stored results, in order of name.
fn stored_results(data: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(data.join("cdt/expected")).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|e| e.unwrap().path()).collect();
    paths.sort();
    assert!(paths.len() > 30, "only {} stored results", paths.len());
    paths
}

/// A stored result as a mesh on the input's points.
fn mesh_of(input: &Pslg, stored: &CdtExpected) -> IndexedMesh {
    IndexedMesh {
        input_points: input.points.len(),
        points: input.points.clone(),
        triangles: stored.triangles.clone(),
        ..IndexedMesh::default()
    }
}

/// Whether a triangle shares its circle with one of ours: both are right, by different tie rules.
fn is_tied(input: &Pslg, ours: &[[u32; 3]], triangle: [u32; 3]) -> bool {
    let at = |v: u32| input.points[v as usize];
    let [a, b, c] = triangle.map(at);
    ours.iter().any(|t| t.iter().all(|&v| in_circle(a, b, c, at(v)) == 0))
}

/// Equal corners of a soup joined.
fn joined(soup: &[[Point; 3]]) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut points: Vec<Point> = Vec::new();
    let mut id = |p: Point| {
        let at = points.iter().position(|&q| q == p).unwrap_or_else(|| {
            points.push(p);
            points.len() - 1
        });
        u32::try_from(at).unwrap()
    };
    let triangles = soup.iter().map(|t| t.map(&mut id)).collect();
    (points, triangles)
}
