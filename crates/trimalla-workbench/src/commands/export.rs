//! `Export`.

use std::path::PathBuf;

use trimalla_io::WriteOptions;

use super::save::write;
use super::{Ask, CommandRow, Deed};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::Interface;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Export",
    arguments: "FILE",
    summary: "writes the mesh, or before 'Triangulate' the drawing, in the format of the ending",
    help: "A mesh as .ele (with .node and .poly), .poly, .node, .edge, .neigh, .msh, .msh2, .inp, .mesh, .meshsuite, .su2, \
           .vtu, .vtk, .obj, .ply, .stl, .off, .geojson, .soup, .svg or .png; a drawing as .poly, .node, .mesh, .meshsuite, \
           .svg or .png. Files are written whole or not at all.",
    parse: |arguments| Deed::ask(Export { path: arguments.path()? }),
};

struct Export {
    path: PathBuf,
}

impl Ask for Export {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let options = WriteOptions::default();
        match document.indexed() {
            Some(mesh) => {
                let files = trimalla_io::files_of_mesh(&self.path, &options);
                write(document, &self.path, &files, interface, |outputs| outputs.add_mesh(&self.path, &mesh, &options))
            }
            None => write(document, &self.path, std::slice::from_ref(&self.path), interface, |outputs| {
                outputs.add_pslg(&self.path, &document.state().input.whole_drawing(), &options)
            }),
        }
    }
}
