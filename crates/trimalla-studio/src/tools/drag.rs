//! A vertex that is dragged: each move takes the one before back, so that one command is left.

use eframe::egui::{PointerButton, Response};

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
    pub(super) fn work(&mut self, response: &Response, hit: Option<&Hit>) -> Vec<Asked> {
        if response.drag_started_by(PointerButton::Primary) {
            (self.name, self.moved) = (hit.and_then(|hit| hit.vertex), None);
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
