//! Triangulations of point sets.

use trimalla::geometry::Point;
use trimalla::optimal::{OptimalInput, OptimalMethod};
use trimalla::trace::NoTrace;
use trimalla_testkit::generators::{PointSetKind, point_set};

use super::enumerate;

/// Point sets of every kind, of at most `n` points.
fn sets(n: usize, seeds: u64) -> impl Iterator<Item = (String, Vec<Point>)> {
    let kinds = PointSetKind::ALL.into_iter();
    kinds.flat_map(move |kind| (0..seeds).map(move |seed| (format!("{kind:?} {n} {seed}"), point_set(kind, n, seed))))
}

#[test]
fn pairs_give_one_of_the_triangulations() {
    for n in [0, 3, 6, 8] {
        for (name, points) in sets(n, 2) {
            let made = OptimalMethod::Pairs.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
            let all = enumerate::triangulations(&points);
            assert!(all.contains(&made.triangles) || all.is_empty() && made.triangles.is_empty(), "{name}: {made:?}");
        }
    }
}
