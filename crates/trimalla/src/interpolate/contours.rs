//! Contours: lines of equal height on a terrain.
//!
//! ```text
//!          b  110            level 100: a and c are below it, b is not.
//!         / \                The contour crosses ab and bc; the higher ground is on its left.
//!     ◄──/───\──◄
//!       /     \
//!   90 a ───── c 95
//! ```
//!
//! *The rule.* A vertex at the height of the level counts as above it. So each triangle has two corners on one side and
//! one on the other, or all on one side: the contour passes through it from one edge to another, or not at all. Hence
//! every contour is closed or ends at the boundary, on any heights, also where several vertices have the height of the
//! level and where a triangle is level.
//!
//! 1. For each level the edges are found that it crosses, with the higher end behind: at such an edge a contour enters
//!    a triangle.
//! 2. Contours that begin at the boundary are followed from there, triangle by triangle, until they leave.
//! 3. What is left are closed ones: they are followed until they come back.
//!
//! The point on an edge is computed from the lower end to the higher one, so that both triangles have the same. Points
//! that are equal are given once in a row. A contour of one point is left out: it is that of a summit, whose neighbours
//! are all below, at exactly the level.
//!
//! # Complexity
//! Linear in the edges and in the points of contours; n log n in the levels.
//!
//! # Source
//! `[Triangulaciones]` has the heights; the rule is ours.

use super::error::InterpolateError;
use super::surface::Surface;
use crate::geometry::{Point, lexicographic};
use crate::half_edge::{HalfEdgeId, VertexId};
use crate::trace::{NoTrace, Shape, Trace};

/// At which heights contours are drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// At these.
    At(Vec<f64>),
    /// At every multiple of a step between the lowest and the highest vertex.
    Every(f64),
}

impl Levels {
    /// The most levels that a step may give.
    pub const MAX_LEVELS: usize = 100_000;

    /// The levels of a surface, ascending, each once.
    fn of(&self, surface: &Surface<'_>) -> Result<Vec<f64>, InterpolateError> {
        let mut levels = match self {
            Self::At(levels) => levels.clone(),
            Self::Every(step) => match surface.range() {
                Some(range) => multiples(*step, range)?,
                None => Vec::new(),
            },
        };
        if let Some(&level) = levels.iter().find(|level| !level.is_finite()) {
            return Err(InterpolateError::Level(level));
        }
        levels.sort_by(f64::total_cmp);
        levels.dedup(); // As numbers: −0 is 0.
        Ok(levels)
    }
}

/// The multiples of a step in a range.
fn multiples(step: f64, [low, high]: [f64; 2]) -> Result<Vec<f64>, InterpolateError> {
    if !(step > 0.0 && step.is_finite()) {
        return Err(InterpolateError::Step(step));
    }
    let (first, last) = ((low / step).ceil(), (high / step).floor());
    let limit = Levels::MAX_LEVELS;
    // Below 2⁵³, where whole numbers are exact and differ.
    let is_exact = first.abs().max(last.abs()) < 9_007_199_254_740_992.0;
    if !is_exact || last - first >= limit as f64 {
        return Err(InterpolateError::TooManyLevels { step, low, high, limit });
    }
    let count = (last - first + 1.0).max(0.0) as usize;
    Ok((0..count).map(|i| (first + i as f64) * step).collect())
}

/// A line of equal height.
#[doc(alias = "isoline")]
#[doc(alias = "curva de nivel")]
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// The height.
    pub level: f64,
    /// Its points, rounded; of a closed contour the first is not repeated. The higher ground is on the left.
    pub points: Vec<Point>,
    /// Whether it comes back to its first point; else it ends at the boundary.
    pub is_closed: bool,
}

/// Contours.
impl Surface<'_> {
    /// The contours at some levels, the lowest level first; of a level first those that end at the boundary.
    ///
    /// # Guarantees
    /// Which edges a contour crosses is exact. Every contour is closed or ends at the boundary at both ends, and no two
    /// of one level cross. Each point lies between the ends of an edge, coordinate by coordinate.
    ///
    /// # Errors
    /// [`InterpolateError::Level`], [`InterpolateError::Step`], [`InterpolateError::TooManyLevels`].
    ///
    /// # Examples
    /// ```
    /// use trimalla::delaunay::Delaunay;
    /// use trimalla::geometry::Point;
    /// use trimalla::interpolate::{Levels, Surface};
    ///
    /// let pyramid = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 2.0]].map(Point::from);
    /// let delaunay = Delaunay::new(&pyramid)?;
    /// let contours = Surface::new(&delaunay, &[0.0, 0.0, 0.0, 0.0, 8.0])?.contours(&Levels::Every(4.0))?;
    /// // At 0 the base, all of which counts as above; at 8 the summit alone: neither is a line.
    /// let [middle] = &contours[..] else { panic!("{contours:?}") };
    /// assert!(middle.is_closed && middle.level == 4.0 && middle.points.len() == 4);
    /// # Ok::<(), trimalla::interpolate::InterpolateError>(())
    /// ```
    pub fn contours(&self, levels: &Levels) -> Result<Vec<Contour>, InterpolateError> {
        self.contours_with_trace(levels, &mut NoTrace)
    }

    /// The contours at some levels, step by step.
    ///
    /// # Errors
    /// Those of [`contours`](Self::contours), and [`InterpolateError::Cancelled`].
    pub fn contours_with_trace(
        &self,
        levels: &Levels,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Vec<Contour>, InterpolateError> {
        let levels = levels.of(self)?;
        let t = self.triangulation();
        // Step 1: the half-edges of real faces by which each level enters them. A stable sort by level keeps their
        // order.
        let below = |v: usize| levels.partition_point(|level| *level <= self.height(VertexId::from_index(v))) as u32;
        let below: Vec<u32> = (0..t.points().len()).map(below).collect();
        let mut entries: Vec<(u32, HalfEdgeId)> = Vec::new();
        for h in t.real_faces().flat_map(|f| f.half_edges()) {
            let levels = below[t.dest(h).index()]..below[t.origin(h).index()];
            entries.extend(levels.map(|level| (level, h)));
        }
        entries.sort_by_key(|&(level, _)| level);
        let mut contours = Vec::new();
        // For each half-edge one more than the level that came by last.
        let mut passed = vec![0; 3 * t.face_slots()];
        for of_level in entries.chunk_by(|a, b| a.0 == b.0) {
            let (at, level) = (of_level[0].0, levels[of_level[0].0 as usize]);
            let is_open = |h: HalfEdgeId| t.is_ghost(t.twin(h).face());
            let open = of_level.iter().filter(|(_, h)| is_open(*h));
            // Steps 2 and 3.
            for &(_, h) in open.chain(of_level) {
                if trace.is_cancelled() {
                    return Err(InterpolateError::Cancelled);
                }
                if passed[h.index()] != at + 1 {
                    let contour = self.follow(h, level, at + 1, &mut passed);
                    for contour in contour.into_iter().filter(|c| c.points.len() > 1) {
                        let sides = contour.points.windows(2);
                        sides.for_each(|ends| trace.add(Shape::Line([ends[0], ends[1]]), "a part of a contour"));
                        contours.push(contour);
                    }
                }
            }
        }
        Ok(contours)
    }

    /// The contour that enters a triangle by a half-edge.
    fn follow(&self, first: HalfEdgeId, level: f64, stamp: u32, passed: &mut [u32]) -> Option<Contour> {
        let t = self.triangulation();
        let mut points = vec![self.crossing(first, level)];
        let mut h = first;
        let mut is_closed = false;
        while std::mem::replace(&mut passed[h.index()], stamp) != stamp {
            // The other edge that the level crosses: its end is above, its origin below.
            let rises = |h: &HalfEdgeId| self.height(t.origin(*h)) < level && self.height(t.dest(*h)) >= level;
            let out = [h.next(), h.prev()].into_iter().find(rises)?;
            let p = self.crossing(out, level);
            if points.last() != Some(&p) {
                points.push(p);
            }
            h = t.twin(out);
            is_closed = h == first;
            if is_closed || t.is_ghost(h.face()) {
                break;
            }
        }
        if is_closed && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        Some(Contour { level, points, is_closed })
    }

    /// Where a level crosses an edge, one end of which is below it and the other not; the same from both sides.
    fn crossing(&self, h: HalfEdgeId, level: f64) -> Point {
        let t = self.triangulation();
        let ends = [t.origin(h), t.dest(h)].map(|v| (self.height(v), t.point(v)));
        let [low, high] = if ends[0].0 < ends[1].0 { ends } else { [ends[1], ends[0]] };
        debug_assert!(lexicographic(low.1, high.1).is_ne(), "an edge has two ends");
        // Halves, so that no difference of heights overflows; of small heights nothing is lost that matters.
        let scale = if (high.0 - low.0).is_finite() { 1.0 } else { 0.5 };
        let by = (level * scale - low.0 * scale) / (high.0 * scale - low.0 * scale);
        if level == high.0 { high.1 } else { Point::lerp(low.1, high.1, by.clamp(0.0, 1.0)) }
    }
}
