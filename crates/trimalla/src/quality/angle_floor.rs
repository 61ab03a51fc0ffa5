//! Input angles, and the angle that refinement keeps in spite of them.
//!
//! Where two segments meet at less than the angle bound θ, every mesh has a small angle. How small it need be is known
//! for Ruppert's refinement with shells: the worst triangle has two corners on one shell, at distance 1 from where the
//! segments meet, and the third on one of them at the next split, at distance ρ:
//!
//! ```text
//!               q                        tan φ = sin θ / (ρ − cos θ)
//!            /  |  ‾‾--..__
//!         /  θ  |       φ ‾‾--..__       ρ = 2 between shells, whose radii are powers of two;
//!       o ───── p ──────────────── r     ρ < 3 beyond the first shell, which is in the middle third of a segment
//!       0       1                  ρ
//!
//!     θ              1      5     10     20     30     36.53
//!     φ at ρ = 2    1.00   4.96   9.71  17.88  23.79  26.45
//!     φ at ρ = 3    0.50   2.49   4.92   9.43  13.19  15.16
//! ```

use super::sectors::for_each_sector;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Angle, Point, math};
use crate::half_edge::VertexId;

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
pub fn smallest_input_angle(cdt: &ConstrainedTriangulation) -> Option<InputAngle> {
    let mut smallest: Option<InputAngle> = None;
    for_each_sector(cdt, |vertex, sector| {
        if sector.is_corner() && smallest.is_none_or(|found| sector.angle < found.angle) {
            smallest = Some(InputAngle { angle: sector.angle, vertex, at: cdt.point(vertex) });
        }
    });
    smallest
}

/// The angle below which refinement need not go if the smallest input angle is `smallest_input`, and segments that meet
/// at small angles have been split at lengths that are powers of two beforehand.
///
/// # Guarantees
/// Proved for Ruppert's refinement with shells at bounds of up to 26.45 degrees. No larger than the input angle.
///
/// # Source
/// `[MillerPavWalkington03]`, the bound on the minimum angle over all triangles: arctan(sin θ / (2 − cos θ)).
#[must_use]
pub fn angle_floor(smallest_input: Angle) -> Angle {
    floor_at(smallest_input, 2.0)
}

/// The [`angle_floor`] for segments of any length: the first shell is where it is in the middle third.
///
/// # Source
/// The argument of `[MillerPavWalkington03]` with 3 for 2: a box with an angle of 20 degrees between segments of length
/// 10, whose first shell is at 4, has a triangle with arctan(sin θ / (2.5 − cos θ)), which is 12.36 degrees.
#[must_use]
pub fn shell_floor(smallest_input: Angle) -> Angle {
    floor_at(smallest_input, 3.0)
}

/// The angle of the worst triangle if the next split is `next` times as far away as the shell.
fn floor_at(smallest_input: Angle, next: f64) -> Angle {
    // Wider angles than this have no shells between their sides.
    let angle = smallest_input.radians().min(Angle::from_degrees(60.0).radians());
    let angle = Angle::from_radians(angle);
    Angle::from_radians(math::atan(angle.sin() / (next - angle.cos())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constrained::Crossings;
    use crate::domain::{DomainRule, build};
    use crate::drawing::Pslg;

    #[test]
    fn the_table_of_the_file_holds() {
        for (theta, floor) in [(1.0, 1.00), (5.0, 4.96), (10.0, 9.71), (20.0, 17.88), (30.0, 23.79), (36.53, 26.45)] {
            let found = angle_floor(Angle::from_degrees(theta)).degrees();
            assert!((found - floor).abs() < 0.006 && found <= theta, "{theta}: {found}");
        }
        for (theta, floor) in [(1.0, 0.50), (5.0, 2.49), (10.0, 4.92), (20.0, 9.43), (30.0, 13.19), (36.53, 15.16)] {
            let found = shell_floor(Angle::from_degrees(theta)).degrees();
            assert!((found - floor).abs() < 0.006, "{theta}: {found}");
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
