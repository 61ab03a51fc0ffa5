//! The catalogue of inputs that have broken triangulators and refiners, entry by entry.
//!
//! A test is named by the entry that it covers: a letter for the family (points, segments, domains, refinement) and a
//! number. `docs/reliability.md` lists every entry with its test, also those of files, outputs and processes, whose
//! tests stand beside the readers and the program.

#[path = "../common/agreement.rs"]
mod agreement;
#[path = "../common/alike.rs"]
mod alike;
#[path = "../common/verdict.rs"]
mod verdict;

mod a_points;
mod b_segments;
mod c_domains;
mod d_refinement;

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainError, DomainRule, Warning, build};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla::quality::against_input;
use trimalla::refine::{NoObserver, RefineOptions, Refinement, Report};
use trimalla::triangulation::{Triangulation, check_mesh};
use trimalla_testkit::oracles::{check_indexed, contacts};

/// The one triangulation of the points that all algorithms agree on; the checker finds no fault in it.
fn agreed(points: &[Point]) -> Triangulation {
    agreement::agreed(points).expect("the algorithms agree")
}

/// The points of a list of pairs.
fn at(places: &[[f64; 2]]) -> Vec<Point> {
    places.iter().copied().map(Point::from).collect()
}

/// A drawing of points and segments.
fn drawing(points: Vec<Point>, segments: &[[u32; 2]]) -> Pslg {
    Pslg { points, segments: segments.to_vec(), ..Pslg::default() }
}

/// The segments of a closed ring of vertices from `first` on.
fn ring(first: u32, n: u32) -> Vec<[u32; 2]> {
    (0..n).map(|i| [first + i, first + (i + 1) % n]).collect()
}

/// The constrained triangulation of a drawing, crossings split; checked in full, and held against the drawing.
fn constrained(input: &Pslg) -> ConstrainedDelaunay {
    let cdt = ConstrainedDelaunay::new(&input.points, &input.segments, Crossings::Split).expect("good input");
    assert_eq!(cdt.check(), []);
    assert_eq!(against_input(&cdt.to_indexed(input), input).faults, []);
    cdt
}

/// The pairs of segments that the library refuses, which are those that the slow comparison of all pairs finds.
fn refused_pairs(input: &Pslg) -> usize {
    use trimalla::constrained::ConstraintError::Crossing;
    match ConstrainedDelaunay::new(&input.points, &input.segments, Crossings::Refuse) {
        Ok(_) => 0,
        Err(Crossing(pairs)) => {
            let truth = contacts(input).crossings;
            assert!(pairs.iter().all(|pair| truth.contains(&(pair.segments[0], pair.segments[1]))), "{pairs:?}");
            pairs.len()
        }
        Err(e) => panic!("{e}"),
    }
}

/// The triangulated domain of a drawing, crossings split, without refinement; checked in full.
fn domain(input: &Pslg, rule: DomainRule) -> Result<(IndexedMesh, Vec<Warning>), DomainError> {
    let (cdt, warnings) = build(input, rule, Crossings::Split, AlgorithmKey::default())?;
    assert_eq!(cdt.check(), []);
    let mesh = cdt.to_indexed(input);
    assert_eq!(check_mesh(&mesh), []);
    assert_eq!(check_indexed(&mesh, Some(input)), Vec::<String>::new());
    Ok((mesh, warnings))
}

/// The refined domain of a drawing; checked in full, and held against the drawing.
fn refined(input: &Pslg, rule: DomainRule, options: RefineOptions) -> (IndexedMesh, Report) {
    let (cdt, _) = build(input, rule, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    let mut refinement = Refinement::new(cdt, options).expect("good options");
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert_eq!(cdt.check_delaunay(), []);
    let mesh = cdt.to_indexed(input);
    assert_eq!(check_mesh(&mesh), []);
    assert_eq!(against_input(&mesh, input).faults, []);
    assert_eq!(mesh.points[..input.points.len()], input.points, "input vertices come first");
    assert!(mesh.points.iter().all(|p| p.is_finite()), "a vertex is not finite");
    (mesh, report)
}

/// Every test named in the table of `docs/reliability.md` is there, and every test here is in the table.
#[test]
fn the_page_names_the_tests_there_are() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = std::fs::read_to_string(root.join("docs/reliability.md")).expect("the page");
    let is_test = |name: &&str| {
        let bytes = name.as_bytes();
        bytes.len() > 4
            && bytes[0].is_ascii_lowercase()
            && bytes[1..3].iter().all(u8::is_ascii_digit)
            && bytes[3] == b'_'
    };
    let named: std::collections::BTreeSet<&str> = page.split('`').filter(is_test).collect();
    let mut sources = String::new();
    let mut folders = vec![root.join("crates")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder of ours") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                sources += &std::fs::read_to_string(path).expect("a source of ours");
            }
        }
    }
    let missing: Vec<&&str> = named.iter().filter(|name| !sources.contains(&format!("fn {name}()"))).collect();
    assert!(missing.is_empty(), "named, but not there: {missing:?}");
    for module in [
        include_str!("a_points.rs"),
        include_str!("b_segments.rs"),
        include_str!("c_domains.rs"),
        include_str!("d_refinement.rs"),
    ] {
        let here = module.split("\nfn ").skip(1).filter_map(|rest| rest.split('(').next()).filter(is_test);
        let unnamed: Vec<&str> = here.filter(|name| !named.contains(name)).collect();
        assert!(unnamed.is_empty(), "not in the table: {unnamed:?}");
    }
}
