//! A strategy from outside the library: how to add one, and how it does beside those inside.
//!
//! Step 3 of refinement says where a new vertex goes. Ours takes the middle between the circumcenter and the longest
//! edge's middle: not clever, but bounded by the same limits and judged by the same report as every other.
//!
//! `cargo run -p trimalla-compare --example own_strategy`, with a name of a file for charts after it
#![allow(clippy::print_stdout, reason = "an example talks")]

use std::sync::Arc;

use trimalla::drawing::Pslg;
use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::FaceId;
use trimalla::refine::Preset;
use trimalla::refine::steps::{Places, PointStep, Proposal, View};
use trimalla_compare::{Contender, Experiment, NoWatch, figures, markdown};

/// Halfway from the middle of the longest edge to the circumcenter.
struct Halfway;

impl PointStep for Halfway {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let [a, b, c] = view.cdt.corners(face);
        let longest = trimalla::refine::lepp::longest_edge(view.cdt, view.ruler, face);
        let middle = trimalla::refine::lepp::edge_midpoint(view.cdt, longest);
        let point = Triangle::new(a, b, c).circumcenter().map(|center| Point::midpoint(middle, center));
        // The walk to it ends there, or at a segment in its way, which is split instead.
        places.extend(point.and_then(|point| Proposal::towards(view, face, point)));
    }
}

/// A box with a notch, and vertices along an arc that crowd towards one end.
fn drawing() -> Pslg {
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 6.0], [5.5, 6.0], [5.0, 5.0], [4.5, 6.0], [0.0, 6.0]];
    let n = corners.len() as u32;
    let mut points = corners.map(Point::from).to_vec();
    points.extend((1..24).map(f64::from).map(|i| Point::new(0.4 * i, 0.005 * i * i)));
    Pslg { points, segments: (0..n).map(|i| [i, (i + 1) % n]).collect(), ..Pslg::default() }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut experiment = Experiment::new((20..=30).step_by(2).map(f64::from));
    experiment.max_vertices = 5000;
    experiment.add_drawing("notched box", drawing())?;
    for preset in [Preset::OffCenter, Preset::Circumcenter, Preset::LeppCentroid] {
        experiment.add_contender(Contender::of(preset))?;
    }
    let halfway = Contender::of(Preset::OffCenter).called("halfway");
    experiment.add_contender(halfway.with_steps("1", |_, steps| steps.point = Arc::new(Halfway)))?;

    let outcomes = experiment.run(2, None, &NoWatch)?;
    let sheets = experiment.sheets(&outcomes, None);
    print!("{}", markdown::text(&experiment, &sheets));
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, figures::all_in_one(&experiment, &sheets))?;
    }
    Ok(())
}
