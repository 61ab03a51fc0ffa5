//! What the commands on one triangle's terminal edge share.

use trimalla::half_edge::{FaceId, HalfEdgeId, VertexId};
use trimalla::refine::{Centroid, LeppRule};
use trimalla::triangulation::Triangulation;

use crate::changes::Work;
use crate::error::CommandError;
use crate::state::State;

/// The face with three corners, given by their indices in any order.
pub(super) fn face(state: &State, corners: [u32; 3]) -> Result<FaceId, CommandError> {
    let Some(mesh) = &state.mesh else { return Err(CommandError::nothing_triangulated()) };
    let t = mesh.triangulation();
    let [a, b, c] = corners;
    let none = || CommandError::new(format!("there is no triangle {a} {b} {c}"));
    let vertices = [state.vertex(a)?, state.vertex(b)?, state.vertex(c)?];
    face_of(t, vertices).ok_or_else(none)
}

/// The real face with three corners.
pub(super) fn face_of(t: &Triangulation, [a, b, c]: [VertexId; 3]) -> Option<FaceId> {
    let h = edge_of(t, a, b)?;
    [h, t.twin(h)].into_iter().find(|&h| t.apex(h) == c && t.is_real(h.face())).map(HalfEdgeId::face)
}

/// The half-edge from one vertex to another, if both are in use and there is one.
pub(super) fn edge_of(t: &Triangulation, a: VertexId, b: VertexId) -> Option<HalfEdgeId> {
    (t.is_used(a) && t.is_used(b)).then(|| t.half_edge_between(a, b))?
}

/// Inserts the point that the terminal edge of a triangle stands for: the centroid of the two triangles there, or the
/// middle of the edge.
pub(super) fn insert(work: &mut Work<'_>, corners: [u32; 3], centroid: Option<Centroid>) -> Result<(), CommandError> {
    let f = face(work.state(), corners)?;
    let v = work.edit_delaunay(|cdt, log, _| {
        let path = cdt.lepp(f, LeppRule::StopAtBoundary);
        let no_room = || CommandError::new("rounding leaves no room for the point");
        cdt.lepp_insert_with(path.terminal_edge, centroid, log).ok_or_else(no_room)
    })?;
    let name = work.state().names.name(v).unwrap_or(v.0);
    let at = work.state().mesh.as_ref().map(|mesh| mesh.triangulation().point(v));
    work.say(at.map_or_else(String::new, |at| format!("vertex {name} at {at}")));
    Ok(())
}
