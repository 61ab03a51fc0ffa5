//! The formats and how a file name tells them apart.

use std::path::{Path, PathBuf};

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Vertices.
    Node,
    /// Triangles, with a `.node` file beside.
    Ele,
    /// A planar straight-line graph.
    Poly,
    /// Edges.
    Edge,
    /// Neighbours of triangles.
    Neigh,
    /// Area bounds of triangles.
    Area,
    /// A drawing or mesh in one file of `MeshSuite`.
    MeshSuite,
    /// Triangles by coordinates.
    Soup,
    /// A mesh for Gmsh, version 4.1.
    Msh,
    /// A mesh for Gmsh, version 2.2.
    Msh2,
    /// A mesh for Abaqus.
    Abaqus,
    /// A mesh or drawing for Medit.
    Medit,
    /// A mesh for SU2.
    Su2,
    /// A mesh for ParaView.
    Vtu,
    /// A mesh for ParaView, in the older format.
    Vtk,
    /// A surface for programs of computer graphics, Wavefront's format.
    Obj,
    /// A surface for programs of computer graphics, Stanford's format.
    Ply,
    /// Triangles for printers.
    Stl,
    /// A mesh for other programs of geometry.
    Off,
    /// Triangles for maps.
    GeoJson,
    /// A picture of lines and areas.
    Svg,
    /// A picture of pixels.
    Png,
}

impl Format {
    /// All formats, in the order in which lists show them.
    pub const ALL: [Self; 22] = [
        Self::Node,
        Self::Ele,
        Self::Poly,
        Self::Edge,
        Self::Neigh,
        Self::Area,
        Self::MeshSuite,
        Self::Soup,
        Self::Msh,
        Self::Msh2,
        Self::Abaqus,
        Self::Medit,
        Self::Su2,
        Self::Vtu,
        Self::Vtk,
        Self::Obj,
        Self::Ply,
        Self::Stl,
        Self::Off,
        Self::GeoJson,
        Self::Svg,
        Self::Png,
    ];

    /// The ending of file names, without the dot.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            Self::Node => "node",
            Self::Ele => "ele",
            Self::Poly => "poly",
            Self::Edge => "edge",
            Self::Neigh => "neigh",
            Self::Area => "area",
            Self::MeshSuite => "meshsuite",
            Self::Soup => "soup",
            Self::Msh => "msh",
            Self::Msh2 => "msh2",
            Self::Abaqus => "inp",
            Self::Medit => "mesh",
            Self::Su2 => "su2",
            Self::Vtu => "vtu",
            Self::Vtk => "vtk",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Stl => "stl",
            Self::Off => "off",
            Self::GeoJson => "geojson",
            Self::Svg => "svg",
            Self::Png => "png",
        }
    }

    /// One line for lists.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Node => "vertices (Triangle); read and written",
            Self::Ele => "a mesh (Triangle), with its .node and .poly; read and written",
            Self::Poly => "a planar straight-line graph (Triangle); read and written",
            Self::Edge => "edges of a mesh (Triangle); written",
            Self::Neigh => "neighbours of triangles (Triangle); written",
            Self::Area => "area bounds of triangles (Triangle); read beside a mesh that is refined",
            Self::MeshSuite => "a drawing or a mesh in one file (MeshSuite; also read from .mesh); read and written",
            Self::Soup => "triangles by coordinates (Sanhueza; also read from .txt); read and written",
            Self::Msh => "a mesh for Gmsh and solvers, version 4.1, with physical names; read (also 2.2) and written",
            Self::Msh2 => "the same in version 2.2, for older programs; read and written",
            Self::Abaqus => "a mesh for Abaqus and CalculiX, with sets and surfaces; read and written",
            Self::Medit => "a mesh or a drawing for Medit, FreeFem, Mmg and MFEM; read and written",
            Self::Su2 => "a mesh for SU2, with markers by name; read and written",
            Self::Vtu => "a mesh for ParaView (VTK, XML as plain text), heights as z; read and written",
            Self::Vtk => "a mesh for ParaView and others (VTK's legacy format), heights as z; read and written",
            Self::Obj => "a surface for computer graphics (Wavefront), heights as z; read and written",
            Self::Ply => "a surface for computer graphics (Stanford), heights as z; read and written",
            Self::Stl => "triangles for printers, heights as z; read and written",
            Self::Off => {
                "triangles for other programs of geometry (Object File Format), heights as z; read and written"
            }
            Self::GeoJson => "triangles as features with their region, for maps; written",
            Self::Svg => "a picture; written",
            Self::Png => "a picture in pixels, without letters; written",
        }
    }

    /// The format in which [`read_mesh`](crate::read_mesh) reads a path: that of its ending, where it holds triangles.
    /// `.txt` is read as a soup, though never written unasked.
    #[must_use]
    pub fn of_mesh(path: &Path) -> Option<Self> {
        match Self::from_path(path) {
            None if path.extension()?.eq_ignore_ascii_case("txt") => Some(Self::Soup),
            format => format.filter(|format| format.holds_triangles()),
        }
    }

    /// Whether [`read_mesh`](crate::read_mesh) reads files of this format, which hold triangles.
    #[must_use]
    pub fn holds_triangles(self) -> bool {
        match self {
            Self::Node | Self::Poly | Self::Edge | Self::Neigh | Self::Area => false,
            Self::GeoJson | Self::Svg | Self::Png => false,
            Self::Ele | Self::MeshSuite | Self::Soup | Self::Msh | Self::Msh2 | Self::Abaqus | Self::Medit => true,
            Self::Su2 | Self::Vtu | Self::Vtk | Self::Obj | Self::Ply | Self::Stl | Self::Off => true,
        }
    }

    /// Whether a drawing can be written in this format.
    #[must_use]
    pub fn holds_drawings(self) -> bool {
        matches!(self, Self::Poly | Self::Node | Self::MeshSuite | Self::Medit | Self::Svg | Self::Png)
    }

    /// The format that the ending of a path says, in whatever case.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        Self::ALL.into_iter().find(|format| ending.eq_ignore_ascii_case(format.extension()))
    }
}

/// The file of another format that goes with `path`: the ending is exchanged, or appended where there is none of ours.
/// An ending in capitals stays in capitals.
pub(crate) fn companion(path: &Path, format: Format) -> PathBuf {
    let mut ending = format.extension().to_owned();
    if Format::from_path(path).is_some() {
        if path.extension().is_some_and(|old| old.to_string_lossy().bytes().all(|b| b.is_ascii_uppercase())) {
            ending.make_ascii_uppercase();
        }
        return path.with_extension(ending);
    }
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}
