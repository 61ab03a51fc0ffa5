//! Drawings made domains: seeds, nesting, hull, contours, regions.

use trimalla::DomainOptions;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{self, ContourOrder, Contours};
use trimalla::drawing::Pslg;
use trimalla::geometry::Orientation;
use trimalla::half_edge::VertexId;

use super::{Target, case_of, drawing_input};
use crate::input::{Case, Input};
use crate::judge::{Tally, Verdict, fault, mesh_of, must, none};
use crate::settings::two_algorithms;

/// See the file.
pub const TARGET: Target = Target {
    name: "domains",
    summary: "seeds, nesting, hull, contours, regions",
    share: 9,
    make: drawing_input,
    judge,
};

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Some(case) = case_of(input) else { return Ok(()) };
    let mut d = Case::draws(case.more);
    if d.once_in(8) {
        return contours(case, tally);
    }
    let DomainOptions { rule, crossings, algorithm } = case.domain;
    let drawing = &case.drawing;
    let (cdt, _) = match domain::build(drawing, rule, crossings, algorithm) {
        Ok(built) => built,
        Err(error) => {
            tally.refused += 1;
            return must(error.to_string().len() < 4000, "message too long", || error.to_string());
        }
    };
    none("check", &cdt.check())?;
    let mesh = cdt.to_indexed(drawing);
    must(cdt.clone().into_indexed(drawing) == mesh, "to_indexed and into_indexed differ", String::new)?;
    mesh_of(drawing, &mesh, true, &[], tally)?;
    if d.once_in(4) {
        let other = AlgorithmKey::ALL.into_iter().find(|a| *a != algorithm).unwrap_or(algorithm);
        match domain::build(drawing, rule, crossings, other) {
            Ok((other, _)) => must(other.canonical() == cdt.canonical(), "algorithms differ", String::new)?,
            Err(error) => return fault("algorithms differ in their refusal", error.to_string()),
        }
    }
    Ok(())
}

/// The first rings of the drawing as contours.
fn contours(case: &Case, tally: &mut Tally) -> Verdict {
    let drawing = &case.drawing;
    let mut rings = rings(drawing);
    rings.truncate(4);
    let area_sign = |ring: &[VertexId]| {
        let corners: Vec<_> = ring.iter().map(|v| drawing.points[v.index()]).collect();
        trimalla::geometry::Ring::new(&corners).orientation()
    };
    for (i, ring) in rings.iter_mut().enumerate() {
        let wanted = if i == 0 { Orientation::CounterClockwise } else { Orientation::Clockwise };
        if area_sign(ring) != wanted {
            ring.reverse();
        }
    }
    let mut rings = rings.into_iter();
    let outer = if case.more & 3 == 0 { None } else { rings.next() };
    let order = if case.more & 4 == 0 { ContourOrder::default() } else { ContourOrder::HolesFirst };
    let contours = Contours { outer, holes: rings.collect(), order };
    let made = two_algorithms(case.more).map(|a| contours.triangulate(&drawing.points, a));
    match made {
        [Ok(one), Ok(other)] => {
            let input = Pslg {
                segments: contours.segments(),
                holes: Vec::new(),
                regions: Vec::new(),
                segment_markers: Vec::new(),
                ..drawing.clone()
            };
            none("check", &one.check())?;
            none("check", &other.check())?;
            must(one.canonical() == other.canonical(), "algorithms differ", String::new)?;
            mesh_of(&input, &one.to_indexed(&input), true, &[], tally)
        }
        [Err(_), Err(_)] => {
            tally.refused += 1;
            Ok(())
        }
        [one, other] => fault("algorithms differ in their refusal", format!("{:?} {:?}", one.err(), other.err())),
    }
}

/// Rings that segments of the drawing make, one after the other.
fn rings(drawing: &Pslg) -> Vec<Vec<VertexId>> {
    let mut rings = Vec::new();
    let mut ring: Vec<VertexId> = Vec::new();
    for &[a, b] in &drawing.segments {
        if ring.last() != Some(&VertexId(a)) {
            ring = vec![VertexId(a)];
        }
        if ring.first() == Some(&VertexId(b)) {
            rings.push(std::mem::take(&mut ring));
        } else {
            ring.push(VertexId(b));
        }
    }
    rings
}
