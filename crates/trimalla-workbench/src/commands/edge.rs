//! `Edge`.

use trimalla::constrained::Crossings;

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Edge",
    arguments: "I J",
    summary: "adds a constrained edge",
    help: "Before 'Triangulate' a segment joins the drawing. After it the edge is inserted; vertices exactly on it split \
           it, and where it crosses another one both are split. 'Plan' shows what it would cross.",
    parse: |arguments| Deed::edit(Edge { ends: [arguments.index()?, arguments.index()?] }),
};

struct Edge {
    ends: [u32; 2],
}

impl Act for Edge {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let [i, j] = self.ends;
        if i == j {
            return Err(CommandError::new(format!("an edge from vertex {i} to itself")));
        }
        let [a, b] = [work.vertex(i)?, work.vertex(j)?];
        if work.state().mesh.is_none() {
            work.add_segment([a, b]);
            return Ok(());
        }
        work.edit(true, |edit, _| {
            edit.insert_segment(a, b, Crossings::Split).map_err(|error| CommandError::new(error.to_string()))
        })?;
        Ok(())
    }
}
