//! What clicks and drags into the drawing do. Each ends in a command.

mod contour;
mod drag;
mod edge;
mod hit;

use eframe::egui::{PointerButton, Ui};
use trimalla_workbench::Document;

use self::contour::Contour;
pub(crate) use self::edge::{EdgeTool, Planned};
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
    outline: Contour,
    hole: Contour,
    pub(crate) edge: EdgeTool,
    drag: drag::Drag,
    /// What lies under the pointer, in words.
    hovered: Option<String>,
}

impl Tools {
    /// Takes a tool for another drawing: what was begun is dropped.
    pub(crate) fn take(&mut self, tool: Tool) {
        *self = Self { tool, ..Self::default() };
    }

    /// Changes the tool. A contour that was begun waits; what there is to say of it.
    pub(crate) fn change(&mut self, tool: Tool) -> Option<String> {
        if tool == self.tool {
            return None;
        }
        let (name, contour) = match self.tool {
            Tool::Outline => ("Outline", std::mem::take(&mut self.outline)),
            Tool::Hole => ("Hole", std::mem::take(&mut self.hole)),
            _ => ("", Contour::default()),
        };
        let (outline, hole) = (std::mem::take(&mut self.outline), std::mem::take(&mut self.hole));
        self.take(tool);
        (self.outline, self.hole) = (outline, hole);
        if contour.is_empty() {
            return None;
        }
        let count = contour.len();
        *(if name == "Outline" { &mut self.outline } else { &mut self.hole }) = contour;
        let text =
            format!("the contour of {count} vertices waits: '{name}' goes on with it, 'Drop' or Escape drops it");
        Some(text)
    }

    /// Whether the tool in hand makes vertices where one clicks.
    pub(crate) fn draws(&self) -> bool {
        matches!(self.tool, Tool::Insert | Tool::Outline | Tool::Hole)
    }

    /// Shows the row of tools; what there is to say.
    pub(crate) fn show(&mut self, ui: &mut Ui) -> Option<String> {
        let mut said = None;
        for (number, (tool, name, help)) in (1..).zip(Tool::ALL) {
            let label = ui.selectable_label(self.tool == tool, name);
            if label.on_hover_text(format!("{help} (key {number})")).clicked() {
                said = self.change(tool);
            }
        }
        if self.is_begun() && ui.button("Drop").on_hover_text("drops what was begun (Escape)").clicked() {
            said = self.drop_begun();
        }
        said
    }

    /// What lies under the pointer, in words.
    pub(crate) fn hovered(&self) -> Option<&str> {
        self.hovered.as_deref()
    }

    /// Whether something was begun.
    pub(crate) fn is_begun(&self) -> bool {
        !self.outline.is_empty() || !self.hole.is_empty() || self.edge.is_begun()
    }

    /// Drops what was begun; what there is to say of it.
    pub(crate) fn drop_begun(&mut self) -> Option<String> {
        let count = self.outline.len() + self.hole.len();
        self.take(self.tool);
        (count > 0).then(|| "the contour is dropped; its vertices stay, and 'Undo' takes them back".to_owned())
    }

    /// Drops contours whose vertices are gone, or that come too late; what there is to say of it.
    fn drop_lost(&mut self, document: &Document) -> Option<Asked> {
        let is_late = document.triangulation().is_some();
        let mut lost = 0;
        for contour in [&mut self.outline, &mut self.hole] {
            if !contour.is_empty() && (is_late || !contour.is_in(document)) {
                lost += contour.len();
                *contour = Contour::default();
            }
        }
        let why = if is_late { "it was not closed before 'Triangulate'" } else { "a vertex of it is gone" };
        (lost > 0).then(|| Asked::Say(format!("the contour of {lost} vertices is dropped: {why}")))
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
        let mut asked: Vec<Asked> = document.and_then(|document| self.drop_lost(document)).into_iter().collect();
        if self.tool == Tool::Move {
            asked.extend(self.drag.work(response, hit.as_ref(), document));
        } else if response.dragged_by(PointerButton::Primary) {
            view.pan(response.drag_delta());
        }
        if let Some(hit) = hit.as_ref().filter(|_| response.clicked()) {
            asked.extend(self.click(hit, document, scene));
        }
        for (tool, contour) in [(Tool::Outline, &self.outline), (Tool::Hole, &self.hole)] {
            contour.draw(&shown.painter, hit.as_ref().filter(|_| self.tool == tool));
        }
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
            Tool::Outline => self.outline.click(hit, "Outer", document, scene),
            Tool::Hole => self.hole.click(hit, "Inner", document, scene),
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
