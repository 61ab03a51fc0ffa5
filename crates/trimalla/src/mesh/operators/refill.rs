//! Refill: other faces in the same cavity.

use crate::mesh::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

/// Triangles that fill a region beside an edge, the *base*; they know nothing of the mesh that they are meant for.
///
/// Border vertices are numbered along the border from one end of the base to the other, the region on the left; *rim*
/// `i` is the edge of the border between vertices `i` and `i + 1`. Side `3 t + k` is that of triangle `t` from its corner
/// `k` to the next one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Patch {
    /// Where each side starts: a border vertex.
    pub(crate) corners: Vec<u32>,
    /// The side across each side, [`BORDER`](Self::BORDER) for those on the border.
    pub(crate) across: Vec<u32>,
    /// The side along each rim.
    pub(crate) rim: Vec<u32>,
    /// The side along the base.
    pub(crate) base: u32,
}

impl Patch {
    /// What lies across the sides on the border.
    pub(crate) const BORDER: u32 = u32::MAX;

    /// Number of triangles.
    pub(crate) fn len(&self) -> usize {
        self.corners.len() / 3
    }

    /// The half-edge that a side becomes in these faces.
    #[inline]
    fn half_edge(faces: &[FaceId], side: u32) -> HalfEdgeId {
        faces[side as usize / 3].half_edge(side % 3)
    }

    /// The edges that these faces have between them, one half-edge each.
    pub(crate) fn inner_edges(&self, faces: &[FaceId]) -> impl Iterator<Item = HalfEdgeId> {
        let inner = (0..).zip(&self.across).filter(|&(side, &across)| across != Self::BORDER && side < across);
        inner.map(move |(side, _)| Self::half_edge(faces, side))
    }
}

/// One half of a cavity that an edge parts.
#[derive(Clone, Debug, Default)]
pub(crate) struct Half {
    /// The vertices of its border.
    pub(crate) border: Vec<VertexId>,
    /// Its rims.
    pub(crate) rims: Vec<Rim>,
    /// What fills it.
    pub(crate) patch: Patch,
}

/// An edge of the rim of a cavity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rim {
    /// Its half-edge inside the cavity.
    inner: HalfEdgeId,
    /// Its half-edge outside.
    outer: HalfEdgeId,
    mark: u32,
}

impl Rim {
    /// The rim with that half-edge inside the cavity.
    pub(crate) const fn new(inner: HalfEdgeId) -> Self {
        Self { inner, outer: HalfEdgeId::NONE, mark: 0 }
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
                self.set_twin(rim.outer, Patch::half_edge(faces, side), j);
            }
        }
        // The inner half-edge of an edge that dangles was told, as the other rim's outside, what comes in that one's place.
        for (_, half) in &mut halves {
            for rim in &mut half.rims {
                rim.outer = self.twin(rim.inner);
            }
        }
        for (faces, half) in &halves {
            self.write_half(faces, half, j);
        }
        let [a, b] = halves.map(|(faces, half)| Patch::half_edge(faces, half.patch.base));
        self.glue(a, b, j);
        self.set_mark(a, mark, j);
    }

    /// Writes the faces of one half, but for what lies across its base.
    fn write_half<J: Journal>(&mut self, faces: &[FaceId], half: &Half, j: &mut J) {
        let Half { border, rims, patch } = half;
        for ((&f, corners), across) in faces.iter().zip(patch.corners.chunks_exact(3)).zip(patch.across.chunks_exact(3))
        {
            for ((h, &corner), &across) in f.half_edges().into_iter().zip(corners).zip(across) {
                self.set_origin(h, border[corner as usize], j);
                if across != Patch::BORDER {
                    self.set_twin(h, Patch::half_edge(faces, across), j);
                }
                if !self.mark.is_empty() {
                    self.set_mark_one_side(h, 0, j);
                }
            }
        }
        for ((rim, &side), &v) in rims.iter().zip(&patch.rim).zip(&border[1..]) {
            let h = Patch::half_edge(faces, side);
            self.set_twin(h, rim.outer, j);
            if rim.mark != 0 {
                self.set_mark_one_side(h, rim.mark, j);
            }
            // A rim runs back along the border: it starts at the later vertex.
            self.set_outgoing(v, h, j);
        }
    }
}
