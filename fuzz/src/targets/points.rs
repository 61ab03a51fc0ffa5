//! Delaunay triangulations of points, all of them or some, by every algorithm.

use trimalla::delaunay::{AlgorithmKey, BuildError};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;
use trimalla::triangulation::Triangulation;
use trimalla_testkit::oracles::{brute_force_delaunay, covers_hull, first_flaw};

use super::{Target, case_of};
use crate::drawings;
use crate::draws::Draws;
use crate::input::{Case, Input};
use crate::judge::{Tally, Verdict, fault, must, none};

/// See the file.
pub const TARGET: Target =
    Target { name: "points", summary: "Delaunay, every algorithm, subsets", share: 8, make, judge };

/// Up to so many points all triangles are tried, at times.
const BRUTE: usize = 12;

fn make(d: &mut Draws<'_>) -> Input {
    let drawing = if d.once_in(3) {
        let n = drawings::size(d);
        drawings::points_alone(d, n)
    } else {
        let drawn = drawings::drawing(d);
        Pslg { points: drawn.points, ..Pslg::default() }
    };
    Input::Drawing(Box::new(Case { more: d.bits(), ..Case::of(drawing) }))
}

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Some(case) = case_of(input) else { return Ok(()) };
    let (points, mut d) = (&case.drawing.points, Case::draws(case.more));
    if d.once_in(32) {
        return not_finite(points, &mut d);
    }
    let subset: Option<Vec<VertexId>> =
        d.once_in(4).then(|| (0..points.len()).filter(|_| d.once_in(2)).map(|v| VertexId(v as u32)).collect());
    let made = AlgorithmKey::ALL.map(|a| a.triangulate(points, subset.as_deref()));
    let [Ok(one), others @ ..] = &made else { return fault("points refused", format!("{made:?}")) };
    none("check", &one.check_delaunay())?;
    for other in others {
        let Ok(other) = other else { return fault("points refused", format!("{made:?}")) };
        none("check", &other.check_delaunay())?;
        must(one.canonical() == other.canonical(), "algorithms differ", String::new)?;
    }
    tally.meshes += 2;
    let mesh = mesh_of(points, one);
    if let Some(flaw) = first_flaw(&mesh, None, true) {
        return fault(format!("exact: {}", flaw.key()), flaw.to_string());
    }
    if subset.is_none() && d.once_in(16) {
        must(covers_hull(points, &mesh.triangles), "hull not covered", String::new)?;
        if points.len() <= BRUTE {
            must(brute_force_delaunay(points) == mesh.triangles, "not the triangulation by definition", String::new)?;
        }
    }
    Ok(())
}

/// Points that are not finite are refused by name.
fn not_finite(points: &[Point], d: &mut Draws<'_>) -> Verdict {
    let mut points = points.to_vec();
    let v = d.below(points.len());
    points[v].x = d.pick(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
    for algorithm in AlgorithmKey::ALL {
        match algorithm.triangulate(&points, None) {
            Err(BuildError::NotFinite { index, .. }) if index == v => {}
            other => return fault("not finite accepted", format!("{other:?}")),
        }
    }
    Ok(())
}

/// The triangulation as arrays; the boundary as subsegments.
fn mesh_of(points: &[Point], t: &Triangulation) -> IndexedMesh {
    let triangles: Vec<[u32; 3]> = t.canonical().into_iter().map(|t| t.map(|v| v.0)).collect();
    let mut sides: Vec<[u32; 2]> = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    sides.sort_unstable();
    let segments = sides.iter().copied().filter(|&[a, b]| sides.binary_search(&[b, a]).is_err()).collect();
    IndexedMesh { input_points: points.len(), points: points.to_vec(), triangles, segments, ..IndexedMesh::default() }
}
