//! `Undo`.

use super::{CommandRow, Deed};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Undo",
    arguments: "[N]",
    summary: "takes the last command back, or the last N",
    help: "The document is exactly as it was before. Commands that only ask do not count.",
    parse: |arguments| Ok(Deed::Undo(arguments.count_or_one()?)),
};
