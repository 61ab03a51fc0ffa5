//! What clicks and drags into the drawing do. Each ends in a command.

mod contour;
mod drag;
mod edge;
mod hit;

use eframe::egui::{PointerButton, Ui};
use trimalla_workbench::Document;

pub(crate) use self::edge::EdgeTool;
pub(crate) use self::hit::Hit;
use crate::scene::Scene;
use crate::viewer::Shown;
use crate::viewer::view::View;

/// A tool.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tool {
    #[default]
    Pick,
    Insert,
    Outline,
    Hole,
    Edge,
    Flip,
    Move,
    Delete,
}

impl Tool {
    /// Every tool with its name and what it does.
    pub(crate) const ALL: [(Self, &'static str, &'static str); 8] = [
        (Self::Pick, "Pick", "picks a triangle; drags the view"),
        (Self::Insert, "Insert", "inserts a vertex where one clicks"),
        (
            Self::Outline,
            "Outline",
            "draws the outer contour: click vertices or empty places, the first one again to close",
        ),
        (Self::Hole, "Hole", "draws a hole: click vertices or empty places, the first one again to close"),
        (Self::Edge, "Edge", "joins two vertices by a constrained edge, in two phases that one sees"),
        (Self::Flip, "Flip", "flips the edge that is clicked"),
        (Self::Move, "Move", "drags a vertex, and the triangulation follows"),
        (Self::Delete, "Delete", "deletes a vertex, or releases a constrained edge"),
    ];
}

/// What a tool asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Asked {
    /// Commands, one a line.
    Run(String),
    /// Commands of a drag that goes on: they are not echoed.
    Quietly(String),
    /// A word to the user.
    Say(String),
    /// A triangle is shown as picked, and no command is run: that would drop what was taken back.
    Pick([u32; 3]),
}

/// The tools, with what has been begun.
#[derive(Debug, Default)]
pub(crate) struct Tools {
    tool: Tool,
    contour: contour::Contour,
    pub(crate) edge: EdgeTool,
    drag: drag::Drag,
    /// What lies under the pointer, in words.
    hovered: Option<String>,
}

impl Tools {
    /// Takes a tool; what was begun with another is dropped.
    pub(crate) fn take(&mut self, tool: Tool) {
        *self = Self { tool, ..Self::default() };
    }

    /// Shows the row of tools.
    pub(crate) fn show(&mut self, ui: &mut Ui) {
        for (tool, name, help) in Tool::ALL {
            if ui.selectable_label(self.tool == tool, name).on_hover_text(help).clicked() {
                self.take(tool);
            }
        }
        if self.is_begun() && ui.button("Drop").on_hover_text("drops what was begun (Escape)").clicked() {
            self.take(self.tool);
        }
    }

    /// What lies under the pointer, in words.
    pub(crate) fn hovered(&self) -> Option<&str> {
        self.hovered.as_deref()
    }

    /// Whether something was begun.
    pub(crate) fn is_begun(&self) -> bool {
        !self.contour.is_empty() || self.edge.is_begun()
    }

    /// Drops what was begun.
    pub(crate) fn drop_begun(&mut self) {
        self.take(self.tool);
    }

    /// Lets the pointer work on what a viewer shows, and draws what was begun.
    pub(crate) fn work(
        &mut self,
        shown: &Shown,
        view: &mut View,
        (document, scene): (Option<&Document>, &Scene),
    ) -> Vec<Asked> {
        let response = &shown.response;
        // A drag begins where the button was pressed, and is noticed some points farther.
        let pressed = response.drag_started().then(|| response.ctx.input(|i| i.pointer.press_origin())).flatten();
        let place = pressed.or_else(|| response.interact_pointer_pos()).or_else(|| response.hover_pos());
        let hit = place.map(|at| Hit::at((at, response.rect), *view, document, scene)).filter(|hit| hit.at.is_finite());
        self.hovered = hit.as_ref().map(Hit::to_string);
        let mut asked = Vec::new();
        if self.tool == Tool::Move {
            asked.extend(self.drag.work(response, hit.as_ref()));
        } else if response.dragged_by(PointerButton::Primary) {
            view.pan(response.drag_delta());
        }
        if let Some(hit) = hit.as_ref().filter(|_| response.clicked()) {
            asked.extend(self.click(hit, document, scene));
        }
        self.contour.draw(&shown.painter, hit.as_ref());
        self.edge.draw(&shown.painter, hit.as_ref(), document);
        asked
    }

    fn click(&mut self, hit: &Hit, document: Option<&Document>, scene: &Scene) -> Vec<Asked> {
        let run = |command: Option<String>| command.into_iter().map(Asked::Run).collect();
        match self.tool {
            Tool::Pick => {
                let [i, j, k] = match hit.face {
                    Some(names) => names,
                    None if document.is_some_and(|d| !d.selection().is_empty() && d.undoable().1 == 0) => {
                        return run(Some("Select".to_owned()));
                    }
                    None => return Vec::new(),
                };
                if document.is_some_and(|document| document.undoable().1 > 0) {
                    return vec![Asked::Pick([i, j, k])];
                }
                run(Some(format!("Select {i} {j} {k}")))
            }
            Tool::Insert => run(Some(format!("Insert {} {}", hit.at.x, hit.at.y))),
            Tool::Outline => self.contour.click(hit, "Outer", document, scene),
            Tool::Hole => self.contour.click(hit, "Inner", document, scene),
            Tool::Edge => self.edge.click(hit, document),
            Tool::Flip => match hit.edge {
                Some([i, j]) => run(Some(format!("Flip {i} {j}"))),
                None => vec![Asked::Say("click nearer to an edge".to_owned())],
            },
            Tool::Move => Vec::new(),
            Tool::Delete => match (hit.vertex, hit.edge) {
                (Some(name), _) => run(Some(format!("Delete {name}"))),
                (None, Some([i, j])) => run(Some(format!("Release {i} {j}"))),
                (None, None) => vec![Asked::Say("click nearer to a vertex or an edge".to_owned())],
            },
        }
    }
}
