//! The angle that no mesh of a domain can pass.
//!
//! The idea: the triangles of a mesh fill every sector between two segments that meet. Where `k` triangles share a
//! sector `w`, one of them has an angle of at most `w / k` there; and if all of their angles are at least φ, then none
//! is above 180° − 2φ, so that `w ≤ k (180° − 2φ)`. Hence φ ≤ min(w / k, (180° − w / k) / 2) for the mesh's own `k`:
//!
//! ```text
//!     sector      k = 1     k = 2     best
//!       20           20        10       20      a mesh can leave a sharp corner as it is
//!       90           45        45       45      one diagonal, or none: no mesh of a square passes 45
//!      100           40        50       50
//!       60           60        30       60
//! ```
//!
//! The bound is necessary, not sufficient: it does not say that any mesh reaches it.

use super::sectors::for_each_sector;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Angle, Point};
use crate::half_edge::VertexId;

/// In a full turn the sixth triangle is the last that helps: beyond, `w / k` falls below 60 degrees for every sector.
const MOST_TRIANGLES: u32 = 6;
/// How far a bound may be above the ceiling and still count as within it, in degrees: sectors are rounded.
const ROUNDING_DEG: f64 = 1e-9;

/// An upper bound on the smallest angle of every mesh of a domain, and the corner that sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleCeiling {
    /// No mesh has a smallest angle above this, up to rounding.
    pub bound: Angle,
    /// The vertex of the corner; the lowest of those that set the same bound.
    pub vertex: VertexId,
    /// Where it lies.
    pub at: Point,
    /// The sector of the domain there.
    pub sector: Angle,
}

impl AngleCeiling {
    /// Whether no mesh has all angles at `min_angle` or above.
    #[must_use]
    pub fn forbids(&self, min_angle: Angle) -> bool {
        min_angle.degrees() > self.bound.degrees() + ROUNDING_DEG
    }
}

/// The largest smallest angle that the corners of a carved domain allow; `None` of a triangulation without triangles.
///
/// # Guarantees
/// An upper bound for every triangulation of the domain, whatever vertices are added; at most 60 degrees.
///
/// # Complexity
/// Linear.
///
/// # Source
/// Our own: the angles of a triangle sum to 180 degrees, as the head of the file uses it.
///
/// # Examples
/// ```
/// use trimalla::constrained::Crossings;
/// use trimalla::drawing::Pslg;
/// use trimalla::domain::{DomainRule, build};
/// use trimalla::geometry::Point;
/// use trimalla::quality::angle_ceiling;
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
/// let square = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
/// let (cdt, _) = build(&square, DomainRule::Seeds, Crossings::Refuse, Default::default())?;
/// let ceiling = angle_ceiling(&cdt).expect("a square has triangles");
/// assert_eq!(ceiling.bound.degrees(), 45.0);
/// # Ok::<(), trimalla::domain::DomainError>(())
/// ```
#[must_use]
pub fn angle_ceiling(cdt: &ConstrainedTriangulation) -> Option<AngleCeiling> {
    let mut lowest: Option<AngleCeiling> = None;
    for_each_sector(cdt, |vertex, sector| {
        let bound = best_share(sector.angle);
        if lowest.is_none_or(|found| bound < found.bound) {
            lowest = Some(AngleCeiling { bound, vertex, at: cdt.point(vertex), sector: sector.angle });
        }
    });
    lowest
}

/// The largest smallest angle that triangles in a sector can have.
fn best_share(sector: Angle) -> Angle {
    let share = |k: u32| {
        let each = sector.degrees() / f64::from(k);
        each.min(0.5 * (180.0 - each))
    };
    Angle::from_degrees((1..=MOST_TRIANGLES).map(share).fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constrained::Crossings;
    use crate::domain::{DomainRule, build};
    use crate::drawing::Pslg;
    use crate::geometry::math;

    #[test]
    fn the_table_of_the_file_holds() {
        for (sector, best) in [(20.0, 20.0), (45.0, 45.0), (60.0, 60.0), (90.0, 45.0), (100.0, 50.0), (120.0, 60.0)] {
            let found = best_share(Angle::from_degrees(sector)).degrees();
            assert!((found - best).abs() < 1e-12, "{sector}: {found}");
        }
        assert!((best_share(Angle::from_degrees(360.0)).degrees() - 60.0).abs() < 1e-12);
        assert!((best_share(Angle::from_degrees(80.0)).degrees() - 50.0).abs() < 1e-12);
    }

    fn ceiling(points: &[[f64; 2]], segments: &[[u32; 2]]) -> AngleCeiling {
        let points = points.iter().copied().map(Point::from).collect();
        let pslg = Pslg { points, segments: segments.to_vec(), ..Pslg::default() };
        let (cdt, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, Default::default()).unwrap();
        angle_ceiling(&cdt).unwrap()
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    const AROUND: [[u32; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];

    #[test]
    fn the_lowest_corner_is_named() {
        let found = ceiling(&SQUARE, &AROUND);
        assert_eq!((found.bound.degrees(), found.vertex, found.sector.degrees()), (45.0, VertexId(0), 90.0));
        // A diagonal halves two corners: those still allow 45; a spike at 20 degrees to the bottom does not.
        let mut points = SQUARE.to_vec();
        let spike = Angle::from_degrees(20.0);
        points.push([1.0 - 0.5 * spike.cos(), 0.5 * math::sin(spike.radians())]);
        let found = ceiling(&points, &[AROUND.as_slice(), &[[1, 4]]].concat());
        assert_eq!(found.vertex, VertexId(1));
        assert!((found.bound.degrees() - 20.0).abs() < 1e-12 && found.forbids(Angle::from_degrees(20.1)));
        assert!(!found.forbids(Angle::from_degrees(20.0)));
    }

    #[test]
    fn free_ends_isolated_vertices_and_reflex_corners_do_not_lower_it() {
        let corner = |deg: f64| [Angle::from_degrees(deg).cos(), Angle::from_degrees(deg).sin()];
        // An equilateral triangle with a vertex inside and a segment that ends inside.
        let points = [corner(90.0), corner(210.0), corner(330.0), [0.0, 0.1], [0.0, -0.1], [0.1, -0.1]];
        let found = ceiling(&points, &[[0, 1], [1, 2], [2, 0], [4, 5]]);
        assert!((found.bound.degrees() - 60.0).abs() < 1e-12, "{found:?}");
        // The reflex corner of an arrow is wide; its tips are what counts.
        let found = ceiling(&[[0.0, 0.0], [4.0, 3.0], [0.0, 1.0], [-4.0, 3.0]], &AROUND);
        assert!([1, 3].contains(&found.vertex.0) && found.bound.degrees() < 11.0, "{found:?}");
    }
}
