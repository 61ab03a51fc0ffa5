//! Commands at work slice by slice, a few milliseconds each frame: in a browser there are no threads.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Duration;

use trimalla::constrained::ConstrainedTriangulation;
use trimalla_workbench::{Advanced, Document, Interface, MessageKind, Running};
use web_time::Instant;

use super::growth::{Grown, Growth};
use super::{Message, News, scene_of};
use crate::scene::Scene;

/// Commands at work.
pub(super) struct Slices {
    /// The command at work; `None` when all are done.
    running: Option<Running>,
    /// The lines that come after it.
    lines: VecDeque<String>,
    said: Said,
    began: Instant,
    /// What was drawn before.
    drawn: (Option<u64>, Arc<Scene>),
}

/// Keeps messages for the window.
struct Said {
    messages: Vec<Message>,
    /// Whether only errors are kept.
    is_quiet: bool,
    grown: Vec<Grown>,
    growth: Growth,
    is_cancelled: bool,
}

impl Interface for Said {
    fn message(&mut self, kind: MessageKind, text: &str) {
        if !self.is_quiet || kind == MessageKind::Error {
            self.messages.push((kind, text.to_owned()));
        }
    }

    fn progress(&mut self, triangulation: &ConstrainedTriangulation) {
        self.grown.extend(self.growth.look(triangulation));
    }

    fn is_cancelled(&self) -> bool {
        self.is_cancelled
    }
}

impl Slices {
    /// The lines of a script, none of which is begun.
    pub(super) fn new(document: Document, text: &str, is_quiet: bool, drawn: (Option<u64>, Arc<Scene>)) -> Self {
        let mut lines: VecDeque<String> = text.lines().map(str::to_owned).collect();
        let first = lines.pop_front().unwrap_or_default();
        let (messages, grown) = (Vec::new(), Vec::new());
        let said = Said { messages, is_quiet, grown, growth: Growth::new(), is_cancelled: false };
        Self { running: Some(document.begin(&first)), lines, said, began: Instant::now(), drawn }
    }

    /// Asks the command at work to stop; those after it are not begun.
    pub(super) fn cancel(&mut self) {
        self.said.is_cancelled = true;
    }

    /// Does slices for about so long; what has come of them.
    pub(super) fn news(&mut self, most: Duration) -> News {
        let done = self.advance(most).map(|document| {
            let scene = scene_of(&document, &self.drawn);
            (Box::new(document), scene, self.began.elapsed())
        });
        let Said { messages, grown, .. } = &mut self.said;
        News { messages: std::mem::take(messages), grown: std::mem::take(grown), done }
    }

    /// The document, once all is done or a command was refused.
    fn advance(&mut self, most: Duration) -> Option<Document> {
        let start = Instant::now();
        loop {
            match self.running.take()?.advance(&mut self.said) {
                Advanced::More(rest) => self.running = Some(rest),
                Advanced::Done(document, outcome) => {
                    let goes_on = outcome.is_ok() && !self.said.is_cancelled;
                    match self.lines.pop_front().filter(|_| goes_on) {
                        Some(line) => self.running = Some(document.begin(&line)),
                        None => return Some(document),
                    }
                }
            }
            if start.elapsed() >= most {
                return None;
            }
        }
    }
}
