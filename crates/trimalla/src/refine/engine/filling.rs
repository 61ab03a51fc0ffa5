//! How far the filling of wide parts is: the nodes of lattices that wait.

use std::sync::Arc;

use crate::geometry::{BoundingBox, Point};
use crate::half_edge::{FaceId, VertexId};

/// How far the filling is.
#[derive(Clone, Debug, Default)]
pub(super) enum FillStage {
    /// Subsegments are halved; lattices begin at a corner of this box.
    Segments(BoundingBox),
    /// Nodes go in.
    Nodes(Box<Nodes>),
    /// There is nothing to fill, or no more.
    #[default]
    Done,
}

/// The filling before a node was taken.
#[derive(Clone, Copy, Debug)]
pub(super) struct TakenNode {
    pub(super) near: Option<FaceId>,
    /// The part that the node is in, and the vertex that was known of it.
    pub(super) part: u32,
    pub(super) known: VertexId,
}

impl FillStage {
    /// Takes it back that a node was taken.
    pub(super) fn put_back(&mut self, node: TakenNode) {
        if let Self::Nodes(nodes) = self {
            nodes.done -= 1;
            nodes.near = node.near;
            nodes.parts[node.part as usize].known = node.known;
        }
    }
}

/// What goes in.
#[derive(Clone, Debug)]
pub(super) struct Nodes {
    /// Row by row, and the triangle that each is in.
    pub(super) points: Arc<[Point]>,
    pub(super) part_of: Arc<[u32]>,
    /// The order of insertion.
    pub(super) order: Arc<[u32]>,
    /// How many of them have had their turn.
    pub(super) done: usize,
    /// The face at the node that went in last.
    pub(super) near: Option<FaceId>,
    pub(super) parts: Vec<FilledPart>,
    pub(super) bounds: BoundingBox,
}

/// A triangle that is filled.
#[derive(Clone, Copy, Debug)]
pub(super) struct FilledPart {
    /// The node that went into it last, before the first one a corner.
    pub(super) known: VertexId,
    /// The square of the clearance.
    pub(super) clearance_sq: f64,
}

impl Nodes {
    /// The next node, and the triangle that it is in.
    pub(super) fn take(&mut self) -> Option<(Point, &mut FilledPart)> {
        let i = *self.order.get(self.done)? as usize;
        self.done += 1;
        Some((self.points[i], &mut self.parts[self.part_of[i] as usize]))
    }

    /// What is to be remembered before the next node is taken.
    pub(super) fn next(&self) -> Option<TakenNode> {
        let i = *self.order.get(self.done)? as usize;
        let part = self.part_of[i];
        Some(TakenNode { near: self.near, part, known: self.parts[part as usize].known })
    }

    pub(super) fn left(&self) -> usize {
        self.order.len() - self.done
    }
}
