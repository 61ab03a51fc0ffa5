//! `Midpoint`.

use super::{Act, CommandRow, Deed, terminal};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Midpoint",
    arguments: "I J K",
    summary: "inserts the middle of the terminal edge of a triangle",
    help: "The triangle is given by its vertices. A constrained terminal edge is halved; otherwise a constrained \
           second-longest edge of a terminal triangle is; otherwise the terminal edge.",
    parse: |arguments| Deed::edit(Midpoint { corners: arguments.triangle()? }),
};

struct Midpoint {
    corners: [u32; 3],
}

impl Act for Midpoint {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        terminal::insert(work, self.corners, None)
    }
}
