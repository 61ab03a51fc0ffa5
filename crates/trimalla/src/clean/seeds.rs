//! Hole seeds that no outline encloses, or that lie in another hole.

use std::collections::BTreeSet;

use super::faces::Faces;
use super::fault::{Fault, FaultKind};
use super::graph::Graph;
use super::pieces::Pieces;
use crate::geometry::Point;

/// The faults of hole seeds, in their order.
pub(super) fn faults(graph: &Graph<'_>, faces: &Faces, pieces: &Pieces, holes: &[Point]) -> Vec<Fault> {
    let face_of: Vec<Option<u32>> = holes.iter().map(|&seed| faces.face_at(graph, pieces, seed)).collect();
    let holes_in: BTreeSet<u32> = face_of.iter().flatten().copied().collect();
    let mut faults = Vec::new();
    for (hole, (&seed, face)) in (0..).zip(holes.iter().zip(&face_of)) {
        let is_nested = face.and_then(|face| faces.parent_of(face)).is_some_and(|around| holes_in.contains(&around));
        let kind = match face {
            None => FaultKind::HoleOutside,
            Some(_) if is_nested => FaultKind::WrongNesting,
            Some(_) => continue,
        };
        faults.push(Fault { hole: Some(hole), ..Fault::new(kind, seed, 0.0) });
    }
    faults
}
