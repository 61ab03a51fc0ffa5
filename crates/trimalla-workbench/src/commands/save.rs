//! `Save`.

use std::path::{Path, PathBuf};

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
        recover_beside(&self.path);
        let write = || {
            let mut outputs = trimalla_io::Outputs::default();
            outputs.add_text(&self.path, &document.script())?;
            outputs.commit()
        };
        write().map_err(|error: trimalla_io::IoError| CommandError::new(error.to_string()))?;
        interface.message(MessageKind::Information, &format!("{} written", self.path.display()));
        Ok(())
    }
}

/// Puts files in their places, and removes temporary ones, that a killed run has left in the folder of a file.
pub(super) fn recover_beside(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    trimalla_io::recover(folder.unwrap_or(Path::new(".")));
}
