//! What stands in for faces that the budget does not cover: the constrained Delaunay triangulation, made lighter by
//! flips.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::lengths::Lengths;
use super::walks::{Plane, Start};
use crate::constrained::{ConstrainedDelaunay, Crossings};
use crate::geometry::{Point, segments_cross_properly};
use crate::half_edge::{EdgeKey, VertexId};

/// Triangles of the faces with these walks, all of whose sides are among the fixed edges; none if they do not fit
/// together, which would be a fault of ours.
pub(super) fn triangulate(plane: &Plane<'_>, fixed: &[[u32; 2]], starts: &[Start]) -> Option<Vec<[u32; 3]>> {
    let made = ConstrainedDelaunay::new(plane.points, fixed, Crossings::Refuse).ok()?;
    let mut fixed: Vec<EdgeKey<u32>> = fixed.iter().copied().map(EdgeKey::of).collect();
    fixed.sort_unstable();
    let mut is_met = vec![false; made.face_slots()];
    let mut open = Vec::new();
    for &start in starts {
        let Start::Half(first) = start else { continue };
        let mut h = first;
        loop {
            let ends = [plane.fans.from(h), plane.fans.to[h as usize]].map(VertexId);
            open.push(made.half_edge_between(ends[0], ends[1])?.face());
            h = plane.next_along(h);
            if h == first {
                break;
            }
        }
    }
    let mut triangles = Vec::new();
    while let Some(face) = open.pop() {
        if made.is_ghost(face) {
            return None;
        }
        if std::mem::replace(&mut is_met[face.index()], true) {
            continue;
        }
        let corners = made.face_vertices(face).map(|v| v.0);
        triangles.push(corners);
        for i in 0..3 {
            let (a, b) = (corners[i], corners[(i + 1) % 3]);
            if fixed.binary_search(&EdgeKey::of([a, b])).is_err() {
                open.push(made.half_edge_between(VertexId(b), VertexId(a))?.face());
            }
        }
    }
    Some(triangles)
}

/// Flips inner edges of triangles that are longer than the other diagonal, for so many rounds at most.
pub(super) fn flip_to_shorter(points: &[Point], lengths: &Lengths<'_>, triangles: &mut [[u32; 3]], rounds: usize) {
    for _ in 0..rounds {
        let mut sides: BTreeMap<[u32; 2], (usize, u32)> = BTreeMap::new();
        for (t, &[a, b, c]) in triangles.iter().enumerate() {
            for [from, to, apex] in [[a, b, c], [b, c, a], [c, a, b]] {
                sides.insert([from, to], (t, apex));
            }
        }
        let mut is_changed = vec![false; triangles.len()];
        let mut any = false;
        for (&[p, q], &(t, l)) in &sides {
            let Some(&(u, r)) = sides.get(&[q, p]).filter(|_| p < q) else { continue };
            let at = |v: u32| points[v as usize];
            let is_flipped = !is_changed[t]
                && !is_changed[u]
                && lengths.order([l, r], [p, q]) == Ordering::Less
                && segments_cross_properly(at(p), at(q), at(l), at(r));
            if is_flipped {
                (triangles[t], triangles[u]) = ([p, r, l], [q, l, r]);
                (is_changed[t], is_changed[u], any) = (true, true, true);
            }
        }
        if !any {
            return;
        }
    }
}
