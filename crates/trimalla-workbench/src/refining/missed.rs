//! The bounds that leftover triangles miss.

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::{Point, Triangle};
use trimalla::refine::{Criteria, Missed, Report};

/// The bounds that each leftover misses, and how many miss each; one that misses several counts in each.
#[derive(Debug, Default)]
pub struct MissedBounds {
    /// For each leftover of the report, in order.
    pub by_leftover: Vec<Missed>,
    /// Triangles with an angle below the bound.
    pub angle: usize,
    /// Triangles above an area bound: that of all triangles, or one of their own.
    pub area: usize,
    /// Triangles above the bound on the aspect ratio.
    pub aspect_ratio: usize,
}

impl MissedBounds {
    /// The bounds that the leftovers of a report miss. A leftover that meets every bound for all triangles misses the
    /// area bound of its region.
    pub fn of(mesh: &IndexedMesh, report: &Report, criteria: &Criteria) -> Self {
        let mut all = Self::default();
        for leftover in &report.leftovers {
            let found = corners(mesh, leftover.triangle).map(|t| criteria.missed_by(&t)).unwrap_or_default();
            let missed = if found == Missed::default() { Missed { area: true, ..found } } else { found };
            all.angle += usize::from(missed.angle);
            all.area += usize::from(missed.area);
            all.aspect_ratio += usize::from(missed.aspect_ratio);
            all.by_leftover.push(missed);
        }
        all
    }

    /// The bounds by name, and how many triangles miss each.
    pub fn counts(&self) -> [(&'static str, usize); 3] {
        [("angle", self.angle), ("area", self.area), ("aspect ratio", self.aspect_ratio)]
    }
}

/// The corners of a triangle, if all are there.
pub fn corners(mesh: &IndexedMesh, triangle: usize) -> Option<Triangle> {
    let point = |v: u32| -> Option<Point> { mesh.points.get(v as usize).copied() };
    let [a, b, c] = *mesh.triangles.get(triangle)?;
    Some(Triangle::new(point(a)?, point(b)?, point(c)?))
}
