//! A thousand random point sets: every algorithm gives the one Delaunay triangulation.
//!
//! 1. All kinds of hostile set that the testkit knows, from no point to some hundreds, and some of
//!    ten thousand: the algorithms agree and the checker is silent.
//! 2. Small sets: the result is what the definition says, by brute force.
//! 3. The order of the points does not matter: those of a shuffled set, renamed, are the same.

use std::collections::BTreeSet;

use crate::common::agreement::{agreed, algorithms, renamed};
use crate::common::alike::{alike, same};
use crate::common::verdict::{Verdict, demand};
use trimalla::delaunay::AlgorithmKey;
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};
use trimalla_testkit::oracles::{brute_force_delaunay, representatives};

/// How many sets there are.
const SETS: usize = 1000;
/// Sizes asked for, one a round over all kinds; the last one for all further rounds is drawn.
const SIZES: [usize; 12] = [0, 1, 2, 3, 4, 5, 7, 10, 14, 19, 24, 400];
/// Up to this many points, brute force has the last word.
const SMALL: usize = 24;
/// Size of the large sets.
const LARGE: usize = 10_000;
/// The kinds of the large sets.
const LARGE_KINDS: [PointSetKind; 12] = [
    PointSetKind::Uniform,
    PointSetKind::GaussianClusters,
    PointSetKind::IntegerGrid,
    PointSetKind::TenthGrid,
    PointSetKind::RotatedGrid,
    PointSetKind::UtmGrid,
    PointSetKind::RoundedCircle,
    PointSetKind::Hub,
    PointSetKind::Duplicates,
    PointSetKind::ModerateExponents,
    PointSetKind::Parabola,
    PointSetKind::RandomWalk,
];

#[test]
fn a_thousand_sets_have_one_triangulation_each() {
    let mut kinds = BTreeSet::new();
    for i in 0..SETS {
        let kind = PointSetKind::ALL[i % PointSetKind::ALL.len()];
        let mut random = SplitMix64::new(i as u64);
        let size = match SIZES.get(i / PointSetKind::ALL.len()) {
            Some(&size) => size,
            None => 25 + random.below(275),
        };
        let points = point_set(kind, size, random.next_u64());
        kinds.insert(kind.key());
        demand(&format!("{kind:?}, set {i}"), &points, |p| judge(p, i as u64));
    }
    assert_eq!(kinds.len(), PointSetKind::ALL.len(), "every kind had its turn");
}

#[test]
fn ten_thousand_points_have_one_triangulation() {
    for kind in LARGE_KINDS {
        let points = point_set(kind, LARGE, 1);
        demand(&format!("{kind:?}, large"), &points, |p| judge(p, 2));
    }
}

/// Claims 1 to 3 of one set.
fn judge(points: &[Point], seed: u64) -> Verdict {
    let built = agreed(points)?;
    same("representatives", &stand_ins(&built, points.len()), &representatives(points))?;
    if points.len() <= SMALL {
        let brute = brute_force_delaunay(points);
        same("brute force", &renamed(&built.canonical(), |v| v.0), &brute)?;
    }
    algorithms(points.len()).try_for_each(|key| shuffled_alike(key, &built, points, seed))
}

/// For each point the vertex that stands for it.
fn stand_ins(built: &trimalla::triangulation::Triangulation, points: usize) -> Vec<u32> {
    let ids = (0..points).map(VertexId::from_index);
    ids.map(|v| built.representative(v).0).collect()
}

/// Claim 3: the points in another order give the same triangles, under their old names.
fn shuffled_alike(
    key: AlgorithmKey,
    built: &trimalla::triangulation::Triangulation,
    points: &[Point],
    seed: u64,
) -> Verdict {
    let mut order: Vec<VertexId> = (0..points.len()).map(VertexId::from_index).collect();
    SplitMix64::new(seed).shuffle(&mut order);
    let shuffled: Vec<Point> = order.iter().map(|v| points[v.index()]).collect();
    let other = key.triangulate(&shuffled, None).map_err(|e| e.to_string())?;
    // Of equal points the first in the list stands for all: which one that is depends on the order.
    let old_name = |v: VertexId| built.representative(order[v.index()]).0;
    let (ours, theirs) = (renamed(&built.canonical(), |v| v.0), renamed(&other.canonical(), old_name));
    same("triangles after a shuffle", &ours, &theirs)?;
    let again = key.triangulate(&shuffled, None).map_err(|e| e.to_string())?;
    alike(&other, &again)
}
