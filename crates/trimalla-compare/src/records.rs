//! Sheets for programs: CSV and JSON.

use serde_json::{Map, Value, json};

use crate::experiment::Experiment;
use crate::sheet::{Cell, Column, Quantity, Sheet, Times, seconds_text};

/// A header, and a row each run; the counts of runs without a result are empty, and published rows stand below ours.
#[must_use]
pub fn csv(experiment: &Experiment, sheets: &[Sheet<'_>]) -> String {
    let mut text = String::from(
        "input,recipe,angle_deg,result,vertices,triangles,steiner_points,min_angle_deg,max_angle_deg,below_bound",
    );
    let times = experiment.times;
    text += times_header(times);
    text.push('\n');
    for sheet in sheets {
        if let Err(messages) = sheet.read {
            let commas = 6 + times_header(times).matches(',').count();
            let error = format!("error: {}", messages.join("; "));
            text += &format!("{},,,{}{}\n", field(sheet.name), field(&error), ",".repeat(commas));
        }
        for column in &sheet.columns {
            for (cell, angle) in column.cells.iter().zip(sheet.angles) {
                let Some(end) = csv_end(cell, times) else { continue };
                text += &format!("{},{},{angle},{end}\n", field(sheet.name), field(&column.label));
            }
        }
    }
    text
}

/// The fields of a row from its result on.
fn csv_end(cell: &Cell, times: Times) -> Option<String> {
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
        Cell::Run(run) if run.is_done() => format!(
            "done,{vertices},{triangles},{},{:.4},{:.4},{}",
            run.steiner_points, run.min_angle_deg, run.max_angle_deg, run.below_bound
        ),
        Cell::Run(run) => format!("{},,,,,,", run.end),
    };
    row += &csv_times(cell, times);
    Some(row)
}

/// The names of the last fields.
fn times_header(times: Times) -> &'static str {
    match times {
        Times::Hidden => "",
        Times::Total => ",seconds",
        Times::BySteps => {
            ",seconds,prepare_seconds,select_seconds,point_seconds,insert_seconds,recover_seconds,rest_seconds"
        }
    }
}

fn csv_times(cell: &Cell, times: Times) -> String {
    match cell {
        Cell::Run(run) if times != Times::Hidden => {
            let steps = run.step_times.filter(|_| times == Times::BySteps);
            let steps =
                steps.map(|steps| steps.by_name().map(|(_, seconds)| format!(",{}", seconds_text(seconds))).concat());
            format!(",{}{}", seconds_text(run.seconds), steps.unwrap_or_default())
        }
        _ => ",".repeat(times_header(times).matches(',').count()),
    }
}

fn field(text: &str) -> String {
    let text: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// One object: the limits, and each input with its runs in order.
#[must_use]
pub fn json(experiment: &Experiment, sheets: &[Sheet<'_>]) -> String {
    let inputs: Vec<Value> = sheets.iter().map(|sheet| of_sheet(sheet, experiment.times)).collect();
    let object = json!({
        "max_vertices": experiment.max_vertices,
        "time_limit": experiment.time_limit,
        "angles": experiment.angles(),
        "inputs": inputs,
    });
    format!("{object}\n")
}

fn of_sheet(sheet: &Sheet<'_>, times: Times) -> Value {
    match sheet.read {
        Err(messages) => json!({ "input": sheet.name, "errors": messages }),
        Ok(_) => {
            let column = |column: &Column| {
                let runs = column.cells.iter().zip(sheet.angles).filter_map(|(cell, angle)| run(cell, *angle, times));
                json!({ "recipe": column.label, "published": column.is_published, "runs": runs.collect::<Vec<_>>() })
            };
            json!({ "input": sheet.name, "recipes": sheet.columns.iter().map(column).collect::<Vec<_>>() })
        }
    }
}

fn run(cell: &Cell, angle: f64, times: Times) -> Option<Value> {
    let mut object: Map<String, Value> = match cell {
        Cell::Absent => return None,
        Cell::Run(run) => run.to_json().as_object().cloned().unwrap_or_default(),
        Cell::Published { counts, comment } => {
            let mut object = Map::new();
            object.insert("vertices".to_owned(), json!(counts.map(|c| c[0])));
            object.insert("triangles".to_owned(), json!(counts.map(|c| c[1])));
            object.insert("comment".to_owned(), json!(comment));
            object
        }
    };
    object.insert("angle".to_owned(), json!(angle));
    if times == Times::Hidden {
        object.remove("seconds");
    }
    if times != Times::BySteps {
        object.remove("step_seconds");
    }
    Some(Value::Object(object))
}
