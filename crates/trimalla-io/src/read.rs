//! From a path to a drawing or a mesh.

use std::io;
use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg};

use crate::area::{self, Areas};
use crate::bytes::{self, Content, LONGEST_FILE};
use crate::drawings::{self, DrawingFormat, DrawingOptions, Drawn};
use crate::error::{IoError, Note};
use crate::files::Files;
use crate::format::{Format, companion};
use crate::gathered::NamedMesh;
use crate::names::GroupNames;
use crate::node::{self, Nodes};
use crate::poly::{self, Poly, Sections};
use crate::{abaqus, ele, medit, meshsuite, msh, obj, off, ply, soup, stl, su2, vtk, vtu};

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
    /// What was read and how, where another program's drawing was read: lines of a report.
    pub told: Vec<String>,
    /// For each segment of such a drawing the number of the line, feature or record that it comes from; otherwise
    /// empty.
    pub origins: Vec<u32>,
    /// What these numbers count: `line`, `feature` or `record`.
    pub noun: &'static str,
    /// Names of regions and boundaries. Hand them to [`WriteOptions`](crate::WriteOptions) to keep them.
    pub names: GroupNames,
}

impl<T> Numbered<T> {
    /// The content of one file, nothing of which was ignored.
    fn whole(value: T, first_index: u32, path: &Path) -> Self {
        Self::of_files(value, first_index, vec![path.to_owned()], Vec::new())
    }

    fn of_files(value: T, first_index: u32, files: Vec<PathBuf>, notes: Vec<Note>) -> Self {
        Self {
            value,
            first_index,
            files,
            notes,
            told: Vec::new(),
            origins: Vec::new(),
            noun: "line",
            names: GroupNames::default(),
        }
    }
}

impl Numbered<Pslg> {
    fn of_poly(mut poly: Poly, files: Vec<PathBuf>) -> Self {
        let mut notes = std::mem::take(&mut poly.nodes.notes);
        notes.append(&mut poly.sections.notes);
        let first_index = poly.nodes.first_index;
        Self::of_files(poly.into_pslg(), first_index, files, notes)
    }

    fn of_drawn(drawn: Drawn, files: Vec<PathBuf>) -> Self {
        let Drawn { pslg, notes, told, origins, noun } = drawn;
        Self { told, origins, noun, ..Self::of_files(pslg, 1, files, notes) }
    }
}

/// Reads a drawing: a `.poly` file (with its `.node` file where it has no vertices of its own), a `.node` file,
/// Medit's `.mesh` or `MeshSuite`'s `.mesh` or `.meshsuite` (whose triangles are left out), a drawing of another
/// program in a [`DrawingFormat`], the stem of a `.poly` or `.node` file, or `-` for standard input.
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
    read_pslg_with(path, &DrawingOptions::default())
}

/// Reads a drawing as [`read_pslg`] does, with options for those of other programs.
///
/// The ending of the name says the format, or where it says none the first bytes of the file.
///
/// # Errors
/// Every [`IoError`] that is not about output.
pub fn read_pslg_with(path: impl AsRef<Path>, options: &DrawingOptions) -> Result<Numbered<Pslg>, IoError> {
    pslg(&Files::Disk, path.as_ref(), options)
}

/// Reads a drawing.
pub(crate) fn pslg(files: &Files, path: &Path, options: &DrawingOptions) -> Result<Numbered<Pslg>, IoError> {
    if path == Path::new("-") && matches!(files, Files::Disk) {
        let bytes = bytes::of_stream(io::stdin().lock()).map_err(|source| unreadable(path, source))?;
        return match DrawingFormat::of_content(&bytes) {
            Some(format) => Ok(Numbered::of_drawn(drawings::read(&bytes, format, "-", None, options)?, Vec::new())),
            None => Ok(Numbered::of_poly(poly::read_unnamed(&bytes, "-")?, Vec::new())),
        };
    }
    if let Some(format) = DrawingFormat::from_path(path) {
        return read_drawn(files, path, Some(format), options);
    }
    match Format::from_path(path) {
        Some(Format::Poly) => read_poly(files, path),
        Some(Format::Node) => {
            let mut nodes = read_nodes(files, path, None)?;
            let notes = std::mem::take(&mut nodes.notes);
            let first_index = nodes.first_index;
            Ok(Numbered { notes, ..Numbered::whole(nodes.into_pslg(), first_index, path) })
        }
        Some(Format::MeshSuite | Format::Medit) => {
            let (bytes, name) = (read_file(files, path, None)?, name_of(path));
            if medit::is_medit(&bytes) {
                return Ok(Numbered::whole(medit::read_pslg(&bytes, &name)?, 1, path));
            }
            let file = meshsuite::read(&bytes, &name)?;
            let first_index = file.first_index;
            Ok(Numbered::whole(file.into_pslg(), first_index, path))
        }
        None => match of_stem(files, path, &[Format::Poly, Format::Node]) {
            Some(file) => pslg(files, &file, options),
            None if Format::of_mesh(path).is_none() && files.is_there(path) => read_drawn(files, path, None, options),
            None => Err(unknown(path, DRAWING_ENDINGS)),
        },
        Some(_) => Err(unknown(path, DRAWING_ENDINGS)),
    }
}

const DRAWING_ENDINGS: &str = ".poly, .node, .mesh, .meshsuite, .geojson, .dxf, .svg, .wkt, .shp, .csv, .xyz or .las";
const MESH_ENDINGS: &str =
    ".ele, .msh, .inp, .mesh, .meshsuite, .su2, .vtu, .vtk, .obj, .ply, .stl, .off, .soup or .txt";

/// Reads a mesh: an `.ele` file with the `.node` file beside it and, where there is one without vertices of its own,
/// the `.poly` file, which names subsegments and holes. The `.node` file or the stem names the same mesh. Or one file
/// in another format that [holds triangles](Format::holds_triangles).
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
    let format = match Format::of_mesh(path) {
        Some(Format::Ele) => return read_group(files, path),
        Some(format) => format,
        None => return Err(unknown(path, MESH_ENDINGS)),
    };
    let (bytes, name) = (read_file(files, path, None)?, name_of(path));
    if format == Format::MeshSuite || (format == Format::Medit && !medit::is_medit(&bytes)) {
        let file = meshsuite::read_mesh(&bytes, &name)?;
        let first_index = file.first_index;
        return Ok(Numbered::whole(file.into_mesh(), first_index, path));
    }
    let NamedMesh { mesh, names } = one_file(format, &bytes, &name)?;
    Ok(Numbered { names, ..Numbered::whole(mesh, 1, path) })
}

/// Reads a mesh from the bytes of a file in one of the formats of one file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault; [`IoError::UnknownInput`] for a format
/// that holds no triangles or needs several files.
pub fn read_mesh_bytes(format: Format, bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    match format {
        Format::MeshSuite => {
            let mesh = meshsuite::read_mesh(bytes, name)?.into_mesh();
            Ok(NamedMesh { mesh, names: GroupNames::default() })
        }
        _ => one_file(format, bytes, name),
    }
}

fn one_file(format: Format, bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    match format {
        Format::Msh | Format::Msh2 => msh::read(bytes, name),
        Format::Abaqus => abaqus::read(bytes, name),
        Format::Medit => medit::read(bytes, name),
        Format::Su2 => su2::read(bytes, name),
        Format::Vtu => vtu::read(bytes, name),
        Format::Vtk => vtk::read(bytes, name),
        Format::Obj => obj::read(bytes, name),
        Format::Ply => ply::read(bytes, name),
        Format::Stl => stl::read(bytes, name),
        Format::Off => off::read(bytes, name),
        Format::Soup => Ok(NamedMesh { mesh: soup::read(bytes, name)?, names: GroupNames::default() }),
        _ => Err(unknown(Path::new(name), MESH_ENDINGS)),
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

/// Reads a drawing of another program; without a format, the first bytes must say it.
fn read_drawn(
    files: &Files,
    path: &Path,
    format: Option<DrawingFormat>,
    options: &DrawingOptions,
) -> Result<Numbered<Pslg>, IoError> {
    let bytes = bytes::read_drawing(files, path)?;
    let format = format.or_else(|| DrawingFormat::of_content(&bytes)).ok_or_else(|| unknown(path, DRAWING_ENDINGS))?;
    let mut read = vec![path.to_owned()];
    let mut table = None;
    if format == DrawingFormat::Shapefile && options.property.is_some() {
        let is_capital = path.extension().is_some_and(|ending| ending == "SHP");
        let beside = path.with_extension(if is_capital { "DBF" } else { "dbf" });
        table = Some(files.read(&beside, LONGEST_FILE, Content::Binary).map_err(|source| match source.kind() {
            io::ErrorKind::NotFound => IoError::Missing { path: beside.clone(), needed_by: Some(path.to_owned()) },
            _ => unreadable(&beside, source),
        })?);
        read.push(beside);
    }
    let drawn = drawings::read(&bytes, format, &name_of(path), table.as_deref(), options)?;
    Ok(Numbered::of_drawn(drawn, read))
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
    Ok(Numbered::of_files(mesh, first_index, read, notes))
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
