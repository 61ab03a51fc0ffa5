//! File dialogs: what one is to ask for, and what came of it. The window opens them; a page has those of its browser.

use std::path::PathBuf;

use trimalla_workbench::MessageKind;

use crate::app::Studio;

/// What a file dialog is to ask for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wish {
    /// What stands above it.
    pub title: String,
    /// Whether an existing file is opened, or one is written.
    pub purpose: Purpose,
    /// Kinds of files: a name, and the endings without the dot.
    pub kinds: Vec<(String, Vec<String>)>,
    /// The folder in which it begins; `None` for the one that the system proposes.
    pub folder: Option<PathBuf>,
}

/// What a chosen file is for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// It is opened.
    Open,
    /// It is written by a command.
    Write {
        /// The command.
        word: &'static str,
        /// The name that is proposed, without folders.
        name: String,
        /// The path where no dialog can ask for another one.
        path: String,
        /// The ending of a name that has none, with the dot.
        ending: &'static str,
    },
}

/// What came of a dialog.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// A file was chosen.
    Chosen(PathBuf),
    /// The dialog was closed.
    Closed,
    /// No dialog can be shown here.
    Impossible,
}

/// What can be opened.
const OPENED: [(&str, &[&str]); 5] = [
    ("Everything that opens", &["poly", "node", "ele", "mesh", "soup", "txt", "tri", "toml"]),
    ("Drawings", &["poly", "node", "mesh"]),
    ("Meshes", &["ele", "mesh", "soup", "txt"]),
    ("Scripts", &["tri"]),
    ("Recipes", &["toml"]),
];

impl Wish {
    /// A file to open.
    pub(crate) fn to_open(folder: Option<PathBuf>) -> Self {
        let kinds = OPENED.iter().map(|(name, endings)| (*name, *endings));
        Self::new("Open".to_owned(), Purpose::Open, kinds, folder)
    }

    /// A file to write: its kind, the command, the path where none is chosen, and its ending.
    pub(crate) fn to_write(kind: &str, word: &'static str, path: &str, ending: &'static str) -> Self {
        let whole = PathBuf::from(path);
        let name = whole.file_name().map_or_else(|| path.to_owned(), |name| name.to_string_lossy().into_owned());
        let folder = whole.parent().filter(|folder| !folder.as_os_str().is_empty()).map(PathBuf::from);
        let purpose = Purpose::Write { word, name, path: path.to_owned(), ending };
        let bare = ending.trim_start_matches('.');
        Self::new(format!("Write {}", kind.to_lowercase()), purpose, [(kind, &[bare][..])].into_iter(), folder)
    }

    fn new<'a>(
        title: String,
        purpose: Purpose,
        kinds: impl Iterator<Item = (&'a str, &'a [&'a str])>,
        folder: Option<PathBuf>,
    ) -> Self {
        let owned = |(name, endings): (&str, &[&str])| {
            (name.to_owned(), endings.iter().map(|&ending| ending.to_owned()).collect())
        };
        let folder = folder.and_then(|folder| std::path::absolute(folder).ok()).filter(|folder| folder.is_dir());
        Self { title, purpose, kinds: kinds.map(owned).collect(), folder }
    }
}

/// What the window around the studio does with dialogs.
impl Studio {
    /// A studio that asks for files by dialogs: the window takes [wishes](Self::take_wish) and
    /// [answers](Self::answer) them. Another studio has the field 'File' alone.
    #[must_use]
    pub fn with_dialogs(mut self) -> Self {
        self.dialogs.are_there = true;
        self
    }

    /// The dialog that is to be opened now.
    pub fn take_wish(&mut self) -> Option<Wish> {
        self.dialogs.wish.take()
    }

    /// Opens or writes the file that a dialog has asked for.
    pub fn answer(&mut self, wish: Wish, answer: Answer) {
        match (wish.purpose, answer) {
            (_, Answer::Closed) => {}
            (Purpose::Open, Answer::Chosen(path)) => self.open(&path.to_string_lossy()),
            (Purpose::Open, Answer::Impossible) => self.say_impossible("type a path into 'File', or drop a file"),
            (Purpose::Write { word, ending, .. }, Answer::Chosen(mut path)) => {
                if path.extension().is_none() {
                    path.set_extension(&ending[1..]);
                }
                self.write(word, &path.to_string_lossy());
            }
            (Purpose::Write { word, path, .. }, Answer::Impossible) => {
                self.say_impossible("the file gets the name that the menu shows");
                self.write(word, &path);
            }
        }
    }

    /// Asks for a dialog.
    pub(crate) fn wish(&mut self, wish: Wish) {
        self.dialogs.wish = Some(wish);
    }

    fn say_impossible(&mut self, instead: &str) {
        let needs = if cfg!(target_os = "linux") { " (it needs xdg-desktop-portal or zenity)" } else { "" };
        self.say(MessageKind::Information, format!("no file dialog can be shown here{needs}: {instead}"));
    }
}

/// What a studio knows of dialogs.
#[derive(Debug, Default)]
pub(crate) struct Dialogs {
    /// Whether the window has any.
    pub(crate) are_there: bool,
    /// The one that is to be opened now.
    wish: Option<Wish>,
}
