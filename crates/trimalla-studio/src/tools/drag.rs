//! A vertex that is dragged: each move takes the one before back, so that one command is left.

use eframe::egui::{PointerButton, Response};
use trimalla::triangulation::Closure;
use trimalla_workbench::Document;

use super::{Asked, Hit};

/// What is dragged.
#[derive(Clone, Debug, Default)]
pub(super) struct Drag {
    /// The vertex.
    name: Option<u32>,
    /// The last move, if there was one.
    moved: Option<String>,
}

impl Drag {
    /// Follows the pointer.
    pub(super) fn work(&mut self, response: &Response, hit: Option<&Hit>, document: Option<&Document>) -> Vec<Asked> {
        if response.drag_started_by(PointerButton::Primary) {
            (self.name, self.moved) = (hit.and_then(|hit| hit.vertex), None);
            if let Some(name) = self.name.filter(|&name| document.is_some_and(|of| is_fixed(of, name))) {
                self.name = None;
                let text = format!(
                    "vertex {name} is on the boundary of the domain, which stays after 'Triangulate': 'Reset', then move \
                     (or 'Undo' to before 'Triangulate', which keeps contours)"
                );
                return vec![Asked::Say(text)];
            }
        }
        let Some(name) = self.name else { return Vec::new() };
        let mut asked = Vec::new();
        if let Some(hit) = hit.filter(|_| response.dragged_by(PointerButton::Primary)) {
            let to = format!("Move {name} {} {}", hit.at.x, hit.at.y);
            if self.moved.as_ref() != Some(&to) {
                asked.push(Asked::Quietly(to.clone()));
                self.moved = Some(to);
            }
        }
        if response.drag_stopped() {
            self.name = None;
            asked.extend(self.moved.take().map(Asked::Run));
        }
        asked
    }
}

/// Whether a vertex is on the boundary of a domain, which stays where it is.
fn is_fixed(document: &Document, name: u32) -> bool {
    let Some((t, v)) = document.triangulation().zip(document.vertex(name)) else { return false };
    let is_domain = t.closure() == Closure::Domain && t.is_used(v);
    is_domain && t.edges_around(v).any(|h| t.is_boundary_edge(h))
}
