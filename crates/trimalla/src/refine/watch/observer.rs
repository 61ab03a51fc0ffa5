//! Observers of a refinement.

use super::event::Event;
use super::stopwatch::Clock;
use crate::constrained::ConstrainedTriangulation;
use crate::half_edge::FaceId;
use crate::refine::forecast::outlook::Outlook;

/// How far a refinement has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The present number of vertices.
    pub vertices: usize,
    /// Bad triangles in the queue; some of them may no longer exist.
    pub waiting: usize,
    /// The vertex budget.
    pub max_vertices: usize,
}

/// Size and smallest angle of a triangulation under refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overview {
    /// Vertices, those of the input that are in no triangle included.
    pub vertices: usize,
    /// Triangles.
    pub triangles: usize,
    /// The smallest angle in degrees; `None` without a triangle.
    pub min_angle_deg: Option<f64>,
}

/// A refinement before its first step: an observer may read it, and pick triangles for the order `manual`.
pub trait Beginning {
    /// The triangulation.
    fn triangulation(&self) -> &ConstrainedTriangulation;

    /// Its size and smallest angle.
    ///
    /// # Complexity
    /// Linear.
    fn overview(&self) -> Overview;

    /// Picks a triangle to be treated after those picked before; returns whether there is such a triangle.
    fn pick(&mut self, face: FaceId) -> bool;
}

/// Watches a refinement.
pub trait Observer {
    /// Called before the first step and then at least once in every 256 steps and insertions; `false` cancels.
    fn progress(&mut self, progress: Progress) -> bool;

    /// A clock that measures the steps; nothing is measured without one.
    fn clock(&self) -> Option<Clock> {
        None
    }

    /// Whether [`outlook`](Self::outlook) is to be called. An outlook takes about a tenth of the time of a run.
    fn wants_outlook(&self) -> bool {
        false
    }

    /// Called by [`mesh_with`](crate::mesh_with) before the refinement begins.
    fn outlook(&mut self, _outlook: &Outlook) {}

    /// Called by [`mesh_with`](crate::mesh_with) and [`refine_mesh_with`](crate::refine_mesh_with) before the first
    /// step: here triangles can be picked.
    fn begins(&mut self, _begun: &mut dyn Beginning) {}

    /// Whether [`event`](Self::event) is to be called after every step.
    fn wants_events(&self) -> bool {
        false
    }

    /// Called after every step, if [`wants_events`](Self::wants_events), with the present triangulation.
    fn event(&mut self, _event: &Event, _cdt: &ConstrainedTriangulation) {}
}

/// Watches nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoObserver;

impl Observer for NoObserver {
    fn progress(&mut self, _: Progress) -> bool {
        true
    }
}

impl<F: FnMut(Progress) -> bool> Observer for F {
    fn progress(&mut self, progress: Progress) -> bool {
        self(progress)
    }
}
