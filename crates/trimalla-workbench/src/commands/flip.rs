//! `Flip`.

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::edge_of;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Flip",
    arguments: "I J",
    summary: "replaces an edge by the other diagonal of its two triangles",
    help: "Whatever the circle test says; 'Check' tells what fails it then. Constrained edges stay, and so does an edge \
           whose two triangles do not form a strictly convex quadrilateral.",
    parse: |arguments| Deed::edit(Flip { ends: [arguments.index()?, arguments.index()?] }),
};

struct Flip {
    ends: [u32; 2],
}

impl Act for Flip {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let [i, j] = self.ends;
        let [a, b] = [work.vertex(i)?, work.vertex(j)?];
        work.edit(false, |edit, _| {
            let none = || CommandError::new(format!("there is no edge {i} {j}"));
            let h = edge_of(edit, a, b).ok_or_else(none)?;
            let stays = || CommandError::new(format!("edge {i} {j} is constrained, or its quadrilateral not convex"));
            edit.try_flip(h).map(|_| ()).ok_or_else(stays)
        })
    }
}
