//! Provenances of the vertices of a mesh, found by their places.
//!
//! A file keeps places, not provenances. A vertex inside one segment was put on it by a split; one inside two that run
//! different ways is their crossing; any other is free. A split was made on a shell, a circle around an end where
//! another segment joins, if its distance from there is a power of two in the ruler's units.

use crate::constrained::{ConstrainedTriangulation, Provenance};
use crate::drawing::SegmentId;
use crate::geometry::{BoundingBox, Segment, math};
use crate::half_edge::{HalfEdgeId, NoJournal, VertexId};

/// Distances this close to a power of two, relatively, are on its shell.
const ON_SHELL: f64 = 1e-3;

/// Gives each vertex that has a provenance of its own the one that its place shows; `free` is that of vertices on no
/// segment or at the end of one.
///
/// # Complexity
/// The degrees of the vertices.
pub(super) fn recover(cdt: &mut ConstrainedTriangulation, free: Provenance) {
    let first = cdt.first_provenance().index();
    let scale = scale_of(cdt.bounding_box());
    let found: Vec<Provenance> = (first..cdt.points().len())
        .map(|v| provenance_of(cdt, VertexId::from_index(v), scale).unwrap_or(free))
        .collect();
    for (v, provenance) in (first..).zip(found) {
        cdt.set_provenance(VertexId::from_index(v), provenance, &mut NoJournal);
    }
}

/// The scale of the ruler of the refinement: a power of two.
fn scale_of(bounds: Option<BoundingBox>) -> f64 {
    math::power_of_two_scale(bounds.map_or(1.0, BoundingBox::largest_coordinate))
}

fn provenance_of(cdt: &ConstrainedTriangulation, v: VertexId, scale: f64) -> Option<Provenance> {
    let edges: Vec<HalfEdgeId> = cdt.edges_around(v).filter(|&h| cdt.is_marked(h)).collect();
    let passes = |&s: &SegmentId| !cdt.segments()[s.index()].contains(&v);
    if let &[h, g] = edges.as_slice() {
        if cdt.mark(h) == cdt.mark(g) {
            let segment = cdt.finest_segment(cdt.mark(h)).filter(passes)?;
            return Some(on_segment(cdt, v, segment, scale));
        }
    }
    let mut inside: Vec<SegmentId> = edges.iter().flat_map(|&h| cdt.segments_of(h)).filter(passes).collect();
    inside.sort_unstable();
    inside.dedup();
    match inside.as_slice() {
        [] => None,
        &[segment] => Some(on_segment(cdt, v, segment, scale)),
        &[a, b, ..] => Some(Provenance::Crossing { segments: [a, b] }),
    }
}

/// The place of a vertex inside a segment: on the shell nearest to it, or on none.
fn on_segment(cdt: &ConstrainedTriangulation, v: VertexId, segment: SegmentId, scale: f64) -> Provenance {
    let ends = cdt.segments()[segment.index()];
    let p = cdt.point(v);
    let t = Segment::new(cdt.point(ends[0]), cdt.point(ends[1])).parameter_of(p);
    let nearer = if t <= 0.5 { [false, true] } else { [true, false] };
    for around_end in nearer {
        let apex = ends[usize::from(around_end)];
        let joined = cdt.edges_around(apex).filter(|&h| cdt.is_marked(h)).nth(1).is_some();
        if let Some(shell) = shell_of(Segment::new(cdt.point(apex), p).length() * scale).filter(|_| joined) {
            return Provenance::Shell { segment, t, around_end, shell };
        }
    }
    Provenance::OnSegment { segment, t }
}

/// The exponent of the power of two that a length is close to.
fn shell_of(length: f64) -> Option<i16> {
    if !length.is_normal() || length < 0.0 {
        return None;
    }
    // Half a binade up, so that lengths just below a power count as it.
    #[allow(clippy::cast_possible_truncation, reason = "eleven bits")]
    let exponent = ((length * std::f64::consts::SQRT_2).to_bits() >> 52) as i16 - 1023;
    let power = f64::from_bits(u64::try_from(i32::from(exponent) + 1023).ok()? << 52);
    ((length / power - 1.0).abs() <= ON_SHELL).then_some(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shells_are_powers_of_two_and_what_is_near_them() {
        for exponent in [-1000_i16, -3, 0, 1, 500] {
            let power = math::pow(2.0, f64::from(exponent));
            for near in [power, power * (1.0 - 9e-4), power * (1.0 + 9e-4)] {
                assert_eq!(shell_of(near), Some(exponent), "{near}");
            }
            for far in [power * 1.002, power * 0.998, power * 1.5] {
                assert_eq!(shell_of(far), None, "{far}");
            }
        }
        for none in [0.0, -1.0, f64::NAN, f64::INFINITY, 5e-324] {
            assert_eq!(shell_of(none), None);
        }
    }
}
