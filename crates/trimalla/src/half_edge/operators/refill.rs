//! Refill: replaces the faces of a cavity by others.

use super::patch::Patch;
use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

/// One half of a cavity that an edge divides.
#[derive(Clone, Debug, Default)]
pub(crate) struct Half {
    /// The vertices of its boundary.
    pub(crate) boundary: Vec<VertexId>,
    /// Its rims.
    rims: Vec<Rim>,
    /// What fills it.
    pub(crate) patch: Patch,
}

/// An edge of the rim of a cavity.
#[derive(Clone, Copy, Debug)]
struct Rim {
    /// Its half-edge inside the cavity.
    inner: HalfEdgeId,
    /// Its half-edge outside.
    outer: HalfEdgeId,
    mark: u32,
}

impl Half {
    /// The half left of the edge from `first` to `last`, with the boundary `between` them and the inner half-edges of
    /// its rims in that order; not filled yet.
    pub(crate) fn start<'a>(
        &mut self,
        first: VertexId,
        between: impl Iterator<Item = &'a VertexId>,
        last: VertexId,
        rims: impl Iterator<Item = &'a HalfEdgeId>,
    ) {
        self.boundary.clear();
        self.boundary.push(first);
        self.boundary.extend(between);
        self.boundary.push(last);
        self.rims.clear();
        self.rims.extend(rims.map(|&inner| Rim { inner, outer: HalfEdgeId::NONE, mark: 0 }));
    }
}

impl HalfEdgeMesh {
    /// Replaces the faces of a cavity by as many others, on both sides of a new edge with that mark.
    ///
    /// ```text
    ///       s ───── t                  s ───── t
    ///      / \     / \                /  \ ‾‾--.. \
    ///     a ──u───v── b     ──>      a ════════════ b       the slots of `faces` are used again, in order;
    ///      \ /     \ /                \ .. -- ‾‾ / /        the base of the first half runs from a to b
    ///       w ───── x                  w ───── x
    /// ```
    ///
    /// An edge that dangles into the cavity has it on both sides: it is a rim twice, each the other's outside.
    /// Inner edges are unmarked afterwards.
    pub(crate) fn refill<J: Journal>(&mut self, faces: &[FaceId], halves: [&mut Half; 2], mark: u32, j: &mut J) {
        let [first, second] = halves;
        debug_assert_eq!(faces.len(), first.patch.len() + second.patch.len(), "a cavity keeps its number of faces");
        let (first_faces, second_faces) = faces.split_at(first.patch.len());
        let mut halves = [(first_faces, first), (second_faces, second)];
        for (_, half) in &mut halves {
            for rim in &mut half.rims {
                (rim.outer, rim.mark) = (self.twin(rim.inner), self.mark(rim.inner));
            }
        }
        for (faces, half) in &halves {
            for (rim, &side) in half.rims.iter().zip(&half.patch.rim) {
                self.set_twin(rim.outer, side.half_edge(faces), j);
            }
        }
        // A dangling edge has two rims, each the outside of the other. The loop above gave each inner half-edge its new
        // twin: that is the new outside.
        for (_, half) in &mut halves {
            for rim in &mut half.rims {
                rim.outer = self.twin(rim.inner);
            }
        }
        for (faces, half) in &halves {
            self.write_half(faces, half, j);
        }
        let [a, b] = halves.map(|(faces, half)| half.patch.base.half_edge(faces));
        self.glue(a, b, j);
        self.set_mark(a, mark, j);
    }

    /// Writes the faces of one half, but for what lies across its base.
    fn write_half<J: Journal>(&mut self, faces: &[FaceId], half: &Half, j: &mut J) {
        let Half { boundary, rims, patch } = half;
        let has_marks = self.has_marks();
        for (&f, triangle) in faces.iter().zip(&patch.triangles) {
            let vertices = triangle.corners.map(|corner| boundary[corner as usize]);
            let twins = triangle.across.map(|side| side.half_edge(faces));
            self.set_vertices_and_twins(f, vertices, twins, j);
            if has_marks {
                f.half_edges().into_iter().for_each(|h| self.set_mark_one_side(h, 0, j));
            }
        }
        for ((rim, side), &v) in rims.iter().zip(&patch.rim).zip(&boundary[1..]) {
            let h = side.half_edge(faces);
            self.set_twin(h, rim.outer, j);
            if rim.mark != 0 {
                self.set_mark_one_side(h, rim.mark, j);
            }
            // A rim runs back along the boundary: it starts at the later vertex.
            self.set_outgoing(v, h, j);
        }
    }
}
