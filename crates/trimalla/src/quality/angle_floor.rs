//! Input angles, and the angle that refinement keeps in spite of them.
//!
//! Where two segments meet at less than the angle bound, no mesh does without a small angle. How small it need be is
//! known for Ruppert's refinement with shells: the triangles across from the input angle θ are the worst, and their
//! angles are at least arctan(sin θ / (2 − cos θ)).
//!
//! ```text
//!     θ        1      5     10     20     30     36.53
//!     floor    1.00   4.96   9.71  17.88  23.79  26.45
//! ```

use super::sectors::for_each_sector;
use crate::constrained::ConstrainedDelaunay;
use crate::geometry::{Angle, Point, math};
use crate::mesh::VertexId;

/// An angle between two segments that meet, inside the domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputAngle {
    /// The angle, rounded.
    pub angle: Angle,
    /// Where the segments meet.
    pub vertex: VertexId,
    /// Its place.
    pub at: Point,
}

/// The smallest angle between constrained edges of a carved triangulation, of equal ones that at the lowest vertex.
///
/// # Complexity
/// Linear.
#[must_use]
pub fn smallest_input_angle(cdt: &ConstrainedDelaunay) -> Option<InputAngle> {
    let mut smallest: Option<InputAngle> = None;
    for vertex in cdt.used_vertices() {
        for_each_sector(cdt, vertex, |sector| {
            if sector.is_corner() && smallest.is_none_or(|found| sector.angle < found.angle) {
                smallest = Some(InputAngle { angle: sector.angle, vertex, at: cdt.point(vertex) });
            }
        });
    }
    smallest
}

/// The angle below which refinement need not go where the smallest input angle is this one.
///
/// # Guarantees
/// Proved for Ruppert's refinement with shells at bounds of up to 26.45 degrees. No larger than the input angle.
///
/// # Source
/// `[MillerPavWalkington03]`, the bound on the minimum angle over all triangles: arctan(sin θ / (2 − cos θ)).
#[must_use]
pub fn angle_floor(smallest_input: Angle) -> Angle {
    Angle::from_radians(math::atan(smallest_input.sin() / (2.0 - smallest_input.cos())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constrained::Crossings;
    use crate::domain::{DomainRule, Pslg, build};

    #[test]
    fn the_table_of_the_file_holds() {
        for (theta, floor) in [(1.0, 1.00), (5.0, 4.96), (10.0, 9.71), (20.0, 17.88), (30.0, 23.79), (36.53, 26.45)] {
            let found = angle_floor(Angle::from_degrees(theta)).degrees();
            assert!((found - floor).abs() < 0.006 && found <= theta, "{theta}: {found}");
        }
    }

    #[test]
    fn only_angles_inside_the_domain_count() {
        // A square hole corner is 270 degrees of domain; the outer corners are 90; one corner is cut at 45.
        let points = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [4.0, 9.0], [0.0, 5.0], [3.0, 3.0], [5.0, 3.0], [4.0, 3.5]];
        let ring = |from: u32, n: u32| (0..n).map(move |i| [from + i, from + (i + 1) % n]);
        let pslg = Pslg {
            points: points.map(Point::from).to_vec(),
            segments: ring(0, 5).chain(ring(5, 3)).collect(),
            holes: vec![Point::new(4.0, 3.2)],
            ..Pslg::default()
        };
        let (cdt, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, Default::default()).unwrap();
        let found = smallest_input_angle(&cdt).unwrap();
        assert_eq!((found.vertex, found.angle.degrees()), (VertexId(0), 90.0), "not the 27 degrees of the hole");
    }
}
