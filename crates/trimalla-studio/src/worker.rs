//! Commands at work on a thread of their own, so that the window answers meanwhile.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use trimalla_workbench::{Document, Interface, MessageKind, script};

use crate::scene::Scene;

/// What most commands take less than: they are waited for, so that nothing flickers.
const WAIT: Duration = Duration::from_millis(30);

/// A message, and what it is about.
pub(crate) type Message = (MessageKind, String);

/// The document with what is drawn of it.
type Done = (Box<Document>, Arc<Scene>);

/// The document, at rest or with a command at work on it.
pub(crate) struct Worker {
    /// `None` while a command is at work.
    document: Option<Box<Document>>,
    /// What was drawn when no command was at work.
    scene: Arc<Scene>,
    job: Option<Job>,
    /// Whether a command took the document with it.
    is_lost: bool,
}

struct Job {
    messages: Receiver<Message>,
    done: Receiver<Done>,
    cancel: Arc<AtomicBool>,
}

/// Passes messages on to the window.
struct Passing {
    messages: Sender<Message>,
    /// Whether only errors are passed on.
    is_quiet: bool,
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

    fn is_cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}

impl Worker {
    /// With an empty document.
    pub(crate) fn new() -> Self {
        Self { document: Some(Box::default()), scene: Arc::default(), job: None, is_lost: false }
    }

    /// With a document, of which nothing is drawn before the first command.
    pub(crate) fn of(document: Document) -> Self {
        Self { document: Some(Box::new(document)), ..Self::new() }
    }

    /// The document, unless a command is at work on it.
    pub(crate) fn document(&self) -> Option<&Document> {
        self.document.as_deref()
    }

    /// What is drawn: of the document before the command at work, if there is one.
    pub(crate) fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Whether a command is at work.
    pub(crate) fn is_busy(&self) -> bool {
        self.job.is_some()
    }

    /// Runs the lines of a script, quietly but for errors if that is asked; does nothing while a command is at work.
    pub(crate) fn run(&mut self, text: String, is_quiet: bool, context: Option<eframe::egui::Context>) {
        let Some(mut document) = self.document.take() else { return };
        let (sender, messages) = channel();
        let (finished, done) = channel();
        let cancel = Arc::new(AtomicBool::new(false));
        let scene = self.scene.clone();
        let mut interface = Passing { messages: sender, is_quiet, cancel: cancel.clone() };
        std::thread::spawn(move || {
            let before = document.version();
            script::run(&mut document, &text, false, &mut interface);
            let is_drawn = !scene.vertices.is_empty() && document.version() == before;
            let scene = if is_drawn { scene } else { Arc::new(Scene::of(&document)) };
            let _ = finished.send((document, scene));
            if let Some(context) = context {
                context.request_repaint();
            }
        });
        self.job = Some(Job { messages, done, cancel });
        self.wait(WAIT);
    }

    /// Asks the command at work to stop.
    pub(crate) fn cancel(&self) {
        if let Some(job) = &self.job {
            job.cancel.store(true, Ordering::Relaxed);
        }
    }

    /// Waits for the command at work, but no longer than that.
    pub(crate) fn wait(&mut self, most: Duration) {
        let Some(job) = self.job.as_ref().filter(|_| self.document.is_none()) else { return };
        match job.done.recv_timeout(most) {
            Ok((document, scene)) => (self.document, self.scene) = (Some(document), scene),
            // A command never panics; if one did, an empty document would be better than a dead window.
            Err(RecvTimeoutError::Disconnected) => {
                (self.document, self.is_lost) = (Some(Box::new(Document::new())), true);
                self.scene = Arc::default();
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
    }

    /// The messages since the last call; whether the document has come back since.
    pub(crate) fn poll(&mut self) -> (Vec<Message>, bool) {
        self.wait(Duration::ZERO);
        let Some(job) = &self.job else { return (Vec::new(), false) };
        let mut messages: Vec<Message> = job.messages.try_iter().collect();
        if std::mem::take(&mut self.is_lost) {
            messages.push((MessageKind::Error, "the command has failed, and the document is lost".to_owned()));
        }
        let is_back = self.document.is_some();
        if is_back {
            self.job = None;
        }
        (messages, is_back)
    }
}
