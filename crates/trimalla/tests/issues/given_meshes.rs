//! Meshes that are refined as they were given: the circle test need not hold in them.

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{IndexedMesh, Pslg, SegmentId};
use trimalla::geometry::Point;
use trimalla::quality::against_input;
use trimalla::refine::{Initial, Insert, Limits, NoObserver, Recipe, Recover, RefineOptions, Refinement, Select};
use trimalla::refine_mesh;
use trimalla::triangulation::check_mesh;
use trimalla_testkit::generators::SplitMix64;

use super::issue;

/// The mesh of the hull of a drawing, so many vertices inserted in that way.
fn mesh_of(drawing: &Pslg, insert: Insert, more: usize) -> Option<IndexedMesh> {
    let (cdt, _) = build(drawing, DomainRule::Hull, Crossings::Split, AlgorithmKey::default()).ok()?;
    let recipe = Recipe { insert, select: Select::First, ..Recipe::default() };
    let limits = Limits { max_vertices: drawing.points.len() + more, ..Limits::default() };
    let options = RefineOptions { recipe, limits, ..RefineOptions::default() };
    let mut refinement = Refinement::new(cdt, options).expect("good options");
    refinement.run(&mut NoObserver);
    Some(refinement.finish().0.to_indexed(drawing))
}

/// Refines a mesh as it was given, by several recipes; how many vertices were deleted.
fn refine_as_given(mesh: &IndexedMesh, drawing: &Pslg, room: usize) -> u64 {
    let mut deleted = 0;
    for select in [Select::First, Select::default()] {
        for insert in [Insert::Flip, Insert::Cavity] {
            for input in [None, Some(drawing)] {
                let recipe = Recipe { initial: Initial::Given, select, insert, ..Recipe::default() };
                let limits = Limits { max_vertices: mesh.points.len() + room, ..Limits::default() };
                let options = RefineOptions { recipe, limits, ..RefineOptions::default() }.with_min_angle_deg(20.0);
                let made = refine_mesh(mesh, input, &options).expect("a mesh of our own");
                assert_eq!(check_mesh(&made.mesh), []);
                deleted += made.report.vertices_deleted;
            }
        }
    }
    deleted
}

#[test]
fn deleting_a_vertex_from_a_given_mesh_asks_no_triangle_at_infinity() {
    let drawing = issue("free-vertex-deleted-from-a-given-mesh");
    for more in 0..30 {
        let mesh = mesh_of(&drawing, Insert::Partition, more).expect("a domain");
        for room in [10, 60] {
            refine_as_given(&mesh, &drawing, room);
        }
    }
}

#[test]
fn vertices_are_deleted_from_random_meshes_that_are_not_delaunay() {
    let mut deleted = 0;
    for seed in 0..60 {
        let mut rng = SplitMix64::new(seed);
        let points = (0..3 + rng.below(7)).map(|_| Point::new(rng.below(40) as f64, rng.below(40) as f64)).collect();
        let drawing = Pslg { points, ..Pslg::default() };
        if let Some(mesh) = mesh_of(&drawing, Insert::Partition, 12) {
            deleted += refine_as_given(&mesh, &drawing, 30);
        }
    }
    assert!(deleted > 100, "only {deleted} vertices were deleted");
}

#[test]
fn segments_let_go_that_share_edges_with_a_neighbour_are_reported_missing() {
    let drawing = issue("edge-of-a-neighbour-let-go");
    let mut lost = 0;
    for more in 0..30 {
        let mesh = mesh_of(&drawing, Insert::Flip, more).expect("a domain");
        for room in 0..30 {
            let recipe = Recipe { recover: Recover::None, ..Recipe::default() };
            let limits = Limits { max_vertices: mesh.points.len() + room, ..Limits::default() };
            let options = RefineOptions { recipe, limits, ..RefineOptions::default() };
            let made = refine_mesh(&mesh, Some(&drawing), &options).expect("a mesh of our own");
            let is_kept = |s: &usize| !made.report.lost_segments.contains(&SegmentId::from_index(*s));
            let kept = (0..drawing.segments.len()).filter(is_kept).map(|s| drawing.segments[s]).collect();
            let kept = Pslg { segments: kept, ..drawing.clone() };
            assert_eq!(against_input(&made.mesh, &kept).faults, [], "{more} more, room for {room}");
            lost += made.report.lost_segments.len();
        }
    }
    assert!(lost > 0, "nothing was lost");
}

/// A finished mesh is read again with its drawing, and gets no vertex.
fn comes_back(name: &str, rule: DomainRule) {
    let drawing = issue(name);
    for degrees in [15.0, 20.0, 22.0, 25.0, 28.0] {
        let (cdt, _) = build(&drawing, rule, Crossings::Split, AlgorithmKey::default()).expect("a domain");
        let options = RefineOptions::default().with_min_angle_deg(degrees);
        let mut refinement = Refinement::new(cdt, options).expect("good options");
        refinement.run(&mut NoObserver);
        let mesh = refinement.finish().0.to_indexed(&drawing);
        let again = refine_mesh(&mesh, Some(&drawing), &options).expect("a mesh of our own");
        assert_eq!(again.mesh.points.len(), mesh.points.len(), "{name}, {degrees} degrees");
    }
}

#[test]
fn a_split_beside_a_gap_is_tried_where_it_was_found() {
    comes_back("split-refused-after-vertices-came-back", DomainRule::Hull);
}

#[test]
fn edges_of_two_segments_within_rounding_are_told_apart() {
    comes_back("edges-of-two-segments-read-as-of-both", DomainRule::Seeds);
}
