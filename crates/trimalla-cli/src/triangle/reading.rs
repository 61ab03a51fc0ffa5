//! The files that switches ask to read.

use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla_io::{IoError, node, poly, read_areas, read_bytes, read_mesh_numbered};
use trimalla_triangle::{Input, Switches};
use trimalla_workbench::numbers::FileNumbers;

use super::names::Names;
use crate::args::ImportOptions;
use crate::console::shown;
use crate::exit::Failure;
use crate::input;

/// What was read.
#[derive(Debug)]
pub(super) struct Read {
    pub(super) content: Content,
    /// The number of the first vertex.
    pub(super) first_index: u32,
    /// The files, the one that was asked for first.
    pub(super) files: Vec<PathBuf>,
    /// What was ignored in them.
    pub(super) notes: Vec<String>,
    /// Whether a `.poly` file has the vertices, and no `.node` file.
    pub(super) has_own_vertices: bool,
}

/// A drawing, or a mesh with its area bounds.
#[derive(Debug)]
pub(super) enum Content {
    Drawing(Pslg),
    Mesh(IndexedMesh, Vec<Option<f64>>),
}

impl Read {
    /// The files of a drawing, a set of points or a mesh.
    pub(super) fn of(names: &Names, switches: &Switches) -> Result<Self, Failure> {
        match (switches.refine, switches.drawing) {
            (true, _) => Self::of_mesh(names, switches),
            (false, true) => Self::of_drawing(names, switches),
            (false, false) => Self::of_points(names),
        }
    }

    /// The input of the call.
    pub(super) fn input(&self) -> Input<'_> {
        match &self.content {
            Content::Drawing(drawing) => Input::Drawing(drawing),
            Content::Mesh(mesh, areas) => Input::Mesh(mesh, areas),
        }
    }

    /// The name of the first file in messages.
    pub(super) fn name(&self) -> String {
        self.files.first().map(|file| shown(file)).unwrap_or_default()
    }

    /// The numbers and lines of the file of a drawing, for faults and warnings.
    pub(super) fn numbers<'a>(&'a self, drawing: &'a Pslg) -> FileNumbers<'a> {
        FileNumbers::new(drawing, self.first_index, self.name(), self.files.first().map(PathBuf::as_path))
    }

    fn of_points(names: &Names) -> Result<Self, Failure> {
        let read = input::read_drawing(&names.input("node"), &ImportOptions::default())?;
        Ok(Self {
            content: Content::Drawing(read.value),
            first_index: read.first_index,
            files: read.files,
            notes: read.notes,
            has_own_vertices: false,
        })
    }

    fn of_drawing(names: &Names, switches: &Switches) -> Result<Self, Failure> {
        let (path, beside) = (names.input("poly"), names.input("node"));
        let mut files = vec![path.clone()];
        let read = poly::read(&bytes(&path)?, &shown(&path), || {
            let nodes = node::read(&bytes(&beside)?, &shown(&beside))?;
            files.push(beside);
            Ok(nodes)
        })?;
        let notes = read.nodes.notes.iter().chain(&read.sections.notes).map(ToString::to_string).collect();
        let (first_index, lone) = (read.nodes.first_index, read.sections.lone_numbers.clone());
        let mut drawing = read.into_pslg();
        if switches.own_areas {
            // A lone number behind the seed is the attribute and the area.
            for index in lone {
                let region = drawing.regions.get_mut(index);
                region.into_iter().for_each(|r| r.max_area = Some(r.attribute).filter(|&area| area > 0.0));
            }
        }
        let has_own_vertices = files.len() == 1;
        Ok(Self { content: Content::Drawing(drawing), first_index, files, notes, has_own_vertices })
    }

    fn of_mesh(names: &Names, switches: &Switches) -> Result<Self, Failure> {
        let (path, drawing) = (names.input("ele"), names.input("poly"));
        let read = read_mesh_numbered(&path)?;
        let mut files = read.files;
        if switches.drawing {
            check_subsegments(&drawing, &files, &read.value)?;
        }
        let mut areas = Vec::new();
        if switches.own_areas {
            let beside = names.input("area");
            let found = read_areas(&path, read.value.triangles.len())?;
            let (found, file) = found.ok_or(IoError::Missing { path: beside, needed_by: None })?;
            areas = found.0;
            files.push(file);
        }
        Ok(Self {
            content: Content::Mesh(read.value, areas),
            first_index: read.first_index,
            files,
            notes: read.notes.iter().map(ToString::to_string).collect(),
            has_own_vertices: false,
        })
    }
}

/// Refuses a mesh whose subsegments are asked for and missing.
fn check_subsegments(drawing: &Path, files: &[PathBuf], mesh: &IndexedMesh) -> Result<(), Failure> {
    if !files.iter().any(|file| file == drawing) {
        return Err(IoError::Missing { path: drawing.to_owned(), needed_by: None }.into());
    }
    if mesh.segments.is_empty() {
        let bytes = bytes(drawing)?;
        let has_own = poly::read(&bytes, &shown(drawing), || node::read(b"0 2 0 0\n", "")).is_ok();
        if has_own {
            let message = format!("{} has vertices of its own: it lists no subsegments of the mesh", shown(drawing));
            return Err(Failure::bad_input(message)
                .hint("'trimalla refine MESH --input DRAWING' takes the drawing that the mesh was made from"));
        }
    }
    Ok(())
}

fn bytes(path: &Path) -> Result<Vec<u8>, IoError> {
    read_bytes(path, u64::MAX)
}
