//! The studio in a page: a canvas of `index.html`, a link that carries a script, files in memory.

mod files;

use eframe::egui::{self, Panel, Ui};
use trimalla_io::{Files, Memory};
use trimalla_workbench::MessageKind;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, HtmlCanvasElement, HtmlElement, Window};

use crate::app::Studio;
use crate::exchange::Exchange;
use crate::link;
use files::Inbox;

/// The studio, and what a page has besides.
struct Page {
    studio: Studio,
    exchange: Exchange,
    inbox: Inbox,
    /// What the page was last told of the document.
    told: String,
}

/// Shows the studio in the page; what fails is written there.
pub fn start() {
    wasm_bindgen_futures::spawn_local(async {
        if let Err(error) = show().await {
            tell_failure(&error);
        }
    });
}

async fn show() -> Result<(), String> {
    let document = document().ok_or("there is no page")?;
    let canvas = document.get_element_by_id("studio").and_then(|found| found.dyn_into::<HtmlCanvasElement>().ok());
    let canvas = canvas.ok_or("the page has no canvas 'studio'")?;
    let script = window().and_then(|window| window.location().hash().ok()).and_then(|hash| link::script_of(&hash));
    let page = Box::new(move |created: &eframe::CreationContext<'_>| {
        let format = created.wgpu_render_state.as_ref().map(|state| state.target_format);
        Ok(Box::new(Page::new(script, format)) as Box<dyn eframe::App>)
    });
    let shown = eframe::WebRunner::new().start(canvas, eframe::WebOptions::default(), page).await;
    shown.map_err(|error| text_of(&error))?;
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    Ok(())
}

impl Page {
    fn new(script: Option<String>, format: Option<eframe::wgpu::TextureFormat>) -> Self {
        let memory = Memory::default();
        let mut studio = Studio::new(format).in_slices(Files::Memory(memory.clone()));
        if let Some(script) = script {
            studio.run_script(script);
        }
        Self { studio, exchange: Exchange::new(memory), inbox: Inbox::default(), told: String::new() }
    }

    /// The buttons that a window does not need.
    fn show_bar(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            let help = "adds files of yours to those of the page, and opens one; or drop them anywhere";
            if ui.button("Choose files").on_hover_text(help).clicked() {
                self.inbox.choose(ui.ctx());
            }
            let help = "a link to this page that carries the commands which led here";
            if ui.button("Copy link").on_hover_text(help).clicked() {
                self.copy_link(ui.ctx());
            }
            ui.label("'Save' and 'Export' download.");
        });
    }

    fn copy_link(&mut self, context: &egui::Context) {
        let Some(document) = self.studio.document() else {
            return self.studio.say(MessageKind::Error, "a command is at work: the link is made after it".to_owned());
        };
        let script = document.script();
        match link::fragment_of(&script) {
            Ok(fragment) => {
                let text = match set_fragment(&fragment) {
                    Some(link) => {
                        context.copy_text(link);
                        "the link is copied, and in the address bar".to_owned()
                    }
                    None => "the page has no address".to_owned(),
                };
                self.studio.say(MessageKind::Information, text);
                if script.lines().any(|line| line.trim_start().to_ascii_lowercase().starts_with("load ")) {
                    let text = "it names files and does not carry them: they must be dropped first";
                    self.studio.say(MessageKind::Information, text.to_owned());
                }
            }
            Err(length) => {
                let most = link::LONGEST;
                let text =
                    format!("a link would take {length} characters, and {most} are the most: 'Save' writes a file");
                self.studio.say(MessageKind::Error, text);
            }
        }
    }

    /// Opens what has come in, and offers what was written.
    fn exchange_files(&mut self, ui: &Ui) {
        let dropped = ui.input_mut(|input| std::mem::take(&mut input.raw.dropped_files));
        self.inbox.read(dropped, ui.ctx());
        if self.studio.document().is_none() {
            return;
        }
        let (arrived, failed) = self.inbox.take();
        for error in failed {
            self.studio.say(MessageKind::Error, error);
        }
        if let Some(name) = self.exchange.arrive(arrived) {
            self.studio.open(&name.to_string_lossy());
        }
        for (name, content) in self.exchange.written() {
            if let Err(error) = files::download(&name, &content) {
                self.studio
                    .say(MessageKind::Error, format!("{} is not downloaded: {}", name.display(), text_of(&error)));
            }
        }
    }

    /// Tells the page how large the document is, for scripts of the page and for tests.
    fn tell(&mut self) {
        let told = match self.studio.document() {
            None => "busy".to_owned(),
            Some(document) => {
                let figures = document.figures();
                let (done, _) = document.undoable();
                let (vertices, triangles, angle) = (figures.vertices, figures.triangles, figures.min_angle_deg);
                format!("ready commands={done} vertices={vertices} triangles={triangles} min-angle={angle:.2}")
            }
        };
        if told != self.told {
            let body = document().and_then(|document| document.body());
            let is_set = body.and_then(|body| body.set_attribute("data-document", &told).ok());
            if is_set.is_some() {
                self.told = told;
            }
        }
    }
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.exchange_files(ui);
        Panel::top("page").show(ui, |ui| self.show_bar(ui));
        self.studio.show(ui);
        self.tell();
    }
}

fn window() -> Option<Window> {
    web_sys::window()
}

fn document() -> Option<Document> {
    window()?.document()
}

/// Puts a fragment into the address bar; the whole address.
fn set_fragment(fragment: &str) -> Option<String> {
    let window = window()?;
    window.history().ok()?.replace_state_with_url(&JsValue::NULL, "", Some(fragment)).ok()?;
    window.location().href().ok()
}

/// Writes into the page why there is no studio.
fn tell_failure(error: &str) {
    let shown = document().and_then(|document| document.get_element_by_id("loading"));
    if let Some(shown) = shown.and_then(|found| found.dyn_into::<HtmlElement>().ok()) {
        shown.set_inner_text(&format!("The studio cannot be shown: {error}. It needs WebGL 2."));
    }
}

/// What an error of the browser says.
fn text_of(error: &JsValue) -> String {
    let of_error = error.dyn_ref::<js_sys::Error>().map(|error| String::from(error.message()));
    of_error.or_else(|| error.as_string()).unwrap_or_else(|| format!("{error:?}"))
}
