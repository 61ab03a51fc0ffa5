//! From a path to a drawing or a mesh.

use std::io;
use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg};

use crate::area::{self, Areas};
use crate::bytes::{self, LONGEST_FILE};
use crate::error::{IoError, Note};
use crate::files::Files;
use crate::format::{Format, companion};
use crate::node::{self, Nodes};
use crate::poly::{self, Poly, Sections};
use crate::{ele, meshsuite, soup};

/// The content of a file, and the number that it gives to its first vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbered<T> {
    /// The drawing or mesh; its indices count from 0.
    pub value: T,
    /// The number of the first vertex in the file: 0 or 1 (1 where vertices have no numbers). Hand it to
    /// [`WriteOptions`](crate::WriteOptions) to keep it.
    pub first_index: u32,
    /// The files that were read, the one with the name asked for first; empty for standard input.
    pub files: Vec<PathBuf>,
    /// What was ignored in the files.
    pub notes: Vec<Note>,
}

impl<T> Numbered<T> {
    /// The content of one file, nothing of which was ignored.
    fn whole(value: T, first_index: u32, path: &Path) -> Self {
        Self { value, first_index, files: vec![path.to_owned()], notes: Vec::new() }
    }
}

impl Numbered<Pslg> {
    fn of_poly(mut poly: Poly, files: Vec<PathBuf>) -> Self {
        let mut notes = std::mem::take(&mut poly.nodes.notes);
        notes.append(&mut poly.sections.notes);
        Self { first_index: poly.nodes.first_index, value: poly.into_pslg(), files, notes }
    }
}

/// Reads a drawing: a `.poly` file (with its `.node` file where it has no vertices of its own), a `.node` file,
/// `MeshSuite`'s `.mesh` (whose triangles are left out), the stem of a `.poly` or `.node` file, or `-` for standard
/// input.
///
/// # Errors
/// Every [`IoError`] that is not about output.
pub fn read_pslg(path: impl AsRef<Path>) -> Result<Pslg, IoError> {
    read_pslg_numbered(path).map(|drawing| drawing.value)
}

/// Reads a drawing as [`read_pslg`] does, and says where its numbers start.
///
/// # Errors
/// Every [`IoError`] that is not about output.
pub fn read_pslg_numbered(path: impl AsRef<Path>) -> Result<Numbered<Pslg>, IoError> {
    pslg(&Files::Disk, path.as_ref())
}

/// Reads a drawing.
pub(crate) fn pslg(files: &Files, path: &Path) -> Result<Numbered<Pslg>, IoError> {
    if path == Path::new("-") && matches!(files, Files::Disk) {
        let bytes = bytes::of_stream(io::stdin().lock()).map_err(|source| unreadable(path, source))?;
        return Ok(Numbered::of_poly(poly::read_unnamed(&bytes, "-")?, Vec::new()));
    }
    match Format::from_path(path) {
        Some(Format::Poly) => read_poly(files, path),
        Some(Format::Node) => {
            let mut nodes = read_nodes(files, path, None)?;
            let notes = std::mem::take(&mut nodes.notes);
            let first_index = nodes.first_index;
            Ok(Numbered { notes, ..Numbered::whole(nodes.into_pslg(), first_index, path) })
        }
        Some(Format::MeshSuite) => {
            let file = meshsuite::read(&read_file(files, path, None)?, &name_of(path))?;
            let first_index = file.first_index;
            Ok(Numbered::whole(file.into_pslg(), first_index, path))
        }
        None => match of_stem(files, path, &[Format::Poly, Format::Node]) {
            Some(file) => pslg(files, &file),
            None => Err(unknown(path, DRAWING_ENDINGS)),
        },
        Some(_) => Err(unknown(path, DRAWING_ENDINGS)),
    }
}

const DRAWING_ENDINGS: &str = ".poly, .node or .mesh";
const MESH_ENDINGS: &str = ".ele, .mesh, .soup or .txt";

/// Reads a mesh: an `.ele` file with the `.node` file beside it and, where there is one without vertices of its own,
/// the `.poly` file, which names subsegments and holes. The `.node` file or the stem names the same mesh. Or one file:
/// `MeshSuite`'s `.mesh`, or a `.soup` (or `.txt`) of triangles.
///
/// # Errors
/// Every [`IoError`] that is not about output.
pub fn read_mesh(path: impl AsRef<Path>) -> Result<IndexedMesh, IoError> {
    read_mesh_numbered(path).map(|mesh| mesh.value)
}

/// Reads a mesh as [`read_mesh`] does, and says where its numbers start.
///
/// # Errors
/// Every [`IoError`] that is not about output.
pub fn read_mesh_numbered(path: impl AsRef<Path>) -> Result<Numbered<IndexedMesh>, IoError> {
    mesh(&Files::Disk, path.as_ref())
}

/// Reads a mesh.
pub(crate) fn mesh(files: &Files, path: &Path) -> Result<Numbered<IndexedMesh>, IoError> {
    match Format::from_path(path) {
        Some(Format::Node) => return read_group(files, &companion(path, Format::Ele)),
        None if of_stem(files, path, &[Format::Ele]).is_some() => {
            return read_group(files, &companion(path, Format::Ele));
        }
        _ => {}
    }
    match Format::of_mesh(path) {
        Some(Format::Ele) => read_group(files, path),
        Some(Format::MeshSuite) => {
            let file = meshsuite::read_mesh(&read_file(files, path, None)?, &name_of(path))?;
            let first_index = file.first_index;
            Ok(Numbered::whole(file.into_mesh(), first_index, path))
        }
        Some(Format::Soup) => {
            let value = soup::read(&read_file(files, path, None)?, &name_of(path))?;
            Ok(Numbered::whole(value, 1, path))
        }
        _ => Err(unknown(path, MESH_ENDINGS)),
    }
}

/// Reads the area bounds of a mesh, which lie in an `.area` file beside its `.ele` file, with the name of that file.
///
/// `path` names the mesh as it does for [`read_mesh`]. `None` where there is no such file, or the mesh is in another
/// format.
///
/// # Errors
/// Every [`IoError`] that is not about output; a count other than `triangles` is a fault in the file.
pub fn read_areas(path: impl AsRef<Path>, triangles: usize) -> Result<Option<(Areas, PathBuf)>, IoError> {
    let (files, path) = (&Files::Disk, path.as_ref());
    if !matches!(Format::from_path(path), None | Some(Format::Ele | Format::Node))
        || !files.is_there(&companion(path, Format::Ele))
    {
        return Ok(None);
    }
    let beside = companion(path, Format::Area);
    if !files.is_there(&beside) {
        return Ok(None);
    }
    let areas = area::read(&read_file(files, &beside, None)?, &name_of(&beside))?;
    if areas.0.len() != triangles {
        return Err(area::miscounted(&name_of(&beside), areas.0.len(), triangles));
    }
    Ok(Some((areas, beside)))
}

fn read_poly(files: &Files, path: &Path) -> Result<Numbered<Pslg>, IoError> {
    let bytes = read_file(files, path, None)?;
    let mut read = vec![path.to_owned()];
    let poly = poly::read(&bytes, &name_of(path), || {
        let beside = companion(path, Format::Node);
        let nodes = read_nodes(files, &beside, Some(path))?;
        read.push(beside);
        Ok(nodes)
    })?;
    Ok(Numbered::of_poly(poly, read))
}

fn read_nodes(files: &Files, path: &Path, needed_by: Option<&Path>) -> Result<Nodes, IoError> {
    node::read(&read_file(files, path, needed_by)?, &name_of(path))
}

/// Reads the files of a mesh, given its `.ele` file.
fn read_group(files: &Files, path: &Path) -> Result<Numbered<IndexedMesh>, IoError> {
    let bytes = read_file(files, path, None)?;
    let mut read = vec![path.to_owned(), companion(path, Format::Node)];
    let mut nodes = read_nodes(files, &read[1], Some(path))?;
    let mut notes = std::mem::take(&mut nodes.notes);
    let (range, first_index) = (nodes.range(), nodes.first_index);
    let mut elements = ele::read(&bytes, &name_of(path), range)?;
    notes.append(&mut elements.notes);
    drop(bytes);
    let drawing = companion(path, Format::Poly);
    let mut sections = None;
    if files.is_there(&drawing) {
        sections = poly::read_with_mesh(&read_file(files, &drawing, Some(path))?, &name_of(&drawing), range)?;
        read.push(drawing);
    }
    let Sections { segments, segment_markers, holes, notes: of_sections, .. } = sections.unwrap_or_default();
    notes.extend(of_sections);
    let mesh = IndexedMesh {
        triangles: elements.triangles,
        attributes_per_triangle: elements.attributes_per_triangle,
        triangle_attributes: elements.attributes,
        segments,
        segment_markers,
        holes,
        ..nodes.into_mesh()
    };
    Ok(Numbered { value: mesh, first_index, files: read, notes })
}

/// The first existing file of the given formats that has `path` as its stem.
fn of_stem(files: &Files, path: &Path, formats: &[Format]) -> Option<PathBuf> {
    formats.iter().map(|&format| companion(path, format)).find(|file| files.is_there(file))
}

fn unknown(path: &Path, expected: &'static str) -> IoError {
    IoError::UnknownInput { path: path.to_owned(), expected }
}

fn name_of(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

fn read_file(files: &Files, path: &Path, needed_by: Option<&Path>) -> Result<Vec<u8>, IoError> {
    bytes::read(files, path, needed_by, LONGEST_FILE)
}

fn unreadable(path: &Path, source: io::Error) -> IoError {
    IoError::Unreadable { path: path.to_owned(), source }
}
