//! Small constrained triangulations, made by hand and at random.

use super::*;
use crate::delaunay::{BuildError, Delaunay, Inserted, limit_of_test};
use crate::drawing::SegmentId;
use crate::geometry::Point;
use crate::half_edge::{HalfEdgeId, NoJournal, UndoLog, VertexId};

struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    #[allow(clippy::cast_precision_loss, reason = "small")]
    fn point(&mut self, round: u64) -> Point {
        let scale = [1.0, 0.1, 1.0 / 3.0][(round % 3) as usize];
        Point::new(self.below(8) as f64 * scale, self.below(8) as f64 * scale)
    }
}

fn soup(round: u64, points: u64, segments: u64) -> (Vec<Point>, Vec<[u32; 2]>) {
    let mut r = Random(round);
    let list = (0..points).map(|_| r.point(round)).collect();
    (list, (0..segments).map(|_| [r.below(points) as u32, r.below(points) as u32]).collect())
}

/// Every segment that is not a point is a chain from its start to its end.
fn assert_chains(cdt: &ConstrainedDelaunay) {
    for (i, &[a, b]) in cdt.segments().iter().enumerate() {
        let chain = cdt.chain(SegmentId::from_index(i));
        let end = chain.last().map_or(a, |&h| cdt.dest(h));
        assert_eq!(end, b, "segment {i} is a chain to its end");
    }
}

#[test]
fn soups_split_at_their_crossings() {
    for round in 0..1500 {
        let (points, segments) = soup(round, 3 + round % 20, round % 12);
        let cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Split).unwrap();
        assert_eq!(cdt.check(), [], "round {round}");
        assert_chains(&cdt);
        let pairs = crossing_pairs(&points, &segments);
        match ConstrainedDelaunay::new(&points, &segments, Crossings::Refuse) {
            Ok(refusing) => {
                assert_eq!(pairs, [], "round {round}: nothing crosses");
                assert_eq!(refusing.canonical(), cdt.canonical(), "round {round}");
            }
            Err(ConstraintError::Crossing(found)) => assert_eq!(found, pairs, "round {round}"),
            Err(e) => panic!("round {round}: {e}"),
        }
    }
}

#[test]
fn the_order_of_segments_does_not_matter() {
    for round in 0..600 {
        let (points, segments) = soup(round, 20, 10);
        let mut kept: Vec<[u32; 2]> = Vec::new();
        for s in segments {
            kept.push(s);
            if !crossing_pairs(&points, &kept).is_empty() {
                kept.pop();
            }
        }
        let a = ConstrainedDelaunay::new(&points, &kept, Crossings::Refuse).unwrap();
        kept.reverse();
        let b = ConstrainedDelaunay::new(&points, &kept, Crossings::Refuse).unwrap();
        assert_eq!(a.canonical(), b.canonical(), "round {round}");
        let mut c = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).unwrap();
        c.set_filling(Filling::Recursive);
        c.insert_segments(&kept, Crossings::Refuse).unwrap();
        assert_eq!(a.canonical(), c.canonical(), "round {round}: both fillings agree");
    }
}

#[test]
fn removing_every_segment_gives_the_delaunay_triangulation() {
    for round in 0..600 {
        let (points, segments) = soup(round, 18, 8);
        let mut cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Split).unwrap();
        for i in cdt.segment_ids() {
            cdt.remove_segment(i);
            assert_eq!(cdt.check(), [], "round {round}");
        }
        assert!(cdt.edges().all(|h| !cdt.is_marked(h)), "no constraint is left");
    }
}

#[test]
fn overlaps_keep_every_name() {
    let points: Vec<Point> = (0..5).map(|i| Point::new(f64::from(i), 0.0)).chain([Point::new(2.0, 3.0)]).collect();
    let cdt = ConstrainedDelaunay::new(&points, &[[0, 3], [1, 4], [2, 1]], Crossings::Refuse).unwrap();
    let h = cdt.half_edge_between(VertexId(1), VertexId(2)).unwrap();
    assert_eq!(cdt.segments_of(h), [0, 1, 2].map(SegmentId));
    assert_eq!(cdt.chain(SegmentId(1)).len(), 3);
    assert_chains(&cdt);
}

#[test]
fn a_plan_lists_what_is_crossed() {
    let points: Vec<Point> =
        [[0.0, 0.0], [10.0, 0.0], [3.0, 1.0], [6.0, 1.0], [3.0, -1.0], [6.0, -1.0]].map(Point::from).to_vec();
    let cdt = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).unwrap();
    let plan = cdt.plan_segment(VertexId(0), VertexId(1)).unwrap();
    assert_eq!(plan.left, [VertexId(2), VertexId(3)]);
    assert_eq!(plan.right, [VertexId(4), VertexId(5)]);
    assert_eq!(plan.crossed.len(), 3);
    assert_eq!(plan.to, VertexId(1));
}

#[test]
fn edits_roll_back_exactly() {
    for round in 0..250u64 {
        let mut r = Random(round);
        let (points, _) = soup(round, 12, 0);
        let mut cdt = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).unwrap();
        let mut log = UndoLog::new();
        let mut states = vec![(log.checkpoint(), cdt.clone())];
        for _ in 0..40 {
            let used: Vec<VertexId> = cdt.used_vertices().collect();
            let mut pick = || used[r.below(used.len() as u64) as usize];
            let (a, b) = (pick(), pick());
            match r.below(8) {
                0 | 1 => drop(cdt.insert_segment_with(a, b, Crossings::Split, &mut log)),
                2 => drop(cdt.insert_segment_with(a, b, Crossings::Refuse, &mut log)),
                3 => drop(cdt.insert_with(r.point(round), &mut log)),
                4 => drop(cdt.remove_with(a, &mut log)),
                5 => drop(cdt.merge_subsegments(a, &mut log)),
                6 => {
                    let n = cdt.segments().len() as u64;
                    if n > 0 {
                        cdt.remove_segment_with(SegmentId(r.below(n) as u32), &mut log);
                    }
                }
                _ => {
                    let keep = 1 + r.below(states.len() as u64) as usize;
                    states.truncate(keep);
                    let (at, state) = states.last().unwrap();
                    cdt.rollback(&mut log, *at);
                    assert!(cdt == *state, "round {round}: rollback restored the arrays");
                }
            }
            assert_eq!(cdt.check(), [], "round {round}");
            states.push((log.checkpoint(), cdt.clone()));
        }
    }
}

#[test]
fn triangulations_become_delaunay_in_slices_of_any_size() {
    for round in 0..100u64 {
        let mut r = Random(round);
        let (points, segments) = soup(round, 30, 4);
        let cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Split).unwrap();
        let mut t = ConstrainedTriangulation::from(cdt.clone());
        let mut work = Workspace::default();
        let mut flips = 0;
        for _ in 0..60 {
            let h = HalfEdgeId(r.below(3 * t.face_slots() as u64) as u32);
            flips += usize::from(t.edit(&mut work, &mut NoJournal).try_flip(h).is_some());
        }
        assert!(flips > 0 || t.dimension() < 2, "round {round}: something is not Delaunay");
        let mut legalising = Legalising::new(t.clone());
        let slice = 1 + round as usize % 40;
        let slices = (0..10_000).take_while(|_| legalising.advance(slice)).count();
        assert!(slices < 10_000, "round {round}: it ends");
        let legal = legalising.finish();
        assert_eq!(legal.check(), [], "round {round}");
        assert_eq!(legal.canonical(), cdt.canonical(), "round {round}");
        assert_eq!(ConstrainedDelaunay::from(t).canonical(), cdt.canonical(), "round {round}");
    }
}

/// G07 of the catalogue: just under and over the indices of half-edges, by a limit that a test can meet.
#[test]
fn g07_more_vertices_than_half_edges_can_name_are_an_error() {
    let cross: Vec<Point> = [[0.0, 0.0], [4.0, 4.0], [0.0, 4.0], [4.0, 0.0]].map(Point::from).to_vec();
    let too_many = |points| BuildError::TooManyPoints(points);
    limit_of_test::with(5, || {
        let mut cdt = ConstrainedDelaunay::new(&cross, &[[0, 1], [2, 3]], Crossings::Split).unwrap();
        assert_eq!(cdt.points().len(), 5, "four points and the crossing just fit");
        let before = cdt.clone();
        assert_eq!(cdt.insert(Point::new(1.0, 2.0)), Err(too_many(6)));
        assert_eq!(cdt.insert(Point::new(2.0, 2.0)), Ok(Inserted::Existing(VertexId(4))), "no vertex is needed");
        assert!(cdt == before);
        let mut delaunay = Delaunay::new(&before.points()[..5]).unwrap();
        assert_eq!(delaunay.insert(Point::new(1.0, 2.0)), Err(too_many(6)));
        assert_eq!(Delaunay::new(&[cross.clone(), cross.clone()].concat()).err(), Some(too_many(8)));
    });
    limit_of_test::with(4, || {
        let refused = ConstrainedDelaunay::new(&cross, &[[0, 1], [2, 3]], Crossings::Split);
        assert_eq!(refused.err(), Some(too_many(5).into()));
        let mut cdt = ConstrainedDelaunay::new(&cross, &[[0, 1]], Crossings::Refuse).unwrap();
        let before = cdt.clone();
        let refused = cdt.insert_segment(VertexId(2), VertexId(3), Crossings::Split);
        assert_eq!(refused, Err(too_many(5).into()));
        assert!(cdt == before, "nothing has changed");
    });
    assert!(6 * (BuildError::MAX_POINTS + 1) < u32::MAX as usize, "each vertex brings six half-edges");
}
