//! `V`.

use trimalla::delaunay::{BuildError, Inserted};
use trimalla::geometry::Point;

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "V",
    arguments: "INDEX X Y",
    summary: "adds a vertex",
    help: "Indices increase strictly, from 0. Before 'Triangulate' a point joins the drawing. After it the point is \
           inserted, and the triangulation stays constrained Delaunay; vertices that splits and refinement have added \
           have indices, too.",
    parse: |arguments| {
        let word = arguments.word("the index of a vertex")?;
        let index = crate::arguments::index_of(word)?;
        let (column, width) = (word.column, word.text.chars().count());
        Deed::edit(Vertex { index, at: arguments.point()?, place: (column, width) })
    },
};

struct Vertex {
    index: u32,
    at: Point,
    /// Where the index stands in the line.
    place: (usize, usize),
}

impl Act for Vertex {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let next = work.state().names.next();
        if self.index < next {
            let message = format!("the index must be above {}, the highest there is", next - 1);
            return Err(CommandError::at(self.place.0, self.place.1, message));
        }
        if work.state().mesh.is_none() {
            work.add_point(self.index, self.at);
            return Ok(());
        }
        insert(work, self.at, self.index)
    }
}

/// Inserts a point into the triangulation, under a name.
pub(super) fn insert(work: &mut Work<'_>, at: Point, name: u32) -> Result<(), CommandError> {
    let failed = |error: BuildError| CommandError::new(error.to_string());
    match work.insert(name, |edit| edit.insert(at).map_err(failed))? {
        Inserted::Existing(v) => {
            let other = work.state().name(v);
            work.say(format!("vertex {name} lies on vertex {other}, and stands for it"));
        }
        Inserted::New(_) => work.say(format!("vertex {name} at {at}")),
    }
    Ok(())
}
