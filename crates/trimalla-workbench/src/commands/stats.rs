//! `Stats`.

use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Stats",
    arguments: "",
    summary: "counts vertices, edges and triangles, and measures angles",
    help: "Of a drawing that was loaded its file, and of the last run of a refinement what was asked and what it did.",
    parse: |_| Deed::ask(Stats),
};

struct Stats;

impl Ask for Stats {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let figures = document.figures();
        let mut say = |text: String| interface.message(MessageKind::Information, &text);
        if let Some(file) = document.state().input.files.last() {
            say(format!("file {}", file.display()));
        }
        say(format!("{} vertices, {} of them added", figures.vertices, figures.steiner));
        if document.triangulation().is_none() {
            say("nothing is triangulated yet".to_owned());
            return Ok(());
        }
        let (edges, constrained, boundary) = (figures.edges, figures.constrained, figures.boundary);
        say(format!("{edges} edges, {constrained} constrained, {boundary} on the boundary"));
        say(format!("{} triangles, area {}", figures.triangles, figures.area));
        if figures.triangles > 0 {
            say(format!("angles {:.4} to {:.4} degrees", figures.min_angle_deg, figures.max_angle_deg));
        }
        if let Some(run) = document.runs().last() {
            say(format!("the last of {} runs of a refinement:", document.runs().len()));
            run.lines().into_iter().for_each(|line| say(format!("  {line}")));
        }
        Ok(())
    }
}
