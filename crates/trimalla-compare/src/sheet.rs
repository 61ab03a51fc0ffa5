//! One drawing's columns, those that were run and the published ones.

use crate::baseline::Baseline;
use crate::experiment::{Drawing, Experiment};
use crate::outcome::Outcome;
use crate::runs::Outcomes;

/// What tables and charts show of a drawing.
#[derive(Debug)]
pub struct Sheet<'a> {
    /// As the command line names the drawing.
    pub name: &'a str,
    /// A word for file names and headings.
    pub title: &'a str,
    /// The counts of the drawing in words, or what is wrong with it.
    pub read: Result<&'a str, &'a [String]>,
    /// Degrees, the rows of every column.
    pub angles: &'a [f64],
    /// Contenders, then published columns.
    pub columns: Vec<Column>,
}

/// A contender, or a published column.
#[derive(Debug)]
pub struct Column {
    /// Its title.
    pub label: String,
    /// Whether it is published, not run here.
    pub is_published: bool,
    /// One for each angle.
    pub cells: Vec<Cell>,
}

/// One run, of this experiment or published.
#[derive(Clone, Debug)]
pub enum Cell {
    /// One of this experiment.
    Run(Outcome),
    /// A published one.
    Published {
        /// Vertices and triangles; `None` where the table says ND.
        counts: Option<[usize; 2]>,
        /// What whoever copied the table says about the row.
        comment: String,
    },
    /// The table has no such row.
    Absent,
}

/// What tables show of times.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Times {
    /// Nothing: then the same experiment gives the same bytes.
    Hidden,
    /// What each run took.
    #[default]
    Total,
    /// In CSV and JSON what each step took, too.
    BySteps,
}

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Vertices of the mesh.
    Vertices,
    /// Triangles of the mesh.
    Triangles,
    /// Triangulation and refinement.
    Seconds,
}

impl Quantity {
    /// Every one.
    pub const ALL: [Self; 3] = [Self::Vertices, Self::Triangles, Self::Seconds];

    /// All, or all but the times.
    #[must_use]
    pub fn shown(times: Times) -> &'static [Self] {
        if times == Times::Hidden { &Self::ALL[..2] } else { &Self::ALL }
    }

    /// Its name.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Vertices => "vertices",
            Self::Triangles => "triangles",
            Self::Seconds => "seconds",
        }
    }
}

impl Cell {
    /// The number, if there is one.
    #[must_use]
    pub fn value(&self, quantity: Quantity) -> Option<f64> {
        match (self, quantity) {
            (Self::Run(run), _) if !run.is_done() => None,
            (Self::Run(run), Quantity::Vertices) => Some(run.vertices as f64),
            (Self::Run(run), Quantity::Triangles) => Some(run.triangles as f64),
            (Self::Run(run), Quantity::Seconds) => Some(run.seconds),
            (Self::Published { counts, .. }, Quantity::Vertices) => counts.map(|c| c[0] as f64),
            (Self::Published { counts, .. }, Quantity::Triangles) => counts.map(|c| c[1] as f64),
            _ => None,
        }
    }

    /// The comment on a published row that cannot be right.
    #[must_use]
    pub fn impossible(&self) -> Option<&str> {
        match self {
            Self::Published { comment, .. } if comment.starts_with("impossible") => Some(comment),
            _ => None,
        }
    }

    /// Any other comment on a published row.
    #[must_use]
    pub fn remark(&self) -> Option<&str> {
        match self {
            Self::Published { comment, counts: Some(_) } if !comment.is_empty() => {
                self.impossible().is_none().then_some(comment)
            }
            _ => None,
        }
    }
}

impl Experiment {
    /// The outcomes of the experiment, one sheet a drawing, beside published tables where there are some.
    #[must_use]
    pub fn sheets<'a>(&'a self, outcomes: &Outcomes, baseline: Option<&Baseline>) -> Vec<Sheet<'a>> {
        let sheet = |(d, drawing): (usize, &'a Drawing)| {
            let outcome = |c: usize, a: usize| outcomes.0.get(self.index(d, c, a)).cloned().flatten();
            let mut columns = Vec::new();
            if drawing.read.is_ok() {
                columns.extend(self.contenders().iter().enumerate().map(|(c, contender)| Column {
                    label: contender.label.clone(),
                    is_published: false,
                    cells: (0..self.angles().len()).map(|a| outcome(c, a).map_or(Cell::Absent, Cell::Run)).collect(),
                }));
                columns.extend(baseline.map(|b| b.columns(&drawing.title, self.angles())).unwrap_or_default());
            }
            let read = drawing.read.as_ref().map(|good| &good.facts[..]).map_err(|messages| &messages[..]);
            Sheet { name: &drawing.name, title: &drawing.title, read, angles: self.angles(), columns }
        };
        self.drawings().iter().enumerate().map(sheet).collect()
    }
}

/// A time in three significant digits, without an exponent: a microsecond is 0.00000100.
pub(crate) fn seconds_text(seconds: f64) -> String {
    let scientific = format!("{seconds:.2e}");
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    let decimals = usize::try_from(2 - exponent.unwrap_or(0)).unwrap_or(0);
    format!("{seconds:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::seconds_text;

    #[test]
    fn times_have_three_significant_digits() {
        let texts = [0.0, 1.234e-6, 0.000_098_76, 0.000_999_9, 0.0123, 1.0, 59.96, 1234.5].map(seconds_text);
        assert_eq!(texts, ["0.00", "0.00000123", "0.0000988", "0.00100", "0.0123", "1.00", "60.0", "1234"]);
    }
}
