//! What is written, and under which names.

use std::path::{Path, PathBuf};

use eframe::egui::Ui;
use trimalla_io::Files;
use trimalla_workbench::{MessageKind, script};

use super::{Studio, Then};
use crate::dialog::Wish;

/// What can be written: its name, the command, the ending, the help.
const WRITTEN: [(&str, &str, &str, &str); 13] = [
    ("Picture", "Export", ".svg", "lines that scale"),
    ("Picture", "Export", ".png", "pixels"),
    ("Player", "Player", ".html", "one page that plays the refinement in any browser, step by step"),
    ("Mesh", "Export", ".ele", "with .node and .poly, as Triangle writes them"),
    ("Mesh", "Export", ".vtu", "for ParaView"),
    ("Mesh", "Export", ".msh", "for Gmsh and solvers"),
    ("Mesh", "Export", ".meshsuite", "as MeshSuite writes it"),
    ("Mesh", "Export", ".soup", "the corners of each triangle in a line"),
    ("Mesh", "Export", ".off", "for geometry viewers"),
    ("Edges", "Export", ".edge", "as Triangle writes them"),
    ("Neighbours", "Export", ".neigh", "as Triangle writes them"),
    ("Script", "Save", ".tri", "the commands that led here"),
    ("Recipe", "SaveRecipe", ".toml", "the options on the right"),
];

impl Studio {
    /// Shows what can be written; writes what was chosen.
    pub(super) fn show_write(&mut self, ui: &mut Ui) {
        let mut chosen = None;
        for (name, word, ending, help) in WRITTEN {
            let file = self.name_for(ending);
            let asks = if self.dialogs.are_there { " …" } else { "" };
            if ui.button(format!("{name}: {file}{asks}")).on_hover_text(help).clicked() {
                chosen = Some((name, word, file, ending));
                ui.close();
            }
        }
        ui.separator();
        if ui.button("In the format of the name above").on_hover_text("by its ending").clicked() {
            chosen = Some(("", "Export", self.path.trim().to_owned(), ""));
            ui.close();
        }
        if let Some(folder) = self.whole_path("").filter(|_| matches!(self.worker.files(), Files::Disk)) {
            ui.weak(format!("into {}", folder.display()));
        }
        let Some((kind, word, file, ending)) = chosen else { return };
        if let Err(why) = self.can_write(word, &file) {
            return self.say(MessageKind::Error, why.to_owned());
        }
        // A name that was typed with its ending needs no question.
        if self.dialogs.are_there && !ending.is_empty() {
            self.wish(Wish::to_write(kind, word, &file, ending));
        } else {
            self.write(word, &file);
        }
    }

    /// Whether there is a name, and something to write; else why not.
    fn can_write(&self, word: &str, file: &str) -> Result<(), &'static str> {
        if file.is_empty() {
            return Err("there is no name: type one into the field 'File'");
        }
        let document = self.worker.document();
        if word != "SaveRecipe" && document.is_some_and(|d| d.figures().vertices == 0) {
            return Err("there is nothing to write: the drawing is empty");
        }
        Ok(())
    }

    /// Asks for a file to open, beside the last one.
    pub(super) fn browse(&mut self) {
        let folder = Path::new(self.path.trim()).parent().map(Path::to_path_buf);
        self.wish(Wish::to_open(folder.filter(|folder| !folder.as_os_str().is_empty())));
    }

    /// Writes a file by a command, and says where it is.
    pub(crate) fn write(&mut self, word: &str, file: &str) {
        let says = match self.worker.files() {
            Files::Disk => self.whole_path(file).map(|path| format!("it is in {}", path.display())),
            _ => None,
        };
        self.run_then(format!("{word} {}", script::word(file)), Then { says, ..Then::default() });
    }

    /// The path of a file of this name, from the root.
    fn whole_path(&self, file: &str) -> Option<PathBuf> {
        let folder = Path::new(self.path.trim()).parent().filter(|_| file.is_empty());
        let path = folder.map_or_else(|| PathBuf::from(file), |folder| folder.join("."));
        std::path::absolute(if path.as_os_str().is_empty() { Path::new(".") } else { &path }).ok()
    }

    /// The name under which something with this ending is written: the one above as it was given, else one that is
    /// free.
    fn name_for(&self, ending: &str) -> String {
        let (stem, is_given) = self.stem(ending);
        let files = self.worker.files();
        let together: &[&str] = if ending == ".ele" { &[".ele", ".node", ".poly"] } else { &[ending] };
        let is_free = |stem: &str| !together.iter().any(|ending| files.is_there(Path::new(&format!("{stem}{ending}"))));
        if is_given || is_free(&stem) {
            return format!("{stem}{ending}");
        }
        let numbered = (2..10_000).map(|number| format!("{stem}-{number}")).find(|stem| is_free(stem));
        format!("{}{ending}", numbered.unwrap_or(stem))
    }

    /// The name above without its ending, to which others are put; and whether the user gave it for this one.
    fn stem(&self, wanted: &str) -> (String, bool) {
        let path = Path::new(self.path.trim());
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
        let stem = path.with_extension("");
        let stem = stem.to_string_lossy();
        // What is read is not replaced.
        let is_input = ["poly", "node", "ele", "msh", "mesh", "meshsuite", "soup", "txt"].contains(&&*ending);
        match (stem.is_empty(), is_input) {
            (true, _) => {
                // What came with the program, or by a command.
                let source = self.source.as_deref().map(Path::new).and_then(Path::file_stem);
                (source.map_or_else(|| "mesh".to_owned(), |stem| stem.to_string_lossy().into_owned()), false)
            }
            (false, true) => (format!("{stem}.1"), false),
            (false, false) => (stem.into_owned(), ending.is_empty() || wanted[1..] == ending),
        }
    }
}
