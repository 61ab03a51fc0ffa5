//! Phase two of inserting a segment: the crossed faces away, others in their place.

use super::plan::SegmentPlan;
use super::pseudo_polygon::{Across, Filled, Filling, fill};
use crate::delaunay::Lawson;
use crate::geometry::Point;

use crate::mesh::{FaceId, HalfEdgeId, Journal, Side, VertexId};
use crate::triangulation::Triangulation;

/// One side of the segment: a pseudo-polygon and its filling.
struct Bank {
    /// Vertices from one end of the base to the other, the region on the left.
    vertices: Vec<VertexId>,
    /// For rim `i`: the inner half-edge from vertex `i + 1` to vertex `i`.
    rim: Vec<HalfEdgeId>,
    filled: Vec<Filled>,
}

/// Puts the planned edge into the triangulation, unmarked, and legalises around it.
///
/// Returns the half-edge from `plan.from` to `plan.to`; `None`, and nothing changed, where the plan crosses
/// constrained edges or is out of date.
pub(super) fn apply<J: Journal>(
    t: &mut Triangulation,
    plan: &SegmentPlan,
    mark: u32,
    filling: Filling,
    lawson: &mut Lawson,
    j: &mut J,
) -> Option<HalfEdgeId> {
    if let Some(h) = plan.existing {
        t.mesh.set_mark(h, mark, j);
        return Some(h);
    }
    if !plan.constrained.is_empty() {
        return None;
    }
    if let [crossed] = plan.crossed[..] {
        return flip_into_place(t, crossed, mark, lawson, j);
    }
    let left = bank(t, plan.from, &plan.left, plan.to, plan.left_rim.clone(), filling)?;
    let right_chain: Vec<VertexId> = plan.right.iter().rev().copied().collect();
    let right = bank(t, plan.to, &right_chain, plan.from, plan.right_rim.iter().rev().copied().collect(), filling)?;
    let faces = crossed_faces(t, plan);
    debug_assert_eq!(faces.len(), left.filled.len() + right.filled.len(), "a cavity keeps its number of faces");
    let base = replace_faces(t, &faces, &left, &right, j)?;
    t.mesh.set_mark(base, mark, j);
    for &f in &faces {
        for h in f.half_edges() {
            lawson.push(h);
        }
    }
    lawson.legalise_all(t, j);
    t.half_edge_between(plan.from, plan.to)
}

/// The segment that crosses a single edge is the other diagonal of its two faces.
///
/// ```text
///        l                    l
///       /|\                  / \        the segment runs inside both faces, so the quadrilateral is
///   from ─ ─ to     ──>  from ═══ to     strictly convex
///       \ /                  \ /
///        r                    r
/// ```
fn flip_into_place<J: Journal>(
    t: &mut Triangulation,
    crossed: HalfEdgeId,
    mark: u32,
    lawson: &mut Lawson,
    j: &mut J,
) -> Option<HalfEdgeId> {
    let h = t.mesh.flip(crossed, j);
    t.mesh.set_mark(h, mark, j);
    let o = t.twin(h);
    for side in [h.next(), h.prev(), o.next(), o.prev()] {
        lawson.push(side);
    }
    lawson.legalise_all(t, j);
    Some(h)
}

fn crossed_faces(t: &Triangulation, plan: &SegmentPlan) -> Vec<FaceId> {
    let first = plan.crossed.first().map(|h| h.face());
    first.into_iter().chain(plan.crossed.iter().map(|&h| t.twin(h).face())).collect()
}

fn bank(
    t: &Triangulation,
    first: VertexId,
    chain: &[VertexId],
    last: VertexId,
    rim: Vec<HalfEdgeId>,
    filling: Filling,
) -> Option<Bank> {
    let mut vertices = Vec::with_capacity(chain.len() + 2);
    vertices.push(first);
    vertices.extend_from_slice(chain);
    vertices.push(last);
    let points: Vec<Point> = vertices.iter().map(|&v| t.point(v)).collect();
    let filled = fill(&points, filling)?;
    Some(Bank { vertices, rim, filled })
}

/// Writes both fillings into the slots of the crossed faces; returns the half-edge along the base.
fn replace_faces<J: Journal>(
    t: &mut Triangulation,
    faces: &[FaceId],
    left: &Bank,
    right: &Bank,
    j: &mut J,
) -> Option<HalfEdgeId> {
    let offset = [0, u32::try_from(left.filled.len()).ok()?];
    let banks = [left, right];
    let base = banks.map(|b| {
        b.filled.iter().enumerate().find_map(|(i, f)| f.across.iter().position(|&a| a == Across::Base).map(|k| (i, k)))
    });
    let [Some(left_base), Some(right_base)] = base else { return None };
    let at = |bank: usize, (i, k): (usize, usize)| (offset[bank] + i as u32, k as u32);
    let doubled = doubled_rims(t, faces, banks, offset);
    let mut vertices = Vec::with_capacity(faces.len());
    let mut sides = Vec::with_capacity(faces.len());
    for (b, bank) in banks.iter().enumerate() {
        for f in &bank.filled {
            vertices.push(f.vertices.map(|i| bank.vertices[i as usize]));
            sides.push(f.across.map(|a| match a {
                Across::Triangle(i, k) => Side::New(offset[b] + i, k),
                Across::Base => {
                    let (i, k) = if b == 0 { at(1, right_base) } else { at(0, left_base) };
                    Side::New(i, k)
                }
                Across::Rim(i) => {
                    let inner = bank.rim[i as usize];
                    let outer = t.twin(inner);
                    match doubled.binary_search_by_key(&outer, |&(h, ..)| h) {
                        Ok(k) => Side::Doubled(doubled[k].1, doubled[k].2, t.mark(inner)),
                        Err(_) => Side::Rim(outer, t.mark(inner)),
                    }
                }
            }));
        }
    }
    t.mesh.refill(faces, &vertices, &sides, j);
    Some(faces[left_base.0].half_edge(left_base.1 as u32))
}

/// Where each inner half-edge of the rim went, sorted; empty where no edge dangles into the cavity.
///
/// An edge that dangles, alone or with others at its end, has the cavity on both sides: its two rims face each other.
fn doubled_rims(
    t: &Triangulation,
    faces: &[FaceId],
    banks: [&Bank; 2],
    offset: [u32; 2],
) -> Vec<(HalfEdgeId, u32, u32)> {
    let mut cavity = faces.to_vec();
    cavity.sort_unstable();
    let dangles = |&inner: &HalfEdgeId| cavity.binary_search(&t.twin(inner).face()).is_ok();
    let mut found = Vec::new();
    if !banks.iter().any(|bank| bank.rim.iter().any(dangles)) {
        return found;
    }
    for (bank, offset) in banks.into_iter().zip(offset) {
        for (i, f) in bank.filled.iter().enumerate() {
            for (k, a) in f.across.iter().enumerate() {
                if let Across::Rim(r) = a {
                    found.push((bank.rim[*r as usize], offset + i as u32, k as u32));
                }
            }
        }
    }
    found.sort_unstable();
    found
}
