//! `Delete`.

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Delete",
    arguments: "I",
    summary: "removes a vertex from the triangulation, with the edges that end there",
    help: "Constrained edges on which it lies stay where they are. A vertex of the drawing keeps its index, unused.",
    parse: |arguments| Deed::edit(Delete { name: arguments.index()? }),
};

struct Delete {
    name: u32,
}

impl Act for Delete {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let v = work.vertex(self.name)?;
        work.edit(true, |edit, _| edit.remove_with_segments(v).map_err(|error| CommandError::new(error.to_string())))
    }
}
