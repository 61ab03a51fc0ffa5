//! `SaveRecipe`.

use std::path::PathBuf;

use trimalla_io::recipe;

use super::save::write;
use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::Interface;

pub(super) const ROW: CommandRow = CommandRow {
    name: "SaveRecipe",
    arguments: "FILE",
    summary: "writes the options of the refinement as a recipe file",
    help: "'Recipe' reads it, and so does '--recipe' of the program. The file is written whole or not at all.",
    parse: |arguments| Deed::ask(SaveRecipe { path: arguments.path()? }),
};

struct SaveRecipe {
    path: PathBuf,
}

impl Ask for SaveRecipe {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let mut bytes = Vec::new();
        let written = recipe::write(&mut bytes, document.options());
        written.map_err(|error| CommandError::new(error.to_string()))?;
        write(document, &self.path, std::slice::from_ref(&self.path), interface, |outputs| {
            outputs.add_text(&self.path, &String::from_utf8_lossy(&bytes))
        })
    }
}
