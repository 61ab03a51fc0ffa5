//! Where a vertex comes from.

use super::columns;
use crate::drawing::SegmentId;
use crate::half_edge::{Entry, Journal, VertexId};

/// Where a vertex comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Provenance {
    /// The caller's input.
    #[default]
    Input,
    /// Inserted freely, on no segment: it may be moved or removed.
    Free,
    /// On input segment `segment`, at this parameter from its start (0) to its end (1).
    OnSegment {
        /// The input segment; where several overlap, the one with the smallest coordinates.
        segment: SegmentId,
        /// The parameter.
        t: f64,
    },
    /// Where two input segments cross, rounded.
    Crossing {
        /// The two segments.
        segments: [SegmentId; 2],
    },
    /// On input segment `segment`, on a circle around one of its ends where segments meet at a small angle.
    Shell {
        /// The input segment.
        segment: SegmentId,
        /// The parameter from the segment's start.
        t: f64,
        /// Whether the circle's centre is the segment's end, not its start.
        around_end: bool,
        /// The circle's number: vertices of one apex on one circle have the same.
        shell: i16,
    },
}

impl Provenance {
    /// Whether the vertex may be taken out again without losing anything of the input.
    #[must_use]
    pub const fn is_free(self) -> bool {
        matches!(self, Self::Free)
    }
}

/// Which vertices were given, and where the others come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Origins {
    /// Vertices below it are the caller's.
    input_points: usize,
    /// Vertices below it came with the input, or with the mesh that was taken up, and stay.
    given_points: usize,
    /// The first vertex with a provenance of its own.
    first: usize,
    /// Whether a mesh was taken up.
    is_of_mesh: bool,
    provenances: Provenances,
}

impl Origins {
    /// All vertices are the input.
    pub(super) fn of_input(points: usize) -> Self {
        Self {
            input_points: points,
            given_points: points,
            first: points,
            is_of_mesh: false,
            provenances: Provenances::default(),
        }
    }

    /// All vertices came with a mesh; the first of them are those of its drawing, if that is known.
    pub(super) fn of_mesh(points: usize, input_points: Option<usize>) -> Self {
        Self {
            input_points: input_points.unwrap_or(points),
            first: input_points.unwrap_or(0),
            is_of_mesh: true,
            ..Self::of_input(points)
        }
    }

    pub(super) fn input_points(&self) -> usize {
        self.input_points
    }

    pub(super) fn given_points(&self) -> usize {
        self.given_points
    }

    pub(super) fn first(&self) -> usize {
        self.first
    }

    pub(super) fn is_of_mesh(&self) -> bool {
        self.is_of_mesh
    }

    /// Where a vertex comes from.
    pub(super) fn of(&self, v: VertexId) -> Provenance {
        v.index().checked_sub(self.first).map_or(Provenance::Input, |i| self.provenances.get(i))
    }

    /// Sets where a vertex comes from; a vertex before the first with a provenance of its own always is input.
    #[inline]
    pub(super) fn set<J: Journal>(&mut self, v: VertexId, provenance: Provenance, j: &mut J) {
        if let Some(i) = v.index().checked_sub(self.first) {
            self.provenances.set(i, provenance, j);
        }
    }

    /// The parameter of a vertex on a segment, if its provenance says that it lies there.
    #[inline]
    pub(super) fn parameter_on(&self, segment: SegmentId, v: VertexId) -> Option<f64> {
        v.index().checked_sub(self.first).and_then(|i| self.provenances.parameter_on(segment, i))
    }

    /// How many of three vertices are neither the input's nor free. Added up without branches: the answers are
    /// unpredictable.
    #[inline]
    pub(super) fn count_bound(&self, vertices: [VertexId; 3]) -> usize {
        // Of the input, the number wraps around, and no vertex has such a one.
        let is_bound = |v: VertexId| self.provenances.is_bound(v.index().wrapping_sub(self.first));
        vertices.into_iter().map(|v| usize::from(is_bound(v))).sum()
    }

    /// Puts back one entry.
    pub(super) fn undo(&mut self, entry: Entry) {
        self.provenances.undo(entry);
    }
}

/// Provenances of the vertices after the input: two words for each that is not free, or was not once. Most are free.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Provenances {
    words: Vec<[u64; 2]>,
    /// Where the words of each vertex lie, counted from 1; 0 for none. Those after the last are free.
    places: Vec<u32>,
    /// One bit a vertex: whether it is not free. Refinement reads it for every corner of every bad triangle.
    bound: Vec<u64>,
}

impl Provenances {
    /// The provenance of the `i`-th vertex after the input.
    fn get(&self, i: usize) -> Provenance {
        self.place(i).map_or(Provenance::Free, |place| Provenance::from_words(self.words[place]))
    }

    /// Whether the `i`-th vertex after the input is not free.
    #[inline]
    fn is_bound(&self, i: usize) -> bool {
        self.bound.get(i / 64).is_some_and(|bits| bits >> (i % 64) & 1 == 1)
    }

    /// The parameter of the `i`-th vertex after the input, if it is on this segment by its provenance.
    #[inline]
    fn parameter_on(&self, segment: SegmentId, i: usize) -> Option<f64> {
        let [kind, place] = self.words[self.place(i)?];
        let is_on = matches!(kind & 0xff, ON_SEGMENT | SHELL_AROUND_START | SHELL_AROUND_END);
        (is_on && SegmentId((kind >> 8) as u32) == segment).then(|| f64::from_bits(place))
    }

    /// Sets the provenance of the `i`-th vertex after the input, through the journal.
    #[inline(always)] // For each new vertex; nearly all are free, and were.
    fn set<J: Journal>(&mut self, i: usize, new: Provenance, j: &mut J) {
        let place = self.place(i);
        if place.is_some() || !new.is_free() {
            self.set_words(i, place, new.to_words(), j);
        }
    }

    /// Sets the words of a vertex, which lie at `place` if it has any.
    #[inline(never)]
    fn set_words<J: Journal>(&mut self, i: usize, place: Option<usize>, new: [u64; 2], j: &mut J) {
        let place = place.unwrap_or_else(|| self.make_room(i, j));
        let old = self.words[place];
        if old == new {
            return;
        }
        if J::ACTIVE {
            j.note(columns::PROVENANCE_KIND, i as u32, old[0]);
            j.note(columns::PROVENANCE_PLACE, i as u32, old[1]);
        }
        self.words[place] = new;
        self.note_bound(i, new[0]);
    }

    /// Where the words of a vertex lie, if it has any.
    #[inline]
    fn place(&self, i: usize) -> Option<usize> {
        self.places.get(i).and_then(|&place| (place as usize).checked_sub(1))
    }

    /// Words for a vertex that has none, which say that it is free.
    fn make_room<J: Journal>(&mut self, i: usize, j: &mut J) -> usize {
        if i >= self.places.len() {
            if J::ACTIVE {
                j.note(columns::PROVENANCE_APPENDED, self.places.len() as u32, 0);
            }
            self.places.resize(i + 1, 0);
            self.bound.resize(self.places.len().div_ceil(64), 0);
        }
        if J::ACTIVE {
            j.note(columns::PROVENANCE_STORED, i as u32, 0);
        }
        self.words.push(FREE);
        self.places[i] = self.words.len() as u32;
        self.words.len() - 1
    }

    /// Puts back one entry.
    fn undo(&mut self, entry: Entry) {
        let i = entry.index as usize;
        match (entry.column, self.place(i)) {
            (columns::PROVENANCE_KIND, Some(place)) => {
                self.words[place][0] = entry.old;
                self.note_bound(i, entry.old);
            }
            (columns::PROVENANCE_PLACE, Some(place)) => self.words[place][1] = entry.old,
            (columns::PROVENANCE_STORED, _) => {
                self.words.pop();
                self.places[i] = 0;
            }
            // They were appended free: their bits are not set any more.
            _ => {
                self.places.truncate(i);
                self.bound.truncate(i.div_ceil(64));
            }
        }
    }

    /// Sets the bit of a vertex by the first of its words.
    #[inline]
    fn note_bound(&mut self, i: usize, kind: u64) {
        let (bits, bit) = (&mut self.bound[i / 64], 1 << (i % 64));
        if kind == FREE[0] { *bits &= !bit } else { *bits |= bit }
    }
}

/// The words of a free vertex.
const FREE: [u64; 2] = [1, 0];
/// The low bytes of the provenances that have a parameter on a segment.
const ON_SEGMENT: u64 = 2;
const SHELL_AROUND_START: u64 = 4;
const SHELL_AROUND_END: u64 = 5;

impl Provenance {
    /// Kind in the low byte, segment in the middle, circle on top; parameter or second segment.
    fn to_words(self) -> [u64; 2] {
        match self {
            Self::Input => [0, 0],
            Self::Free => FREE,
            Self::OnSegment { segment, t } => [ON_SEGMENT | u64::from(segment.0) << 8, t.to_bits()],
            Self::Crossing { segments: [a, b] } => [3 | u64::from(a.0) << 8, u64::from(b.0)],
            Self::Shell { segment, t, around_end, shell } => {
                let circle = u64::from(u16::from_ne_bytes(shell.to_ne_bytes())) << 40;
                let kind = if around_end { SHELL_AROUND_END } else { SHELL_AROUND_START };
                [kind | u64::from(segment.0) << 8 | circle, t.to_bits()]
            }
        }
    }

    #[allow(clippy::cast_possible_truncation, reason = "each field is cut out of its own bits")]
    fn from_words([kind, place]: [u64; 2]) -> Self {
        let segment = SegmentId((kind >> 8) as u32);
        match kind & 0xff {
            0 => Self::Input,
            ON_SEGMENT => Self::OnSegment { segment, t: f64::from_bits(place) },
            3 => Self::Crossing { segments: [segment, SegmentId(place as u32)] },
            k @ (SHELL_AROUND_START | SHELL_AROUND_END) => {
                let shell = i16::from_ne_bytes(((kind >> 40) as u16).to_ne_bytes());
                Self::Shell { segment, t: f64::from_bits(place), around_end: k == SHELL_AROUND_END, shell }
            }
            _ => Self::Free,
        }
    }
}
