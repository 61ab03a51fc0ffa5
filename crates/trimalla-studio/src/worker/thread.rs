//! Commands at work on a thread of their own.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use trimalla::constrained::ConstrainedTriangulation;
use trimalla_workbench::{Document, Interface, MessageKind, script};
use web_time::Instant;

use super::growth::{Grown, Growth};
use super::{Message, News, scene_of};
use crate::scene::Scene;

/// Commands at work.
pub(super) struct Thread {
    messages: Receiver<Message>,
    grown: Receiver<Grown>,
    done: Receiver<(Box<Document>, Arc<Scene>, Duration)>,
    cancel: Arc<AtomicBool>,
}

/// Passes messages on to the window.
struct Passing {
    messages: Sender<Message>,
    /// Whether only errors are passed on.
    is_quiet: bool,
    grown: Sender<Grown>,
    growth: Growth,
    cancel: Arc<AtomicBool>,
}

impl Interface for Passing {
    fn message(&mut self, kind: MessageKind, text: &str) {
        if self.is_quiet && kind != MessageKind::Error {
            return;
        }
        // Nobody listens when the window is closed.
        let _ = self.messages.send((kind, text.to_owned()));
    }

    fn progress(&mut self, triangulation: &ConstrainedTriangulation) {
        if let Some(grown) = self.growth.look(triangulation) {
            let _ = self.grown.send(grown);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}

impl Thread {
    /// Begins to run the lines of a script.
    pub(super) fn new(
        mut document: Box<Document>,
        text: String,
        is_quiet: bool,
        drawn: (Option<u64>, Arc<Scene>),
        context: Option<eframe::egui::Context>,
    ) -> Self {
        let (sender, messages) = channel();
        let (grows, grown) = channel();
        let (finished, done) = channel();
        let cancel = Arc::new(AtomicBool::new(false));
        let mut interface =
            Passing { messages: sender, is_quiet, grown: grows, growth: Growth::new(), cancel: cancel.clone() };
        std::thread::spawn(move || {
            let began = Instant::now();
            script::run(&mut document, &text, false, &mut interface);
            let took = began.elapsed();
            let scene = scene_of(&document, &drawn);
            let _ = finished.send((document, scene, took));
            if let Some(context) = context {
                context.request_repaint();
            }
        });
        Self { messages, grown, done, cancel }
    }

    pub(super) fn cancel(&self) {
        self.cancel.store(true, Ordering::Relaxed);
    }

    /// What has come since the last call; waits for the end, but no longer than that.
    pub(super) fn news(&self, most: Duration) -> News {
        let done = self.done.recv_timeout(most);
        let mut news = News { messages: self.messages.try_iter().collect(), ..News::default() };
        news.grown = self.grown.try_iter().collect();
        news.done = match done {
            Ok(done) => Some(done),
            Err(RecvTimeoutError::Timeout) => None,
            // A command never panics; if one did, an empty document would be better than a dead window.
            Err(RecvTimeoutError::Disconnected) => {
                news.messages.push((MessageKind::Error, "the command has failed, and the document is lost".to_owned()));
                Some((Box::default(), Arc::default(), Duration::ZERO))
            }
        };
        news
    }
}
