//! The catalogue of inputs that have broken triangulators and refiners, entry by entry.
//!
//! A test is named by the entry that it covers: a letter for the family (points, segments, domains, refinement) and a
//! number. `docs/reliability.md` lists every entry with its test, also those of files, outputs and processes, whose tests
//! stand beside the readers and the program.

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
use trimalla::domain::{DomainError, DomainRule, Pslg, Warning, build};
use trimalla::geometry::Point;
use trimalla::quality::against_input;
use trimalla::refine::{NoObserver, RefineOptions, Refinement, Report};
use trimalla::triangulation::{IndexedMesh, Triangulation, check_mesh};
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
    assert_eq!(cdt.check(), []);
    let mesh = cdt.to_indexed(input);
    assert_eq!(check_mesh(&mesh), []);
    assert_eq!(against_input(&mesh, input).faults, []);
    assert_eq!(mesh.points[..input.points.len()], input.points, "input vertices come first");
    assert!(mesh.points.iter().all(|p| p.is_finite()), "a vertex is not finite");
    (mesh, report)
}
