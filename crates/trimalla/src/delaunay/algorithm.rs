//! Algorithms chosen by type and by key.

use std::fmt;
use std::str::FromStr;

use super::delaunay::BuildError;
use super::{divide_and_conquer, incremental};
use crate::by_key::Row;
use crate::geometry::Point;
use crate::half_edge::VertexId;
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
    fn triangulate(points: &[Point], subset: Option<&[VertexId]>) -> Result<Triangulation, BuildError>;
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

impl Algorithm for Incremental {
    const KEY: AlgorithmKey = AlgorithmKey::Incremental;

    fn triangulate(points: &[Point], subset: Option<&[VertexId]>) -> Result<Triangulation, BuildError> {
        let subset = validate(points, subset)?;
        Ok(incremental::build(points, subset.as_deref()).0)
    }
}

impl Algorithm for DivideAndConquer {
    const KEY: AlgorithmKey = AlgorithmKey::DivideAndConquer;

    fn triangulate(points: &[Point], subset: Option<&[VertexId]>) -> Result<Triangulation, BuildError> {
        let subset = validate(points, subset)?;
        Ok(divide_and_conquer::build(points, subset.as_deref()))
    }
}

/// An algorithm by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AlgorithmKey {
    /// `incremental`
    #[default]
    Incremental,
    /// `divide-and-conquer`
    DivideAndConquer,
}

impl AlgorithmKey {
    /// Every algorithm.
    pub const ALL: [Self; 2] = [Self::Incremental, Self::DivideAndConquer];

    /// The key, as scripts and the program spell it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Incremental => "incremental",
            Self::DivideAndConquer => "divide-and-conquer",
        }
    }

    /// One line on what it does.
    #[must_use]
    pub const fn summary(self) -> &'static str {
        match self {
            Self::Incremental => "points inserted along a curve, round by round, with Lawson's flips",
            Self::DivideAndConquer => "Guibas and Stolfi: halves triangulated and merged",
        }
    }

    /// Its key, what it does, and its source.
    #[must_use]
    pub const fn row(self) -> Row {
        let source = match self {
            Self::Incremental => "AmentaChoiRote03",
            Self::DivideAndConquer => "GuibasStolfi85",
        };
        Row { key: self.key(), summary: self.summary(), source }
    }

    /// Runs the algorithm.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn triangulate(self, points: &[Point], subset: Option<&[VertexId]>) -> Result<Triangulation, BuildError> {
        match self {
            Self::Incremental => Incremental::triangulate(points, subset),
            Self::DivideAndConquer => DivideAndConquer::triangulate(points, subset),
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

serialized_by_key!(AlgorithmKey);

impl fmt::Display for AlgorithmKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}

impl FromStr for AlgorithmKey {
    type Err = String;

    fn from_str(s: &str) -> Result<Self, String> {
        Self::ALL
            .into_iter()
            .find(|a| a.key() == s)
            .ok_or_else(|| format!("no triangulation algorithm is called '{s}'"))
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
