//! From a mesh or a drawing to a path.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg};

use crate::atomic::{Draft, Group, Pictures};
use crate::columns::Points;
use crate::error::IoError;
use crate::files::Memory;
use crate::format::{Format, companion};
use crate::names::GroupNames;
use crate::picture::PictureOptions;
use crate::recipe;
use crate::single::{self, Precision};
use crate::{
    abaqus, edge, ele, geojson_mesh, medit, meshsuite, msh, neigh, node, obj, off, ply, png, poly, soup, stl, su2, svg,
};
use crate::{vtk, vtu};
use trimalla::refine::NamedOptions;

/// How files are written.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// The number of the first vertex, triangle, … in text files: 0 or 1.
    pub first_index: u32,
    /// The format where it is not the one that the ending of the path says.
    pub format: Option<Format>,
    /// What a picture shows.
    pub picture: PictureOptions,
    /// Names of regions and boundaries.
    pub names: GroupNames,
    /// How exact the coordinates of meshes are.
    pub precision: Precision,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self {
            first_index: 1,
            format: None,
            picture: PictureOptions::default(),
            names: GroupNames::default(),
            precision: Precision::Double,
        }
    }
}

impl WriteOptions {
    /// Numbers records from `first_index`, which must be 0 or 1.
    #[must_use]
    pub fn with_first_index(mut self, first_index: u32) -> Self {
        self.first_index = first_index;
        self
    }

    /// Writes `format` whatever the path says.
    #[must_use]
    pub fn with_format(mut self, format: Format) -> Self {
        self.format = Some(format);
        self
    }

    /// Draws pictures with these options.
    #[must_use]
    pub fn with_picture(mut self, picture: PictureOptions) -> Self {
        self.picture = picture;
        self
    }

    /// Calls regions and boundaries by these names, in formats that have a place for them.
    #[must_use]
    pub fn with_names(mut self, names: GroupNames) -> Self {
        self.names = names;
        self
    }

    /// Writes the coordinates of meshes this exactly.
    #[must_use]
    pub fn with_precision(mut self, precision: Precision) -> Self {
        self.precision = precision;
        self
    }

    fn format_for(&self, path: &Path, expected: &'static str) -> Result<Format, IoError> {
        let unknown = || IoError::UnknownOutput { path: path.to_owned(), expected };
        self.format.or_else(|| Format::from_path(path)).ok_or_else(unknown)
    }
}

/// The files that [`write_mesh`] replaces, so that a caller can spare its inputs.
#[must_use]
pub fn files_of_mesh(path: &Path, options: &WriteOptions) -> Vec<PathBuf> {
    if is_group(path, options) && !is_stream(path) {
        [Format::Node, Format::Ele, Format::Poly].map(|format| member(path, format)).into()
    } else {
        vec![path.to_owned()]
    }
}

/// Outputs that appear together or not at all.
///
/// ```no_run
/// # fn main() -> Result<(), trimalla_io::IoError> {
/// # let mesh = trimalla::drawing::IndexedMesh::default();
/// use trimalla_io::{Outputs, WriteOptions};
///
/// let mut outputs = Outputs::default();
/// outputs.add_mesh("key.1.ele", &mesh, &WriteOptions::default())?;
/// outputs.add_mesh("key.svg", &mesh, &WriteOptions::default())?;
/// outputs.commit()
/// # }
/// ```
#[derive(Debug, Default)]
pub struct Outputs {
    target: Target,
}

/// Where outputs go.
#[derive(Debug)]
enum Target {
    Disk(Group),
    /// To files in memory, once these are complete.
    Memory(Memory, Vec<(PathBuf, Vec<u8>)>),
}

impl Default for Target {
    fn default() -> Self {
        Self::Disk(Group::default())
    }
}

impl Target {
    fn add(&mut self, path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), IoError> {
        match self {
            Self::Disk(group) => group.add(path, write),
            Self::Memory(_, complete) => {
                let mut content = Vec::new();
                write(&mut content).map_err(|source| IoError::Unwritable { path: path.to_owned(), source })?;
                complete.push((path.to_owned(), content));
                Ok(())
            }
        }
    }

    /// The group of files on the disk.
    fn group(&mut self, path: &Path) -> Result<&mut Group, IoError> {
        match self {
            Self::Disk(group) => Ok(group),
            Self::Memory(..) => {
                let source = io::Error::new(io::ErrorKind::Unsupported, "files in memory are written in one piece");
                Err(IoError::Unwritable { path: path.to_owned(), source })
            }
        }
    }

    /// Whether `path` stands for the three files of a mesh.
    fn is_group(&self, path: &Path, options: &WriteOptions) -> bool {
        is_group(path, options) && (matches!(self, Self::Memory(..)) || !is_stream(path))
    }
}

impl Outputs {
    pub(crate) fn in_memory(memory: Memory) -> Self {
        Self { target: Target::Memory(memory, Vec::new()) }
    }

    /// Prepares a mesh in the format that the ending of `path` says.
    ///
    /// `.ele` stands for the group `.node`, `.ele` and `.poly` of the same stem; `.node` holds the vertices alone,
    /// `.poly` the vertices, subsegments and holes in one file. Pipes, devices and `-` (standard output) are written at
    /// once, and `.ele` writes the three files one after the other to them, each behind a comment with its ending; add
    /// them last, as they cannot be taken back.
    ///
    /// # Errors
    /// [`IoError::UnknownOutput`] and [`IoError::Unwritable`].
    pub fn add_mesh(
        &mut self,
        path: impl AsRef<Path>,
        mesh: &IndexedMesh,
        options: &WriteOptions,
    ) -> Result<(), IoError> {
        let path = path.as_ref();
        let format = options.format_for(path, MESH_ENDINGS)?;
        if format == Format::Area {
            return Err(IoError::UnknownOutput { path: path.to_owned(), expected: MESH_ENDINGS });
        }
        let rounded = match options.precision {
            Precision::Double => None,
            Precision::Single => {
                let rounded = single::rounded(mesh);
                Some(rounded.map_err(|source| IoError::Unwritable { path: path.to_owned(), source })?)
            }
        };
        let mesh = rounded.as_ref().unwrap_or(mesh);
        if !self.target.is_group(path, options) {
            return self.target.add(path, |out| write_as_is(out, format, mesh, options));
        }
        let first_index = options.first_index;
        self.target.add(&member(path, Format::Node), |out| node::write(out, mesh, first_index))?;
        self.target.add(&member(path, Format::Ele), |out| ele::write(out, mesh, first_index))?;
        self.target.add(&member(path, Format::Poly), |out| poly::write_beside_node(out, mesh, first_index))
    }

    /// Prepares a drawing in the format that the ending of `path` says: `.poly` with the vertices in the same file,
    /// `.node` (the vertices alone), `.mesh`, `.meshsuite`, `.svg` or `.png`.
    ///
    /// # Errors
    /// [`IoError::UnknownOutput`] and [`IoError::Unwritable`].
    pub fn add_pslg(&mut self, path: impl AsRef<Path>, pslg: &Pslg, options: &WriteOptions) -> Result<(), IoError> {
        let path = path.as_ref();
        let format = options.format_for(path, PSLG_ENDINGS)?;
        if !format.holds_drawings() {
            return Err(IoError::UnknownOutput { path: path.to_owned(), expected: PSLG_ENDINGS });
        }
        self.target.add(path, |out| write_pslg_to(out, format, pslg, options))
    }

    /// Prepares a recipe.
    ///
    /// # Errors
    /// [`IoError::Unwritable`].
    pub fn add_recipe(&mut self, path: impl AsRef<Path>, file: &NamedOptions) -> Result<(), IoError> {
        self.target.add(path.as_ref(), |out| recipe::write(out, file))
    }

    /// Prepares a text, such as a table or a chart.
    ///
    /// # Errors
    /// [`IoError::Unwritable`].
    pub fn add_text(&mut self, path: impl AsRef<Path>, text: &str) -> Result<(), IoError> {
        self.target.add(path.as_ref(), |out| out.write_all(text.as_bytes()))
    }

    /// Begins a file that is written piece by piece; [hand it back](Self::end) when it is complete.
    ///
    /// # Errors
    /// [`IoError::Unwritable`].
    ///
    /// # Examples
    /// ```no_run
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// use std::io::Write as _;
    ///
    /// let mut outputs = trimalla_io::Outputs::default();
    /// let mut log = outputs.begin("steps.txt")?;
    /// for step in 1..=3 {
    ///     writeln!(log, "step {step}")?;
    /// }
    /// outputs.end(log)?;
    /// outputs.commit()?;
    /// # Ok(())
    /// # }
    /// ```
    pub fn begin(&mut self, path: impl AsRef<Path>) -> Result<Draft, IoError> {
        self.target.group(path.as_ref())?.begin(path.as_ref())
    }

    /// Takes a file that is complete.
    ///
    /// # Errors
    /// [`IoError::Unwritable`].
    pub fn end(&mut self, draft: Draft) -> Result<(), IoError> {
        self.target.group(draft.path())?.end(draft)
    }

    /// Begins a folder of numbered pictures; [hand it back](Self::end_pictures) when it is complete.
    ///
    /// # Errors
    /// [`IoError::Unwritable`]; a folder that holds anything else than such pictures, or in which the process runs, is
    /// one.
    pub fn begin_pictures(&mut self, path: impl AsRef<Path>) -> Result<Pictures, IoError> {
        self.target.group(path.as_ref())?.begin_pictures(path.as_ref())
    }

    /// Takes a folder that is complete.
    ///
    /// # Errors
    /// [`IoError::Unwritable`].
    pub fn end_pictures(&mut self, pictures: Pictures) -> Result<(), IoError> {
        self.target.group(pictures.path())?.end_pictures(pictures)
    }

    /// Puts every file in its place. Without this call, old files stay as they are and nothing new appears.
    ///
    /// # Errors
    /// [`IoError::Unwritable`].
    pub fn commit(self) -> Result<(), IoError> {
        match self.target {
            Target::Disk(group) => group.commit(),
            Target::Memory(memory, complete) => {
                memory.put_all(complete);
                Ok(())
            }
        }
    }
}

/// The endings by which [`write_mesh`] knows formats, in words.
pub const MESH_ENDINGS: &str = ".node, .ele, .poly, .edge, .neigh, .msh, .msh2, .inp, .mesh, .meshsuite, .su2, .vtu, .vtk, .obj, .ply, .stl, .off, .geojson, .soup, .svg or .png";
const PSLG_ENDINGS: &str = ".poly, .node, .mesh, .meshsuite, .svg or .png";

/// Writes a mesh in the format that the ending of `path` says: see [`Outputs::add_mesh`].
///
/// # Errors
/// [`IoError::UnknownOutput`] and [`IoError::Unwritable`]; old files are then as they were.
pub fn write_mesh(path: impl AsRef<Path>, mesh: &IndexedMesh, options: &WriteOptions) -> Result<(), IoError> {
    let mut outputs = Outputs::default();
    outputs.add_mesh(path, mesh, options)?;
    outputs.commit()
}

/// Writes a mesh in one format to a stream.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where the mesh cannot be expressed in the format: columns of wrong lengths,
/// indices without a vertex, numbers that are not finite; kind `Unsupported` for [`Format::Area`], which holds no mesh.
pub fn write_mesh_to(
    out: &mut dyn Write,
    format: Format,
    mesh: &IndexedMesh,
    options: &WriteOptions,
) -> io::Result<()> {
    match options.precision {
        Precision::Double => write_as_is(out, format, mesh, options),
        Precision::Single => write_as_is(out, format, &single::rounded(mesh)?, options),
    }
}

fn write_as_is(out: &mut dyn Write, format: Format, mesh: &IndexedMesh, options: &WriteOptions) -> io::Result<()> {
    match format {
        Format::Node => node::write(out, mesh, options.first_index),
        Format::Ele => write_group(out, mesh, options.first_index),
        Format::Poly => poly::write(out, mesh, options.first_index),
        Format::Edge => edge::write(out, mesh, options.first_index),
        Format::Neigh => neigh::write(out, mesh, options.first_index),
        Format::MeshSuite => meshsuite::write(out, mesh, options.first_index),
        Format::Soup => soup::write(out, mesh),
        Format::Msh => msh::write(out, mesh, &options.names),
        Format::Msh2 => msh::write_version_2(out, mesh, &options.names),
        Format::Abaqus => abaqus::write(out, mesh, &options.names),
        Format::Medit => medit::write(out, mesh),
        Format::Su2 => su2::write(out, mesh, &options.names),
        Format::Vtu => vtu::write(out, mesh),
        Format::Vtk => vtk::write(out, mesh),
        Format::Obj => obj::write(out, mesh, &options.names),
        Format::Ply => ply::write(out, mesh),
        Format::Stl => stl::write(out, mesh, &options.names),
        Format::Off => off::write(out, mesh),
        Format::GeoJson => geojson_mesh::write(out, mesh, &options.names, options.first_index),
        Format::Area => Err(io::ErrorKind::Unsupported.into()),
        Format::Svg => svg::draw_mesh(out, mesh, &options.picture),
        Format::Png => png::draw_mesh(out, mesh, &options.picture),
    }
}

/// The three files of a mesh one after the other, each behind a comment with its ending.
fn write_group(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    writeln!(out, "# .node")?;
    node::write(out, mesh, first_index)?;
    writeln!(out, "# .ele")?;
    ele::write(out, mesh, first_index)?;
    writeln!(out, "# .poly")?;
    poly::write_beside_node(out, mesh, first_index)
}

/// Writes a drawing in the format that the ending of `path` says: see [`Outputs::add_pslg`].
///
/// # Errors
/// [`IoError::UnknownOutput`] and [`IoError::Unwritable`]; old files are then as they were.
pub fn write_pslg(path: impl AsRef<Path>, pslg: &Pslg, options: &WriteOptions) -> Result<(), IoError> {
    let mut outputs = Outputs::default();
    outputs.add_pslg(path, pslg, options)?;
    outputs.commit()
}

/// Writes a drawing to a stream as `.poly`, `.node`, `.mesh`, `.meshsuite`, `.svg` or `.png`.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where the drawing cannot be expressed in the format, or the format holds meshes
/// only.
pub fn write_pslg_to(out: &mut dyn Write, format: Format, pslg: &Pslg, options: &WriteOptions) -> io::Result<()> {
    match format {
        Format::Poly => poly::write_pslg(out, pslg, options.first_index),
        Format::Node => node::write_points(out, &Points::of_pslg(pslg), options.first_index),
        Format::Svg => svg::draw_pslg(out, pslg, &options.picture),
        Format::Png => png::draw_pslg(out, pslg, &options.picture),
        Format::MeshSuite => meshsuite::write_pslg(out, pslg, options.first_index),
        Format::Medit => medit::write_pslg(out, pslg),
        _ => Err(io::ErrorKind::Unsupported.into()),
    }
}

/// Whether `path` is written as three files, where it is no stream.
fn is_group(path: &Path, options: &WriteOptions) -> bool {
    options.format.or_else(|| Format::from_path(path)) == Some(Format::Ele)
}

fn is_stream(path: &Path) -> bool {
    path == Path::new("-")
        || path == Path::new("/dev/stdout")
        || path.metadata().is_ok_and(|found| !found.is_file() && !found.is_dir())
}

/// A file of the group of `path`; the one the caller named keeps its name.
fn member(path: &Path, format: Format) -> PathBuf {
    if format == Format::Ele && Format::from_path(path) == Some(Format::Ele) {
        path.to_owned()
    } else {
        companion(path, format)
    }
}
