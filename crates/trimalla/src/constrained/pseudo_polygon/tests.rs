//! Both fillings against each other, and against the definition.

use std::collections::BTreeMap;

use super::*;
use crate::half_edge::Side;

/// What lies across a side of a filled triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Across {
    /// Side `.1` of triangle `.0` of the same filling.
    Triangle(u32, u32),
    /// The rim between vertices `i` and `i + 1`.
    Rim(u32),
    /// The base.
    Base,
}

/// A triangle of a filling: positions in the list of vertices, counter-clockwise, and what lies
/// across the side from `vertices[k]` to `vertices[k + 1]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Filled {
    vertices: [u32; 3],
    across: [Across; 3],
}

/// The triangles of a patch one by one.
fn triangles(patch: &Patch) -> Vec<Filled> {
    let rims: BTreeMap<Side, u32> = patch.rim.iter().copied().zip(0..).collect();
    let across = |side: Side| match patch.across(side) {
        Side::BOUNDARY if side == patch.base => Across::Base,
        Side::BOUNDARY => Across::Rim(rims[&side]),
        other => Across::Triangle(other.triangle(), other.corner() as u32),
    };
    let triangle = |t: u32| Filled {
        vertices: patch.triangles[t as usize].corners,
        across: [0, 1, 2].map(|k| across(Side::new(t, k))),
    };
    (0..patch.len() as u32).map(triangle).collect()
}

fn fill_randomised(points: &[Point]) -> Option<Vec<Filled>> {
    let mut patch = Patch::default();
    randomised::fill(Boundary(points), &mut patch, &mut randomised::Room::default()).map(|_| triangles(&patch))
}

fn fill_recursive(points: &[Point]) -> Option<Vec<Filled>> {
    let mut patch = Patch::default();
    recursive::fill(Boundary(points), &mut patch, &mut recursive::Room::default(), &mut ()).map(|_| triangles(&patch))
}

/// The triangles as sorted positions, after checking that every side leads where it says.
fn sound(filled: &[Filled], n: u32) -> Vec<[u32; 3]> {
    assert_eq!(filled.len() as u32, n - 2, "number of triangles");
    let mut rims = vec![false; n as usize - 1];
    let mut base = false;
    for (i, t) in filled.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (t.vertices[k], t.vertices[(k + 1) % 3]);
            match t.across[k] {
                Across::Base => {
                    assert_eq!((a, b), (0, n - 1), "the base runs from first to last");
                    base = true;
                }
                Across::Rim(r) => {
                    assert_eq!((a, b), (r + 1, r), "rim {r} of triangle {i}");
                    assert!(!std::mem::replace(&mut rims[r as usize], true), "rim {r} once");
                }
                Across::Triangle(o, s) => {
                    let other = filled[o as usize];
                    assert_eq!(
                        (other.vertices[s as usize], other.vertices[(s as usize + 1) % 3]),
                        (b, a),
                        "neighbours agree"
                    );
                    assert_eq!(other.across[s as usize], Across::Triangle(i as u32, k as u32), "neighbours agree");
                }
            }
        }
    }
    assert!(base && rims.into_iter().all(|r| r), "every side of the boundary is met");
    let mut list: Vec<[u32; 3]> = filled
        .iter()
        .map(|t| {
            let mut v = t.vertices;
            v.sort_unstable();
            v
        })
        .collect();
    list.sort_unstable();
    list
}

#[test]
fn convex_chains_are_filled_alike() {
    for n in 3..60u32 {
        let points: Vec<Point> = (0..n)
            .map(|i| {
                let x = f64::from(i) / f64::from(n - 1);
                Point::new(x, x * (1.0 - x) * (1.0 + 0.3 * x))
            })
            .collect();
        let a = sound(&fill_randomised(&points).unwrap(), n);
        let b = sound(&fill_recursive(&points).unwrap(), n);
        assert_eq!(a, b, "{n} vertices");
    }
}

#[test]
fn a_long_convex_chain_is_filled() {
    let n = 100_000u32;
    let points: Vec<Point> = (0..n)
        .map(|i| {
            let x = f64::from(i) - f64::from(n) / 2.0;
            Point::new(x, 1e9 - x * x * 1e-3)
        })
        .enumerate()
        .map(|(i, p)| if i == 0 || i == n as usize - 1 { Point::new(p.x, 0.0) } else { p })
        .collect();
    assert_eq!(sound(&fill_randomised(&points).unwrap(), n).len(), n as usize - 2);
}

#[test]
fn jagged_chains_are_filled_counter_clockwise() {
    let mut state = 7u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 33) as u32) / f64::from(1u32 << 31)
    };
    for round in 0..500 {
        let n = 3 + round % 40;
        let mut points: Vec<Point> = (0..n).map(|i| Point::new(f64::from(i), 0.1 + unit())).collect();
        points[0].y = 0.0;
        points[n as usize - 1].y = 0.0;
        for filled in [fill_randomised(&points), fill_recursive(&points)].into_iter().flatten() {
            sound(&filled, n);
            assert!(filled.iter().all(|t| Boundary(&points).is_ccw(t.vertices)), "every triangle is counter-clockwise");
        }
    }
}
