//! `Outer`.

use trimalla::half_edge::VertexId;

use super::{Act, CommandRow, Deed};
use crate::arguments::Arguments;
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Outer",
    arguments: "N I1 ... IN",
    summary: "gives the outer contour, counter-clockwise",
    help: "What lies outside is removed when the drawing is triangulated. It comes before 'Triangulate', and once.",
    parse: |arguments| Deed::edit(Outer { ring: ring(arguments)? }),
};

struct Outer {
    ring: Vec<u32>,
}

impl Act for Outer {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let ring = vertices(work, &self.ring)?;
        if work.state().input.outer.is_some() {
            return Err(CommandError::new("there is an outer contour already"));
        }
        work.set_outer(ring);
        Ok(())
    }
}

/// The vertices of a contour: how many, and their indices.
pub(super) fn ring(arguments: &mut Arguments<'_>) -> Result<Vec<u32>, CommandError> {
    let count = arguments.word("how many vertices the contour has")?;
    let n = crate::arguments::count_of(count, "how many vertices the contour has")?;
    if n < 3 {
        return Err(count.fault("a contour has three vertices at least"));
    }
    let mut ring = Vec::new();
    for _ in 0..n {
        ring.push(arguments.index()?);
    }
    Ok(ring)
}

/// The vertices of a contour that is given in time.
pub(super) fn vertices(work: &Work<'_>, ring: &[u32]) -> Result<Vec<VertexId>, CommandError> {
    if work.state().mesh.is_some() {
        return Err(CommandError::new("contours come before 'Triangulate'; 'Reset' goes back there"));
    }
    ring.iter().map(|&name| work.vertex(name)).collect()
}
