//! Commands at work on a thread of their own, so that the window answers meanwhile; or slice by slice, where there are
//! no threads.

mod growth;
mod slices;
mod thread;

use std::sync::Arc;
use std::time::Duration;

use trimalla_io::Files;
use trimalla_workbench::{Document, MessageKind};
use web_time::Instant;

pub(crate) use self::growth::Grown;
use self::slices::Slices;
use self::thread::Thread;
use crate::scene::Scene;

/// What most commands take less than: they are waited for, so that nothing flickers.
const WAIT: Duration = Duration::from_millis(30);

/// Slices take so long in each frame.
const FRAME: Duration = Duration::from_millis(12);

/// A message, and what it is about.
pub(crate) type Message = (MessageKind, String);

/// The document, at rest or with a command at work on it; and what is drawn.
pub(crate) struct Worker {
    /// `None` while a command is at work.
    document: Option<Box<Document>>,
    at_work: Option<AtWork>,
    /// What is drawn of the document, and of which version.
    scene: Arc<Scene>,
    version: Option<u64>,
    /// The triangulation at some moments of the command at work, or of the last one.
    growth: Vec<Grown>,
    /// Whether commands are done slice by slice, and not on a thread.
    has_slices: bool,
    files: Files,
    began: Instant,
    /// How long the last commands took, if they are done.
    took: Option<Duration>,
}

enum AtWork {
    Thread(Thread),
    Slices(Box<Slices>),
}

/// What has come of the commands at work since the last call.
#[derive(Default)]
struct News {
    messages: Vec<Message>,
    grown: Vec<Grown>,
    /// The document when they are done, with what is drawn of it.
    done: Option<(Box<Document>, Arc<Scene>, Duration)>,
}

impl Worker {
    /// With an empty document.
    pub(crate) fn new() -> Self {
        Self {
            document: Some(Box::default()),
            at_work: None,
            scene: Arc::default(),
            version: None,
            growth: Vec::new(),
            has_slices: false,
            files: Files::Disk,
            began: Instant::now(),
            took: None,
        }
    }

    /// A worker that needs neither threads nor a disk.
    pub(crate) fn in_slices(files: Files) -> Self {
        let document = Document::new().with_files(files.clone());
        Self { document: Some(Box::new(document)), has_slices: true, files, ..Self::new() }
    }

    /// A worker of the same kind with a copy of the document; `None` while a command is at work on it.
    pub(crate) fn copy(&self) -> Option<Self> {
        let document = self.document()?.copy();
        let (has_slices, files) = (self.has_slices, self.files.clone());
        Some(Self { document: Some(Box::new(document)), has_slices, files, ..Self::new() })
    }

    /// A worker of the same kind with an empty document.
    pub(crate) fn empty(&self) -> Self {
        let (has_slices, files) = (self.has_slices, self.files.clone());
        let document = Document::new().with_files(files.clone());
        Self { document: Some(Box::new(document)), has_slices, files, ..Self::new() }
    }

    /// The files that commands read and write.
    pub(crate) fn files(&self) -> &Files {
        &self.files
    }

    /// After how long the window is to ask again, while a command is at work.
    pub(crate) fn pause(&self) -> Duration {
        if self.has_slices { Duration::ZERO } else { WAIT }
    }

    /// The document, unless a command is at work on it.
    pub(crate) fn document(&self) -> Option<&Document> {
        self.document.as_deref()
    }

    /// What is drawn: while a long command is at work, its triangulation at the last moment that was noted.
    pub(crate) fn scene(&self) -> &Arc<Scene> {
        self.growth.iter().rev().find_map(|grown| grown.scene.as_ref()).unwrap_or(&self.scene)
    }

    fn forget_scenes(&mut self) {
        self.growth.iter_mut().for_each(|grown| grown.scene = None);
    }

    /// The triangulation at some moments of the command at work, or of the last one.
    pub(crate) fn growth(&self) -> &[Grown] {
        &self.growth
    }

    /// How long the last commands took, or take until now; `None` before the first.
    pub(crate) fn seconds(&self) -> Option<f64> {
        let until_now = self.is_busy().then(|| self.began.elapsed());
        self.took.or(until_now).map(|time| time.as_secs_f64())
    }

    /// Whether a command is at work.
    pub(crate) fn is_busy(&self) -> bool {
        self.at_work.is_some()
    }

    /// Runs the lines of a script, quietly but for errors if that is asked; does nothing while a command is at work.
    pub(crate) fn run(&mut self, text: &str, is_quiet: bool, context: Option<eframe::egui::Context>) {
        let Some(document) = self.document.take() else { return };
        self.growth.clear();
        (self.began, self.took) = (Instant::now(), None);
        let drawn = (self.version, self.scene.clone());
        self.at_work = Some(if self.has_slices {
            AtWork::Slices(Box::new(Slices::new(*document, text, is_quiet, drawn)))
        } else {
            AtWork::Thread(Thread::new(document, text.to_owned(), is_quiet, drawn, context))
        });
    }

    /// Asks the command at work to stop.
    pub(crate) fn cancel(&mut self) {
        match &mut self.at_work {
            Some(AtWork::Thread(thread)) => thread.cancel(),
            Some(AtWork::Slices(slices)) => slices.cancel(),
            None => {}
        }
    }

    /// The messages since the last call; whether the document has come back since. Waits for a short command.
    pub(crate) fn poll_shortly(&mut self) -> (Vec<Message>, bool) {
        self.poll_within(WAIT)
    }

    /// The messages since the last call; whether the document has come back since.
    pub(crate) fn poll(&mut self) -> (Vec<Message>, bool) {
        self.poll_within(Duration::ZERO)
    }

    fn poll_within(&mut self, most: Duration) -> (Vec<Message>, bool) {
        let news = match &mut self.at_work {
            Some(AtWork::Thread(thread)) => thread.news(most),
            Some(AtWork::Slices(slices)) => slices.news(FRAME),
            None => News::default(),
        };
        for grown in news.grown {
            // Of all but the last one that can be drawn only the figures are kept.
            if grown.scene.is_some() {
                self.forget_scenes();
            }
            self.growth.push(grown);
        }
        let is_back = news.done.is_some();
        if let Some((document, scene, took)) = news.done {
            self.took = Some(took);
            self.at_work = None;
            self.forget_scenes();
            self.version = Some(document.version());
            (self.document, self.scene) = (Some(document), scene);
        }
        (news.messages, is_back)
    }
}

/// What is drawn of a document after commands: what was drawn before, if they have changed nothing.
fn scene_of(document: &Document, (version, before): &(Option<u64>, Arc<Scene>)) -> Arc<Scene> {
    if *version == Some(document.version()) { before.clone() } else { Arc::new(Scene::of(document)) }
}
