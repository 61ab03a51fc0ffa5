//! `Move`.

use trimalla::delaunay::Inserted;
use trimalla::geometry::Point;

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Move",
    arguments: "I X Y",
    summary: "moves a vertex of the triangulation, with the edges that end there",
    help: "Constrained edges on which it lies stay where they are. Where another vertex lies already, nothing moves.",
    parse: |arguments| Deed::edit(Move { name: arguments.index()?, to: arguments.point()? }),
};

struct Move {
    name: u32,
    to: Point,
}

impl Act for Move {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let v = work.vertex(self.name)?;
        let moved = work
            .edit(true, |edit, _| edit.move_vertex(v, self.to).map_err(|error| CommandError::new(error.to_string())))?;
        match moved {
            Inserted::Existing(other) if other != v => {
                let other = work.state().name(other);
                Err(CommandError::new(format!("vertex {other} lies there already")))
            }
            _ => Ok(()),
        }
    }
}
