//! What is triangulated, what comes out, and the first look at the input that all algorithms share.

use super::OptimalError;
use crate::delaunay::AlgorithmKey;
use crate::drawing::{IndexedMesh, Side, Sides};
use crate::geometry::{Orientation, Point, lexicographic, orient2d};
use crate::triangulation::check_mesh;

/// What is triangulated.
///
/// # Shape
/// `heights`, if any, has one number a point. `domain`, if any, has the same points; its triangles say which part
/// of the plane is triangulated. Points that are no corner of the domain are left out.
#[derive(Clone, Copy, Debug)]
pub struct OptimalInput<'a> {
    /// The points.
    pub points: &'a [Point],
    /// A height for each point, for criteria of surfaces.
    pub heights: Option<&'a [f64]>,
    /// Triangles of the domain whose boundary must be kept; `None`: the convex hull of the points.
    pub domain: Option<&'a IndexedMesh>,
}

/// A triangulation and what it attains.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Optimal {
    /// Counter-clockwise triangles by indices into the points, each from its smallest index on, sorted.
    pub triangles: Vec<[u32; 3]>,
    /// Whether no triangulation is better by the criterion of the algorithm.
    pub is_proved: bool,
    /// The value of the criterion, rounded. For `pairs`, greedy algorithms and
    /// `flip-shortest-diagonal`: the sum of the lengths of the edges; for the other flips an angle in radians.
    pub value: f64,
}

impl<'a> OptimalInput<'a> {
    /// The convex hull of points is triangulated.
    #[must_use]
    pub const fn of_points(points: &'a [Point]) -> Self {
        Self { points, heights: None, domain: None }
    }

    /// Checks numbers, lengths and the domain.
    ///
    /// # Errors
    /// [`OptimalError`] names the first thing that is wrong.
    ///
    /// # Complexity
    /// O(n log n).
    pub(crate) fn check(&self) -> Result<(), OptimalError> {
        self.check_numbers()?;
        let Some(domain) = self.domain else { return Ok(()) };
        if domain.points != self.points {
            return Err(OptimalError::OtherPoints { count: domain.points.len(), expected: self.points.len() });
        }
        let faults = check_mesh(domain);
        if !faults.is_empty() {
            return Err(OptimalError::Domain(faults));
        }
        Ok(())
    }

    /// Checks the input, and finds the vertices and the edges that must be kept.
    ///
    /// # Errors
    /// See [`OptimalError`].
    ///
    /// # Complexity
    /// O(n log n).
    pub(crate) fn prepare(&self) -> Result<Prepared, OptimalError> {
        self.check()?;
        let Some(domain) = self.domain else {
            return Ok(Prepared {
                vertices: distinct(self.points),
                boundary: Vec::new(),
                segments: Vec::new(),
                sides: None,
            });
        };
        let sides = Sides::of(domain);
        let vertices = (0..self.points.len() as u32).filter(|&v| sides.is_used(v)).collect();
        let boundary = sides.boundary().map(|s| [s.origin, s.dest]).collect();
        let is_inside = |&[a, b]: &[u32; 2]| sides.find(a, b).is_some() && sides.find(b, a).is_some();
        let segments = domain.segments.iter().copied().filter(is_inside).collect();
        Ok(Prepared { vertices, boundary, segments, sides: Some(sides) })
    }

    /// Triangles to begin with: those of the domain, or the Delaunay triangulation.
    ///
    /// # Errors
    /// See [`OptimalError`].
    ///
    /// # Complexity
    /// O(n log n).
    pub(crate) fn start(&self) -> Result<Vec<[u32; 3]>, OptimalError> {
        self.check()?;
        if let Some(domain) = self.domain {
            return Ok(domain.triangles.clone());
        }
        let too_many = |_| OptimalError::TooMany { count: self.points.len(), limit: MOST_POINTS };
        let delaunay = AlgorithmKey::Incremental.triangulate(self.points, None).map_err(too_many)?;
        Ok(delaunay.canonical().into_iter().map(|t| t.map(|v| v.0)).collect())
    }

    fn check_numbers(&self) -> Result<(), OptimalError> {
        let (points, heights) = (self.points, self.heights);
        if points.len() > MOST_POINTS {
            return Err(OptimalError::TooMany { count: points.len(), limit: MOST_POINTS });
        }
        if let Some(heights) = heights.filter(|heights| heights.len() != points.len()) {
            return Err(OptimalError::HeightCount { heights: heights.len(), points: points.len() });
        }
        let is_finite = |i: usize| points[i].is_finite() && heights.is_none_or(|heights| heights[i].is_finite());
        match (0..points.len()).find(|&i| !is_finite(i)) {
            Some(i) => Err(OptimalError::NotFinite { index: i as u32, point: points[i] }),
            None => Ok(()),
        }
    }
}

/// The vertices and the fixed edges of an input.
#[derive(Clone, Debug)]
pub(crate) struct Prepared {
    /// The vertices: distinct places, by index.
    pub(crate) vertices: Vec<u32>,
    /// The boundary of the domain, which lies to the left of each edge; empty without a domain.
    pub(crate) boundary: Vec<[u32; 2]>,
    /// The constrained edges inside of the domain.
    pub(crate) segments: Vec<[u32; 2]>,
    /// The sides of the triangles of the domain.
    sides: Option<Sides>,
}

impl Prepared {
    /// The edges that must be kept: the boundary of the domain, and its segments.
    pub(crate) fn fixed(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.boundary.iter().chain(&self.segments).copied()
    }

    /// Whether the way from vertex `u` to vertex `v` starts inside the domain, or along one of its edges with the
    /// domain to the left; always, without a domain.
    ///
    /// A segment that crosses no boundary edge and passes through no vertex then lies in the domain.
    ///
    /// # Complexity
    /// Linear in the domain's triangles at `u`.
    pub(crate) fn starts_inside(&self, points: &[Point], u: u32, v: u32) -> bool {
        let Some(sides) = &self.sides else { return true };
        let [p, to] = [u, v].map(|v| points[v as usize]);
        sides.from(u).iter().any(|&Side { dest, apex, .. }| {
            let [first, last] = [dest, apex].map(|v| points[v as usize]);
            orient2d(p, first, to) != Orientation::Clockwise && orient2d(p, to, last) == Orientation::CounterClockwise
        })
    }
}

/// The points of distinct places: of equal points the first one, by index.
pub(crate) fn distinct(points: &[Point]) -> Vec<u32> {
    let at = |v: u32| points[v as usize];
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_unstable_by(|&a, &b| lexicographic(at(a), at(b)).then(a.cmp(&b)));
    order.dedup_by(|b, a| at(*a) == at(*b));
    order.sort_unstable();
    order
}

/// The most points that half-edges can name.
const MOST_POINTS: usize = (u32::MAX / 8) as usize;

/// Triangles in the order of [`Optimal::triangles`].
pub(crate) fn in_order(mut triangles: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    for t in &mut triangles {
        let first = (0..3).min_by_key(|&k| t[k]).unwrap_or(0);
        t.rotate_left(first);
    }
    triangles.sort_unstable();
    triangles
}
