//! The window: which panel is where, and what its buttons run.

mod bar;
mod control;
mod keys;
mod side;
mod watch;
mod write;

use std::collections::VecDeque;

use eframe::egui::{self, CentralPanel, Panel, Ui};
use eframe::wgpu::TextureFormat;
use trimalla_io::Files;
use trimalla_workbench::{Document, MessageKind, script};

use self::control::Control;
use self::watch::Watch;
use crate::compare::Compare;
use crate::dialog::Dialogs;
use crate::learn;
use crate::panels::console::Console;
use crate::panels::{information, missed};
use crate::scene::Picked;
use crate::told::Told;
use crate::tools::{Asked, Tool, Tools};
use crate::viewer::switches::{self, Switches};
use crate::viewer::view::View;
use crate::viewer::{Viewer, overlay};
use crate::worker::{Message, Worker};

/// The studio.
///
/// One field for each part of the window.
pub struct Studio {
    worker: Worker,
    /// Commands that wait for the one at work; whether quietly.
    waiting: VecDeque<(String, bool)>,
    picked: Option<Picked>,
    /// The commands at work, which may show something.
    asked: String,
    console: Console,
    viewer: Viewer,
    view: View,
    /// Whether the next frame shows everything.
    fits: bool,
    /// What is to be done when the commands at work are done.
    then: Then,
    /// Whether something went wrong since they began.
    has_failed: bool,
    /// Whether nothing was drawn before them.
    was_empty: bool,
    switches: Switches,
    /// How far the last refinement has missed its bounds.
    missed: Option<String>,
    /// From where the drawing came.
    source: Option<String>,
    tools: Tools,
    control: Control,
    watch: Watch,
    /// The steps of an algorithm, until the one that is shown.
    told: Told,
    course: information::Course,
    compare: Compare,
    lesson: Option<learn::Playing>,
    page: Page,
    path: String,
    pub(crate) dialogs: Dialogs,
    /// How high the window is.
    room: f32,
}

/// How wide the panel on the right is.
const SIDE: f32 = 320.0;

/// With more points than these a drawing did not come by clicks.
const FEW: usize = 2;

/// What is to be done when the commands at work are done.
#[derive(Debug, Default)]
struct Then {
    /// Everything is shown, also where they failed.
    fits: bool,
    /// Something was opened: everything is shown, and the first tool is taken, unless they failed.
    has_opened: bool,
    /// A file was written: this is said, unless they failed.
    says: Option<String>,
}

/// What the middle of the window shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Page {
    /// Where to begin.
    #[default]
    Welcome,
    /// The document.
    Draw,
    /// Recipes side by side.
    Compare,
}

impl Default for Studio {
    fn default() -> Self {
        Self::new(None)
    }
}

impl Studio {
    /// A studio with an empty document, which draws into a window's card of that format.
    #[must_use]
    pub fn new(format: Option<TextureFormat>) -> Self {
        Self {
            worker: Worker::new(),
            waiting: VecDeque::new(),
            picked: None,
            asked: String::new(),
            console: Console::default(),
            viewer: Viewer { number: 0, format },
            view: View::default(),
            fits: true,
            then: Then::default(),
            has_failed: false,
            was_empty: true,
            switches: Switches::default(),
            missed: None,
            source: None,
            tools: Tools::default(),
            control: Control::default(),
            watch: Watch::default(),
            told: Told::default(),
            course: information::Course::default(),
            compare: Compare::new(format),
            lesson: None,
            page: Page::default(),
            path: String::new(),
            dialogs: Dialogs::default(),
            room: 0.0,
        }
    }

    /// A studio for where there are neither threads nor a disk: commands are done slice by slice, on these files.
    #[must_use]
    pub fn in_slices(self, files: Files) -> Self {
        Self { worker: Worker::in_slices(files), ..self }
    }

    /// Runs the commands of a script, and shows all of what they lead to.
    pub fn run_script(&mut self, text: String) {
        (self.fits, self.page) = (true, Page::Draw);
        self.run(text, None);
    }

    /// Shows a message in the console.
    pub fn say(&mut self, kind: MessageKind, text: String) {
        self.console.add(vec![(kind, text)]);
    }

    /// Opens a drawing or a mesh, takes a recipe (`.toml`), or runs a script (`.tri`). What cannot be opened leaves the
    /// tool in hand and the view.
    pub fn open(&mut self, path: &str) {
        self.path = path.to_owned();
        let text = if path.ends_with(".tri") {
            match script::read_in(self.worker.files(), path) {
                Ok(text) => text,
                Err(error) => return self.say(MessageKind::Error, error.to_string()),
            }
        } else if path.ends_with(".toml") {
            format!("Recipe {}", script::word(path))
        } else {
            format!("Load {}", script::word(path))
        };
        self.page = Page::Draw;
        self.run_then(text, Then { has_opened: true, ..Then::default() });
    }

    /// The document, unless a command is at work on it.
    #[must_use]
    pub fn document(&self) -> Option<&Document> {
        self.worker.document()
    }

    /// Runs commands, one a line, as if they were typed.
    pub fn enter(&mut self, commands: &str) {
        self.page = Page::Draw;
        self.run(commands.to_owned(), None);
    }

    /// Runs commands, one a line.
    fn run(&mut self, text: String, context: Option<&egui::Context>) {
        if self.worker.is_busy() {
            let busy = "a command is at work: 'Cancel' stops it".to_owned();
            return self.console.add(vec![(MessageKind::Command, text), (MessageKind::Error, busy)]);
        }
        self.worker.run(&text, false, context.cloned());
        self.has_failed = false;
        self.asked = text;
        self.poll_shortly();
    }

    /// Runs commands, and does something when they are done.
    fn run_then(&mut self, text: String, then: Then) {
        if !self.worker.is_busy() {
            self.then = then;
        }
        self.run(text, None);
    }

    /// Shows in the drawing what a command has told of: `Show I J K` picks the triangle, `Plan I J` plans the edge.
    fn show_told(&mut self) {
        let Some(document) = self.worker.document() else { return };
        for line in std::mem::take(&mut self.asked).lines() {
            let mut words = line.split_whitespace();
            let name = words.next().unwrap_or_default();
            let names: Vec<u32> = words.map_while(|word| word.parse().ok()).collect();
            match names[..] {
                [i, j, k] if name.eq_ignore_ascii_case("Show") => {
                    self.picked = Picked::of(document, [i, j, k]).map(Picked::whole);
                }
                [i, j] if name.eq_ignore_ascii_case("Plan") => self.tools.edge.plan(document, [i, j]),
                _ => {}
            }
        }
    }

    /// Does what a tool asks for.
    fn act(&mut self, asked: Asked, context: &egui::Context) {
        match asked {
            Asked::Say(text) => self.console.add(vec![(MessageKind::Information, text)]),
            // A drag goes on: of moves that wait only the last one counts.
            Asked::Quietly(text) => {
                self.waiting.retain(|(_, is_quiet)| !is_quiet);
                self.waiting.push_back((text, true));
            }
            Asked::Run(text) if self.waiting.is_empty() && !self.control.has_drag() => self.run(text, Some(context)),
            Asked::Run(text) => self.waiting.push_back((text, false)),
            Asked::Pick(names) => {
                self.picked = self.worker.document().and_then(|document| Picked::of(document, names));
            }
        }
        self.run_waiting(context);
    }

    /// Runs commands that wait, as long as none takes long.
    fn run_waiting(&mut self, context: &egui::Context) {
        while !self.worker.is_busy() {
            let Some((text, is_quiet)) = self.waiting.pop_front() else { return };
            if self.control.takes_drag_back(self.worker.document()) {
                self.waiting.push_front((text, is_quiet));
                self.worker.run("Undo", true, Some(context.clone()));
                self.poll_dragging();
            } else if is_quiet {
                self.control.begin_drag(self.worker.document());
                self.worker.run(&text, true, Some(context.clone()));
                self.poll_dragging();
            } else {
                self.run(text, Some(context));
            }
        }
    }

    /// Takes what commands at work have said, and what they have done.
    fn poll(&mut self) {
        let news = self.worker.poll();
        self.take(news);
    }

    /// The same; waits for a short command.
    fn poll_shortly(&mut self) {
        let news = self.worker.poll_shortly();
        self.take(news);
    }

    /// The same in a drag, whose last command says what is wrong.
    fn poll_dragging(&mut self) {
        let (_, is_back) = self.worker.poll_shortly();
        self.take((Vec::new(), is_back));
    }

    fn take(&mut self, (mut messages, is_back): (Vec<Message>, bool)) {
        self.has_failed |= messages.iter().any(|(kind, _)| *kind == MessageKind::Error);
        if self.lesson.is_some() {
            // What a lesson tests of itself is not of interest.
            let is_test = |(kind, text): &Message| *kind == MessageKind::Command && text.starts_with("Expect ");
            messages.retain(|message| !is_test(message));
        }
        self.console.add(messages);
        if is_back {
            self.end();
        }
    }

    /// Takes what the commands have done that came to their end.
    fn end(&mut self) {
        let Some(document) = self.worker.document() else { return };
        let names = document.selection().first().copied();
        let before = self.picked.take();
        self.picked =
            names.and_then(|names| Picked::of(document, names)).map(|picked| picked.shown_as(before.as_ref()));
        self.course.note(document, &self.worker.scene().figures);
        self.switches.follow(document.options());
        self.missed = missed::of(document);
        self.source = information::source_of(document);
        let then = std::mem::take(&mut self.then);
        let vertices = self.worker.scene().vertices.len();
        // One who draws keeps the view in which the first corners were clicked.
        let is_filled = self.was_empty && vertices > 0 && (vertices > FEW || !self.tools.draws());
        self.was_empty = vertices == 0;
        let has_opened = then.has_opened && !self.has_failed;
        self.fits |= then.fits || is_filled || has_opened;
        if has_opened {
            self.tools.take(Tool::Pick);
        }
        if let Some(says) = then.says.filter(|_| !self.has_failed) {
            self.say(MessageKind::Information, says);
        }
        self.show_told();
    }

    /// The drawing; what the tool in hand asks for.
    fn show_viewer(&mut self, ui: &mut Ui) -> Vec<Asked> {
        let fits = std::mem::take(&mut self.fits);
        let scene = self.worker.scene().clone();
        // What is loaded now comes with the command at work.
        self.fits = fits && self.worker.is_busy();
        let mut view = self.view;
        let document = self.worker.document();
        let construction = document.and_then(|d| Some((d, d.construction()?)));
        let watched = construction.and_then(|(d, c)| Some((d, c, self.watch.shown(d, c)?)));
        let drawn = watched.map_or_else(|| scene.clone(), |(d, c, shown)| self.told.scene(d, c, shown));
        let shown = self.viewer.show(ui, (&drawn, "Drawing"), &mut view, &self.switches, fits);
        if let Some((d, c, at)) = watched {
            let step = at.checked_sub(1).and_then(|last| c.steps().get(last));
            let points = d.triangulation().map_or(&[][..], |t| t.points());
            overlay::draw_told(&shown.painter, &self.told, step, points);
        }
        let stepped = document.and_then(|d| Some((d.last_step()?, d.triangulation()?)));
        if let Some((event, t)) = stepped.filter(|_| self.switches.step) {
            overlay::draw_step(&shown.painter, event, t);
        }
        if let Some(picked) = &self.picked {
            overlay::draw_picked(&shown.painter, picked, &self.switches);
        }
        let asked = self.tools.work(&shown, &mut view, (document, &scene));
        if let Some(missed) = &self.missed {
            shown.painter.note(missed, ui.visuals().warn_fg_color);
        }
        if scene.vertices.is_empty() && !self.worker.is_busy() {
            shown.painter.hint(if self.lesson.is_some() {
                "'Next scene' goes on, 'Play lesson' goes through all of them."
            } else {
                "Nothing is drawn yet. Take 'Outline' and click corners, the first one again to close; or open a file."
            });
        }
        self.view = view;
        asked
    }

    /// Does what was chosen on the welcome page.
    fn welcome(&mut self, chosen: learn::Welcomed, context: &egui::Context) {
        (self.page, self.fits) = (Page::Draw, true);
        self.lesson = None;
        self.tools.take(Tool::Pick);
        match chosen {
            learn::Welcomed::Run(commands) => self.run(commands, Some(context)),
            learn::Welcomed::Draw => {
                self.tools.take(Tool::Outline);
                self.view = View::default();
                self.run("Clear".to_owned(), Some(context));
            }
            learn::Welcomed::Lesson(number) => {
                self.lesson = script::LEARN.get(number).map(learn::Playing::new);
                let first = self.lesson.as_mut().zip(self.worker.document());
                if let Some(learn::Asked::Run(text)) = first.and_then(|(lesson, document)| lesson.forward(document)) {
                    self.run(text, Some(context));
                }
            }
        }
    }

    /// Shows the window's contents.
    pub fn show(&mut self, ui: &mut Ui) {
        self.poll();
        strengthen(ui);
        let context = ui.ctx().clone();
        self.run_waiting(&context);
        if self.worker.is_busy() {
            context.request_repaint_after(self.worker.pause());
        }
        self.room = ui.available_height();
        let mut commands = self.take_keys(ui);
        for file in ui.input(|i| i.raw.dropped_files.clone()) {
            self.open(&file.path().to_string_lossy());
        }
        Panel::top("bar").show(ui, |ui| {
            // In a small window one scrolls.
            let most = 0.35 * self.room;
            let rows = egui::ScrollArea::vertical().max_height(most).min_scrolled_height(most);
            rows.show(ui, |ui| commands.extend(self.show_bar(ui)));
        });
        let most = (self.room / 3.0).min(0.4 * ui.available_height()).max(60.0);
        Panel::bottom("console").resizable(true).default_size(170.0).max_size(most).show(ui, |ui| {
            commands.extend(self.console.show(ui));
        });
        match self.page {
            Page::Welcome => self.show_welcome(ui, commands),
            Page::Draw => self.show_document(ui, commands),
            Page::Compare => self.show_compare(ui, commands),
        }
    }

    fn show_welcome(&mut self, ui: &mut Ui, commands: Vec<String>) {
        let context = ui.ctx().clone();
        let mut chosen = None;
        CentralPanel::default().show(ui, |ui| chosen = learn::show_welcome(ui));
        for command in commands {
            // What was typed here shows in the document.
            (self.page, self.fits) = (Page::Draw, true);
            self.run(command, Some(&context));
        }
        if let Some(chosen) = chosen {
            self.welcome(chosen, &context);
        }
    }

    fn show_compare(&mut self, ui: &mut Ui, commands: Vec<String>) {
        let mut said = Vec::new();
        CentralPanel::default().show(ui, |ui| said = self.compare.show(ui, &self.worker, &self.switches));
        self.console.add(said);
        commands.into_iter().for_each(|command| self.run(command, Some(ui.ctx())));
    }

    fn show_document(&mut self, ui: &mut Ui, mut commands: Vec<String>) {
        commands.extend(self.show_lesson(ui));
        // Always as wide, so that nothing moves under the pointer.
        let width = SIDE.min(0.45 * ui.available_width());
        Panel::right("side").resizable(false).exact_size(width).show(ui, |ui| {
            let all = egui::ScrollArea::both().auto_shrink(false);
            all.show(ui, |ui| commands.extend(self.show_side(ui)));
        });
        let mut asked = Vec::new();
        CentralPanel::default().show(ui, |ui| {
            switches::show_view(ui, &mut self.view, self.tools.hovered());
            asked = self.show_viewer(ui);
        });
        commands.into_iter().for_each(|command| self.run(command, Some(ui.ctx())));
        asked.into_iter().for_each(|asked| self.act(asked, ui.ctx()));
    }

    /// The lesson that plays; the commands of its next scene.
    fn show_lesson(&mut self, ui: &mut Ui) -> Option<String> {
        let lesson = self.lesson.as_mut()?;
        let mut asked = None;
        Panel::top("lesson").show(ui, |ui| asked = lesson.show(ui, self.worker.document()));
        self.then.fits |= asked.is_some();
        match asked? {
            learn::Asked::Run(text) => Some(text),
            learn::Asked::End(before) => {
                self.lesson = None;
                before
            }
        }
    }
}

impl eframe::App for Studio {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.show(ui);
    }
}

/// Gives text more contrast than the toolkit does.
fn strengthen(ui: &mut Ui) {
    let visuals = ui.visuals_mut();
    let colour = if visuals.dark_mode { egui::Color32::from_gray(205) } else { egui::Color32::from_gray(45) };
    visuals.widgets.noninteractive.fg_stroke.color = colour;
}
