//! `Save`.

use std::path::{Path, PathBuf};

use trimalla_io::{IoError, Outputs};

use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Save",
    arguments: "FILE",
    summary: "writes the commands that led here, as a script",
    help: "Run on an empty document they lead here again. The file is written whole or not at all.",
    parse: |arguments| Deed::ask(Save { path: arguments.path()? }),
};

struct Save {
    path: PathBuf,
}

impl Ask for Save {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        write(document, &self.path, std::slice::from_ref(&self.path), interface, |outputs| {
            outputs.add_text(&self.path, &document.script())
        })
    }
}

/// Writes files whole or not at all, unless one of them was read. What a killed run has left in their folder is put in
/// its place or removed first.
pub(super) fn write(
    document: &Document,
    path: &Path,
    files: &[PathBuf],
    interface: &mut dyn Interface,
    add: impl FnOnce(&mut Outputs) -> Result<(), IoError>,
) -> Result<(), CommandError> {
    if let Some(read) = files.iter().find(|file| document.is_spared(file)) {
        let text = format!("{} was read, and is not replaced: give another name", read.display());
        return Err(CommandError::new(text));
    }
    let mut outputs = document.files().outputs(path);
    let written = add(&mut outputs).and_then(|()| outputs.commit());
    written.map_err(|error| CommandError::new(error.to_string()))?;
    interface.message(MessageKind::Information, &format!("{} written", path.display()));
    Ok(())
}
