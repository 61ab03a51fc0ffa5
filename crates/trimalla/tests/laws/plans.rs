//! The recursion beside a planned segment, told call by call, is the one by which the segment is inserted.

use std::collections::BTreeSet;

use trimalla::constrained::{
    ConstrainedDelaunay, ConstrainedTriangulation, Crossings, Filling, Recursion, SegmentPlan, Workspace,
};
use trimalla::geometry::{CircleSide, in_circle_perturbed};
use trimalla::half_edge::{NoJournal, VertexId};
use trimalla::triangulation::Triangulation;
use trimalla_testkit::generators::{PointSetKind, PslgKind, SplitMix64, point_set, pslg};

/// The triangles, by their corners in ascending order.
fn triangles(t: &Triangulation) -> BTreeSet<[VertexId; 3]> {
    t.real_faces().map(|f| sorted(t.face_vertices(f))).collect()
}

fn sorted(mut corners: [VertexId; 3]) -> [VertexId; 3] {
    corners.sort_unstable();
    corners
}

/// The triangles that a recursion makes, after a check of each call: its circle holds no vertex of the stretch, each
/// vertex that was best is inside the circle of the one before, and the stretches that are left are called for.
fn made(t: &Triangulation, side: &Recursion) -> Vec<[VertexId; 3]> {
    assert!(side.is_complete);
    assert_eq!(side.calls.len(), side.boundary.len() - 2, "one triangle for each vertex between the ends");
    let point = |i: usize| t.point(side.boundary[i]);
    let mut waiting = vec![0..=side.boundary.len() - 1];
    for call in &side.calls {
        assert_eq!(waiting.pop(), Some(call.stretch()), "the stretch that is next");
        let [a, b] = [call.first, call.last].map(point);
        assert_eq!(call.improved.last(), Some(&call.chosen));
        assert!(call.tried().contains(&call.chosen));
        for pair in call.improved.windows(2) {
            let [before, after] = [pair[0], pair[1]].map(point);
            assert_eq!(in_circle_perturbed(a, b, before, after), CircleSide::Inside, "a better corner");
        }
        for p in call.tried().map(point).filter(|&p| p != point(call.chosen) && p != a && p != b) {
            assert_ne!(in_circle_perturbed(a, b, point(call.chosen), p), CircleSide::Inside, "an empty circle");
        }
        // The first stretch is called for first.
        waiting.extend(call.left().into_iter().rev().filter(|stretch| stretch.end() - stretch.start() > 1));
    }
    assert!(waiting.is_empty());
    let corners = |i: [usize; 3]| sorted(i.map(|i| side.boundary[i]));
    side.calls.iter().map(|call| corners([call.first, call.last, call.chosen])).collect()
}

/// Compares the recursion of a plan with what its insertion does to a triangulation.
fn compare(t: &ConstrainedTriangulation, plan: &SegmentPlan, filling: Filling) -> usize {
    let [left, right] = t.plan_recursion(plan).expect("a plan of this triangulation");
    let (before, mut after) = (triangles(t), t.clone());
    let mut work = Workspace::default();
    work.set_filling(filling);
    after.edit(&mut work, &mut NoJournal).insert_segment(plan.from, plan.to, Crossings::Refuse).expect("a segment");
    let after = triangles(&after);
    let made: Vec<_> = [&left, &right].into_iter().flat_map(|side| made(t, side)).collect();
    assert_eq!(made.len(), plan.left.len() + plan.right.len());
    for triangle in &made {
        assert!(after.contains(triangle), "{triangle:?} is there after the insertion");
    }
    assert_eq!(before.difference(&after).count(), after.difference(&before).count());
    assert!(after.difference(&before).all(|triangle| made.contains(triangle)), "and no other is new");
    made.len()
}

#[test]
fn a_recursion_that_is_told_is_the_one_that_inserts() {
    let (mut longest, mut crossing) = (0, 0);
    let points = PointSetKind::ALL.into_iter().map(|kind| (point_set(kind, 150, 3), Vec::new()));
    let drawings = PslgKind::ALL.into_iter().map(|kind| pslg(kind, 150, 3)).map(|p| (p.points, p.segments));
    for (points, segments) in points.chain(drawings) {
        let Ok(t) = ConstrainedDelaunay::new(&points, &segments, Crossings::Split) else { continue };
        let mut random = SplitMix64::new(17);
        for round in 0..60 {
            let [from, to] = [(); 2].map(|()| VertexId::from_index(random.below(points.len())));
            let Some(plan) = t.plan_segment(from, to) else { continue };
            if plan.existing.is_some() {
                assert_eq!(t.plan_recursion(&plan), None, "nothing to do");
            } else if plan.constrained.is_empty() {
                let filling = if round % 2 == 0 { Filling::Recursive } else { Filling::Randomised };
                longest = longest.max(compare(&t, &plan, filling));
            } else {
                // What is in the way is to be told, too.
                let sides = t.plan_recursion(&plan).expect("a plan of this triangulation");
                assert!(sides.iter().all(|side| made(&t, side).len() == side.calls.len()));
                crossing += 1;
            }
        }
    }
    assert!(longest > 30 && crossing > 100, "the longest has {longest} triangles, {crossing} cross segments");
}

#[test]
fn a_plan_of_another_triangulation_is_refused() {
    let points = point_set(PointSetKind::ALL[0], 60, 1);
    let t = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).expect("points");
    let few = ConstrainedDelaunay::new(&points[..5], &[], Crossings::Refuse).expect("points");
    for to in 1..60 {
        let Some(plan) = t.plan_segment(VertexId(0), VertexId(to)).filter(|plan| plan.existing.is_none()) else {
            continue;
        };
        if plan.left.iter().chain(&plan.right).chain([&plan.from, &plan.to]).any(|v| v.index() >= 5) {
            assert_eq!(few.plan_recursion(&plan), None);
        }
    }
}
