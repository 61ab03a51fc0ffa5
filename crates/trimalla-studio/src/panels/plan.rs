//! The panel of an edge that is planned: its two phases, before it is inserted.

use eframe::egui::{Slider, Ui};
use trimalla_workbench::{Document, NamedPoint};

use crate::tools::EdgeTool;

/// Shows the plan; the command that carries it out, where its button was clicked.
pub(crate) fn show(ui: &mut Ui, tool: &mut EdgeTool, document: &Document) -> Option<String> {
    let planned = tool.planned(document)?;
    let [i, j] = planned.ends;
    ui.heading(format!("Edge {i}-{j}"));
    if planned.plan.is_there {
        ui.label("This edge is there already; inserted, it is constrained.");
    }
    let is_inserted = ui.button("Insert edge").on_hover_text("removes what it crosses, and fills both sides").clicked();
    ui.strong("First phase: what it crosses");
    let crossed: Vec<String> = planned.plan.crossed.iter().map(|[p, q]| format!("{}-{}", p.name, q.name)).collect();
    ui.label(format!("{} edges: {}", crossed.len(), crossed.join(" ")));
    ui.label(format!("left of it: {}", names(&planned.plan.left.boundary)));
    ui.label(format!("right of it: {}", names(&planned.plan.right.boundary)));
    let calls = planned.calls();
    if calls > 0 {
        ui.strong("Second phase: both sides are filled");
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().slider_width = 60.0;
            if ui.button("Previous call").clicked() {
                planned.shown = planned.shown.saturating_sub(1);
            }
            if ui.button("Next call").on_hover_text("the next call of the recursion").clicked() {
                planned.shown = (planned.shown + 1).min(calls);
            }
            ui.add(Slider::new(&mut planned.shown, 0..=calls)).on_hover_text("how many calls are shown");
        });
        if let Some(last) = planned.shown.checked_sub(1) {
            let (side, own) = planned.call(last);
            if let Some(call) = side.calls.get(own) {
                let name = |position: usize| side.boundary.get(position).map_or(0, |v| v.name);
                let list = |positions: &mut dyn Iterator<Item = usize>| {
                    positions.map(|position| name(position).to_string()).collect::<Vec<_>>().join(" ")
                };
                ui.label(format!("call {}: base {}-{}", last + 1, name(call.first), name(call.last)));
                ui.label(format!("tried: {}", list(&mut call.tried())));
                ui.label(format!("chosen: {}, as its circle holds no other", name(call.chosen)));
                let [first, second] = call.left();
                ui.label(format!("left to fill: {} and {}", list(&mut { first }), list(&mut { second })));
            }
        }
    }
    is_inserted.then(|| {
        tool.clear();
        format!("Edge {i} {j}")
    })
}

fn names(boundary: &[NamedPoint]) -> String {
    boundary.iter().map(|v| v.name.to_string()).collect::<Vec<_>>().join(" ")
}
