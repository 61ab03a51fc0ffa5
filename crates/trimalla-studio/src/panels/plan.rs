//! The panel of an edge that is planned: its two phases, before it is inserted.

use eframe::egui::Ui;
use trimalla::half_edge::VertexId;
use trimalla_workbench::Document;

use crate::tools::EdgeTool;

/// Shows the plan; the command that carries it out, where its button was clicked.
pub(crate) fn show(ui: &mut Ui, tool: &mut EdgeTool, document: &Document) -> Option<String> {
    let [i, j] = tool.planned()?;
    ui.heading(format!("Edge {i}-{j}"));
    let plan = document.triangulation().and_then(|t| {
        let plan = t.plan_segment(document.vertex(i)?, document.vertex(j)?)?;
        Some((t, plan))
    });
    let Some((t, plan)) = plan else {
        ui.label("No edge can lead there.");
        return None;
    };
    let names = |all: &[VertexId]| all.iter().map(|&v| document.name(v).to_string()).collect::<Vec<_>>().join(" ");
    let crossed = plan.crossed.iter().map(|&h| names(&[t.origin(h), t.dest(h)]).replace(' ', "-"));
    let crossed: Vec<String> = crossed.collect();
    ui.label(format!("1. It crosses {} edges: {}", crossed.len(), crossed.join(" ")));
    ui.label(format!("2. Left of it: {}", names(&plan.left)));
    ui.label(format!("    Right of it: {}", names(&plan.right)));
    let is_inserted = ui.button("Insert edge").on_hover_text("removes what it crosses, and fills both sides").clicked();
    is_inserted.then(|| {
        tool.clear();
        format!("Edge {i} {j}")
    })
}
