//! Reports for programs: one JSON object, keys in alphabetical order.

use serde_json::{Map, Value, json};
use trimalla::Meshed;
use trimalla::drawing::IndexedMesh;
use trimalla::quality::{Classes, Histogram, Spread, Statistics};
use trimalla::refine::{self, Group, NamedOptions, OPTIONS, OptionRow, Overview, Report};
use trimalla_workbench::refining::{MissedBounds, Outcome};

use crate::console;
use crate::exit::Failure;

/// The report of a refinement.
pub(crate) fn of_meshing(outcome: &Outcome, algorithm: &str, seconds: f64) -> Value {
    let Outcome { meshed: Meshed { mesh, report, outlook, attempted, improved, .. }, warnings, foreseen, .. } = outcome;
    let reasons: Map<_, _> =
        report.reasons().into_iter().map(|(reason, count)| (reason.key().to_owned(), json!(count))).collect();
    let warnings: Vec<&String> = warnings.iter().chain(foreseen).collect();
    json!({
        "vertices": mesh.points.len(),
        "triangles": mesh.triangles.len(),
        "steiner_points": mesh.points.len() - mesh.input_points,
        "min_angle": report.min_angle_deg,
        "max_angle": report.max_angle_deg,
        "angle_ceiling": outlook.as_ref().and_then(|o| o.angle_ceiling).map(|ceiling| ceiling.bound.degrees()),
        "below_bound": report.leftovers.len(),
        "bound_met": attempted.map(|attempted| attempted.bound_deg),
        "attempts": attempted.map_or(1, |attempted| attempted.runs),
        "improved_from": improved.map(|improved| improved.vertices_before),
        "climbed_from": improved.and_then(|improved| improved.climbed_from_deg),
        "proved": improved.map(|improved| improved.is_proved),
        "reasons": reasons,
        "algorithm": algorithm,
        "seconds": seconds,
        "complete": report.complete(),
        "stop": report.stop.key(),
        "lost_segments": report.lost_segments.iter().map(|s| s.0).collect::<Vec<u32>>(),
        "lepp_lengths": report.lepp_lengths,
        "insertions": {
            "free": report.points_inserted,
            "on_segments": report.segments_split,
            "taken_back": report.points_rejected,
            "deleted": report.vertices_deleted,
            "flips_instead": report.flips_instead,
        },
        "forecast_triangles": outlook.as_ref().map(|o| whole(o.forecast.triangles)),
        "warnings": warnings,
    })
}

/// Adds the options, the state before the refinement, the bounds missed, and the command that repeats the run.
pub(crate) fn add_asked(
    object: &mut Value,
    asked: &NamedOptions,
    before: Option<Overview>,
    missed: &MissedBounds,
    command: &str,
) {
    let steps = asked.steps().map(|(option, value)| (option.key.to_owned(), of_value(&value)));
    object["recipe"] = Value::Object(steps.collect());
    object["recipe"]["preset"] = json!(asked.preset.unwrap_or_default().key());
    let is_bound = |option: &&OptionRow| matches!(option.group, Group::Protect | Group::Criteria | Group::Limits);
    let bounds = OPTIONS.iter().filter(is_bound);
    let bounds =
        bounds.map(|option| (option.key.replace('-', "_"), option.get(asked).map_or(Value::Null, |v| of_value(&v))));
    object["bounds"] = Value::Object(bounds.collect());
    object["before"] = json!(before.map(|Overview { vertices, triangles, min_angle_deg }| json!({
        "vertices": vertices,
        "triangles": triangles,
        "min_angle": min_angle_deg,
    })));
    object["missed"] = json!({ "angle": missed.angle, "area": missed.area, "aspect_ratio": missed.aspect_ratio });
    object["command"] = json!(command);
    object["version"] = json!(env!("CARGO_PKG_VERSION"));
}

fn of_value(value: &refine::Value) -> Value {
    match value {
        refine::Value::Truth(truth) => json!(truth),
        refine::Value::Number(number) => json!(number),
        refine::Value::Count(count) => json!(count),
        refine::Value::Key(_) | refine::Value::Text(_) => json!(value.to_string()),
    }
}

/// The object that `--details` adds.
pub(crate) fn of_details(statistics: &Statistics, report: &Report) -> Value {
    let inserted: Map<_, _> = report.insertions().iter().map(|(kind, n)| (kind.key().to_owned(), json!(n))).collect();
    let times = report.step_times.map(|times| {
        let by_name = times.by_name().map(|(name, seconds)| (name.to_owned(), json!(seconds)));
        by_name.into_iter().collect::<Map<_, _>>()
    });
    json!({
        "smallest_angles": of_histogram(&statistics.smallest_angles),
        "all_angles": of_histogram(&statistics.all_angles),
        "aspect_ratio": statistics.aspect_ratio.map(of_spread),
        "aspect_ratios": of_classes(&statistics.aspect_ratios),
        "inserted": inserted,
        "step_seconds": times,
    })
}

/// Counts by equal ranges.
pub(crate) fn of_histogram(h: &Histogram) -> Value {
    json!({ "width": h.width_deg, "counts": h.counts })
}

/// Counts by ranges of different width.
pub(crate) fn of_classes(c: &Classes) -> Value {
    json!({ "bounds": c.bounds, "counts": c.counts })
}

/// The smallest, mean and largest of some values.
pub(crate) fn of_spread(s: Spread) -> Value {
    json!({ "min": s.min, "mean": s.mean, "max": s.max })
}

/// A count, as a whole number unless it is too large for one.
fn whole(count: f64) -> Value {
    const LARGEST: f64 = 9_007_199_254_740_992.0;
    if count < LARGEST { json!(count as u64) } else { json!(count) }
}

/// The report of a triangulation.
pub(crate) fn of_triangulation(
    mesh: &IndexedMesh,
    angles_deg: [f64; 2],
    algorithm: &str,
    attained: Option<(f64, bool)>,
    seconds: f64,
    warnings: &[String],
) -> Value {
    json!({
        "vertices": mesh.points.len(),
        "triangles": mesh.triangles.len(),
        "steiner_points": mesh.points.len() - mesh.input_points,
        "attained": attained.map(|(value, _)| value),
        "proved": attained.map(|(_, is_proved)| is_proved),
        "min_angle": angles_deg[0],
        "max_angle": angles_deg[1],
        "algorithm": algorithm,
        "seconds": seconds,
        "warnings": warnings,
    })
}

/// Prints an object on one line of standard output.
pub(crate) fn print(object: &Value) -> Result<(), Failure> {
    console::print(&format!("{object}\n"))
}
