//! From what the recipes begin.
//!
//! That is the triangulation as it is; where a refinement goes step by step, the one before its first step. A copy of
//! a refinement at work would go on by its own options, whatever the recipe says.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};

use eframe::egui;
use trimalla_workbench::{Document, MessageKind};

use crate::worker::{Message, Worker};

/// A document on which the recipes wait: it is made by commands at work.
pub(super) struct Base {
    worker: Worker,
    /// Whether the triangulation of now is taken, as the commands do not lead back.
    is_of_now: bool,
}

/// What has come of it.
pub(super) enum Made {
    NotYet,
    /// The recipes begin from this one.
    Ready(Worker),
    Failed,
}

impl Base {
    /// Begins to make the triangulation before the refinement that goes step by step; `None` without one.
    pub(super) fn before_steps(document: &Worker, context: &egui::Context) -> Option<Self> {
        let of = document.document().filter(|of| of.is_refining())?;
        let script = of.script();
        let lines: Vec<&str> = script.lines().collect();
        let (before, steps) = lines.split_at(first_step(&lines));
        let options = steps.iter().filter(|line| is_one_of(line, &["Set", "Select", "Recipe"]));
        let lines: Vec<&str> = before.iter().chain(options).copied().collect();
        let mut worker = document.empty();
        worker.run(&lines.join("\n"), true, Some(context.clone()));
        Some(Self { worker, is_of_now: false })
    }

    /// What has come of it; what there is to say.
    pub(super) fn poll(&mut self, document: &Worker, context: &egui::Context) -> (Made, Option<Message>) {
        let (messages, is_back) = self.worker.poll();
        if !is_back {
            return (Made::NotYet, None);
        }
        let has_failed = messages.iter().any(|(kind, _)| *kind == MessageKind::Error);
        let is_made = self.worker.document().is_some_and(|of| of.triangulation().is_some()) && !has_failed;
        let say = |kind, text: &str| Some((kind, text.to_owned()));
        match (is_made, self.is_of_now, document.copy()) {
            (true, false, _) => {
                let text = "the recipes begin from the triangulation before the first 'Step'";
                (Made::Ready(std::mem::replace(&mut self.worker, Worker::new())), say(MessageKind::Information, text))
            }
            (true, true, _) => (Made::Ready(std::mem::replace(&mut self.worker, Worker::new())), None),
            (false, false, Some(mut copy)) => {
                // A command that changes nothing, and ends the refinement that goes step by step.
                copy.run("LEPP 0", true, Some(context.clone()));
                *self = Self { worker: copy, is_of_now: true };
                let text = "what was there before the first 'Step' cannot be made again: the recipes begin from the \
                            triangulation of now, as if no refinement were at work";
                (Made::NotYet, say(MessageKind::Information, text))
            }
            _ => (Made::Failed, say(MessageKind::Error, "there is nothing from which the recipes could begin")),
        }
    }
}

/// A number that is another one for another drawing or triangulation; options and steps of a refinement that is at
/// work change nothing.
pub(super) fn state_of(document: &Document) -> u64 {
    let script = document.script();
    let lines: Vec<&str> = script.lines().collect();
    let most = if document.is_refining() { first_step(&lines) } else { lines.len() };
    let mut hasher = DefaultHasher::new();
    let leave = |line: &&&str| !is_one_of(line, &["Set", "Select", "Recipe", "Watch"]);
    lines[..most].iter().filter(leave).for_each(|line| line.hash(&mut hasher));
    hasher.finish()
}

/// How many lines come before the first step of the refinement with which they end.
fn first_step(lines: &[&str]) -> usize {
    let of_refinement = |line: &&&str| is_one_of(line, &["Step", "Set", "Select", "Recipe"]);
    let group = lines.iter().rev().take_while(of_refinement).count();
    let start = lines.len() - group;
    start + lines[start..].iter().position(|line| is_one_of(line, &["Step"])).unwrap_or(group)
}

fn is_one_of(line: &str, names: &[&str]) -> bool {
    line.split_whitespace().next().is_some_and(|name| names.iter().any(|n| n.eq_ignore_ascii_case(name)))
}

#[cfg(test)]
mod tests {
    use trimalla_workbench::{Quiet, script};

    use super::*;

    #[test]
    fn steps_and_options_leave_the_state_and_other_commands_do_not() {
        let after = |text: &str| {
            let mut document = Document::new();
            assert_eq!(script::run(&mut document, text, false, &mut Quiet), [], "{text}");
            state_of(&document)
        };
        let start = "Generate random 30 4\nTriangulate\n";
        let state = after(start);
        assert_eq!(state, after(&format!("{start}Set min-angle 25\nStep 2\nSet min-angle 20\nStep\nSelect")));
        assert_ne!(state, after(&format!("{start}Insert 0.5 0.5")));
        assert_ne!(state, after(&format!("{start}Refine\nStep")));
        assert_eq!(after(&format!("{start}Refine")), after(&format!("{start}Step\nRefine\nUndo 2\nRefine\nStep")));
    }
}
