//! The smallest angle of each triangle and its class of five degrees.

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::{Point, math};

use super::frame::Frame;

/// Classes of five degrees up to 60.
pub(crate) const CLASSES: usize = 12;
pub(crate) const CLASS_DEG: f64 = 5.0;

/// The triangles by class.
#[derive(Debug)]
pub(crate) struct Histogram {
    pub(crate) counts: [usize; CLASSES],
    /// Class of each triangle.
    pub(crate) class_of: Vec<u8>,
    /// The smallest angle of all triangles.
    pub(crate) smallest_deg: Option<f64>,
}

impl Histogram {
    /// Sorts the triangles of a mesh, whose indices are in range, into classes.
    pub(crate) fn of(mesh: &IndexedMesh, frame: &Frame) -> Self {
        let mut histogram =
            Self { counts: [0; CLASSES], class_of: Vec::with_capacity(mesh.triangles.len()), smallest_deg: None };
        for triangle in &mesh.triangles {
            let angle_deg = smallest_angle_deg(triangle.map(|v| frame.scaled(mesh.points[v as usize])));
            let class = ((angle_deg / CLASS_DEG) as usize).min(CLASSES - 1);
            histogram.counts[class] += 1;
            histogram.class_of.push(class as u8);
            histogram.smallest_deg = Some(histogram.smallest_deg.map_or(angle_deg, |least| least.min(angle_deg)));
        }
        histogram
    }
}

/// The angle opposite the shortest side, good enough to colour by; 0 where the triangle is a point.
///
/// Sides are divided by the largest component, so that products neither overflow nor vanish.
fn smallest_angle_deg([a, b, c]: [Point; 3]) -> f64 {
    let side = |p: Point, q: Point| (q.x - p.x, q.y - p.y);
    let sides = [side(b, c), side(c, a), side(a, b)];
    let size = sides.iter().fold(0.0_f64, |size, (x, y)| size.max(x.abs()).max(y.abs()));
    if size == 0.0 {
        return 0.0;
    }
    let sides = sides.map(|(x, y)| (x / size, y / size));
    let length_sq = sides.map(|(x, y)| x * x + y * y);
    let shortest = (0..3).fold(0, |best, i| if length_sq[i] < length_sq[best] { i } else { best });
    let (u, v) = (sides[(shortest + 1) % 3], sides[(shortest + 2) % 3]);
    let cross = u.0 * v.1 - u.1 * v.0;
    // The two other sides run head to tail through the corner, hence the sign.
    let dot = -(u.0 * v.0 + u.1 * v.1);
    math::atan2(cross.abs(), dot).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_angles() {
        for (corners, expected_deg) in [
            ([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], 45.0),
            ([(0.0, 0.0), (0.0, 2e200), (1e200, 0.0)], 26.565_051_177_077_99),
            ([(0.0, 0.0), (2.0, 0.0), (1.0, 3.0_f64.sqrt())], 60.0),
            ([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)], 0.0),
            ([(3.0, 1.0), (3.0, 1.0), (3.0, 1.0)], 0.0),
        ] {
            let angle_deg = smallest_angle_deg(corners.map(|(x, y)| Point::new(x, y)));
            assert!((angle_deg - expected_deg).abs() < 1e-9, "{corners:?}: {angle_deg}");
        }
    }
}
