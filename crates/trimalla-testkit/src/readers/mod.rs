//! Readers of the shared real inputs, one file a family, small and trusting.
//!
//! They exist so that tests of the library do not depend on the io crate, which is itself under test.
//! They panic on what they do not understand. The rules are those of the shared `data/README.md`:
//! points stay as listed, duplicates too; the closing point of a ring that repeats its first is not
//! counted; a ring of two points is one segment, of one point none.

mod cdt;
mod cgshop;
mod earcut;
mod geojson;
mod graphml;
mod json_points;
mod line;
mod meshsuite;
mod poly2tri;
mod predicates;
mod readme;
mod rings;
mod soup;
mod triangle;
mod wkt;
mod xy;

use std::fs;
use std::path::{Path, PathBuf};

use trimalla::drawing::Pslg;

pub use cdt::{CdtExpected, read_cdt, read_cdt_expected};
pub use cgshop::read_cgshop;
pub use earcut::{earcut_rings, read_earcut};
pub use geojson::read_geojson;
pub use graphml::read_graphml;
pub use json_points::read_json_points;
pub use line::read_line;
pub use meshsuite::{MeshSuiteRow, read_meshsuite_tables};
pub use poly2tri::read_poly2tri;
pub use predicates::{OrientCase, read_orient_cases};
pub use readme::{ReadmeRow, read_readme};
pub use soup::read_triangle_soup;
pub use triangle::{read_ele, read_node, read_poly};
pub use wkt::read_wkt;
pub use xy::read_xy;

/// One real input.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedInput {
    /// The folder it is in.
    pub family: String,
    /// Its file name.
    pub name: String,
    /// Its content as a drawing.
    pub pslg: Pslg,
    /// Whether its segments are rings that bound a domain by the even–odd rule, as opposed to loose
    /// segments.
    pub rings: bool,
}

/// Every input that the table of the shared `data/README.md` lists, read, in the order of the
/// table.
///
/// # Shape
/// `data` is the folder that [`shared_data`](crate::shared::shared_data) finds. Predicate cases and
/// `seeds/` are no inputs.
#[must_use]
pub fn all_inputs(data: &Path) -> Vec<NamedInput> {
    let rows = read_readme(&data.join("README.md")).into_iter().filter(|row| row.points.is_some());
    rows.map(|row| {
        let (pslg, rings) = read_input(&row.path(data));
        NamedInput { family: row.family, name: row.name, pslg, rings }
    })
    .collect()
}

/// Reads an input by the folder it is in, and says whether its segments are rings.
///
/// # Panics
/// If the folder is no known family or the file does not follow its rules.
#[must_use]
pub fn read_input(path: &Path) -> (Pslg, bool) {
    let family = path.parent().and_then(Path::file_name).unwrap_or_default().to_string_lossy();
    let kind = path.extension().unwrap_or_default().to_string_lossy();
    match (&*family, &*kind) {
        ("triangle", "node") => (read_node(path), false),
        ("triangle", "poly") => (read_poly(path), false),
        ("cdt", _) => (read_cdt(path), false),
        ("earcut", _) => (read_earcut(path), true),
        ("poly2tri", _) => (read_poly2tri(path), true),
        ("delaunator", _) => (read_json_points(path), false),
        ("cgshop", _) => (read_cgshop(path), false),
        ("salzburg", "graphml") => (read_graphml(path), false),
        ("salzburg", "line") => (read_line(path), true),
        ("geo" | "crossing" | "points", "json" | "geojson") => read_geojson(path),
        ("geo", "wkt") => read_wkt(path),
        ("points", "txt") => (read_xy(path), false),
        _ => panic!("no reader for {}", path.display()),
    }
}

/// The whole file as text.
fn text_of(path: &Path) -> String {
    let bytes = fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    String::from_utf8_lossy(&bytes).into_owned()
}

/// A neighbouring file with the same stem and another ending.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}{ending}"))
}

/// A number, or a panic that names it.
fn number(token: &str) -> f64 {
    token.parse().unwrap_or_else(|e| panic!("{token:?} is no number: {e}"))
}

/// An index, or a panic that names it.
fn index(token: &str) -> u32 {
    token.parse().unwrap_or_else(|e| panic!("{token:?} is no index: {e}"))
}
