//! What a sweep finds, and who is told.

use super::super::corners::Mark;

keyed! {
    /// The kind of a corner, as a sweep from left to right meets it.
    ///
    /// *Left* and *right* are those of the lexicographic order: of two points with the same x, the lower one is left.
    VertexKind, {
        Start = "start", "both sides are to the right, the inside between them is less than a half-plane", "";
        End = "end", "both sides are to the left, the inside between them is less than a half-plane", "";
        Split = "split", "both sides are to the right, the inside is to the left", "";
        Merge = "merge", "both sides are to the left, the inside is to the right", "";
        Upper = "upper-chain", "one side on either hand, the inside is below", "";
        Lower = "lower-chain", "one side on either hand, the inside is above", "";
    }
}

/// One of the two chains that bound a monotone piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::polygon) enum Chain {
    /// The chain below the piece.
    Lower,
    /// The chain above the piece.
    Upper,
}

/// Why a diagonal is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// Its right end is a split vertex: the sweep from left to right of the notes draws it.
    Split,
    /// Its left end is a merge vertex: the sweep from right to left of the notes draws it.
    Merge,
    /// Both: both sweeps would draw it.
    Both,
}

impl Cause {
    /// The cause in a few words.
    pub(in crate::polygon) const fn note(self) -> &'static str {
        match self {
            Self::Split => "a diagonal to the helper of a split vertex",
            Self::Merge => "a diagonal from a merge vertex, which is the helper",
            Self::Both => "a diagonal from a merge vertex to a split vertex",
        }
    }
}

/// Is told the monotone pieces while a sweep finds them, corner by corner from left to right.
pub(in crate::polygon) trait Pieces {
    /// The sweep is at a corner.
    fn visit(&mut self, _at: Mark, _kind: VertexKind) {}

    /// A diagonal is drawn.
    fn diagonal(&mut self, _from: Mark, _to: Mark, _cause: Cause) {}

    /// A piece begins in a corner.
    fn begin(&mut self, at: Mark) -> u32;

    /// A piece has another corner on one of its chains.
    fn extend(&mut self, piece: u32, at: Mark, chain: Chain);

    /// A piece ends in a corner.
    fn finish(&mut self, piece: u32, at: Mark);

    /// The last corner of a piece so far, and its chain.
    fn last(&self, piece: u32) -> (Mark, Chain);

    /// An edge begins in a corner, or ends there.
    fn edge(&mut self, _edge: u32, _corner: u32, _goes_out: bool) {}

    /// Whether somebody has cancelled.
    fn is_cancelled(&self) -> bool {
        false
    }
}
