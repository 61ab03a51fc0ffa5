//! The rule of what lies on a segment, in rationals and by brute force.
//!
//! Written from the words of the rule in `geometry::Strip`, by other formulas: a point is in the strip if the box
//! around it meets the line, which is found by where the line enters and leaves the box's range of x.

use std::collections::{BTreeMap, BTreeSet};

use dashu_ratio::RBig;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use super::delaunay::representatives;
use super::exact::{RPoint, on_open_segment, rational};

/// Last places that a vertex on a segment may be off it.
const PLACES: u32 = 16;
/// Last places that an input vertex may be off it, where segments cross.
const INPUT_PLACES: u32 = 12;

/// What is wrong with the chains of a drawing's segments, all of which lie inside the mesh.
///
/// `crossed` tells whether segments of the drawing cross, so that edges may be led through input vertices beside them.
///
/// # Complexity
/// The product of vertices and segments, in rationals: meant for some hundred vertices.
#[must_use]
pub fn chain_faults(mesh: &IndexedMesh, input: &Pslg, crossed: bool) -> Vec<String> {
    let first = representatives(&input.points);
    let mut joined: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for t in &mesh.triangles {
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            joined.entry(a).or_default().insert(b);
            joined.entry(b).or_default().insert(a);
        }
    }
    let used = |v: u32| joined.contains_key(&v);
    let mut faults = Vec::new();
    for (s, ends) in input.segments.iter().enumerate() {
        let [a, b] = ends.map(|v| first[v as usize]);
        if a == b || !used(a) || !used(b) {
            continue;
        }
        let line = Line::new([a, b].map(|v| mesh.points[v as usize]));
        let known = input.points.len() as u32;
        let is_exact = |v: u32| v < known && on_open_segment(mesh.points[v as usize], line.ends[0], line.ends[1]);
        let on = |v: u32| {
            let p = mesh.points[v as usize];
            is_exact(v) || if v < known { crossed && line.holds(p, INPUT_PLACES) } else { line.holds(p, PLACES) }
        };
        let along: BTreeMap<u32, RBig> = (0..mesh.points.len() as u32)
            .filter(|&v| used(v) && (v == a || v == b || on(v)))
            .map(|v| (v, line.along(mesh.points[v as usize])))
            .collect();
        let mut stops: Vec<u32> = along.keys().copied().filter(|&v| v == a || v == b || is_exact(v)).collect();
        stops.sort_by(|v, w| along[v].cmp(&along[w]));
        if stops.first() != Some(&a) || stops.last() != Some(&b) {
            faults.push(format!("segment {s}: its ends are not first and last"));
            continue;
        }
        for pair in stops.windows(2) {
            if !leads(&joined, &along, pair[0], pair[1]) {
                faults.push(format!("segment {s}: no chain from {} to {}", pair[0], pair[1]));
            }
        }
    }
    faults
}

/// Whether edges lead from one vertex to another, always strictly forward.
fn leads(joined: &BTreeMap<u32, BTreeSet<u32>>, along: &BTreeMap<u32, RBig>, from: u32, to: u32) -> bool {
    let (mut seen, mut open) = (BTreeSet::from([from]), vec![from]);
    while let Some(v) = open.pop() {
        for &w in &joined[&v] {
            if w == to {
                return true;
            }
            let ahead = along.get(&w).is_some_and(|t| *t > along[&v] && *t < along[&to]);
            if ahead && seen.insert(w) {
                open.push(w);
            }
        }
    }
    false
}

/// A segment in rationals.
struct Line {
    ends: [Point; 2],
    from: RPoint,
    along: RPoint,
}

impl Line {
    fn new(ends: [Point; 2]) -> Self {
        let [from, to] = ends.map(rational);
        let along = [&to[0] - &from[0], &to[1] - &from[1]];
        Self { ends, from, along }
    }

    /// How far along a point lies, times the squared length.
    fn along(&self, p: Point) -> RBig {
        let p = rational(p);
        (&p[0] - &self.from[0]) * &self.along[0] + (&p[1] - &self.from[1]) * &self.along[1]
    }

    /// Whether the line meets the box around a point.
    fn holds(&self, p: Point, places: u32) -> bool {
        let [a, b] = self.ends;
        let reach = |m: f64| {
            let place = RBig::try_from(f64::EPSILON).unwrap() * RBig::try_from(m).unwrap();
            place.max(RBig::try_from(f64::from_bits(1)).unwrap()) * RBig::from(places)
        };
        let (w, h) = (reach(a.x.abs().max(b.x.abs())), reach(a.y.abs().max(b.y.abs())));
        let [px, py] = rational(p);
        let (left, right) = (&px - &w - &self.from[0], &px + &w - &self.from[0]);
        if self.along[0] == RBig::ZERO {
            return left <= RBig::ZERO && right >= RBig::ZERO;
        }
        let slope = &self.along[1] / &self.along[0];
        let (one, two) = (&self.from[1] + left * &slope, &self.from[1] + right * &slope);
        let (low, high) = if one < two { (one, two) } else { (two, one) };
        low <= &py + &h && high >= py - h
    }
}
