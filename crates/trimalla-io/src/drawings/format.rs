//! The formats of drawings that are read, and how their names and first bytes tell them apart.

use std::path::Path;

use super::wkt;

/// A format of drawings of other programs, which are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DrawingFormat {
    /// Features of maps.
    GeoJson,
    /// Drawings of CAD programs, as text.
    Dxf,
    /// Vector graphics.
    Svg,
    /// Geometries as words and numbers.
    Wkt,
    /// Features of maps, with a table beside.
    Shapefile,
    /// Points in columns, separated by commas.
    Csv,
    /// Points in columns, separated by blanks.
    Xyz,
    /// Points of a laser scanner.
    Las,
}

impl DrawingFormat {
    /// All formats, in the order in which lists show them.
    pub const ALL: [Self; 8] =
        [Self::GeoJson, Self::Dxf, Self::Svg, Self::Wkt, Self::Shapefile, Self::Csv, Self::Xyz, Self::Las];

    /// The endings of file names, without the dot; the first is the key.
    #[must_use]
    pub const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::GeoJson => &["geojson", "json"],
            Self::Dxf => &["dxf"],
            Self::Svg => &["svg"],
            Self::Wkt => &["wkt"],
            Self::Shapefile => &["shp"],
            Self::Csv => &["csv", "tsv"],
            Self::Xyz => &["xyz", "pts"],
            Self::Las => &["las"],
        }
    }

    /// The key, which is the ending that most files have.
    #[must_use]
    pub const fn key(self) -> &'static str {
        self.endings()[0]
    }

    /// The name in reports.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::GeoJson => "GeoJSON",
            Self::Dxf => "DXF",
            Self::Svg => "SVG",
            Self::Wkt => "WKT",
            Self::Shapefile => "shapefile",
            Self::Csv => "CSV",
            Self::Xyz => "XYZ",
            Self::Las => "LAS",
        }
    }

    /// One line for lists.
    #[must_use]
    pub const fn summary(self) -> &'static str {
        match self {
            Self::GeoJson => "points, lines and polygons of maps (also .json); features or a property are regions",
            Self::Dxf => "lines, polylines, arcs, splines and blocks of CAD programs, as text; layers are regions",
            Self::Svg => "shapes of vector graphics with their transforms; colours are regions",
            Self::Wkt => "well-known text, one geometry after the other",
            Self::Shapefile => "points, lines and polygons of maps, with the .dbf file beside",
            Self::Csv => "points with heights in columns, with or without names (also .tsv)",
            Self::Xyz => "points with heights in columns (also .pts)",
            Self::Las => "points of laser scanners, with heights; not compressed",
        }
    }

    /// Whether the format is no text.
    #[must_use]
    pub const fn is_binary(self) -> bool {
        matches!(self, Self::Shapefile | Self::Las)
    }

    /// The format that the ending of a path says, in whatever case.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        Self::ALL.into_iter().find(|format| format.endings().iter().any(|e| ending.eq_ignore_ascii_case(e)))
    }

    /// The format that the first bytes of a file say; `None` for columns of numbers, which may be anything.
    #[must_use]
    pub fn of_content(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"LASF") {
            return Some(Self::Las);
        }
        if bytes.starts_with(&[0, 0, 0x27, 0x0a]) {
            return Some(Self::Shapefile);
        }
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let text = bytes.trim_ascii_start();
        let mut lines = text.split(|&b| b == b'\n').map(<[u8]>::trim_ascii);
        match (text.first(), lines.next(), lines.next()) {
            (Some(b'{'), ..) => Some(Self::GeoJson),
            (Some(b'<'), ..) => Some(Self::Svg),
            (_, Some(b"0"), Some(b"SECTION")) | (_, Some(b"999"), Some(_)) => Some(Self::Dxf),
            _ => wkt::is_likely(text).then_some(Self::Wkt),
        }
    }
}
