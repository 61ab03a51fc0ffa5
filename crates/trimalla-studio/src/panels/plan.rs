//! The panel of an edge that is planned: its two phases, before it is inserted.

use eframe::egui::{Label, Slider, Ui};
use trimalla_workbench::{Document, NamedPoint};

use crate::tools::{EdgeTool, Planned};

/// Shows the plan; the command that carries it out, where its button was clicked.
pub(crate) fn show(ui: &mut Ui, tool: &mut EdgeTool, document: &Document) -> Option<String> {
    let planned = tool.planned(document)?;
    let [i, j] = planned.ends;
    ui.heading(format!("Edge {i}-{j}"));
    if planned.plan.is_there {
        ui.label("This edge is there already; inserted, it is constrained.");
    }
    let is_inserted = ui.button("Insert edge").on_hover_text("removes what it crosses, and fills both sides").clicked();
    let calls = planned.calls();
    ui.add_enabled_ui(calls > 0, |ui| {
        ui.horizontal_wrapped(|ui| {
            if ui.button("Previous call").clicked() {
                planned.shown = planned.shown.saturating_sub(1);
            }
            if ui.button("Next call").on_hover_text("the next call of the recursion").clicked() {
                planned.shown = (planned.shown + 1).min(calls);
            }
            ui.spacing_mut().slider_width = 60.0;
            ui.add(Slider::new(&mut planned.shown, 0..=calls)).on_hover_text("how many calls are shown");
        });
    });
    ui.strong("First phase: what it crosses");
    let line = |ui: &mut Ui, text: String| ui.add(Label::new(&text).truncate()).on_hover_text(text);
    let crossed: Vec<String> = planned.plan.crossed.iter().map(|[p, q]| format!("{}-{}", p.name, q.name)).collect();
    line(ui, format!("{} edges: {}", crossed.len(), crossed.join(" ")));
    line(ui, format!("left of it: {}", names(&planned.plan.left.boundary)));
    line(ui, format!("right of it: {}", names(&planned.plan.right.boundary)));
    ui.strong("Second phase: both sides are filled");
    call_lines(planned).into_iter().for_each(|text| drop(line(ui, text)));
    ui.separator();
    is_inserted.then(|| {
        tool.clear();
        format!("Edge {i} {j}")
    })
}

fn names(boundary: &[NamedPoint]) -> String {
    boundary.iter().map(|v| v.name.to_string()).collect::<Vec<_>>().join(" ")
}

/// The last call that is shown; as many lines without one.
fn call_lines(planned: &Planned) -> [String; 4] {
    let shown = planned.shown.checked_sub(1).map(|last| (last, planned.call(last)));
    let Some((last, (side, call))) = shown.and_then(|(last, (side, own))| Some((last, (side, side.calls.get(own)?))))
    else {
        let first = if planned.calls() > 0 { "'Next call' shows the recursion" } else { "nothing is left to fill" };
        return [first.to_owned(), String::new(), String::new(), String::new()];
    };
    let name = |position: usize| side.boundary.get(position).map_or(0, |v| v.name);
    let list = |positions: &mut dyn Iterator<Item = usize>| {
        positions.map(|position| name(position).to_string()).collect::<Vec<_>>().join(" ")
    };
    let [first, second] = call.left();
    [
        format!("call {}: base {}-{}", last + 1, name(call.first), name(call.last)),
        format!("tried: {}", list(&mut call.tried())),
        format!("chosen: {}, as its circle holds no other", name(call.chosen)),
        format!("left to fill: {} and {}", list(&mut { first }), list(&mut { second })),
    ]
}
