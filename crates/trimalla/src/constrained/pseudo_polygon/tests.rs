//! Both fillings against each other, and against the definition.

use super::*;

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
    assert!(base && rims.into_iter().all(|r| r), "every side of the border is met");
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
        let a = sound(&randomised::fill(&points).unwrap(), n);
        let b = sound(&recursive::fill(&points).unwrap(), n);
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
    assert_eq!(sound(&randomised::fill(&points).unwrap(), n).len(), n as usize - 2);
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
        for filled in [randomised::fill(&points), recursive::fill(&points)].into_iter().flatten() {
            sound(&filled, n);
            assert!(filled.iter().all(|t| is_ccw(&points, t.vertices)), "every triangle is counter-clockwise");
        }
    }
}
