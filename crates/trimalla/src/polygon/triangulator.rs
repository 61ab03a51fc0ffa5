//! Many polygons, one after the other.

use super::constrained_delaunay::Flips;
use super::corners::Corners;
use super::few::Few;
use super::lone_points::LonePoints;
use super::proving_ears::ProvingEars;
use super::stack::{Stacks, Triangles};
use super::sweep::Sweep;
use super::{Polygon, PolygonError, easy, monotone};
use crate::geometry::Point;
use crate::trace::NoTrace;

/// Triangulates polygons, and keeps its memory from one to the next: the fastest way for any polygon, small or large.
///
/// # Guarantees
/// Exact, for every polygon: triangles are given only if the polygon is proved valid, as
/// [`monotone`](super::monotone()) proves it, and they are counter-clockwise, do not overlap, and cover the polygon.
/// Which triangles they are may change between releases. The same polygon gives the same triangles, whatever came
/// before.
///
/// # How
/// 1. Three or four corners: the signs of two triangles decide.
/// 2. One ring that is convex, or monotone along x or y, or all of which its middle sees: linear time proves it simple
///    (`easy.rs`).
/// 3. One ring of few corners, if it is not monotone along x: ears that prove it simple while they are cut off
///    (`proving_ears.rs`).
/// 4. All others: the sweep of [`monotone`](super::monotone()).
///
/// # Complexity
/// O(n log n).
///
/// # Source
/// `[GareyEtAl78]`
///
/// ```
/// use trimalla::geometry::Point;
/// use trimalla::polygon::{Polygon, Triangulator};
///
/// let mut triangulator = Triangulator::new();
/// for size in [1.0, 2.0, 3.0] {
///     let arrow = [[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]].map(|[x, y]| Point::new(size * x, size * y));
///     assert_eq!(triangulator.triangulate(Polygon::new(&arrow, &[4])?)?, [[1, 2, 3], [1, 3, 0]]);
/// }
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Triangulator {
    few: Few,
    proving: ProvingEars,
    left: Vec<(Point, u32)>,
    corners: Corners,
    sweep: Sweep,
    stacks: Stacks,
    triangles: Vec<[u32; 3]>,
    flips: Flips,
}

impl Triangulator {
    /// A triangulator that has no memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Triangulates a polygon with holes.
    ///
    /// # Shape
    /// Counter-clockwise triangles of indices into [`Polygon::points`], until the next call;
    /// `n - 2 + 2h` of them for `n` corners and `h` holes, if no rings touch and no point repeats the one before. A
    /// hole of one point is a corner of triangles.
    ///
    /// # Errors
    /// Flat rings, sides that cross or overlap, holes outside the outline.
    pub fn triangulate(&mut self, polygon: Polygon<'_>) -> Result<&[[u32; 3]], PolygonError> {
        self.triangles.clear();
        let mut rings = polygon.rings();
        let easy = match (rings.next(), rings.next()) {
            (Some(ring), None) => self.one_ring(&polygon.points()[ring.clone()], ring.start as u32),
            _ => false,
        };
        if !easy {
            self.triangles.clear();
            match self.by_sweep(polygon) {
                Err(PolygonError::Flat { .. }) => self.with_lone_points(polygon)?,
                other => other?,
            }
        }
        Ok(&self.triangles)
    }

    /// Triangulates a polygon with holes, constrained Delaunay: no vertex that a triangle sees lies in its circle.
    ///
    /// # Shape
    /// See [`triangulate`](Self::triangulate).
    ///
    /// # Guarantees
    /// The triangles are those of [`constrained_delaunay`](super::constrained_delaunay()), in another order.
    ///
    /// # Errors
    /// See [`triangulate`](Self::triangulate).
    ///
    /// # Complexity
    /// O(n²) flips at worst, few in practice.
    pub fn triangulate_delaunay(&mut self, polygon: Polygon<'_>) -> Result<&[[u32; 3]], PolygonError> {
        self.triangulate(polygon)?;
        self.flips.legalise(polygon.points(), &mut self.triangles, &mut NoTrace)?;
        Ok(&self.triangles)
    }

    /// Triangulates a ring in a way that is faster than the sweep, if there is one.
    #[inline]
    fn one_ring(&mut self, mut ring: &[Point], first: u32) -> bool {
        if let [rest @ .., last] = ring {
            if rest.first() == Some(last) {
                ring = rest;
            }
        }
        if ring.len() < 5 {
            return Few::triangulate(ring, first, &mut self.triangles);
        }
        if ring.len() <= ProvingEars::MOST_AT_ONCE {
            return (ring.len() >= ProvingEars::FEWEST_IF_CONVEX
                && easy::convex_ring(ring, first, &mut self.triangles))
                || self.along_x(ring, first)
                || self.proving.triangulate(ring, first, &mut self.triangles);
        }
        easy::convex_ring(ring, first, &mut self.triangles)
            || self.along_x(ring, first)
            || self.along_y(ring, first)
            || easy::star_ring(ring, first, &mut self.left, &mut self.few, &mut self.triangles)
            || (ring.len() <= ProvingEars::MOST && self.proving.triangulate(ring, first, &mut self.triangles))
    }

    /// Triangulates a ring that is monotone along x.
    fn along_x(&mut self, ring: &[Point], first: u32) -> bool {
        self.along(ring.len(), first, |i| ring[i])
    }

    /// Triangulates a ring that is monotone along y: turned by a right angle, which changes no sign.
    fn along_y(&mut self, ring: &[Point], first: u32) -> bool {
        self.along(ring.len(), first, |i| Point::new(ring[i].y, -ring[i].x))
    }

    #[inline]
    fn along(&mut self, count: usize, first: u32, at: impl Fn(usize) -> Point) -> bool {
        let nobody = &mut NoTrace;
        let mut pieces = Triangles::new(&mut self.stacks, &mut self.triangles, nobody);
        let done = easy::monotone_ring(count, first, at, &mut pieces);
        if !done {
            self.triangles.clear();
        }
        done
    }

    /// Triangulates a polygon with a flat ring, which may be a hole of one point.
    #[cold]
    fn with_lone_points(&mut self, polygon: Polygon<'_>) -> Result<(), PolygonError> {
        let apart = LonePoints::of(polygon);
        self.triangles = match apart {
            Some(apart) => apart.triangulate(polygon, &mut NoTrace, |rings, trace| monotone(rings, trace))?,
            None => monotone(polygon, &mut NoTrace)?,
        };
        Ok(())
    }

    fn by_sweep(&mut self, polygon: Polygon<'_>) -> Result<(), PolygonError> {
        self.corners.fill(polygon)?;
        self.triangles.reserve(self.corners.count + 2 * self.corners.ring_count);
        self.sweep.run(&mut self.corners, &mut Triangles::new(&mut self.stacks, &mut self.triangles, &mut NoTrace))
    }
}
