//! `Insert`.

use trimalla::geometry::Point;

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Insert",
    arguments: "X Y",
    summary: "inserts a vertex, whose index is the next one",
    help: "As 'V' with the next index.",
    parse: |arguments| Deed::edit(Insert { at: arguments.point()? }),
};

struct Insert {
    at: Point,
}

impl Act for Insert {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let name = work.state().names.next();
        if work.state().mesh.is_none() {
            work.add_point(name, self.at);
            work.say(format!("vertex {name} at {}", self.at));
            return Ok(());
        }
        super::v::insert(work, self.at, name)
    }
}
