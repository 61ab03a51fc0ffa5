//! `Stats`.

use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Stats",
    arguments: "",
    summary: "counts vertices, edges and triangles, and measures angles",
    help: "",
    parse: |_| Deed::ask(Stats),
};

struct Stats;

impl Ask for Stats {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let figures = document.figures();
        let mut say = |text: String| interface.message(MessageKind::Information, &text);
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
        Ok(())
    }
}
