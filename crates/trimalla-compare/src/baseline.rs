//! Published tables to stand beside ours.
//!
//! A CSV file with a header that names at least `mesh`, `algorithm`, `angle_deg`, `vertices` and `triangles`, in any
//! order; `appendix`, `priority`, `program` and `comment` are used if they are there. Empty counts are runs that gave
//! no mesh. A comment that begins with `impossible` marks a row that no mesh can have.

use std::path::Path;

use trimalla_io::{Fault, IoError, Place, read_bytes};

use crate::error::CompareError;
use crate::sheet::{Cell, Column};

/// No published table is longer.
const LONGEST: u64 = 1 << 28;

/// The rows of the tables.
#[derive(Debug)]
pub struct Baseline {
    rows: Vec<Row>,
}

#[derive(Debug)]
struct Row {
    mesh: String,
    label: String,
    appendix: String,
    angle_deg: f64,
    cell: Cell,
}

/// A field and its column in the line, counted from 1.
type Field = (String, u64);

impl Baseline {
    /// Reads the tables in a file.
    ///
    /// # Errors
    /// [`CompareError::Io`], with line and column.
    pub fn read(path: &Path) -> Result<Self, CompareError> {
        let bytes = read_bytes(path, LONGEST)?;
        Ok(Self::of_text(&String::from_utf8_lossy(&bytes), &path.to_string_lossy())?)
    }

    fn of_text(text: &str, name: &str) -> Result<Self, IoError> {
        let mut lines = text.trim_start_matches('\u{feff}').lines().zip(1_u64..).filter(|(line, _)| !line.is_empty());
        let (header, line) = lines.next().unwrap_or(("", 1));
        let header = Header::of(&fields(header, name, line)?, name, line)?;
        let rows = lines.map(|(text, line)| header.row(&fields(text, name, line)?, name, line));
        Ok(Self { rows: rows.collect::<Result<_, _>>()? })
    }

    /// The columns of the mesh of this name, whatever the case of its letters. Columns of two appendices that agree in
    /// all these angles are one.
    pub(crate) fn columns(&self, mesh: &str, angles: &[f64]) -> Vec<Column> {
        let rows = || self.rows.iter().filter(|row| row.mesh.eq_ignore_ascii_case(mesh));
        let mut keys: Vec<(&str, &str)> = Vec::new();
        for row in rows() {
            if !keys.contains(&(&row.label, &row.appendix)) {
                keys.push((&row.label, &row.appendix));
            }
        }
        let mut columns: Vec<(&str, Vec<&str>, Vec<Cell>)> = Vec::new();
        for (label, appendix) in keys {
            let of_column = || rows().filter(|row| row.label == label && row.appendix == appendix);
            let at = |&angle: &f64| of_column().find(|row| row.angle_deg == angle);
            let cells: Vec<Cell> = angles.iter().map(|a| at(a).map_or(Cell::Absent, |row| row.cell.clone())).collect();
            match columns.iter_mut().find(|(l, _, c)| *l == label && c.iter().zip(&cells).all(|(a, b)| agree(a, b))) {
                Some((_, appendices, _)) => appendices.push(appendix),
                None => columns.push((label, vec![appendix], cells)),
            }
        }
        let has_value = |cells: &[Cell]| cells.iter().any(|cell| !matches!(cell, Cell::Absent));
        columns.retain(|(.., cells)| has_value(cells));
        let column = |(label, appendices, cells): (&str, Vec<&str>, Vec<Cell>)| {
            let appendices = appendices.join(", ");
            let source = if appendices.is_empty() { String::new() } else { format!(" [{appendices}]") };
            Column { label: format!("{label}{source}"), is_published: true, cells }
        };
        columns.into_iter().map(column).collect()
    }

    /// The meshes that the tables know.
    #[must_use]
    pub fn meshes(&self) -> Vec<&str> {
        let mut meshes: Vec<&str> = self.rows.iter().map(|row| &row.mesh[..]).collect();
        meshes.sort_unstable();
        meshes.dedup();
        meshes
    }
}

/// Whether two published cells say the same, absent ones agreeing with all.
fn agree(one: &Cell, other: &Cell) -> bool {
    match (one, other) {
        (Cell::Published { counts: one, .. }, Cell::Published { counts: other, .. }) => one == other,
        _ => true,
    }
}

/// Where in a row its fields are.
struct Header {
    width: usize,
    needed: [usize; 5],
    optional: [Option<usize>; 4],
}

const NEEDED: [&str; 5] = ["mesh", "algorithm", "angle_deg", "vertices", "triangles"];
const OPTIONAL: [&str; 4] = ["appendix", "priority", "program", "comment"];

impl Header {
    fn of(fields: &[Field], name: &str, line: u64) -> Result<Self, IoError> {
        let place = |key: &str| fields.iter().position(|(field, _)| field == key);
        let mut needed = [0; 5];
        for (slot, key) in needed.iter_mut().zip(NEEDED) {
            let expected = || format!("a header with {}", NEEDED.join(", "));
            *slot = place(key).ok_or_else(|| fault(name, line, 1, &expected(), &format!("none with '{key}'")))?;
        }
        Ok(Self { width: fields.len(), needed, optional: OPTIONAL.map(place) })
    }

    fn row(&self, fields: &[Field], name: &str, line: u64) -> Result<Row, IoError> {
        if fields.len() != self.width {
            let expected = format!("{} fields, as the header has", self.width);
            return Err(fault(name, line, 1, &expected, &fields.len().to_string()));
        }
        let [mesh, algorithm, angle, vertices, triangles] = self.needed.map(|i| &fields[i]);
        let [appendix, priority, program, comment] = self.optional.map(|i| i.map_or("", |i| &fields[i].0));
        let angle_deg = angle.0.parse().ok().filter(|a: &f64| a.is_finite());
        let angle_deg = angle_deg.ok_or_else(|| wrong(name, line, angle, "an angle in degrees"))?;
        let count = |field: &Field| match &field.0[..] {
            "" | "ND" => Ok(None),
            digits => digits.parse().map(Some).map_err(|_| wrong(name, line, field, "a count, or nothing")),
        };
        let counts = count(vertices)?.zip(count(triangles)?).map(|(v, t)| [v, t]);
        let parts = [&algorithm.0[..], priority, program].into_iter().filter(|part| !part.is_empty());
        let label = parts.collect::<Vec<_>>().join(", ");
        let cell = Cell::Published { counts, comment: comment.to_owned() };
        Ok(Row { mesh: mesh.0.clone(), label, appendix: appendix.to_owned(), angle_deg, cell })
    }
}

/// The fields of a line; those between quotes may hold commas, and quotes twice.
fn fields(line: &str, name: &str, number: u64) -> Result<Vec<Field>, IoError> {
    let mut fields = vec![(String::new(), 1)];
    let (mut is_quoted, mut chars) = (false, line.char_indices().peekable());
    while let Some((at, c)) = chars.next() {
        let field = fields.last_mut().map(|(text, _)| text);
        match (c, is_quoted) {
            ('"', true) if chars.peek().is_some_and(|(_, c)| *c == '"') => {
                chars.next();
                field.into_iter().for_each(|text| text.push('"'));
            }
            ('"', _) => is_quoted = !is_quoted,
            (',', false) => fields.push((String::new(), at as u64 + 2)),
            (c, _) => field.into_iter().for_each(|text| text.push(c)),
        }
    }
    if is_quoted {
        return Err(fault(name, number, line.len() as u64 + 1, "the end of a quoted field", "the end of the line"));
    }
    Ok(fields)
}

fn wrong(name: &str, line: u64, (found, column): &Field, expected: &str) -> IoError {
    fault(name, line, *column, expected, &format!("'{found}'"))
}

fn fault(name: &str, line: u64, column: u64, expected: &str, found: &str) -> IoError {
    let found = found.chars().map(|c| if c.is_control() { '?' } else { c }).collect();
    let place = Place { file: name.to_owned(), line, column };
    IoError::Syntax(Box::new(Fault { place, expected: expected.to_owned(), found }))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "appendix,mesh,algorithm,priority,angle_deg,vertices,triangles,program,comment\n\
        A,A,Off,shortest edge,20,56,60,Triangle,\n\
        A,A,Off,shortest edge,21,107,104,Triangle,\"impossible: 110, of 107\"\n\
        B,A,Off,shortest edge,20,56,60,Triangle,\n\
        B,A,Off,shortest edge,22,,,Triangle,ND\n\
        B,A,On,,20,1,2,,\n";

    #[test]
    fn columns_of_two_appendices_that_agree_are_one() {
        let table = Baseline::of_text(TABLE, "t.csv").unwrap();
        let columns = table.columns("a", &[20.0, 21.0]);
        let labels: Vec<&str> = columns.iter().map(|c| &c.label[..]).collect();
        assert_eq!(labels, ["Off, shortest edge, Triangle [A, B]", "On [B]"]);
        assert_eq!(columns[0].cells[1].impossible(), Some("impossible: 110, of 107"));
        assert!(table.columns("B", &[20.0]).is_empty());
        assert!(table.columns("A", &[30.0]).is_empty());
        assert_eq!(table.meshes(), ["A"]);
    }

    #[test]
    fn faults_are_named() {
        let fault = |text: &str| Baseline::of_text(text, "t.csv").unwrap_err().to_string();
        assert!(fault("").starts_with("t.csv:1:1: expected a header with mesh, "), "{}", fault(""));
        let head = "mesh,algorithm,angle_deg,vertices,triangles\n";
        assert_eq!(fault(&format!("{head}A,x,20,7")), "t.csv:2:1: expected 5 fields, as the header has, found 4");
        assert_eq!(fault(&format!("{head}A,x,y,7,8")), "t.csv:2:5: expected an angle in degrees, found 'y'");
        assert_eq!(fault(&format!("{head}\nA,x,20,7,-8")), "t.csv:3:10: expected a count, or nothing, found '-8'");
        assert_eq!(
            fault(&format!("{head}\"A")),
            "t.csv:2:3: expected the end of a quoted field, found the end of the line"
        );
    }
}
