//! Sheets as charts: a quantity against the angle, a curve each contender.

use trimalla_io::chart::{Chart, Curve, draw};

use crate::experiment::Experiment;
use crate::sheet::{Cell, Column, Quantity, Sheet, Times};

/// The names of the files with a chart each, as [`each`] gives them: `key-vertices.svg`.
#[must_use]
pub fn file_names(experiment: &Experiment) -> Vec<String> {
    let good = experiment.drawings().iter().filter(|drawing| drawing.is_good());
    let quantities = Quantity::shown(experiment.times);
    good.flat_map(|d| quantities.iter().map(|q| format!("{}-{}.svg", d.title, q.key()))).collect()
}

/// A picture each chart: of each drawing each quantity.
#[must_use]
pub fn each(experiment: &Experiment, sheets: &[Sheet<'_>]) -> Vec<String> {
    charts(sheets, experiment.times).iter().map(|chart| svg(std::slice::from_ref(chart), 1)).collect()
}

/// All charts in one picture, a row each drawing.
#[must_use]
pub fn all_in_one(experiment: &Experiment, sheets: &[Sheet<'_>]) -> String {
    svg(&charts(sheets, experiment.times), Quantity::shown(experiment.times).len())
}

fn charts(sheets: &[Sheet<'_>], times: Times) -> Vec<Chart> {
    let good = sheets.iter().filter(|sheet| sheet.read.is_ok());
    good.flat_map(|sheet| Quantity::shown(times).iter().map(|&q| chart(sheet, q))).collect()
}

fn svg(charts: &[Chart], in_a_row: usize) -> String {
    let mut out = Vec::new();
    let _ = draw(&mut out, charts, in_a_row); // Memory takes all.
    String::from_utf8_lossy(&out).into_owned()
}

fn chart(sheet: &Sheet<'_>, quantity: Quantity) -> Chart {
    let columns: Vec<&Column> =
        sheet.columns.iter().filter(|c| quantity != Quantity::Seconds || !c.is_published).collect();
    let values = columns.iter().flat_map(|column| &column.cells).filter_map(|cell| cell.value(quantity));
    let is_short = quantity == Quantity::Seconds && values.fold(0.0, f64::max) < 0.1;
    let (unit, factor) = if is_short { ("milliseconds", 1000.0) } else { (quantity.key(), 1.0) };
    Chart {
        title: format!("{}: {unit}", sheet.title),
        x_label: "smallest angle asked for, in degrees".to_owned(),
        y_label: unit.to_owned(),
        curves: columns.into_iter().map(|column| curve(column, sheet.angles, quantity, factor)).collect(),
    }
}

fn curve(column: &Column, angles: &[f64], quantity: Quantity, factor: f64) -> Curve {
    let point = |(cell, angle): (&Cell, &f64)| Some([*angle, factor * cell.value(quantity)?]);
    let cells = || column.cells.iter().zip(angles);
    let points: Vec<_> = cells().map(|at| point(at).filter(|_| at.0.impossible().is_none())).collect();
    let doubted: Vec<_> = cells().filter(|at| at.0.impossible().is_some()).filter_map(point).collect();
    let is_empty = doubted.is_empty() && points.iter().all(Option::is_none);
    let label = if is_empty { format!("{} (ND)", column.label) } else { column.label.clone() };
    Curve { label, points, doubted, is_dashed: column.is_published }
}
