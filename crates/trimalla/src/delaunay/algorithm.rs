//! Algorithms chosen by type and by key.

use super::delaunay::BuildError;
use super::{divide_and_conquer, flip, incremental, lift, voronoi};
use crate::geometry::Point;
use crate::half_edge::VertexId;
use crate::trace::{NoTrace, Trace};
use crate::triangulation::Triangulation;

/// A way to build a Delaunay triangulation of points.
///
/// Implementations agree on the canonical form; they differ in time, memory and slots.
pub trait Algorithm {
    /// The key under which the program knows it.
    const KEY: AlgorithmKey;

    /// Triangulates the points that `subset` names, or all.
    ///
    /// # Errors
    /// See [`BuildError`]; checked before any work.
    fn triangulate(points: &[Point], subset: Option<&[VertexId]>) -> Result<Triangulation, BuildError> {
        Self::triangulate_traced(points, subset, &mut NoTrace)
    }

    /// Triangulates the points that `subset` names, or all, and tells each step; algorithms without steps to tell
    /// tell none.
    ///
    /// # Errors
    /// See [`BuildError`], checked before any work; [`BuildError::Cancelled`] if the trace says so.
    fn triangulate_traced(
        points: &[Point],
        subset: Option<&[VertexId]>,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Triangulation, BuildError>;
}

/// Insertion of one point after the other, in curve order. The default.
///
/// # Source
/// `[Lawson77]`, `[AmentaChoiRote03]`.
#[derive(Clone, Copy, Debug)]
pub struct Incremental;

/// Halves triangulated and merged.
///
/// # Source
/// `[GuibasStolfi85]`.
#[derive(Clone, Copy, Debug)]
pub struct DivideAndConquer;

/// The lower convex hull of the points on a paraboloid.
///
/// # Source
/// `[Triangulaciones]`, `[EdelsbrunnerSeidel86]`, `[ClarksonShor89]`.
#[doc(alias = "paraboloide")]
#[derive(Clone, Copy, Debug)]
pub struct Lift;

/// Any triangulation, then flips until every edge is legal: O(n²).
///
/// # Source
/// `[Triangulaciones]`, `[Lawson77]`.
#[doc(alias = "giros")]
#[derive(Clone, Copy, Debug)]
pub struct Flip;

/// The dual of the Voronoi diagram, which a sweep draws.
///
/// # Source
/// `[Triangulaciones]`, `[Fortune87]`.
#[doc(alias = "Fortune")]
#[derive(Clone, Copy, Debug)]
pub struct Voronoi;

/// The algorithms, each with its call.
macro_rules! algorithms {
    ($($name:ident: |$points:ident, $subset:ident, $trace:ident| $build:expr;)*) => {$(
        impl Algorithm for $name {
            const KEY: AlgorithmKey = AlgorithmKey::$name;

            fn triangulate_traced(
                $points: &[Point],
                subset: Option<&[VertexId]>,
                $trace: &mut (impl Trace + ?Sized),
            ) -> Result<Triangulation, BuildError> {
                let subset = validate($points, subset)?;
                let $subset = subset.as_deref();
                $build
            }
        }
    )*};
}

algorithms! {
    Incremental: |points, subset, _trace| Ok(incremental::build(points, subset).0);
    DivideAndConquer: |points, subset, _trace| Ok(divide_and_conquer::build(points, subset));
    Lift: |points, subset, trace| lift::build(points, subset, trace);
    Flip: |points, subset, trace| flip::build(points, subset, trace);
    Voronoi: |points, subset, trace| voronoi::build(points, subset, trace);
}

keyed! {
    /// An algorithm by name.
    AlgorithmKey, {
        Incremental = "incremental", "points inserted along a curve, round by round, with Lawson's flips", "AmentaChoiRote03";
        DivideAndConquer = "divide-and-conquer", "halves triangulated and merged", "GuibasStolfi85";
        Lift = "lift", "the lower convex hull of the points on a paraboloid, in random order", "ClarksonShor89";
        Flip = "flip", "any triangulation, then flips of illegal edges: slow, to teach", "Lawson77";
        Voronoi = "voronoi", "Fortune's sweep: the Voronoi diagram first, its dual then", "Fortune87";
    }
}

#[expect(clippy::derivable_impls, reason = "the macro that declares the keys marks no variant")]
impl Default for AlgorithmKey {
    fn default() -> Self {
        Self::Incremental
    }
}

impl AlgorithmKey {
    /// Runs the algorithm.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn triangulate(self, points: &[Point], subset: Option<&[VertexId]>) -> Result<Triangulation, BuildError> {
        self.triangulate_traced(points, subset, &mut NoTrace)
    }

    /// Whether the algorithm tells its steps: `lift`, `flip` and `voronoi` do.
    #[must_use]
    pub const fn tells_steps(self) -> bool {
        matches!(self, Self::Lift | Self::Flip | Self::Voronoi)
    }

    /// Runs the algorithm, and tells each step of `lift`, `flip` and `voronoi`; the others tell none.
    ///
    /// # Errors
    /// See [`BuildError`]; [`BuildError::Cancelled`] if the trace says so.
    ///
    /// # Examples
    /// ```
    /// use trimalla::delaunay::AlgorithmKey;
    /// use trimalla::geometry::Point;
    /// use trimalla::trace::{Act, Shape, Step};
    ///
    /// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
    /// let mut steps: Vec<Step> = Vec::new();
    /// let t = AlgorithmKey::Voronoi.triangulate_traced(&square, None, &mut steps)?;
    /// let dual = steps.iter().filter(|s| s.act == Act::Add && matches!(s.shape, Shape::Triangle(_)));
    /// assert_eq!((t.face_count(), dual.count()), (2, 2));
    /// # Ok::<(), trimalla::delaunay::BuildError>(())
    /// ```
    pub fn triangulate_traced(
        self,
        points: &[Point],
        subset: Option<&[VertexId]>,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Triangulation, BuildError> {
        match self {
            Self::Incremental => Incremental::triangulate_traced(points, subset, trace),
            Self::DivideAndConquer => DivideAndConquer::triangulate_traced(points, subset, trace),
            Self::Lift => Lift::triangulate_traced(points, subset, trace),
            Self::Flip => Flip::triangulate_traced(points, subset, trace),
            Self::Voronoi => Voronoi::triangulate_traced(points, subset, trace),
        }
    }

    /// Triangulates all points; returns their order [`along_curve`](super::along_curve) too, if the algorithm has it.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub(crate) fn triangulate_all(
        self,
        points: &[Point],
    ) -> Result<(Triangulation, Option<Vec<VertexId>>), BuildError> {
        if self == Self::Incremental {
            validate(points, None)?;
            return Ok(incremental::build(points, None));
        }
        Ok((self.triangulate(points, None)?, None))
    }
}

/// Every coordinate finite, every index in range; the subset without repetitions, in order.
pub(crate) fn validate(points: &[Point], subset: Option<&[VertexId]>) -> Result<Option<Vec<VertexId>>, BuildError> {
    BuildError::if_too_many(points.len(), 0)?;
    // One test of all points, without a branch for each: nearly every input is finite.
    let are_finite = points.iter().fold(true, |are_finite, p| are_finite & p.is_finite());
    if !are_finite {
        if let Some((index, &point)) = points.iter().enumerate().find(|(_, p)| !p.is_finite()) {
            return Err(BuildError::NotFinite { index, point });
        }
    }
    let Some(subset) = subset else { return Ok(None) };
    if let Some(&v) = subset.iter().find(|v| v.index() >= points.len()) {
        return Err(BuildError::NoSuchVertex { vertex: v, points: points.len() });
    }
    let mut sorted = subset.to_vec();
    sorted.sort_unstable();
    sorted.dedup();
    Ok(Some(sorted))
}
