//! Typed ids: a vertex cannot name a face.

/// Makes a typed id of a number: of 32 bits, ordered as its number, shown as that, with a letter before it in debug
/// output.
macro_rules! id_type {
    ($(#[$doc:meta])* $name:ident, $letter:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
        #[repr(transparent)]
        pub struct $name(pub u32);

        impl $name {
            /// The id as an index into an array.
            #[must_use]
            #[inline]
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// The id with this index.
            ///
            /// # Guarantees
            /// Exact for indices below 2³² − 2; triangulations are refused beyond that long before.
            #[must_use]
            #[inline]
            #[allow(clippy::cast_possible_truncation, reason = "sizes are bounded where arrays grow")]
            pub const fn from_index(index: usize) -> Self {
                Self(index as u32)
            }
        }

        impl std::fmt::Debug for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, "{}", self.0)
            }
        }
    };
}

pub(crate) use id_type;

id_type! {
    /// A vertex: the caller's index, always; Steiner points follow the input.
    VertexId, "v"
}

id_type! {
    /// One side of an edge, directed; belongs to face `h / 3`, which lies to its left.
    HalfEdgeId, "h"
}

id_type! {
    /// A triangle slot; half-edges `3f`, `3f + 1`, `3f + 2` run counter-clockwise around it.
    FaceId, "f"
}

id_type! {
    /// An undirected edge: the index of the half-edge that [`edges`](super::HalfEdgeMesh::edges) gives for it.
    EdgeId, "e"
}

impl EdgeId {
    /// The half-edge that stands for the edge; its twin is the other one.
    #[must_use]
    #[inline]
    pub const fn half_edge(self) -> HalfEdgeId {
        HalfEdgeId(self.0)
    }
}

impl VertexId {
    /// The vertex at infinity, third corner of every ghost face.
    pub const INFINITE: Self = Self(u32::MAX);
    /// Origin of the half-edges of a dead slot.
    pub(crate) const DEAD: Self = Self(u32::MAX - 1);

    /// Whether this is a vertex with coordinates.
    #[must_use]
    #[inline]
    pub const fn is_finite(self) -> bool {
        self.0 != Self::INFINITE.0
    }
}

impl HalfEdgeId {
    /// No half-edge: twin of a dead slot, half-edge of an unused vertex.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// The face to the left.
    #[must_use]
    #[inline]
    pub const fn face(self) -> FaceId {
        FaceId(self.0 / 3)
    }

    /// The next half-edge counter-clockwise around the face.
    #[must_use]
    #[inline]
    pub const fn next(self) -> Self {
        // `% 3 == 0` compiles to one multiplication; a full remainder would be slower.
        let after = self.0 + 1;
        if after % 3 == 0 { Self(after - 3) } else { Self(after) }
    }

    /// The previous half-edge counter-clockwise around the face.
    #[must_use]
    #[inline]
    pub const fn prev(self) -> Self {
        if self.0 % 3 == 0 { Self(self.0 + 2) } else { Self(self.0 - 1) }
    }

    /// The next and the previous half-edge around the face.
    #[must_use]
    #[inline]
    pub const fn next_and_prev(self) -> (Self, Self) {
        // Arithmetic instead of a branch: `h % 3` is unpredictable.
        let (after, before) = (self.0 + 1, self.0 + 2);
        let rest = self.0 % 3;
        (Self(after - 3 * (rest == 2) as u32), Self(before - 3 * (rest != 0) as u32))
    }

    /// `None` for [`NONE`](Self::NONE), else this half-edge.
    #[must_use]
    #[inline]
    pub(crate) fn some(self) -> Option<Self> {
        (self != Self::NONE).then_some(self)
    }
}

impl FaceId {
    /// The face's half-edge number `k`, 0 to 2.
    #[must_use]
    #[inline]
    pub const fn half_edge(self, k: u32) -> HalfEdgeId {
        HalfEdgeId(self.0 * 3 + k)
    }

    /// The three half-edges, counter-clockwise.
    #[must_use]
    #[inline]
    pub const fn half_edges(self) -> [HalfEdgeId; 3] {
        [self.half_edge(0), self.half_edge(1), self.half_edge(2)]
    }
}
