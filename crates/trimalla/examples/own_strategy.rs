//! A strategy from outside the library: how to add one, and how it does beside those inside.
//!
//! Step 3 of refinement says where a new vertex goes. Ours takes the middle between the circumcenter and the longest edge's
//! middle: not clever, but bounded by the same limits and judged by the same report as every other.
//!
//! `cargo run -p trimalla --example own_strategy`
#![allow(clippy::print_stdout, reason = "an example talks")]

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, Pslg, build};
use trimalla::geometry::{Point, Triangle};
use trimalla::mesh::FaceId;
use trimalla::refine::steps::{PointStep, Proposal, View};
use trimalla::refine::{NoObserver, Preset, RefineOptions, Refinement, Report};

/// Halfway from the middle of the longest edge to the circumcenter.
struct Halfway;

impl PointStep for Halfway {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
        let [a, b, c] = view.cdt.corners(face);
        let longest = trimalla::refine::lepp::longest_edge(view.cdt, view.ruler, face);
        let middle = trimalla::refine::lepp::edge_midpoint(view.cdt, longest);
        let point = Triangle::new(a, b, c).circumcenter().map(|center| Point::midpoint(middle, center));
        // The walk to it ends there, or at a segment in its way, which is split instead.
        places.extend(point.and_then(|point| Proposal::towards(view, face, point)));
    }
}

/// A box with a notch.
fn drawing() -> Pslg {
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 6.0], [5.5, 6.0], [5.0, 2.0], [4.5, 6.0], [0.0, 6.0]];
    let n = corners.len() as u32;
    Pslg {
        points: corners.map(Point::from).to_vec(),
        segments: (0..n).map(|i| [i, (i + 1) % n]).collect(),
        ..Pslg::default()
    }
}

fn refined(degrees: f64, preset: Preset, own: bool) -> Result<Report, Box<dyn std::error::Error>> {
    let (cdt, _) = build(&drawing(), DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
    let options = RefineOptions::of(preset).with_min_angle_deg(degrees).with_max_vertices(5000);
    let mut refinement = Refinement::new(cdt, options)?;
    if own {
        refinement = refinement.with_point(Halfway);
    }
    refinement.run(&mut NoObserver);
    Ok(refinement.finish().1)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("angle  halfway  off-center  circumcenter  lepp-centroid   (vertices; * where the bound is not met)");
    for degrees in [20.0, 24.0, 28.0, 30.0] {
        let own = refined(degrees, Preset::OffCenter, true)?;
        let others = [Preset::OffCenter, Preset::Circumcenter, Preset::LeppCentroid];
        let reports = others.into_iter().map(|preset| refined(degrees, preset, false));
        let reports: Vec<Report> = std::iter::once(Ok(own)).chain(reports).collect::<Result<_, _>>()?;
        let cell = |r: &Report| format!("{}{}", r.vertices, if r.complete() { " " } else { "*" });
        let cells: Vec<String> = reports.iter().map(cell).collect();
        println!("{degrees:>5}  {:>7}  {:>10}  {:>12}  {:>13}", cells[0], cells[1], cells[2], cells[3]);
    }
    Ok(())
}
