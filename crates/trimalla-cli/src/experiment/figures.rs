//! Sheets as charts: a quantity against the angle, a curve each recipe.

use std::fs;
use std::path::{Path, PathBuf};

use trimalla_io::chart::{Chart, Curve, draw};

use super::plan::Plan;
use super::sheet::{Cell, Column, Quantity, Sheet};
use crate::console::shown;
use crate::exit::{Failure, Status};

/// Whether a path stands for one file with all charts; else it is a folder with a file for each.
fn is_one_file(path: &Path) -> bool {
    path == Path::new("-") || path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

/// The files that the charts go to; the folder is made where there is none.
pub(crate) fn files(path: &Path, plan: &Plan, no_times: bool) -> Result<Vec<PathBuf>, Failure> {
    if is_one_file(path) {
        return Ok(vec![path.to_owned()]);
    }
    fs::create_dir_all(path).map_err(|error| {
        Failure::new(Status::Unwritable, format!("cannot make the folder {}: {error}", shown(path)))
    })?;
    let good = plan.drawings.iter().filter(|drawing| drawing.read.is_ok());
    let names = good.flat_map(|d| Quantity::shown(no_times).iter().map(|q| format!("{}-{}.svg", d.title, q.key())));
    Ok(names.map(|name| path.join(name)).collect())
}

/// The texts of those files.
pub(crate) fn texts(path: &Path, sheets: &[Sheet<'_>], no_times: bool) -> Vec<String> {
    let quantities = Quantity::shown(no_times);
    let good = sheets.iter().filter(|sheet| sheet.read.is_ok());
    let charts: Vec<Chart> = good.flat_map(|sheet| quantities.iter().map(|&q| chart(sheet, q))).collect();
    if is_one_file(path) {
        return vec![svg(&charts, quantities.len())];
    }
    charts.iter().map(|chart| svg(std::slice::from_ref(chart), 1)).collect()
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
