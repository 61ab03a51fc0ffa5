//! Sheets for programs: CSV and JSON.

use serde_json::{Map, Value, json};

use super::plan::Plan;
use super::sheet::{Cell, Quantity, Sheet};

/// A header, and a row each run; the counts of runs without a result are empty, and published rows stand below ours.
pub(crate) fn csv(sheets: &[Sheet<'_>], no_times: bool) -> String {
    let mut text = String::from(
        "input,recipe,angle_deg,result,vertices,triangles,steiner_points,min_angle_deg,max_angle_deg,below_bound",
    );
    text += if no_times { "\n" } else { ",seconds\n" };
    for sheet in sheets {
        if let Err(messages) = sheet.read {
            let commas = if no_times { 6 } else { 7 };
            let error = format!("error: {}", messages.join("; "));
            text += &format!("{},,,{}{}\n", field(sheet.name), field(&error), ",".repeat(commas));
        }
        for column in &sheet.columns {
            for (cell, angle) in column.cells.iter().zip(sheet.angles) {
                let Some(end) = csv_end(cell, no_times) else { continue };
                text += &format!("{},{},{angle},{end}\n", field(sheet.name), field(&column.label));
            }
        }
    }
    text
}

/// The fields of a row from its result on.
fn csv_end(cell: &Cell, no_times: bool) -> Option<String> {
    let count = |q: Quantity| cell.value(q).map_or_else(String::new, |v| format!("{v}"));
    let [vertices, triangles] = [count(Quantity::Vertices), count(Quantity::Triangles)];
    let mut row = match cell {
        Cell::Absent => return None,
        Cell::Published { counts, .. } => {
            let result = match (counts, cell.impossible()) {
                (None, _) => "published: ND".to_owned(),
                (Some(_), Some(comment)) => format!("published: {comment}"),
                (Some(_), None) => "published".to_owned(),
            };
            format!("{},{vertices},{triangles},,,,", field(&result))
        }
        Cell::Ours(run) if run.is_done() => format!(
            "done,{vertices},{triangles},{},{:.4},{:.4},{}",
            run.steiner_points, run.min_angle_deg, run.max_angle_deg, run.below_bound
        ),
        Cell::Ours(run) => format!("{},,,,,,", run.end),
    };
    if !no_times {
        let is_ours = matches!(cell, Cell::Ours(_));
        let seconds = if let Cell::Ours(run) = cell { run.seconds } else { 0.0 };
        row += &if is_ours { format!(",{seconds:.6}") } else { ",".to_owned() };
    }
    Some(row)
}

fn field(text: &str) -> String {
    let text: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// One object: the limits, and each input with its runs in order.
pub(crate) fn json(plan: &Plan, sheets: &[Sheet<'_>], no_times: bool) -> String {
    let inputs: Vec<Value> = sheets.iter().map(|sheet| of_sheet(sheet, no_times)).collect();
    let object = json!({
        "max_vertices": plan.max_vertices,
        "time_limit": plan.time_limit,
        "angles": plan.angles,
        "inputs": inputs,
    });
    format!("{object}\n")
}

fn of_sheet(sheet: &Sheet<'_>, no_times: bool) -> Value {
    match sheet.read {
        Err(messages) => json!({ "input": sheet.name, "errors": messages }),
        Ok(_) => {
            let column = |column: &super::sheet::Column| {
                let runs =
                    column.cells.iter().zip(sheet.angles).filter_map(|(cell, angle)| run(cell, *angle, no_times));
                json!({ "recipe": column.label, "published": column.is_published, "runs": runs.collect::<Vec<_>>() })
            };
            json!({ "input": sheet.name, "recipes": sheet.columns.iter().map(column).collect::<Vec<_>>() })
        }
    }
}

fn run(cell: &Cell, angle: f64, no_times: bool) -> Option<Value> {
    let mut object: Map<String, Value> = match cell {
        Cell::Absent => return None,
        Cell::Ours(run) => run.to_json().as_object().cloned().unwrap_or_default(),
        Cell::Published { counts, comment } => {
            let mut object = Map::new();
            object.insert("vertices".to_owned(), json!(counts.map(|c| c[0])));
            object.insert("triangles".to_owned(), json!(counts.map(|c| c[1])));
            object.insert("comment".to_owned(), json!(comment));
            object
        }
    };
    object.insert("angle".to_owned(), json!(angle));
    if no_times {
        object.remove("seconds");
    }
    Some(Value::Object(object))
}
