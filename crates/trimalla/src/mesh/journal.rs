//! The journal: what was overwritten, so that it can be put back.
//!
//! Every array of a triangulation is written through a setter that first shows the journal the old
//! entry. Taking a change back replays those entries in reverse order, so the arrays, their lengths
//! and the free lists return exactly, whatever the operators did. [`NoJournal`] notes nothing and
//! compiles to nothing; bulk builds use it.

/// The array that an [`Entry`] belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Column {
    /// `origin` of a half-edge.
    Origin,
    /// `twin` of a half-edge.
    Twin,
    /// Constraint mark of a half-edge.
    Mark,
    /// Marks began to be kept.
    MarksAdded,
    /// Region of a face.
    Region,
    /// Regions began to be kept.
    RegionsAdded,
    /// The half-edge a vertex keeps.
    Outgoing,
    /// A face slot was appended.
    FaceAppended,
    /// A face slot was pushed onto the free list.
    FaceFreed,
    /// A face slot was popped off the free list; `old` is the slot.
    FaceReused,
    /// A vertex slot was appended.
    VertexAppended,
    /// A vertex slot was pushed onto the free list.
    VertexFreed,
    /// A vertex slot was popped off the free list; `old` is the slot.
    VertexReused,
    /// Bits of an abscissa.
    X,
    /// Bits of an ordinate.
    Y,
    /// State of the triangulation itself (closure, lone vertex); meaning known to its owner.
    State,
    /// Classes of constraint marks were added, lists from `index` on, spans of lines from `old` on.
    Constraint,
    /// Input segments were added, from `index` on.
    Segment,
    /// A line of overlapping segments was added.
    LineAdded,
    /// The two ends of a line of overlapping segments.
    LineEnds,
    /// A segment joined a line of overlapping segments; `index` is the segment.
    LineMember,
    /// A line of overlapping segments was connected to another one.
    LineConnected,
    /// A line of overlapping segments was closed.
    LineClosed,
    /// A member of a line of overlapping segments was removed; `index` is the segment.
    LineMemberRemoved,
    /// Vertices from `index` on were given room for a provenance.
    ProvenanceAppended,
    /// A vertex got its first provenance but that of a free one.
    ProvenanceStored,
    /// First word of a vertex's provenance.
    ProvenanceKind,
    /// Second word of a vertex's provenance.
    ProvenancePlace,
    /// Vertex `index` no longer duplicates vertex `old`.
    DuplicateForgotten,
    /// Vertex `index` came to, or left, the border of the domain: what lies outside has noted it.
    Outside,
}

/// One overwritten entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Which array.
    pub column: Column,
    /// Where in it.
    pub index: u32,
    /// What stood there.
    pub old: u64,
}

/// Receives overwritten entries from the setters.
pub trait Journal {
    /// Whether anything is noted; setters skip the call where not.
    const ACTIVE: bool;

    /// Notes that `old` stood at `index` of `column`.
    fn note(&mut self, column: Column, index: u32, old: u64);
}

/// Notes nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoJournal;

impl Journal for NoJournal {
    const ACTIVE: bool = false;

    #[inline(always)]
    fn note(&mut self, _: Column, _: u32, _: u64) {}
}

/// A place in an [`UndoLog`] to which changes can be taken back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Checkpoint(pub(crate) usize);

/// A journal that remembers.
#[derive(Clone, Debug, Default)]
pub struct UndoLog {
    entries: Vec<Entry>,
}

impl UndoLog {
    /// An empty log.
    #[must_use]
    pub const fn new() -> Self {
        Self { entries: Vec::new() }
    }

    /// The present, as a place to come back to.
    #[must_use]
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint(self.entries.len())
    }

    /// Number of overwritten entries held, 16 bytes each.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether nothing was noted.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// What was noted, oldest first.
    pub fn entries(&self) -> impl DoubleEndedIterator<Item = &Entry> {
        self.entries.iter()
    }

    /// Forgets everything: what was noted can no longer be taken back.
    pub fn clear(&mut self) {
        self.entries.clear();
    }

    /// Removes and returns the newest entry noted since `to`.
    pub fn pop_since(&mut self, to: Checkpoint) -> Option<Entry> {
        if self.entries.len() > to.0 { self.entries.pop() } else { None }
    }
}

impl Journal for UndoLog {
    const ACTIVE: bool = true;

    #[inline]
    fn note(&mut self, column: Column, index: u32, old: u64) {
        self.entries.push(Entry { column, index, old });
    }
}
