//! Triangles that miss the angle bound.

use crate::drawing::{IndexedMesh, is_sound};
use crate::geometry::{Angle, Point, triangle_angles_at_least};

/// The triangles with an angle below `min_angle`, by index.
///
/// # Guarantees
/// Every triangle that is not listed passes the exact certificate [`triangle_angles_at_least`]: a bound that is met
/// exactly, as 45 degrees by half a square, counts as met. Listed are the triangles that cannot be certified: those
/// with wrong indices or coordinates, flat ones, and all if the bound is above 60 degrees or not a number. A bound of
/// zero or less lists only triangles without angles.
#[must_use]
pub fn below_bound(mesh: &IndexedMesh, min_angle: Angle) -> Vec<usize> {
    let bound = Certificate::of(min_angle);
    let below = |t: &[u32; 3]| !is_sound(t, mesh.points.len()) || !bound.holds(t.map(|v| mesh.points[v as usize]));
    let listed = mesh.triangles.iter().enumerate().filter(|(_, t)| below(t));
    listed.map(|(i, _)| i).collect()
}

/// An angle bound in the form that can be proved.
#[derive(Clone, Copy, Debug)]
enum Certificate {
    /// The squared cosine of the bound.
    CosSq(f64),
    /// No triangle meets the bound.
    Never,
}

impl Certificate {
    /// Above this no triangle meets a bound; a little room for the rounding of 60 degrees itself.
    const LARGEST_DEG: f64 = 60.0 + 1e-9;

    fn of(min_angle: Angle) -> Self {
        if min_angle.degrees() <= 0.0 {
            Self::CosSq(1.0)
        } else if min_angle.degrees() <= Self::LARGEST_DEG {
            Self::CosSq(min_angle.cos_sq())
        } else {
            Self::Never
        }
    }

    fn holds(self, corners: [Point; 3]) -> bool {
        let [a, b, c] = corners;
        match self {
            Self::CosSq(cos_sq) => {
                corners.into_iter().all(Point::is_finite) && triangle_angles_at_least(a, b, c, cos_sq)
            }
            Self::Never => false,
        }
    }
}
