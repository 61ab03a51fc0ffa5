//! Random polygons of many kinds, and the check that triangles tile one.

use std::collections::BTreeMap;

use dashu_ratio::RBig;
use trimalla::Point;
use trimalla::geometry::{Orientation, math, on_segment, orient2d};
use trimalla::polygon::Polygon;
use trimalla_testkit::generators::SplitMix64;
use trimalla_testkit::oracles::{doubled_area, doubled_ring_area};

/// Points and ends of rings.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rings {
    pub(crate) points: Vec<Point>,
    pub(crate) ends: Vec<u32>,
}

impl Rings {
    pub(crate) fn add(&mut self, ring: impl IntoIterator<Item = (f64, f64)>) {
        self.points.extend(ring.into_iter().map(|(x, y)| Point::new(x, y)));
        self.ends.push(self.points.len() as u32);
    }

    pub(crate) fn of(ring: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let mut rings = Self::default();
        rings.add(ring);
        rings
    }

    pub(crate) fn polygon(&self) -> Polygon<'_> {
        Polygon::new(&self.points, &self.ends).expect("rings in order")
    }

    pub(crate) fn mapped(&self, map: impl Fn(Point) -> Point) -> Self {
        Self { points: self.points.iter().map(|&p| map(p)).collect(), ends: self.ends.clone() }
    }

    /// Twice the area of the outline less those of the holes.
    pub(crate) fn doubled_area(&self) -> RBig {
        let polygon = self.polygon();
        let size = |ring| {
            let area = doubled_ring_area(polygon.ring(ring).points);
            if area < RBig::ZERO { -area } else { area }
        };
        let mut areas = polygon.rings().map(size);
        let outline = areas.next().unwrap_or(RBig::ZERO);
        areas.fold(outline, |rest, hole| rest - hole)
    }
}

/// A generator of random polygons.
pub(crate) type Generator = fn(usize, &mut SplitMix64) -> Rings;

/// Polygons whose corners are all different and touch no other side: `n - 2 + 2h` triangles.
pub(crate) const GENERATORS: [(&str, Generator); 9] = [
    ("star", star),
    ("comb", comb),
    ("flat comb", flat_comb),
    ("spiral", spiral),
    ("staircase", staircase),
    ("orthogonal", orthogonal),
    ("needles", needles),
    ("near-degenerate", near_degenerate),
    ("holes", holes),
];

pub(crate) fn star(n: usize, rng: &mut SplitMix64) -> Rings {
    Rings::of((0..n.max(3)).map(|i| {
        let angle = (i as f64 + 0.8 * rng.unit()) * std::f64::consts::TAU / n.max(3) as f64;
        let radius = rng.range(0.1, 1.0);
        (radius * math::cos(angle), radius * math::sin(angle))
    }))
}

pub(crate) fn comb(n: usize, rng: &mut SplitMix64) -> Rings {
    let teeth = (n / 2).max(1);
    let mut ring = vec![(0.0, -1.0), (2.0 * teeth as f64, -1.0)];
    for i in (0..teeth).rev() {
        ring.push((2.0 * i as f64 + 1.0, rng.range(1.0, 9.0)));
        ring.push((2.0 * i as f64, rng.range(-0.9, 0.9)));
    }
    Rings::of(ring)
}

/// Teeth with horizontal and collinear sides.
pub(crate) fn flat_comb(n: usize, rng: &mut SplitMix64) -> Rings {
    let teeth = (n / 4).max(1);
    let mut ring = vec![(0.0, -1.0), (2.0 * teeth as f64, -1.0)];
    for i in (0..teeth).rev().map(|i| 2.0 * i as f64) {
        let top = 1.0 + rng.below(3) as f64;
        ring.extend([(i + 2.0, 0.0), (i + 1.0, 0.0), (i + 1.0, top), (i, top)]);
    }
    ring.push((0.0, 0.0));
    Rings::of(ring)
}

pub(crate) fn spiral(n: usize, _: &mut SplitMix64) -> Rings {
    let half = (n / 2).max(3);
    let at = |i: usize, width: f64| {
        let turn = 2.0 * (i as f64 + 4.0).sqrt();
        let radius = 0.4 * turn + width;
        (radius * math::cos(turn), radius * math::sin(turn))
    };
    Rings::of((0..half).map(|i| at(i, 1.0)).chain((0..half).rev().map(|i| at(i, 0.0))))
}

fn staircase(n: usize, _: &mut SplitMix64) -> Rings {
    let steps = (n / 2).max(1) as i32;
    let up = (0..steps).flat_map(|i| [(f64::from(i), f64::from(i)), (f64::from(i + 1), f64::from(i))]);
    Rings::of(up.chain([(f64::from(steps), f64::from(steps)), (0.0, f64::from(steps))]))
}

/// A skyline on both sides of an axis, with equal heights here and there.
pub(crate) fn orthogonal(n: usize, rng: &mut SplitMix64) -> Rings {
    let columns = (n / 4).max(1);
    let mut ring = Vec::new();
    let mut heights: Vec<(f64, f64)> = Vec::new();
    for _ in 0..columns {
        heights.push((1.0 + rng.below(4) as f64, -1.0 - rng.below(4) as f64));
    }
    for (x, (_, low)) in heights.iter().enumerate() {
        ring.extend([(x as f64, *low), (x as f64 + 1.0, *low)]);
    }
    for (x, (high, _)) in heights.iter().enumerate().rev() {
        ring.extend([(x as f64 + 1.0, *high), (x as f64, *high)]);
    }
    ring.dedup();
    Rings::of(ring)
}

fn needles(n: usize, _: &mut SplitMix64) -> Rings {
    let count = (n / 3).max(1);
    let mut ring = vec![(-1.0, -1.0), (count as f64, -1.0), (count as f64, 0.0)];
    for i in (0..count).rev().map(|i| i as f64) {
        ring.extend([(i + 1e-7, 0.0), (i, 1000.0), (i - 1e-7, 0.0)]);
    }
    ring.push((-1.0, 0.0));
    Rings::of(ring)
}

/// Points that are nearly on one line: a last place off.
fn near_degenerate(n: usize, rng: &mut SplitMix64) -> Rings {
    let off = |x: f64, rng: &mut SplitMix64| 0.1 * x + f64::EPSILON * (rng.below(3) as f64 - 1.0);
    let count = (n / 2).max(3);
    let mut ring: Vec<_> = (0..count).map(|i| (i as f64 / 8.0, off(i as f64 / 8.0, rng) - 1e-12)).collect();
    ring.extend((0..count).rev().map(|i| (i as f64 / 8.0, off(i as f64 / 8.0, rng) + 1e-12)));
    Rings::of(ring)
}

/// A box with holes in the squares of a grid.
pub(crate) fn holes(n: usize, rng: &mut SplitMix64) -> Rings {
    let side = ((n as f64 / 5.0).sqrt() as usize).max(1);
    let size = side as f64;
    let mut rings = Rings::of([(-0.5, -0.5), (size, -0.5), (size, size), (-0.5, size)]);
    for k in 0..side * side {
        let (x, y) = ((k % side) as f64, (k / side) as f64);
        let mut ring: Vec<_> =
            star(3 + rng.below(5), rng).points.iter().map(|p| (x + 0.4 * p.x, y + 0.4 * p.y)).collect();
        if rng.below(2) == 0 {
            ring.reverse();
        }
        rings.add(ring);
    }
    rings
}

/// Polygons whose rings touch each other and themselves, with repeated points: the number of triangles is not checked.
pub(crate) fn touching(rng: &mut SplitMix64) -> Rings {
    let mut rings = Rings::default();
    let (x, y) = (rng.below(3) as f64, rng.below(3) as f64);
    match rng.below(7) {
        // A hole that touches the outline in a vertex, and one that touches a side with a vertex.
        0 => {
            rings.add([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]);
            rings.add([(0.0, 0.0), (2.0, 4.0), (4.0, 2.0)]);
            rings.add([(8.0, 3.0 + x), (6.0, 5.0), (5.0 + y, 3.0)]);
        }
        // A hole that splits the domain.
        1 => {
            rings.add([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]);
            rings.add([(0.0, 0.0), (3.0, 5.0), (8.0, 8.0), (5.0, 3.0)]);
        }
        // An outline that touches itself from inside, and one of its sides.
        2 => rings.add([(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (4.0, 6.0), (1.0 + x, 0.0), (2.0, 6.0), (0.0, 6.0)]),
        // An outline that touches itself from outside.
        3 => {
            let outside = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (3.0, 5.0), (4.0, 4.0), (4.0, 2.0)];
            rings.add(outside.into_iter().chain([(2.0, 2.0), (2.0, 4.0), (3.0, 5.0), (0.0, 6.0)]));
        }
        // The same with a vertex on a side.
        4 => {
            let outside = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (5.0, 6.0), (3.0, 4.0), (5.0, 3.0), (5.0, 1.0)];
            rings.add(outside.into_iter().chain([(1.0, 1.0), (1.0, 3.0), (4.0, 5.0), (0.0, 6.0)]));
        }
        // Holes that touch each other, with repeated points.
        5 => {
            rings.add([(0.0, 0.0), (0.0, 0.0), (9.0, 0.0), (9.0, 4.0), (9.0, 9.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)]);
            rings.add([(1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0), (1.0, 2.0)]);
            rings.add([(3.0, 3.0), (5.0, 3.0), (5.0, 5.0), (3.0, 5.0), (3.0, 5.0)]);
            rings.add([(5.0, 4.0), (7.0, 3.0 + y), (7.0, 8.0)]);
        }
        // Holes in a ring that cut a part off.
        _ => {
            rings.add([(-1.0, -1.0), (9.0, -1.0), (9.0, 9.0), (-1.0, 9.0)]);
            rings.add([(1.0, 0.0), (7.0, 0.0), (7.0, 1.0), (1.0, 1.0)]);
            rings.add([(7.0, 1.0), (8.0, 1.0), (8.0, 7.0), (7.0, 7.0)]);
            rings.add([(7.0, 7.0), (7.0, 8.0), (1.0, 8.0), (1.0, 7.0)]);
            rings.add([(1.0, 1.0), (1.0, 7.0), (0.0, 7.0), (0.0, 1.0)]);
        }
    }
    if rng.below(2) == 0 {
        rings = rings.mapped(|p| Point::new(p.y, p.x));
    }
    if rng.below(2) == 0 {
        rings = rings.mapped(|p| Point::new(p.x + 2.0 * p.y, p.y - p.x));
    }
    rings
}

/// Checks that triangles tile a polygon: counter-clockwise, edge to edge, boundary edges on sides, all of the area.
pub(crate) fn check(rings: &Rings, triangles: &[[u32; 3]]) {
    let points = &rings.points;
    let mut sides_of: BTreeMap<[u64; 4], i32> = BTreeMap::new();
    for t in triangles {
        let corners = t.map(|v| points[v as usize]);
        assert_eq!(orient2d(corners[0], corners[1], corners[2]), Orientation::CounterClockwise, "{t:?} in {rings:?}");
        for k in 0..3 {
            let [a, b] = [corners[k], corners[(k + 1) % 3]];
            let bits = |v: f64| (v + 0.0).to_bits();
            assert!(sides_of.insert([a.x, a.y, b.x, b.y].map(bits), 0).is_none(), "an edge twice: {rings:?}");
        }
    }
    let polygon = rings.polygon();
    for key in sides_of.keys() {
        let [ax, ay, bx, by] = *key;
        if !sides_of.contains_key(&[bx, by, ax, ay]) {
            let [a, b] = [(ax, ay), (bx, by)].map(|(x, y)| Point::new(f64::from_bits(x), f64::from_bits(y)));
            let is_side = polygon
                .rings()
                .flat_map(|ring| polygon.ring(ring).sides().collect::<Vec<_>>())
                .any(|(p, q)| on_segment(p, q, a) && on_segment(p, q, b));
            assert!(is_side, "a boundary edge from {a} to {b} is no side of {rings:?}");
        }
    }
    assert_eq!(doubled_area(points, triangles), rings.doubled_area(), "{rings:?}");
}
