//! `Reset`.

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;
use crate::names::Names;
use crate::state::State;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Reset",
    arguments: "",
    summary: "removes triangles, contours and edges, and keeps the vertices",
    help: "The vertices of the drawing keep their indices; those that were inserted after 'Triangulate' or by a \
           refinement are gone.",
    parse: |_| Deed::edit(Reset),
};

struct Reset;

impl Act for Reset {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let before = work.state();
        let input = before.input.points_alone();
        let mut names = Names::default();
        let is_drawn = |v: usize| v < input.drawing.points.len();
        before.names.all().filter(|(_, v)| is_drawn(v.index())).for_each(|(name, v)| names.add(name, v));
        let options = before.options.clone();
        work.replace(State { input, names, options, ..State::default() });
        Ok(())
    }
}
