//! What the commands on one triangle's terminal edge share.

use trimalla::refine::{Centroid, LeppRule, Ruler, lepp};

use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::face_of;

/// Inserts the point that the terminal edge of a triangle stands for: the centroid of the two triangles there, or the
/// middle of the edge.
pub(super) fn insert(work: &mut Work<'_>, corners: [u32; 3], centroid: Option<Centroid>) -> Result<(), CommandError> {
    let f = work.state().face(corners)?;
    let Some(mesh) = &work.state().mesh else { return Err(CommandError::nothing_triangulated()) };
    let vertices = mesh.triangulation().face_vertices(f);
    let v = work.edit_delaunay(|edit, _| {
        // One that was not Delaunay has become so, by flips.
        let flipped = || CommandError::new("the flips that the circle test asks for remove this triangle");
        let f = face_of(edit, vertices).ok_or_else(flipped)?;
        let ruler = Ruler::for_box(edit.bounding_box());
        let edge = lepp::terminal_edge(edit, ruler, f, LeppRule::StopAtBoundary);
        let no_room = || CommandError::new("rounding leaves no room for the point");
        edit.lepp_insert(ruler, edge, centroid).ok_or_else(no_room)
    })?;
    let name = work.state().name(v);
    let at = work.state().mesh.as_ref().map(|mesh| mesh.triangulation().point(v));
    work.say(at.map_or_else(String::new, |at| format!("vertex {name} at {at}")));
    Ok(())
}
