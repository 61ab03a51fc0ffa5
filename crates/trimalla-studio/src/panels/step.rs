//! What the last step of a refinement did: what was chosen, which points were tried and why they were refused, what was
//! inserted.

use eframe::egui::Ui;
use trimalla::half_edge::VertexId;
use trimalla::refine::Event;
use trimalla_workbench::Document;

/// Shows the step.
pub(crate) fn show(ui: &mut Ui, document: &Document) {
    let Some(event) = document.last_step() else { return };
    let name = |v: VertexId| document.name(v);
    ui.heading(format!("Step {}", event.number));
    ui.label(outcome(event));
    if let Some(([a, b, c], _)) = event.selected {
        let why = event.why().unwrap_or_default();
        ui.label(format!("chosen: triangle {} {} {} ({why})", name(a), name(b), name(c)));
    }
    if let Some([a, b]) = event.subsegment {
        ui.label(format!("tested: subsegment {}-{}", name(a), name(b)));
    }
    if event.lepp.len() > 1 {
        ui.label(format!("its longest-edge path has {} triangles", event.lepp.len()));
    }
    if let Some([a, b]) = event.terminal_edge {
        ui.label(format!("terminal edge {}-{}", name(a), name(b)));
    }
    for (number, candidate) in (1..).zip(&event.candidates) {
        let place = match (candidate.point, candidate.edge) {
            (Some(p), _) => format!("({:.6}, {:.6})", p.x, p.y),
            (None, Some([a, b])) => format!("subsegment {}-{}", name(a), name(b)),
            (None, None) => String::new(),
        };
        let verdict = match (candidate.refused, candidate.point) {
            (Some(reason), _) => format!("refused: {reason}"),
            (None, Some(_)) => "taken".to_owned(),
            (None, None) => "it waits to be split".to_owned(),
        };
        ui.label(format!("tried {number}: {place}, {verdict}"));
    }
    for &[a, b] in &event.encroached {
        ui.label(format!("it would encroach upon {}-{}", name(a), name(b)));
    }
    if let Some(inserted) = event.inserted {
        let kind = inserted.kind.key();
        ui.label(format!("inserted: vertex {}, {kind}", name(inserted.vertex)));
    }
    if !event.deleted.is_empty() {
        ui.label(format!("{} vertices deleted before", event.deleted.len()));
    }
    if let Some(reason) = event.given_up {
        ui.label(format!("given up: {reason}"));
    }
    ui.label(format!("{} triangles replaced by {}", event.destroyed.len(), event.made.len()));
}

fn outcome(event: &Event) -> &'static str {
    use trimalla::refine::StepOutcome as Outcome;
    match event.outcome {
        Outcome::SubsegmentSplit => "a subsegment was split",
        Outcome::SubsegmentKept => "a subsegment needs no split any more",
        Outcome::SubsegmentRefused => "there is no room to split a subsegment",
        Outcome::Filled => "a node of the lattice was tested",
        Outcome::Triangle => "a bad triangle was treated",
        Outcome::Prepared => "the loop was prepared",
        Outcome::Recovered => "segments were recovered",
        Outcome::Retried => "triangles without room wait again",
        Outcome::Finished => "nothing is left to do",
        Outcome::Exhausted => "the vertex budget is used up",
        Outcome::Stalled => "more vertices would improve nothing",
    }
}
