//! What the commands on one triangle's terminal edge share.

use trimalla::refine::{Centroid, LeppRule};

use crate::changes::Work;
use crate::error::CommandError;

/// Inserts the point that the terminal edge of a triangle stands for: the centroid of the two triangles there, or the
/// middle of the edge.
pub(super) fn insert(work: &mut Work<'_>, corners: [u32; 3], centroid: Option<Centroid>) -> Result<(), CommandError> {
    let f = work.state().face(corners)?;
    let v = work.edit_delaunay(|cdt, log, _| {
        let path = cdt.lepp(f, LeppRule::StopAtBoundary);
        let no_room = || CommandError::new("rounding leaves no room for the point");
        cdt.lepp_insert_with(path.terminal_edge, centroid, log).ok_or_else(no_room)
    })?;
    let name = work.state().name(v);
    let at = work.state().mesh.as_ref().map(|mesh| mesh.triangulation().point(v));
    work.say(at.map_or_else(String::new, |at| format!("vertex {name} at {at}")));
    Ok(())
}
