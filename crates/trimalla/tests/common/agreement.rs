//! All algorithms agree on points, and the checker agrees with them.
#![allow(dead_code, reason = "every test uses a part of it")]

use trimalla::delaunay::AlgorithmKey;
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;
use trimalla::triangulation::Triangulation;

use super::alike::alike;
use super::verdict::none;

/// Every algorithm gives the same triangles, edges, duplicates and dimension, and a clean check.
pub(crate) fn agreed(points: &[Point]) -> Result<Triangulation, String> {
    let mut all = algorithms(points.len()).map(|key| checked(key, points));
    let first = all.next().ok_or("there are no algorithms")??;
    for other in all {
        alike(&first, &other?)?;
    }
    Ok(first)
}

/// The algorithms to be tried with so many points: all, but `flip`, which is quadratic, for few only.
pub(crate) fn algorithms(points: usize) -> impl Iterator<Item = AlgorithmKey> {
    AlgorithmKey::ALL.into_iter().filter(move |key| *key != AlgorithmKey::Flip || points <= 2000)
}

/// What one algorithm builds, checked by itself.
fn checked(key: AlgorithmKey, points: &[Point]) -> Result<Triangulation, String> {
    let built = key.triangulate(points, None).map_err(|e| e.to_string())?;
    none(key.key(), &built.check_delaunay())?;
    Ok(built)
}

/// The triangles with other names for the vertices, in canonical form.
pub(crate) fn renamed(triangles: &[[VertexId; 3]], name: impl Fn(VertexId) -> u32) -> Vec<[u32; 3]> {
    let named: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(&name)).collect();
    trimalla_testkit::oracles::canonical(&named)
}
