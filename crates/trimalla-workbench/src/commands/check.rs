//! `Check`.

use trimalla::half_edge::HalfEdgeId;

use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

/// So many faults are named.
const NAMED: usize = 10;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Check",
    arguments: "",
    summary: "proves the triangulation sound, and tells what fails the circle test",
    help: "A triangulation that is not sound fails the script; an edge that fails the circle test does not, as one may \
           flip by hand.",
    parse: |_| Deed::ask(Check),
};

struct Check;

impl Ask for Check {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let Some(t) = document.triangulation() else { return Err(CommandError::nothing_triangulated()) };
        let faults = t.check();
        if let Some(first) = faults.first() {
            return Err(CommandError::new(format!("{} faults, the first: {first}", faults.len())));
        }
        let fails = |h: &HalfEdgeId| !t.is_marked(*h) && !t.is_boundary_edge(*h) && t.fails_circle_test(*h);
        let failing: Vec<HalfEdgeId> = t.edges().filter(fails).collect();
        let mut say = |text: String| interface.message(MessageKind::Information, &text);
        match failing.len() {
            0 => say("sound, and constrained Delaunay".to_owned()),
            n => say(format!("sound; {n} edges fail the circle test")),
        }
        for &h in failing.iter().take(NAMED) {
            let [i, j] = [t.origin(h), t.dest(h)].map(|v| document.name(v));
            say(format!("  edge {i} {j} fails the circle test"));
        }
        Ok(())
    }
}
