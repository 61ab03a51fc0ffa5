//! Faults in the numbers of the file: the library counts from 0, most files from 1.

use trimalla::quality::InputFault;
use trimalla::triangulation::{MeshFault, MeshVertex};

/// Gives everything the number that it has in a file whose first number is `first`.
pub trait Renumber {
    /// Adds the first number of a file to every index from 0.
    fn renumber(&mut self, first: u32);

    /// The same with the numbers of the file.
    #[must_use]
    fn renumbered(mut self, first: u32) -> Self
    where
        Self: Sized,
    {
        self.renumber(first);
        self
    }
}

impl Renumber for u32 {
    fn renumber(&mut self, first: u32) {
        *self = self.saturating_add(first);
    }
}

impl Renumber for usize {
    fn renumber(&mut self, first: u32) {
        *self += first as Self;
    }
}

impl Renumber for MeshVertex {
    fn renumber(&mut self, first: u32) {
        self.index.renumber(first);
    }
}

impl<T: Renumber, const N: usize> Renumber for [T; N] {
    fn renumber(&mut self, first: u32) {
        self.iter_mut().for_each(|item| item.renumber(first));
    }
}

impl Renumber for MeshFault {
    fn renumber(&mut self, first: u32) {
        match self {
            Self::NotFinite(vertex) => vertex.renumber(first),
            Self::IndexOutOfRange { triangle, vertex, .. } => {
                triangle.renumber(first);
                vertex.renumber(first);
            }
            Self::RepeatedVertex { triangle, vertex } => {
                triangle.renumber(first);
                vertex.renumber(first);
            }
            Self::NotCounterClockwise { triangle, corners, .. } => {
                triangle.renumber(first);
                corners.renumber(first);
            }
            Self::EdgeUsedTwice { edge, triangles } => {
                edge.renumber(first);
                triangles.renumber(first);
            }
            Self::Star { vertex, triangles } => {
                vertex.renumber(first);
                triangles.renumber(first);
            }
            Self::DuplicateVertices(vertices) => vertices.renumber(first),
            Self::SegmentOutOfRange { segment, vertex, .. } => {
                segment.renumber(first);
                vertex.renumber(first);
            }
            Self::SegmentNotAnEdge { segment, ends } => {
                segment.renumber(first);
                ends.renumber(first);
            }
            Self::BoundaryContact { edges, triangles, .. } => {
                edges.renumber(first);
                triangles.renumber(first);
            }
            Self::Overlap { triangle, edge } => {
                triangle.renumber(first);
                edge.renumber(first);
            }
            Self::NotDelaunay { edge, triangles, inside } => {
                edge.renumber(first);
                triangles.renumber(first);
                inside.renumber(first);
            }
            _ => {} // Faults of columns and counts name no element.
        }
    }
}

impl Renumber for InputFault {
    fn renumber(&mut self, first: u32) {
        match self {
            Self::VertexChanged { vertex, .. } => vertex.renumber(first),
            Self::SegmentOutOfRange { segment, vertex, .. } => {
                segment.renumber(first);
                vertex.renumber(first);
            }
            Self::SegmentNotCovered { segment, ends, stop } => {
                segment.renumber(first);
                ends.renumber(first);
                stop.renumber(first);
            }
            Self::VertexPassedBy { segment, ends, vertex }
            | Self::VertexBeside { segment, ends, vertex }
            | Self::VertexOnWrongSide { segment, ends, vertex } => {
                segment.renumber(first);
                ends.renumber(first);
                vertex.renumber(first);
            }
            Self::SegmentCrossesBoundary { segment, ends, edge } => {
                segment.renumber(first);
                ends.renumber(first);
                edge.renumber(first);
            }
            _ => {}
        }
    }
}
