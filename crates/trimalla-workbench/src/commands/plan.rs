//! `Plan`.

use trimalla::half_edge::VertexId;

use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Plan",
    arguments: "I J",
    summary: "tells what a constrained edge would cross, without inserting it",
    help: "Up to the first vertex on its way: the edges that it crosses, and the vertices on its left and on its right, \
           between which the two pseudo-polygons lie.",
    parse: |arguments| Deed::ask(Plan { ends: [arguments.index()?, arguments.index()?] }),
};

struct Plan {
    ends: [u32; 2],
}

impl Ask for Plan {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let [i, j] = self.ends;
        let Some(t) = document.triangulation() else { return Err(CommandError::nothing_triangulated()) };
        let ends = [document.state().vertex(i)?, document.state().vertex(j)?];
        let none = || CommandError::new(format!("no edge can lead from vertex {i} to vertex {j}"));
        let plan = t.plan_segment(ends[0], ends[1]).ok_or_else(none)?;
        let name = |v: VertexId| document.name(v).to_string();
        let list = |all: &[VertexId]| all.iter().map(|&v| name(v)).collect::<Vec<_>>().join(" ");
        let mut say = |text: String| interface.message(MessageKind::Information, &text);
        if plan.existing.is_some() {
            say(format!("edge {i} {} is there", name(plan.to)));
            return Ok(());
        }
        let crossed: Vec<String> =
            plan.crossed.iter().map(|&h| format!("{}-{}", name(t.origin(h)), name(t.dest(h)))).collect();
        say(format!("from {i} to {}: crosses {}", name(plan.to), crossed.join(" ")));
        say(format!("left: {}", list(&plan.left)));
        say(format!("right: {}", list(&plan.right)));
        Ok(())
    }
}
