//! Both algorithms against each other, and edits against rebuilding.

use super::*;
use crate::geometry::Point;
use crate::half_edge::{UndoLog, VertexId};
use crate::locate::Locus;
use crate::triangulation::Triangulation;

/// A small generator of its own: `SplitMix64`.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    #[allow(clippy::cast_precision_loss, reason = "53 bits")]
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    #[allow(clippy::cast_precision_loss, reason = "small")]
    fn point(&mut self, kind: u64) -> Point {
        match kind % 5 {
            0 => Point::new(self.unit(), self.unit()),
            1 => Point::new(self.below(5) as f64, self.below(5) as f64),
            2 => Point::new(self.below(12) as f64 * 0.1, self.below(12) as f64 * 0.1),
            3 => Point::new(self.below(9) as f64, 0.5),
            _ => {
                let circle = [(3.0, 4.0), (4.0, 3.0), (5.0, 0.0), (0.0, 5.0)];
                let (x, y) = circle[self.below(4) as usize];
                Point::new(if self.below(2) == 0 { x } else { -x }, if self.below(2) == 0 { y } else { -y })
            }
        }
    }
}

fn assert_same(a: &Triangulation, b: &Triangulation, points: &[Point]) {
    assert_eq!(a.dimension(), b.dimension(), "dimension of {points:?}");
    assert_eq!(a.canonical(), b.canonical(), "triangles of {points:?}");
    assert_eq!(a.canonical_edges(), b.canonical_edges(), "edges of {points:?}");
    assert_eq!(a.duplicates(), b.duplicates(), "duplicates of {points:?}");
}

#[test]
fn both_algorithms_agree_on_small_hostile_sets() {
    let mut random = Random(1);
    for round in 0..4000 {
        let n = random.below(24);
        let points: Vec<Point> = (0..n).map(|_| random.point(round)).collect();
        let a = Incremental::triangulate(&points, None).unwrap();
        let b = DivideAndConquer::triangulate(&points, None).unwrap();
        assert_eq!(a.check_delaunay(), [], "incremental on {points:?}");
        assert_eq!(b.check_delaunay(), [], "divide and conquer on {points:?}");
        assert_same(&a, &b, &points);
    }
}

#[test]
fn both_algorithms_agree_on_larger_sets() {
    let mut random = Random(2);
    for kind in [0, 2, 4] {
        let points: Vec<Point> = (0..5000).map(|_| random.point(kind)).collect();
        let a = Incremental::triangulate(&points, None).unwrap();
        let b = DivideAndConquer::triangulate(&points, None).unwrap();
        assert_eq!(a.check_delaunay(), []);
        assert_same(&a, &b, &[]);
    }
}

#[test]
fn a_subset_is_triangulated_as_if_alone() {
    let mut random = Random(3);
    let points: Vec<Point> = (0..40).map(|_| random.point(1)).collect();
    let subset: Vec<VertexId> = (0..40).step_by(3).map(VertexId).collect();
    let a = Incremental::triangulate(&points, Some(&subset)).unwrap();
    let b = DivideAndConquer::triangulate(&points, Some(&subset)).unwrap();
    assert_eq!(a.check_delaunay(), []);
    assert_same(&a, &b, &points);
    assert!(a.used_vertices().all(|v| v.0 % 3 == 0), "only the subset is used");
}

#[test]
fn edits_agree_with_rebuilding_and_roll_back_exactly() {
    let mut random = Random(4);
    for round in 0..300 {
        let mut d = Delaunay::new(&[]).unwrap();
        let mut log = UndoLog::new();
        let mut states = vec![(log.checkpoint(), d.clone())];
        for _ in 0..60 {
            let used: Vec<VertexId> = d.used_vertices().collect();
            let p = random.point(round);
            let pick = |r: &mut Random| used[r.below(used.len() as u64) as usize];
            match random.below(10) {
                0..6 => drop(d.insert_with(p, &mut log).unwrap()),
                6..8 if !used.is_empty() => d.remove_with(pick(&mut random), &mut log).unwrap(),
                8 if !used.is_empty() => drop(d.move_vertex_with(pick(&mut random), p, &mut log).unwrap()),
                _ => {
                    let keep = 1 + random.below(states.len() as u64) as usize;
                    states.truncate(keep);
                    let (at, state) = states.last().unwrap();
                    d.rollback(&mut log, *at);
                    assert!(d == *state, "rollback restored the arrays");
                }
            }
            assert_eq!(d.check_delaunay(), [], "round {round}");
            states.push((log.checkpoint(), d.clone()));
        }
        let used: Vec<VertexId> = d.used_vertices().collect();
        let rebuilt = Incremental::triangulate(d.points(), Some(&used)).unwrap();
        assert_same(&rebuilt, &d, d.points());
    }
}

#[test]
fn every_point_is_located_where_it_is() {
    let points: Vec<Point> = (0..25u8).map(|i| Point::new(f64::from(i % 5), f64::from(i / 5))).collect();
    let d = Delaunay::new(&points).unwrap();
    for (i, &p) in points.iter().enumerate() {
        assert_eq!(d.locate(p), Locus::Vertex(VertexId::from_index(i)));
    }
    assert!(matches!(d.locate(Point::new(0.5, 0.0)), Locus::Edge(_)));
    assert!(matches!(d.locate(Point::new(0.25, 0.125)), Locus::Face(_)));
    assert!(matches!(d.locate(Point::new(-1.0, 2.0)), Locus::Outside(_)));
}

#[test]
fn infinite_and_missing_points_are_named() {
    let points = [Point::new(0.0, 0.0), Point::new(f64::NAN, 1.0)];
    assert!(matches!(Delaunay::new(&points), Err(BuildError::NotFinite { index: 1, .. })));
    let error = Delaunay::of_subset::<Incremental>(&points[..1], &[VertexId(4)]).unwrap_err();
    assert_eq!(error.to_string(), "vertex 4 does not exist: there are 1 points");
}

#[test]
fn an_algorithm_says_whether_it_tells_steps() {
    let points: Vec<Point> = (0..12).map(|i| Point::new(f64::from(i * i % 13), f64::from(i * 5 % 12))).collect();
    for key in AlgorithmKey::ALL {
        let mut steps: Vec<crate::trace::Step> = Vec::new();
        key.triangulate_traced(&points, None, &mut steps).expect("finite");
        assert_eq!(!steps.is_empty(), key.tells_steps(), "{}", key.key());
    }
}

#[test]
fn an_insertion_in_slices_is_the_incremental_algorithm() {
    let spread = |n: u32| (0..n).map(move |i| Point::new(f64::from(i * 7919 % 4001), f64::from(i * 104_729 % 3989)));
    let grid: Vec<Point> = (0..900).map(|i| Point::new(f64::from(i % 30), f64::from(i / 30))).collect();
    let line: Vec<Point> = (0..9).map(|i| Point::new(f64::from(i * 4 % 9), f64::from(i * 4 % 9))).collect();
    let twice: Vec<Point> = spread(600).chain(spread(300)).collect();
    for points in [vec![], vec![Point::new(1.0, 2.0)], line, grid, twice, spread(5000).collect()] {
        let whole = Delaunay::new(&points).expect("finite");
        for slice in [1, 7, 1000, usize::MAX] {
            let mut insertion = Insertion::new(&points).expect("finite");
            while insertion.advance(slice) {}
            assert!(insertion.into_delaunay() == whole, "{} points, {slice} at a time", points.len());
        }
        assert!(Insertion::new(&points).expect("finite").into_delaunay() == whole, "not advanced");
    }
    let refused = Insertion::new(&[Point::new(0.0, f64::NAN)]).expect_err("not finite");
    assert!(matches!(refused, BuildError::NotFinite { index: 0, .. }));
}
