//! `Move`.

use trimalla::delaunay::Inserted;
use trimalla::geometry::Point;

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Move",
    arguments: "I X Y",
    summary: "moves a vertex, with the edges that end there",
    help: "Before 'Triangulate' any point of the drawing. In a triangulation constrained edges stay where they are, and so \
           do vertices of the boundary. Where another vertex lies already, nothing moves.",
    parse: |arguments| Deed::edit(Move { name: arguments.index()?, to: arguments.point()? }),
};

struct Move {
    name: u32,
    to: Point,
}

impl Act for Move {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let v = work.vertex(self.name)?;
        if work.state().mesh.is_none() {
            work.move_point(v, self.to);
            return Ok(());
        }
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
