//! CDT text files (artem-ogre) and the results stored beside them.

use std::path::Path;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::{index, number, text_of};

/// Reads `N M`, N lines `x y`, M lines `a b`, 0-based; any blanks separate.
#[must_use]
pub fn read_cdt(path: &Path) -> Pslg {
    let text = text_of(path);
    let mut tokens = text.split_whitespace();
    let mut next = || tokens.next().unwrap_or_else(|| panic!("{} ends early", path.display()));
    let (n, m) = (index(next()), index(next()));
    let points = (0..n).map(|_| Point::new(number(next()), number(next()))).collect();
    let segments = (0..m).map(|_| [index(next()), index(next())]).collect();
    Pslg { points, segments, ..Pslg::default() }
}

/// A stored result of CDT: `data/cdt/expected/*.txt`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CdtExpected {
    /// The stem of the input it belongs to.
    pub input: String,
    /// `[type_]<vertex order>`, for instance `f64_as-provided`; `conforming_…` for conforming
    /// results.
    pub variant: String,
    /// `ignore` (no crossings allowed) or `resolve` (crossings split, new vertices appended).
    pub crossings: String,
    /// What was erased: `super`, `outer`, `auto` or, indices shifted by 3, `all`.
    pub erased: String,
    /// Vertices of each triangle, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// Neighbours of each triangle; `u32::MAX` is none.
    pub neighbours: Vec<[u32; 3]>,
    /// Constrained edges.
    pub fixed_edges: Vec<[u32; 2]>,
    /// Constrained edges that several input segments share, with how many more.
    pub overlaps: Vec<([u32; 2], u32)>,
    /// The input segments of each piece of a split constraint.
    pub parents: Vec<([u32; 2], Vec<[u32; 2]>)>,
}

/// Reads a stored result; its name says what it belongs to.
#[must_use]
pub fn read_cdt_expected(path: &Path) -> CdtExpected {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let (input, rest) = stem.split_once("__").unwrap_or_else(|| panic!("{stem} names no input"));
    let mut parts = rest.rsplitn(3, '_');
    let mut part = || parts.next().unwrap_or_default().to_owned();
    let (erased, crossings, variant) = (part(), part(), part());
    let text = text_of(path);
    let mut tokens = text.split_whitespace().map(index);
    let mut next = || tokens.next().unwrap_or_else(|| panic!("{} ends early", path.display()));
    let (mut triangles, mut neighbours) = (Vec::new(), Vec::new());
    for _ in 0..next() {
        triangles.push([next(), next(), next()]);
        neighbours.push([next(), next(), next()]);
    }
    let fixed_edges = (0..next()).map(|_| [next(), next()]).collect();
    let overlaps = (0..next()).map(|_| ([next(), next()], next())).collect();
    let parents = (0..next())
        .map(|_| {
            let piece = [next(), next()];
            let parents = (0..next()).map(|_| [next(), next()]).collect();
            (piece, parents)
        })
        .collect();
    assert!(tokens.next().is_none(), "{} goes on after its end", path.display());
    let input = input.to_owned();
    CdtExpected { input, variant, crossings, erased, triangles, neighbours, fixed_edges, overlaps, parents }
}
