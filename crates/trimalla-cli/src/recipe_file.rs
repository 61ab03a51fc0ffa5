//! Recipe files on the command line: `--recipe` reads one, `--save-recipe` writes what was asked in the end.

use std::path::{Path, PathBuf};

use clap::Args;
use trimalla::refine::{NamedOptions, OptionRow, Value};

use crate::console::shown;

/// Where recipes come from and go.
#[derive(Debug, Args)]
pub(crate) struct RecipeFileOptions {
    /// Begin with the recipe in this TOML file; other options change it
    ///
    /// The file may hold the steps, the criteria and the limits, each by the name of its option. --algorithm replaces
    /// all steps of the file at once.
    #[arg(long, value_name = "FILE", help_heading = "Refinement")]
    pub(crate) recipe: Option<PathBuf>,

    /// Write everything that was asked of the refinement to this TOML file, for --recipe and for compare --recipes
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub(crate) save_recipe: Option<PathBuf>,
}

/// The recipe, which is called like its file if it says no name itself.
pub(crate) fn named(mut file: NamedOptions, path: &Path) -> NamedOptions {
    let stem = || path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    file.name = file.name.or_else(stem);
    file
}

/// What tables call a recipe: its name, without what a terminal would obey.
pub(crate) fn title(file: &NamedOptions) -> String {
    let of_preset = file.preset.unwrap_or_default().key();
    shown(Path::new(file.name.as_deref().unwrap_or(of_preset)))
}

/// What reports for programs call a recipe: its own name if it has one, or else that of the preset and the steps that
/// were changed.
pub(crate) fn key(file: &NamedOptions) -> String {
    if file.name.is_some() { title(file) } else { full_title(file) }
}

/// What reports for people call a recipe: its name, the preset that it started from if that is another, and the steps
/// that were changed since.
pub(crate) fn full_title(file: &NamedOptions) -> String {
    let (name, preset) = (title(file), file.preset.unwrap_or_default().key());
    let changes = in_words(file.changed_steps());
    match (name == preset, changes.is_empty()) {
        (true, true) => name,
        (true, false) => format!("{preset}, changed: {changes}"),
        (false, true) => format!("{name} ({preset})"),
        (false, false) => format!("{name} ({preset}, changed: {changes})"),
    }
}

/// Every step of a recipe, in words; what only longest-edge paths need is there where they are followed.
pub(crate) fn steps(asked: &NamedOptions) -> String {
    let is_lepp = asked.recipe.point.key().starts_with("lepp");
    in_words(asked.steps().filter(|(option, _)| is_lepp || !option.is_of_paths))
}

fn in_words(options: impl Iterator<Item = (&'static OptionRow, Value)>) -> String {
    options.map(|(option, value)| format!("{} {value}", option.key)).collect::<Vec<_>>().join(", ")
}
