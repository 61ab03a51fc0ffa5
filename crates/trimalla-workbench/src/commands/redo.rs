//! `Redo`.

use super::{CommandRow, Deed};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Redo",
    arguments: "[N]",
    summary: "does commands again that 'Undo' took back",
    help: "Until another command changes the document.",
    parse: |arguments| Ok(Deed::Redo(arguments.count_or_one()?)),
};
