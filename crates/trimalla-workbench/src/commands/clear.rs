//! `Clear`.

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;
use crate::state::State;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Clear",
    arguments: "",
    summary: "removes everything",
    help: "Vertices, contours, edges, triangles, options and selection are gone. 'Undo' brings them back.",
    parse: |_| Deed::edit(Clear),
};

struct Clear;

impl Act for Clear {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        work.replace(State::default());
        Ok(())
    }
}
