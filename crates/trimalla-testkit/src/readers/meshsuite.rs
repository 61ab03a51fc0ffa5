//! The tables of appendices A, B and C of seed 004, as printed.

use std::path::Path;

use super::{number, text_of};

/// One row of `meshsuite-tables.csv`.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSuiteRow {
    /// Appendix, `A` to `C`.
    pub appendix: String,
    /// Mesh, `A` to `C`.
    pub mesh: String,
    /// Algorithm.
    pub algorithm: String,
    /// Order in which bad triangles are taken.
    pub priority: String,
    /// Angle asked for, in degrees.
    pub angle_deg: f64,
    /// Vertices of the result; nothing where the run did not end.
    pub vertices: Option<usize>,
    /// Triangles of the result; nothing where the run did not end.
    pub triangles: Option<usize>,
    /// `Triangle` or `framework`.
    pub program: String,
    /// Why the printed numbers cannot be right, where they cannot.
    pub comment: String,
}

/// Reads all rows after the heading.
#[must_use]
pub fn read_meshsuite_tables(path: &Path) -> Vec<MeshSuiteRow> {
    let text = text_of(path);
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some("appendix,mesh,algorithm,priority,angle_deg,vertices,triangles,program,comment"),
        "the columns have changed"
    );
    lines.filter(|l| !l.trim().is_empty()).map(row).collect()
}

/// One row.
fn row(line: &str) -> MeshSuiteRow {
    let cells = cells(line);
    let [appendix, mesh, algorithm, priority, angle, vertices, triangles, program, comment] =
        <[String; 9]>::try_from(cells).unwrap_or_else(|c| panic!("{line:?} has {} cells", c.len()));
    let count = |cell: String| {
        if cell.is_empty() { None } else { Some(cell.parse().unwrap()) }
    };
    MeshSuiteRow {
        appendix,
        mesh,
        algorithm,
        priority,
        angle_deg: number(&angle),
        vertices: count(vertices),
        triangles: count(triangles),
        program,
        comment,
    }
}

/// The cells of a line, where quotes protect commas.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            _ => cells.last_mut().unwrap().push(c),
        }
    }
    cells
}
