//! The studio in a window of the desktop, with the system's file dialogs.
//!
//! A dialog is opened where the window lives, as some systems want it, and waited for on a thread of its own: the
//! window answers meanwhile.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

use eframe::egui::{Context, Ui};
use rfd::AsyncFileDialog;
use trimalla_workbench::MessageKind;

use crate::app::Studio;
use crate::dialog::{Answer, Purpose, Wish};

/// The studio, and the file dialog that is open.
pub struct Window {
    studio: Studio,
    dialog: Option<Dialog>,
}

/// A dialog that is open.
struct Dialog {
    wish: Wish,
    chosen: Receiver<Option<PathBuf>>,
}

impl Window {
    /// A window around a studio, which asks for files by dialogs.
    #[must_use]
    pub fn new(studio: Studio) -> Self {
        // A program around this one may have a log of its own: then a dialog that cannot be shown counts as closed.
        if log::set_logger(&Failures).is_ok() {
            log::set_max_level(log::LevelFilter::Error);
        }
        Self { studio: studio.with_dialogs(), dialog: None }
    }

    /// Gives the studio what came of the dialog, if it is closed.
    fn take_answer(&mut self) {
        let Some(dialog) = self.dialog.take() else { return };
        let chosen = match dialog.chosen.try_recv() {
            Ok(chosen) => chosen,
            Err(TryRecvError::Disconnected) => None,
            Err(TryRecvError::Empty) => return self.dialog = Some(dialog),
        };
        let answer = match chosen {
            Some(path) => Answer::Chosen(path),
            None if HAS_FAILED.load(Ordering::Relaxed) => Answer::Impossible,
            None => Answer::Closed,
        };
        self.studio.answer(dialog.wish, answer);
    }

    /// Opens a dialog, unless one is open.
    fn open(&mut self, wish: Wish, frame: &eframe::Frame, context: &Context) {
        if self.dialog.is_some() {
            return self.studio.say(MessageKind::Error, "a file dialog is open already".to_owned());
        }
        HAS_FAILED.store(false, Ordering::Relaxed);
        let (sender, chosen) = channel();
        let asked = dialog_of(&wish).set_parent(frame);
        let context = context.clone();
        let tell = move |chosen: Option<rfd::FileHandle>| {
            // Nobody listens when the window is closed.
            let _ = sender.send(chosen.map(PathBuf::from));
            context.request_repaint();
        };
        if wish.purpose == Purpose::Open {
            let file = asked.pick_file();
            std::thread::spawn(move || tell(pollster::block_on(file)));
        } else {
            let file = asked.save_file();
            std::thread::spawn(move || tell(pollster::block_on(file)));
        }
        self.dialog = Some(Dialog { wish, chosen });
    }
}

/// Whether the last dialog could not be shown. It returns nothing then, as one that is closed, and says so in the log.
static HAS_FAILED: AtomicBool = AtomicBool::new(false);

/// A log that keeps nothing but that a dialog has failed.
struct Failures;

impl log::Log for Failures {
    fn enabled(&self, metadata: &log::Metadata<'_>) -> bool {
        metadata.level() == log::Level::Error && metadata.target().starts_with("rfd")
    }

    fn log(&self, record: &log::Record<'_>) {
        if self.enabled(record.metadata()) {
            HAS_FAILED.store(true, Ordering::Relaxed);
        }
    }

    fn flush(&self) {}
}

/// The dialog of the system that asks for it.
fn dialog_of(wish: &Wish) -> AsyncFileDialog {
    let mut dialog = AsyncFileDialog::new().set_title(&wish.title);
    for (name, endings) in &wish.kinds {
        dialog = dialog.add_filter(name, endings);
    }
    if let Some(folder) = &wish.folder {
        dialog = dialog.set_directory(folder);
    }
    if let Purpose::Write { name, .. } = &wish.purpose {
        dialog = dialog.set_file_name(name);
    }
    dialog
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.take_answer();
        self.studio.show(ui);
        if let Some(wish) = self.studio.take_wish() {
            self.open(wish, frame, ui.ctx());
        }
    }
}
