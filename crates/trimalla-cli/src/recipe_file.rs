//! Recipe files on the command line: `--recipe` reads one, `--save-recipe` writes what was asked in the end.

use std::path::{Path, PathBuf};

use clap::Args;
use trimalla::refine::Recipe;
use trimalla_io::{RecipeFile, recipe};

use crate::console::shown;
use crate::exit::Failure;
use crate::recipe_options::RecipeOptions;

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

impl RecipeFileOptions {
    /// The recipe of the file, or else that of the default preset, with the steps that the command line names. What
    /// else the command line says is the caller's to add.
    pub(crate) fn read(&self, steps: &RecipeOptions) -> Result<RecipeFile, Failure> {
        let mut file = match &self.recipe {
            Some(path) => named(recipe::read_file(path)?, path),
            None => RecipeFile::of(steps.preset()),
        };
        if let (Some(preset), true) = (steps.algorithm, self.recipe.is_some()) {
            (file.name, file.preset, file.recipe) = (None, Some(preset), preset.recipe());
        }
        steps.change(&mut file.recipe);
        Ok(file)
    }
}

/// The recipe, which is called like its file if it says no name itself.
pub(crate) fn named(mut file: RecipeFile, path: &Path) -> RecipeFile {
    let stem = || path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    file.name = file.name.or_else(stem);
    file
}

/// What tables call a recipe: its name, without what a terminal would obey.
pub(crate) fn title(file: &RecipeFile) -> String {
    let of_preset = file.preset.unwrap_or_default().key();
    shown(Path::new(file.name.as_deref().unwrap_or(of_preset)))
}

/// What reports for programs call a recipe: its own name if it has one, or else that of the preset and the steps that
/// were changed.
pub(crate) fn key(file: &RecipeFile) -> String {
    if file.name.is_some() { title(file) } else { full_title(file) }
}

/// What reports for people call a recipe: its name, the preset that it started from if that is another, and the steps
/// that were changed since.
pub(crate) fn full_title(file: &RecipeFile) -> String {
    let (name, preset) = (title(file), file.preset.unwrap_or_default().key());
    let changes: Vec<String> = changes(file).iter().map(|(option, key)| format!("{option} {key}")).collect();
    match (name == preset, changes.is_empty()) {
        (true, true) => name,
        (true, false) => format!("{preset}, changed: {}", changes.join(", ")),
        (false, true) => format!("{name} ({preset})"),
        (false, false) => format!("{name} ({preset}, changed: {})", changes.join(", ")),
    }
}

/// The choices of a recipe that are not those of its preset: the option and the key.
pub(crate) fn changes(file: &RecipeFile) -> Vec<(&'static str, &'static str)> {
    let of_preset = file.preset.unwrap_or_default().recipe().choices();
    file.recipe.choices().into_iter().zip(of_preset).filter(|(own, preset)| own != preset).map(|(own, _)| own).collect()
}

/// Every step of a recipe, in words; what only longest-edge paths need is there where they are followed.
pub(crate) fn steps(recipe: &Recipe) -> String {
    let is_lepp = recipe.point.key().starts_with("lepp");
    let of_paths = ["lepp-stop", "centroid", "constrained-second", "terminal"];
    let choices = recipe.choices().into_iter().filter(|(option, _)| is_lepp || !of_paths.contains(option));
    choices.map(|(option, key)| format!("{option} {key}")).collect::<Vec<_>>().join(", ")
}
