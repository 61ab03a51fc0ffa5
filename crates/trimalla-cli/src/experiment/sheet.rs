//! One drawing's columns, ours and the published ones.

use super::baseline::Baseline;
use super::outcome::Outcome;
use super::plan::Plan;

/// What tables and charts show of a drawing.
#[derive(Debug)]
pub(crate) struct Sheet<'a> {
    /// As the command line names the drawing.
    pub(crate) name: &'a str,
    /// A word for file names and headings.
    pub(crate) title: &'a str,
    /// The counts of the drawing in words, or what is wrong with it.
    pub(crate) read: Result<&'a str, &'a [String]>,
    /// Degrees, the rows of every column.
    pub(crate) angles: &'a [f64],
    pub(crate) columns: Vec<Column>,
}

/// A recipe, or a published column.
#[derive(Debug)]
pub(crate) struct Column {
    pub(crate) label: String,
    pub(crate) is_published: bool,
    /// One for each angle.
    pub(crate) cells: Vec<Cell>,
}

/// One run, ours or published.
#[derive(Clone, Debug)]
pub(crate) enum Cell {
    Ours(Outcome),
    Published {
        /// Vertices and triangles; `None` where the table says ND.
        counts: Option<[usize; 2]>,
        /// What whoever copied the table says about the row.
        comment: String,
    },
    /// The table has no such row.
    Absent,
}

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Vertices,
    Triangles,
    Seconds,
}

impl Quantity {
    pub(crate) const ALL: [Self; 3] = [Self::Vertices, Self::Triangles, Self::Seconds];

    /// All, or all but the times.
    pub(crate) fn shown(no_times: bool) -> &'static [Self] {
        if no_times { &Self::ALL[..2] } else { &Self::ALL }
    }

    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::Vertices => "vertices",
            Self::Triangles => "triangles",
            Self::Seconds => "seconds",
        }
    }
}

impl Cell {
    /// The number, if there is one.
    pub(crate) fn value(&self, quantity: Quantity) -> Option<f64> {
        match (self, quantity) {
            (Self::Ours(run), _) if !run.is_done() => None,
            (Self::Ours(run), Quantity::Vertices) => Some(run.vertices as f64),
            (Self::Ours(run), Quantity::Triangles) => Some(run.triangles as f64),
            (Self::Ours(run), Quantity::Seconds) => Some(run.seconds),
            (Self::Published { counts, .. }, Quantity::Vertices) => counts.map(|c| c[0] as f64),
            (Self::Published { counts, .. }, Quantity::Triangles) => counts.map(|c| c[1] as f64),
            _ => None,
        }
    }

    /// The comment on a published row that cannot be right.
    pub(crate) fn impossible(&self) -> Option<&str> {
        match self {
            Self::Published { comment, .. } if comment.starts_with("impossible") => Some(comment),
            _ => None,
        }
    }

    /// Any other comment on a published row.
    pub(crate) fn remark(&self) -> Option<&str> {
        match self {
            Self::Published { comment, counts: Some(_) } if !comment.is_empty() => {
                self.impossible().is_none().then_some(comment)
            }
            _ => None,
        }
    }
}

/// The sheets of an experiment, one a drawing.
pub(crate) fn sheets<'a>(plan: &'a Plan, outcomes: &[Option<Outcome>], baseline: Option<&Baseline>) -> Vec<Sheet<'a>> {
    let sheet = |(d, drawing): (usize, &'a super::plan::Drawing)| {
        let cell = |c: usize, a: usize| outcomes[plan.index(d, c, a)].clone().map_or(Cell::Absent, Cell::Ours);
        let mut columns = Vec::new();
        if drawing.read.is_ok() {
            columns.extend(plan.contenders.iter().enumerate().map(|(c, contender)| Column {
                label: contender.label.clone(),
                is_published: false,
                cells: (0..plan.angles.len()).map(|a| cell(c, a)).collect(),
            }));
            columns.extend(baseline.map(|b| b.columns(&drawing.title, &plan.angles)).unwrap_or_default());
        }
        let read = drawing.read.as_ref().map(|good| &good.facts[..]).map_err(|messages| &messages[..]);
        Sheet { name: &drawing.name, title: &drawing.title, read, angles: &plan.angles, columns }
    };
    plan.drawings.iter().enumerate().map(sheet).collect()
}
