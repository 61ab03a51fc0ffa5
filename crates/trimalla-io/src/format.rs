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
    /// A mesh for ParaView.
    Vtu,
    /// A mesh for other programs of geometry.
    Off,
    /// A picture of lines and areas.
    Svg,
    /// A picture of pixels.
    Png,
}

impl Format {
    /// All formats, in the order in which lists show them.
    pub const ALL: [Self; 12] = [
        Self::Node,
        Self::Ele,
        Self::Poly,
        Self::Edge,
        Self::Neigh,
        Self::Area,
        Self::MeshSuite,
        Self::Soup,
        Self::Vtu,
        Self::Off,
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
            Self::MeshSuite => "mesh",
            Self::Soup => "soup",
            Self::Vtu => "vtu",
            Self::Off => "off",
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
            Self::MeshSuite => "a drawing or a mesh in one file (MeshSuite); read and written",
            Self::Soup => "triangles by coordinates (Sanhueza; also read from .txt); read and written",
            Self::Vtu => "a mesh for ParaView (VTK, XML as plain text); written",
            Self::Off => "triangles for other programs of geometry (Object File Format, plain text); written",
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
            Some(format @ (Self::Ele | Self::MeshSuite | Self::Soup)) => Some(format),
            _ => None,
        }
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
