//! `Inner`.

use super::outer::{ring, vertices};
use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Inner",
    arguments: "N I1 ... IN",
    summary: "gives the contour of a hole, clockwise",
    help: "What lies inside is removed when the drawing is triangulated. It comes before 'Triangulate', with an outer \
           contour or without: then the holes are in the convex hull.",
    parse: |arguments| Deed::edit(Inner { ring: ring(arguments)? }),
};

struct Inner {
    ring: Vec<u32>,
}

impl Act for Inner {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let ring = vertices(work, &self.ring)?;
        work.add_inner(ring);
        Ok(())
    }
}
