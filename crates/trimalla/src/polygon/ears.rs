//! Ears cut off one after the other.

use super::{Polygon, PolygonError};
use crate::geometry::{Orientation, Point, ccw, left_on};
use crate::trace::{Shape, Trace};

/// Triangulates a polygon by cutting off ears.
///
/// # Errors
/// Holes; a ring without area; a polygon that has no ear left because its sides cross.
pub fn ears(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
    let method = "ears";
    let mut rings = polygon.rings();
    let Some(outline) = rings.next() else { return Ok(Vec::new()) };
    if rings.len() > 0 {
        return Err(PolygonError::Holes { method, holes: rings.len() });
    }
    let points = polygon.points();
    let flat = PolygonError::Flat { ring: 0, first: outline.start as u32 };
    let mut corners: Vec<u32> = outline.clone().map(|v| v as u32).collect();
    match polygon.ring(outline).orientation() {
        Orientation::CounterClockwise => {}
        Orientation::Clockwise => corners.reverse(),
        Orientation::Collinear => return Err(flat),
    }
    corners.dedup_by_key(|&mut v| points[v as usize]);
    while corners.len() > 1 && points[corners[0] as usize] == points[corners[corners.len() - 1] as usize] {
        corners.pop();
    }
    let mut triangles = Vec::with_capacity(corners.len().saturating_sub(2));
    while corners.len() > 2 {
        if trace.is_cancelled() {
            return Err(PolygonError::Cancelled);
        }
        let n = corners.len();
        let triple = |i: usize| [corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]];
        let Some(i) = (0..n).find(|&i| is_ear(points, &corners, triple(i))) else { return Err(flat) };
        trace.add(Shape::Triangle(triple(i)), "an ear is cut off");
        triangles.push(triple(i));
        corners.remove(i);
    }
    Ok(triangles)
}

/// Whether three successive corners turn left, and no other corner is in their triangle.
fn is_ear(points: &[Point], corners: &[u32], triple: [u32; 3]) -> bool {
    let [a, b, c] = triple.map(|v| points[v as usize]);
    let inside = |p: Point| left_on(a, b, p) && left_on(b, c, p) && left_on(c, a, p);
    ccw(a, b, c) && !corners.iter().map(|&v| points[v as usize]).any(|p| p != a && p != b && p != c && inside(p))
}
