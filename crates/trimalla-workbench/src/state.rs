//! What a document holds.

use std::path::PathBuf;
use std::sync::Arc;

use trimalla::domain::Contours;
use trimalla::drawing::Pslg;
use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::VertexId;
use trimalla::polygon::{Polygon, constrained_delaunay};
use trimalla::refine::NamedOptions;
use trimalla::trace::{NoTrace, Recorder, Step};

use crate::mesh::Mesh;
use crate::names::Names;

/// What a document holds, but for its history.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    /// What is triangulated.
    pub(crate) input: Input,
    /// The triangulation, once there is one.
    pub(crate) mesh: Option<Mesh>,
    pub(crate) names: Names,
    /// What a refinement is asked.
    pub(crate) options: NamedOptions,
    /// Triangles that the user picked, by their vertices.
    pub(crate) selection: Vec<[u32; 3]>,
    /// What the algorithm told that made the triangulation, if it told anything and nothing was changed since.
    pub(crate) construction: Option<Construction>,
}

/// The steps of an algorithm that made the triangulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Construction {
    pub(crate) recorder: Arc<Recorder>,
    pub(crate) shown: usize,
}

impl Construction {
    /// The steps; of a long run the first ones.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        self.recorder.steps()
    }

    /// Whether another one has the steps of the same run.
    #[must_use]
    pub fn is_of_run(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.recorder, &other.recorder)
    }

    /// About how many bytes the steps take.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.steps())
    }

    /// How many of them are shown: all of them, until 'Watch' says otherwise.
    #[must_use]
    pub fn shown(&self) -> usize {
        self.shown
    }
}

impl Default for State {
    fn default() -> Self {
        Self {
            input: Input::default(),
            mesh: None,
            names: Names::default(),
            options: NamedOptions::defaults(),
            selection: Vec::new(),
            construction: None,
        }
    }
}

/// A drawing, and contours besides.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Input {
    /// Points, segments, and where it was read from a file, hole and region seeds.
    pub(crate) drawing: Pslg,
    /// Whether the drawing was read: its outside is carved away then.
    pub(crate) is_read: bool,
    /// The files it was read from.
    pub(crate) files: Vec<PathBuf>,
    pub(crate) outer: Option<Vec<VertexId>>,
    pub(crate) inner: Vec<Vec<VertexId>>,
}

impl Input {
    /// Whether anything bounds the domain or lies in it, but points.
    pub(crate) fn has_segments(&self) -> bool {
        self.outer.is_some() || !self.inner.is_empty() || !self.drawing.segments.is_empty()
    }

    /// The same points without segments and contours.
    pub(crate) fn points_alone(&self) -> Self {
        Self { drawing: Pslg { points: self.drawing.points.clone(), ..Pslg::default() }, ..Self::default() }
    }

    /// The drawing with the sides of its contours as segments, and a seed in each hole.
    pub(crate) fn whole_drawing(&self) -> Pslg {
        if self.outer.is_none() && self.inner.is_empty() {
            return self.drawing.clone();
        }
        let contours = Contours { outer: self.outer.clone(), holes: self.inner.clone(), ..Contours::default() };
        let seeds = self.inner.iter().filter_map(|hole| self.place_in(hole));
        Pslg {
            segments: [contours.segments(), self.drawing.segments.clone()].concat(),
            segment_markers: Vec::new(),
            holes: self.drawing.holes.iter().copied().chain(seeds).collect(),
            ..self.drawing.clone()
        }
    }

    /// A place in a hole: the middle of the largest of its triangles.
    fn place_in(&self, hole: &[VertexId]) -> Option<Point> {
        // Holes run clockwise.
        let ring: Vec<Point> = hole.iter().rev().map(|v| self.drawing.points[v.index()]).collect();
        let ends = [u32::try_from(ring.len()).ok()?];
        let triangles = constrained_delaunay(Polygon::new(&ring, &ends).ok()?, &mut NoTrace).ok()?;
        let of = |corners: [u32; 3]| Triangle { corners: corners.map(|i| ring[i as usize]) };
        let largest = triangles.into_iter().map(of).max_by(|a, b| a.area().total_cmp(&b.area()))?;
        Some(largest.centroid())
    }
}
