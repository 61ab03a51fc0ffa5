//! The state of the filling of wide parts: the nodes of lattices that are left.

use std::sync::Arc;

use crate::geometry::{BoundingBox, Point};
use crate::half_edge::{FaceId, VertexId};

/// The stage of the filling.
#[derive(Clone, Debug, Default)]
pub(super) enum FillStage {
    /// Subsegments are being halved; lattices begin at a corner of this box.
    Segments(BoundingBox),
    /// Nodes are being inserted.
    Nodes(Box<Nodes>),
    /// There is nothing to fill, or the filling is done.
    #[default]
    Done,
}

/// What the filling overwrites when a node is taken.
#[derive(Clone, Copy, Debug)]
pub(super) struct TakenNode {
    pub(super) near: Option<FaceId>,
    /// The part that the node is in, and the vertex known in it before.
    pub(super) part: u32,
    pub(super) known: VertexId,
}

impl FillStage {
    /// Puts a node back.
    pub(super) fn put_back(&mut self, node: TakenNode) {
        if let Self::Nodes(nodes) = self {
            nodes.done -= 1;
            nodes.near = node.near;
            nodes.parts[node.part as usize].known = node.known;
        }
    }
}

/// The nodes to insert.
#[derive(Clone, Debug)]
pub(super) struct Nodes {
    /// The nodes, row by row, and the part that each is in.
    pub(super) points: Arc<[Point]>,
    pub(super) part_of: Arc<[u32]>,
    /// The order of insertion.
    pub(super) order: Arc<[u32]>,
    /// The number of nodes that have been treated.
    pub(super) done: usize,
    /// A face at the node inserted last.
    pub(super) near: Option<FaceId>,
    pub(super) parts: Vec<FilledPart>,
    pub(super) bounds: BoundingBox,
}

/// A triangle that is filled.
#[derive(Clone, Copy, Debug)]
pub(super) struct FilledPart {
    /// The node inserted into it last; a corner before the first insertion.
    pub(super) known: VertexId,
    /// The square of the clearance.
    pub(super) clearance_sq: f64,
}

impl Nodes {
    /// Takes the next node; returns it with the part that it is in.
    pub(super) fn take(&mut self) -> Option<(Point, &mut FilledPart)> {
        let i = *self.order.get(self.done)? as usize;
        self.done += 1;
        Some((self.points[i], &mut self.parts[self.part_of[i] as usize]))
    }

    /// What taking the next node will overwrite.
    pub(super) fn next(&self) -> Option<TakenNode> {
        let i = *self.order.get(self.done)? as usize;
        let part = self.part_of[i];
        Some(TakenNode { near: self.near, part, known: self.parts[part as usize].known })
    }

    pub(super) fn left(&self) -> usize {
        self.order.len() - self.done
    }
}
