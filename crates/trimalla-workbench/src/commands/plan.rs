//! `Plan`.

use std::ops::RangeInclusive;

use trimalla::constrained::RecursionCall;

use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::edge_plan::{NamedPoint, PlanSide};
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Plan",
    arguments: "I J",
    summary: "tells what a constrained edge would cross, without inserting it",
    help: "Up to the first vertex on its way: the edges that it crosses, and the vertices on its left and on its right, \
           between which the two pseudo-polygons lie. Then how these are filled, call by call: the base, the vertices \
           that are tried, the one whose circle with the base holds no other, and the two stretches that are left.",
    parse: |arguments| Deed::ask(Plan { ends: [arguments.index()?, arguments.index()?] }),
};

struct Plan {
    ends: [u32; 2],
}

impl Ask for Plan {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let plan = document.edge_plan(self.ends[0], self.ends[1])?;
        let mut say = |text: String| interface.message(MessageKind::Information, &text);
        let (from, to) = (plan.from.name, plan.to.name);
        if plan.is_there {
            say(format!("edge {from} {to} is there"));
            return Ok(());
        }
        say(format!("from {from} to {to}: crosses {}", edges(&plan.crossed)));
        if !plan.constrained.is_empty() {
            say(format!("constrained: {}", edges(&plan.constrained)));
        }
        say(format!("left: {}", list(between(&plan.left.boundary))));
        // As one sees them from the start of the edge on.
        say(format!("right: {}", list(between(&plan.right.boundary).iter().rev())));
        for (name, side) in [("left", &plan.left), ("right", &plan.right)] {
            side.calls.iter().for_each(|call| say(format!("  {name}: {}", text_of(side, call))));
        }
        Ok(())
    }
}

/// The vertices between the first and the last.
fn between(boundary: &[NamedPoint]) -> &[NamedPoint] {
    boundary.get(1..boundary.len().saturating_sub(1)).unwrap_or_default()
}

fn list<'a>(vertices: impl IntoIterator<Item = &'a NamedPoint>) -> String {
    vertices.into_iter().map(|v| v.name.to_string()).collect::<Vec<_>>().join(" ")
}

fn edges(all: &[[NamedPoint; 2]]) -> String {
    all.iter().map(|[a, b]| format!("{}-{}", a.name, b.name)).collect::<Vec<_>>().join(" ")
}

/// A call of the recursion, in a line.
fn text_of(side: &PlanSide, call: &RecursionCall) -> String {
    let name = |i: usize| side.boundary[i].name;
    let stretch = |range: RangeInclusive<usize>| list(&side.boundary[range]);
    let [first, second] = call.left().map(stretch);
    let (a, b) = (name(call.first), name(call.last));
    let tried = list(&side.boundary[call.tried()]);
    format!("base {a}-{b}, tried {tried}, chosen {}, left {first} and {second}", name(call.chosen))
}
