//! `Export`.

use std::path::PathBuf;

use trimalla_io::WriteOptions;

use super::save::recover_beside;
use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Export",
    arguments: "FILE",
    summary: "writes the mesh, or before 'Triangulate' the drawing, in the format of the ending",
    help: "A mesh as .ele (with .node and .poly), .poly, .node, .edge, .neigh, .mesh, .soup, .vtu, .off or .svg; a drawing \
           as .poly, .node, .mesh or .svg. Files are written whole or not at all.",
    parse: |arguments| Deed::ask(Export { path: arguments.path()? }),
};

struct Export {
    path: PathBuf,
}

impl Ask for Export {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        recover_beside(&self.path);
        let options = WriteOptions::default();
        let written = match document.indexed() {
            Some(mesh) => trimalla_io::write_mesh(&self.path, &mesh, &options),
            None => trimalla_io::write_pslg(&self.path, document.drawing(), &options),
        };
        written.map_err(|error| CommandError::new(error.to_string()))?;
        interface.message(MessageKind::Information, &format!("{} written", self.path.display()));
        Ok(())
    }
}
