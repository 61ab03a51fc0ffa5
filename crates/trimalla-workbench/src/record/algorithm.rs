//! What an algorithm tells of its steps, as a page that plays it.
//!
//! All vertices are there from the beginning. A triangle that is added or removed is one of the mesh; an edge, a
//! line or a circle is a shape that lies above it, until it is removed. What is looked at, or refused, is shown by
//! its step alone.

use std::collections::BTreeSet;

use serde_json::{Value, json};
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;
use trimalla::trace::{Act, Recorder, Shape, Step};

use super::player::{Player, TooLarge};
use super::present::{Changed, Corners, Present, sorted};

impl Player {
    /// Records the steps of an algorithm that triangulates a drawing.
    ///
    /// # Errors
    /// [`TooLarge`], where the drawing alone takes more than [`MOST_BYTES`](Self::MOST_BYTES).
    pub fn of_algorithm(title: &str, drawing: &Pslg, recorder: &Recorder) -> Result<Self, TooLarge> {
        let points: Value = drawing.points.iter().map(|p| json!([p.x, p.y])).collect();
        let about = json!({
            "title": title,
            "kind": "algorithm",
            "input_points": drawing.points.len(),
            "drawing": { "points": points, "segments": drawing.segments },
        });
        let (present, came) = Present::of_vertices(&drawing.points);
        let mut player = Self::begin(about, present, (&Changed::default(), &came), Self::MOST_BYTES)?;
        let mut triangles = BTreeSet::new();
        for (number, step) in (1_u64..).zip(recorder.steps()) {
            if !player.has_room() {
                break;
            }
            let changed = changed_by(step, &mut triangles, drawing.points.len());
            let point = |v: u32| drawing.points.get(v as usize).copied().unwrap_or_default();
            let delta = player.present_mut().follow(&changed, point, |_| false);
            let mut told = told(step);
            told["step"] = json!(number);
            told["destroyed"] = json!(changed.destroyed);
            told["made"] = json!(changed.made);
            player.add_told(&told, &changed, &delta);
        }
        if recorder.count() > recorder.steps().len() as u64 {
            player.cut();
        }
        Ok(player)
    }
}

/// The triangle that a step added or removed.
fn changed_by(step: &Step, triangles: &mut BTreeSet<Corners>, vertices: usize) -> Changed {
    let mut changed = Changed::default();
    let Shape::Triangle(corners) = step.shape else { return changed };
    let corners = sorted(corners.map(VertexId));
    let is_sound = corners.iter().all(|&v| (v as usize) < vertices);
    match step.act {
        Act::Add if is_sound && triangles.insert(corners) => changed.made.push(corners),
        Act::Remove if triangles.remove(&corners) => changed.destroyed.push(corners),
        _ => {}
    }
    changed
}

/// The object that tells about a step.
fn told(step: &Step) -> Value {
    let act = match step.act {
        Act::Look => "look",
        Act::Add => "add",
        Act::Remove => "remove",
        Act::Refuse => "refuse",
    };
    let shape = match step.shape {
        Shape::Vertex(v) => json!({ "vertex": v }),
        Shape::Edge(ends) => json!({ "edge": sorted(ends.map(VertexId)) }),
        Shape::Triangle(corners) => json!({ "triangle": sorted(corners.map(VertexId)) }),
        Shape::Line(ends) => json!({ "line": ends.map(coordinates) }),
        Shape::Circle(circle) => json!({ "circle": [circle.center.x, circle.center.y, circle.radius] }),
    };
    json!({ "outcome": step.note, "act": act, "shape": shape })
}

fn coordinates(p: Point) -> [f64; 2] {
    [p.x, p.y]
}

#[cfg(test)]
mod tests {
    use trimalla::trace::Trace as _;

    use super::*;

    #[test]
    fn triangles_are_of_the_mesh_and_vertices_stay() {
        let drawing = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let mut steps = Recorder::of_first(6);
        steps.look(Shape::Vertex(0), "the first one");
        steps.add(Shape::Edge([2, 0]), "a diagonal");
        steps.add(Shape::Triangle([0, 1, 2]), "an ear");
        steps.add(Shape::Triangle([1, 2, 0]), "the same ear");
        steps.add(Shape::Triangle([0, 1, 9]), "no triangle");
        steps.remove(Shape::Triangle([2, 0, 1]), "gone");
        steps.look(Shape::Vertex(3), "one more than are kept");
        let page = Player::of_algorithm("ears", &drawing, &steps).expect("it is small").into_page();
        let (_, after) = page.split_once("id=\"data\">").expect("the data");
        let data: Value = serde_json::from_str(after.split_once("</script>").expect("its end").0).expect("JSON");
        let counts: Vec<u64> = (0..6).filter_map(|i| data["steps"][i]["delta"]["triangles"].as_u64()).collect();
        assert_eq!(counts, [0, 0, 1, 1, 1, 0]);
        assert_eq!((data["steps"].as_array().map(Vec::len), &data["is_cut"]), (Some(6), &json!(true)));
        assert_eq!(data["start"]["points"].as_array().map(Vec::len), Some(4));
        assert_eq!(data["steps"][5]["delta"]["gone"], json!([]), "a vertex without a triangle stays");
        assert_eq!(data["steps"][1]["trace"]["shape"], json!({ "edge": [0, 2] }));
        assert_eq!(data["steps"][3]["trace"]["made"], json!([]));
    }
}
