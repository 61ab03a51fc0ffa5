//! Meshes whose coordinates are numbers of 32 bits, with every triangle still counter-clockwise.
//!
//! Rounding moves a vertex by up to half of the distance between two such numbers, and may turn a thin triangle over.
//! The exact test of the rounded corners says which. There a corner goes to one of the eight places beside it at which
//! no triangle around it is turned over that was not before; if that does not help everywhere, the mesh is refused.

use std::io;

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::{Orientation, Point, orient2d};

use crate::columns::{check_triangles, invalid};

/// How exact coordinates are in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Precision {
    /// As they are.
    #[default]
    Double,
    /// Rounded to 32 bits; triangles stay counter-clockwise.
    Single,
}

/// How often the triangles that are turned over are gone through.
const ROUNDS: usize = 16;

/// The mesh with coordinates of 32 bits, every triangle of which is counter-clockwise if it was.
///
/// # Errors
/// Kind `InvalidInput` where an index has no vertex, a coordinate is beyond the range of 32 bits, or a triangle cannot
/// be kept from being turned over; the message has its number and corners.
///
/// # Complexity
/// Linear, and for each triangle that is turned over at most 16 times 24 times the degree of its corners.
pub(crate) fn rounded(mesh: &IndexedMesh) -> io::Result<IndexedMesh> {
    check_triangles(mesh)?;
    let mut points = Vec::with_capacity(mesh.points.len());
    for (i, p) in mesh.points.iter().enumerate() {
        let near = Point::new(f64::from(p.x as f32), f64::from(p.y as f32));
        if !near.is_finite() {
            return Err(invalid(format!("vertex {i} at {p} is beyond the range of numbers of 32 bits")));
        }
        points.push(near);
    }
    // What was no triangle before is none of our concern.
    let triangles: Vec<[u32; 3]> = mesh.triangles.iter().copied().filter(|t| is_positive(&mesh.points, t)).collect();
    let mut bad: Vec<usize> = (0..triangles.len()).filter(|&t| !is_positive(&points, &triangles[t])).collect();
    if !bad.is_empty() {
        let around = Around::of(&triangles, points.len());
        for _ in 0..ROUNDS {
            bad.retain(|&t| !is_positive(&points, &triangles[t]) && !around.mend(&mut points, &triangles, t));
            if bad.is_empty() {
                break;
            }
        }
    }
    match triangles.iter().find(|t| !is_positive(&points, t)) {
        None => Ok(IndexedMesh { points, ..mesh.clone() }),
        Some(turned) => {
            let number = mesh.triangles.iter().position(|t| t == turned).unwrap_or(0);
            let [a, b, c] = turned.map(|v| mesh.points[v as usize]);
            Err(invalid(format!("triangle {number} with the corners {a}, {b}, {c} is too thin for numbers of 32 bits")))
        }
    }
}

fn is_positive(points: &[Point], triangle: &[u32; 3]) -> bool {
    let [a, b, c] = triangle.map(|v| points[v as usize]);
    orient2d(a, b, c) == Orientation::CounterClockwise
}

/// The triangles around each vertex.
struct Around {
    begin: Vec<usize>,
    triangles: Vec<usize>,
}

impl Around {
    fn of(triangles: &[[u32; 3]], vertices: usize) -> Self {
        let mut begin = vec![0; vertices + 1];
        triangles.iter().flatten().for_each(|&v| begin[v as usize + 1] += 1);
        for v in 0..vertices {
            begin[v + 1] += begin[v];
        }
        let mut next = begin.clone();
        let mut around = vec![0; 3 * triangles.len()];
        for (t, corners) in triangles.iter().enumerate() {
            for &v in corners {
                around[next[v as usize]] = t;
                next[v as usize] += 1;
            }
        }
        Self { begin, triangles: around }
    }

    /// How many triangles around a vertex are turned over.
    fn turned(&self, points: &[Point], triangles: &[[u32; 3]], v: u32) -> usize {
        let around = &self.triangles[self.begin[v as usize]..self.begin[v as usize + 1]];
        around.iter().filter(|&&t| !is_positive(points, &triangles[t])).count()
    }

    /// Moves a corner of a triangle to a place beside it if that leaves fewer triangles turned over; whether this one
    /// no longer is.
    fn mend(&self, points: &mut [Point], triangles: &[[u32; 3]], t: usize) -> bool {
        for v in triangles[t] {
            let (old, before) = (points[v as usize], self.turned(points, triangles, v));
            let mut best = (before, old);
            for place in beside(old) {
                points[v as usize] = place;
                let turned = self.turned(points, triangles, v);
                if turned < best.0 {
                    best = (turned, place);
                }
            }
            points[v as usize] = best.1;
            if is_positive(points, &triangles[t]) {
                return true;
            }
        }
        false
    }
}

/// The eight places around a point whose coordinates are the next numbers of 32 bits.
fn beside(p: Point) -> impl Iterator<Item = Point> {
    let near = |x: f64| {
        let x = x as f32;
        [x, -next_up(-x), next_up(x)].map(f64::from)
    };
    let (xs, ys) = (near(p.x), near(p.y));
    let places = (1..9).map(move |i| Point::new(xs[i % 3], ys[i / 3]));
    places.filter(|place| place.is_finite())
}

/// The next number of 32 bits above.
fn next_up(x: f32) -> f32 {
    if x == 0.0 {
        return f32::from_bits(1);
    }
    let bits = x.to_bits();
    f32::from_bits(if x > 0.0 { bits + 1 } else { bits - 1 })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(points: &[[f64; 2]], triangles: &[[u32; 3]]) -> IndexedMesh {
        let points: Vec<Point> = points.iter().copied().map(Point::from).collect();
        IndexedMesh { points, triangles: triangles.to_vec(), ..IndexedMesh::default() }
    }

    #[test]
    fn a_thin_triangle_is_kept_from_being_turned_over() {
        // Rounded to the nearest, the third corner is on the other side of the first edge, or on it.
        let one = 1.0 + 1e-9;
        let thin = mesh(&[[1.0, 1.0], [3.0, 3.0], [2.0, 2.0 + 1e-9], [one, 5.0]], &[[0, 1, 2], [0, 2, 3]]);
        assert!(thin.triangles.iter().all(|t| is_positive(&thin.points, t)), "positive before");
        let single = rounded(&thin).unwrap();
        assert!(single.triangles.iter().all(|t| is_positive(&single.points, t)), "{:?}", single.points);
        for (p, q) in thin.points.iter().zip(&single.points) {
            assert!((p.x - q.x).abs() < 1e-6 && (p.y - q.y).abs() < 1e-6, "{p} {q}");
            assert_eq!((f64::from(q.x as f32), f64::from(q.y as f32)), (q.x, q.y));
        }
    }

    #[test]
    fn what_does_not_fit_is_named() {
        let far = mesh(&[[1e39, 0.0]], &[]);
        assert!(rounded(&far).unwrap_err().to_string().starts_with("vertex 0 at"));
        // Three corners within a fraction of the distance between two such numbers.
        let tiny = mesh(&[[1e9, 0.0], [1e9 + 1e-6, 0.0], [1e9, 1e-46]], &[[0, 1, 2]]);
        assert!(rounded(&tiny).unwrap_err().to_string().contains("triangle 0 with the corners"), "all at one place");
    }
}
