//! Any triangulation of what is to be triangulated: it tells the boundary, and what is seen from where.

use crate::delaunay::{BuildError, Delaunay};
use crate::drawing::IndexedMesh;
use crate::geometry::Point;
use crate::optimal::{OptimalError, OptimalInput};

/// No triangle.
pub(super) const NONE: u32 = u32::MAX;

/// Triangles with their neighbours.
#[derive(Clone, Debug)]
pub(super) struct Base<'a> {
    pub(super) points: &'a [Point],
    /// Counter-clockwise.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The triangle opposite each corner, or [`NONE`].
    pub(super) across: Vec<[u32; 3]>,
    /// Whether the triangles fill a convex hull.
    pub(super) is_hull: bool,
    /// Where the triangles of each vertex begin in `around`.
    first: Vec<u32>,
    around: Vec<u32>,
}

impl<'a> Base<'a> {
    /// The Delaunay triangulation of the points, or the given triangles of the domain.
    pub(super) fn new(input: &OptimalInput<'a>) -> Result<Self, OptimalError> {
        let points = input.points;
        let triangles = match input.domain {
            Some(domain) => domain.triangles.clone(),
            None => delaunay(points)?,
        };
        let mesh = IndexedMesh { points: points.to_vec(), triangles, ..IndexedMesh::default() };
        Ok(Self::with_neighbours(points, mesh, input.domain.is_none()))
    }

    fn with_neighbours(points: &'a [Point], mesh: IndexedMesh, is_hull: bool) -> Self {
        let neighbours = mesh.neighbours();
        let across = neighbours.into_iter().map(|three| three.map(|other| other.unwrap_or(NONE))).collect();
        let triangles = mesh.triangles;
        let mut first = vec![0; points.len() + 1];
        for &v in triangles.as_flattened() {
            first[v as usize + 1] += 1;
        }
        for v in 0..points.len() {
            first[v + 1] += first[v];
        }
        let mut next = first.clone();
        let mut around = vec![0; 3 * triangles.len()];
        for (t, corners) in (0..).zip(&triangles) {
            for &v in corners {
                around[next[v as usize] as usize] = t;
                next[v as usize] += 1;
            }
        }
        Self { points, triangles, across, is_hull, first, around }
    }

    /// The triangles at a vertex, each with its corner there.
    pub(super) fn around(&self, v: u32) -> impl Iterator<Item = (u32, usize)> + '_ {
        let range = self.first[v as usize] as usize..self.first[v as usize + 1] as usize;
        let corner = move |t: u32| self.triangles[t as usize].iter().position(|&u| u == v).unwrap_or(0);
        self.around[range].iter().map(move |&t| (t, corner(t)))
    }

    /// The boundary edges, each with the inside to its left.
    pub(super) fn boundary(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let sides = |(corners, across): (&[u32; 3], &[u32; 3])| {
            let (c, across) = (*corners, *across);
            (0..3).filter(move |&i| across[i] == NONE).map(move |i| [c[(i + 1) % 3], c[(i + 2) % 3]])
        };
        self.triangles.iter().zip(&self.across).flat_map(sides)
    }
}

fn delaunay(points: &[Point]) -> Result<Vec<[u32; 3]>, OptimalError> {
    let made = Delaunay::new(points).map_err(|error| match error {
        BuildError::NotFinite { index, point } => OptimalError::NotFinite { index: index as u32, point },
        _ => OptimalError::TooMany { count: points.len(), limit: BuildError::MAX_POINTS },
    })?;
    Ok(made.real_faces().map(|f| made.face_vertices(f).map(|v| v.0)).collect())
}
