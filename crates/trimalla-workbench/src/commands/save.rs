//! `Save`.

use std::path::PathBuf;

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
