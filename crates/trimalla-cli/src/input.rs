//! Drawings and meshes as read from files.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla_io::{Format, GroupNames, Numbered, read_mesh_numbered, read_pslg_with};
use trimalla_workbench::numbers::FileNumbers;

use crate::args::ImportOptions;
use crate::console::{note, shown};
use crate::exit::Failure;

/// A drawing or mesh that was read, and its files.
#[derive(Debug)]
pub(crate) struct Input<T> {
    pub(crate) value: T,
    /// The number of the first vertex in the file.
    pub(crate) first_index: u32,
    /// The files that were read, the one with segments or triangles first; none for standard input.
    pub(crate) files: Vec<PathBuf>,
    /// Messages about ignored parts of the files.
    pub(crate) notes: Vec<String>,
    /// What was read of a drawing of another program, and how: lines of the report.
    pub(crate) told: Vec<String>,
    /// Where its segments come from.
    origins: Vec<u32>,
    /// What these numbers count.
    noun: &'static str,
    /// Names of regions and boundaries.
    pub(crate) names: GroupNames,
}

impl Input<Pslg> {
    /// The numbers and lines of its file, for faults and warnings.
    pub(crate) fn numbers(&self) -> FileNumbers<'_> {
        let file = self.files.first().map(PathBuf::as_path);
        let numbers = FileNumbers::new(&self.value, self.first_index, self.name(), file);
        if self.told.is_empty() { numbers } else { numbers.with_origins(&self.origins, self.noun) }
    }
}

impl<T> Input<T> {
    fn of(numbered: Numbered<T>) -> Self {
        let Numbered { value, first_index, files, notes, told, origins, noun, names } = numbered;
        let notes = notes.iter().map(ToString::to_string).collect();
        Self { value, first_index, files, notes, told, origins, noun, names }
    }

    /// The same files with another content.
    pub(crate) fn with_value<U>(self, value: U) -> Input<U> {
        let Self { value: _, first_index, files, notes, told, origins, noun, names } = self;
        Input { value, first_index, files, notes, told, origins, noun, names }
    }

    /// Prints the messages about ignored parts to standard error, for commands whose report has no place for them.
    pub(crate) fn with_notes_shown(self) -> Self {
        self.notes.iter().for_each(|text| note("warning", text));
        self
    }

    /// The name of the input in messages.
    pub(crate) fn name(&self) -> String {
        self.files.first().map_or_else(|| "-".to_owned(), |file| shown(file))
    }

    /// The heading of a picture of it.
    pub(crate) fn title(&self) -> String {
        let stem = self.files.first().and_then(|file| file.file_stem());
        shown(Path::new(stem.unwrap_or(OsStr::new("standard input"))))
    }

    /// The number that the file gives to the vertex, segment or triangle with this index.
    pub(crate) fn number(&self, index: usize) -> usize {
        index + self.first_index as usize
    }
}

/// Reads a drawing.
pub(crate) fn read_drawing(path: &Path, import: &ImportOptions) -> Result<Input<Pslg>, Failure> {
    let read = read_pslg_with(path, &import.options()).map_err(Failure::from);
    match Format::from_path(path) {
        Some(Format::Ele) => read
            .map(Input::of)
            .map_err(|failure| failure.hint("an .ele file is a mesh; the drawing it was made from is needed here")),
        _ if Format::of_mesh(path) == Some(Format::Soup) => read.map(Input::of).map_err(|failure| {
            failure.hint(format!(
                "{} may be a soup of triangles, which is a mesh: 'trimalla refine' takes it, 'trimalla triangulate' too",
                shown(path)
            ))
        }),
        _ => read.map(Input::of),
    }
}

/// Reads a mesh.
pub(crate) fn read_mesh(path: &Path) -> Result<Input<IndexedMesh>, Failure> {
    let read = read_mesh_numbered(path).map_err(Failure::from);
    match Format::from_path(path) {
        Some(Format::Poly) => read
            .map(Input::of)
            .map_err(|failure| failure.hint("a .poly file is a drawing; 'trimalla mesh' makes a mesh of it")),
        _ => read.map(Input::of),
    }
}

/// Reads what is triangulated: a drawing; or a mesh, with the drawing of its segments.
///
/// A file in a format of meshes that holds no drawing is a mesh, and a `.txt` that is a soup and no drawing.
pub(crate) fn read_drawing_or_mesh(
    path: &Path,
    import: &ImportOptions,
) -> Result<(Input<Pslg>, Option<IndexedMesh>), Failure> {
    let format = Format::from_path(path).filter(|format| format.holds_triangles() && !format.holds_drawings());
    if format.is_some() {
        return read_mesh(path).map(with_drawing);
    }
    let drawing = read_drawing(path, import);
    match (drawing, Format::of_mesh(path)) {
        (Err(failure), Some(Format::Soup)) => read_mesh(path).map(with_drawing).map_err(|_| failure),
        (drawing, _) => drawing.map(|drawing| (drawing, None)),
    }
}

/// A mesh, and the drawing of its vertices and segments.
fn with_drawing(mut mesh: Input<IndexedMesh>) -> (Input<Pslg>, Option<IndexedMesh>) {
    let mut taken = std::mem::take(&mut mesh.value);
    taken.input_points = taken.points.len();
    let drawing = Pslg {
        points: taken.points.clone(),
        segments: taken.segments.clone(),
        segment_markers: taken.segment_markers.clone(),
        ..Pslg::default()
    };
    (mesh.with_value(drawing), Some(taken))
}

/// Whether a path names a mesh: a file that holds triangles, or the stem of an `.ele` file.
pub(crate) fn is_mesh(path: &Path) -> bool {
    let beside = || {
        let mut name = path.as_os_str().to_owned();
        name.push(".ele");
        Path::new(&name).exists()
    };
    match Format::from_path(path) {
        Some(format) => format.holds_triangles(),
        None if Format::of_mesh(path).is_some() => true,
        None => path != Path::new("-") && beside(),
    }
}
