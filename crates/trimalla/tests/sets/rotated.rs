//! Drawings turned by any angle, resampled and moved far away mesh as well as straight ones.
//!
//! A drawing that somebody else turned and resampled has sides that are straight in intent and bent by an ulp in
//! fact: of every hundred points on a side about half lie outside the line between its ends and half inside. A
//! program that believes in straight sides, in a convex boundary or in an epsilon breaks here.
//!
//! *Drawings.* Triangle's letter A at every whole degree from 1 to 89, our gear wheel at a seeded dozen of angles,
//! each with a hundred rounded points on every side, near the origin and at an UTM offset (500 000, 4 649 776).
//!
//! *Claims*, at 30 degrees with the default recipe:
//! 1. The bound is reached everywhere: the report has no leftover.
//! 2. The mesh is clean by the library's checker and by the testkit's.
//! 3. Its exact area is that of the drawing, up to the perimeter times an ulp of the largest coordinate (I15 of the
//!    reliability catalogue): what the rounding of vertices on the boundary may change, and no more.

use std::path::{Path, PathBuf};

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::quality::against_input;
use trimalla::refine::RefineOptions;
use trimalla::triangulation::check_mesh;
use trimalla::{MeshOptions, mesh};
use trimalla_testkit::generators::{SplitMix64, moved_to_utm, resampled, rotated};
use trimalla_testkit::oracles::{RBig, check_indexed, doubled_area, doubled_ring_area};
use trimalla_testkit::readers::read_poly;
use trimalla_testkit::shared_data_or_skip;

/// Rounded points on a side.
const ON_A_SIDE: usize = 100;
/// How many angles the gear is turned by.
const GEAR_ANGLES: usize = 12;
/// Points that the gear gets on a side: it has 697 sides of its own.
const ON_A_GEAR_SIDE: usize = 8;

/// One drawing turned, resampled and perhaps moved; says what is wrong.
fn faults_of(drawing: &Pslg, degrees: f64, points_a_side: usize, far: bool) -> Vec<String> {
    let turned = rotated(drawing, degrees.to_radians());
    let turned = if far { moved_to_utm(&turned) } else { turned };
    let fine = resampled(&turned, points_a_side);
    let options = MeshOptions { refine: RefineOptions::default().with_max_vertices(400_000), ..MeshOptions::default() };
    let trimalla::Meshed { mesh, report, .. } = match mesh(&fine, &options) {
        Ok(done) => done,
        Err(e) => return vec![format!("refused: {e}")],
    };
    let mut faults = Vec::new();
    if !report.leftovers.is_empty() {
        faults.push(format!("left over {:?}, first {:?}", report.reasons(), report.leftovers[0]));
    }
    faults.extend(check_mesh(&mesh).iter().map(ToString::to_string));
    faults.extend(against_input(&mesh, &fine).faults.iter().map(ToString::to_string));
    faults.extend(check_indexed(&mesh, Some(&fine)));
    faults.extend(area_fault(&fine, &doubled_area(&mesh.points, &mesh.triangles)));
    faults
}

/// The area of a drawing that is an outline with holes, exactly, against that of its mesh.
fn area_fault(drawing: &Pslg, found: &RBig) -> Option<String> {
    let rings = rings(drawing);
    let mut areas: Vec<RBig> =
        rings.iter().map(|r| doubled_ring_area(r)).map(|a| if a < RBig::ZERO { -a } else { a }).collect();
    areas.sort();
    let outline = areas.pop()?;
    let expected = areas.into_iter().fold(outline, |rest, hole| rest - hole);
    let length = |r: &Vec<Point>| -> f64 { r.windows(2).map(|w| (w[1] - w[0]).length_sq().sqrt()).sum() };
    let perimeter: f64 = rings.iter().map(length).sum();
    let largest = drawing.points.iter().fold(0.0_f64, |m, p| m.max(p.x.abs()).max(p.y.abs()));
    let allowed = 2.0 * perimeter * (f64::EPSILON * largest);
    let off = found - &expected;
    let off = off.to_f64().value().abs();
    (off > allowed).then(|| format!("doubled area is off by {off:e}, allowed are {allowed:e}"))
}

/// The closed rings that the segments form, first point repeated.
fn rings(drawing: &Pslg) -> Vec<Vec<Point>> {
    let mut next = vec![Vec::new(); drawing.points.len()];
    for &[a, b] in &drawing.segments {
        next[a as usize].push(b);
        next[b as usize].push(a);
    }
    let mut met = vec![false; next.len()];
    let mut rings = Vec::new();
    for start in 0..next.len() {
        if met[start] || next[start].is_empty() {
            continue;
        }
        let mut ring = Vec::new();
        let mut at = Some(start);
        while let Some(v) = at {
            met[v] = true;
            ring.push(drawing.points[v]);
            at = next[v].iter().map(|&w| w as usize).find(|&w| !met[w]);
        }
        ring.push(drawing.points[start]);
        rings.push(ring);
    }
    rings
}

fn demand_all(drawing: &Pslg, angles: impl Iterator<Item = f64>, points_a_side: usize) {
    let mut wrong = Vec::new();
    for degrees in angles {
        for far in [false, true] {
            if let Some(fault) = faults_of(drawing, degrees, points_a_side, far).first() {
                wrong.push(format!("{degrees} degrees{}: {fault}", if far { " at UTM" } else { "" }));
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong: {wrong:#?}", wrong.len());
}

fn gear() -> Pslg {
    let root: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes");
    read_poly(&root.join("gear.poly"))
}

#[test]
fn the_letter_a_at_every_degree() {
    let a = read_poly(&shared_data_or_skip!().join("triangle/A.poly"));
    demand_all(&a, (1..90).map(f64::from), ON_A_SIDE);
}

#[test]
fn the_gear_at_a_dozen_degrees() {
    let mut random = SplitMix64::new(89);
    demand_all(&gear(), (0..GEAR_ANGLES).map(|_| (1 + random.below(89)) as f64), ON_A_GEAR_SIDE);
}
