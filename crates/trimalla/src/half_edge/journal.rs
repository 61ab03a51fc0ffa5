//! The journal: overwritten entries, so that a rollback can put them back.
//!
//! Every array of a triangulation is written through a setter that first shows the journal the old
//! entry. Taking a change back replays those entries in reverse order, so the arrays, their lengths
//! and the free lists return exactly, whatever the operators did. [`NoJournal`] notes nothing and
//! compiles to nothing; bulk builds use it.

use super::ids::VertexId;

/// What an [`Entry`] is about: an array, or a list that grew or shrank.
///
/// Each room declares the columns of its own data, so that no room knows those of the rooms above it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column(u8);

/// The rooms whose data the journal records, the lowest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Room {
    Mesh,
    Triangulation,
    Constrained,
}

impl Column {
    /// No room has more columns than this.
    const MOST: u8 = 64;

    /// A column of a room, by its number there.
    pub(crate) const fn of(room: Room, number: u8) -> Self {
        assert!(number < Self::MOST, "each room has a range of its own");
        Self(room as u8 * Self::MOST + number)
    }
}

/// The columns of the half-edges.
pub(crate) mod columns {
    use super::{Column, Room};

    const fn column(number: u8) -> Column {
        Column::of(Room::Mesh, number)
    }

    /// `origin` of a half-edge.
    pub(crate) const ORIGIN: Column = column(0);
    /// `twin` of a half-edge.
    pub(crate) const TWIN: Column = column(1);
    /// Constraint mark of a half-edge.
    pub(crate) const MARK: Column = column(2);
    /// Marks began to be kept.
    pub(crate) const MARKS_ADDED: Column = column(3);
    /// Region of a face.
    pub(crate) const REGION: Column = column(4);
    /// Regions began to be kept.
    pub(crate) const REGIONS_ADDED: Column = column(5);
    /// The half-edge a vertex keeps.
    pub(crate) const OUTGOING: Column = column(6);
    /// A face slot was appended.
    pub(crate) const FACE_APPENDED: Column = column(7);
    /// A face slot was pushed onto the free list.
    pub(crate) const FACE_FREED: Column = column(8);
    /// A face slot was popped off the free list; `old` is the slot.
    pub(crate) const FACE_REUSED: Column = column(9);
    /// A vertex slot was appended.
    pub(crate) const VERTEX_APPENDED: Column = column(10);
    /// A vertex slot was pushed onto the free list.
    pub(crate) const VERTEX_FREED: Column = column(11);
    /// A vertex slot was popped off the free list; `old` is the slot.
    pub(crate) const VERTEX_REUSED: Column = column(12);
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
#[doc(alias = "undo")]
pub trait Journal {
    /// Whether the journal records anything; if not, setters skip the call.
    const ACTIVE: bool;

    /// Notes that `old` stood at `index` of `column`.
    fn note(&mut self, column: Column, index: u32, old: u64);
}

/// A journal that records nothing, for changes that are never taken back.
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

/// A journal that records every overwritten entry.
#[doc(alias = "undo")]
#[doc(alias = "rollback")]
#[doc(alias = "deshacer")]
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

    /// The present place in the log, for a later rollback.
    #[must_use]
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint(self.entries.len())
    }

    /// Number of overwritten entries held, 16 bytes each.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether nothing is recorded.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The vertices of which the mesh kept another half-edge, and those whose slots were taken or freed: all that have
    /// come into use or gone out of it are among them, some several times.
    pub(crate) fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        let is_of_vertex = |column: Column| {
            let columns = [columns::OUTGOING, columns::VERTEX_APPENDED, columns::VERTEX_FREED, columns::VERTEX_REUSED];
            columns.contains(&column)
        };
        self.entries.iter().filter(move |entry| is_of_vertex(entry.column)).map(|entry| VertexId(entry.index))
    }

    /// The recorded entries, oldest first.
    pub fn entries(&self) -> impl DoubleEndedIterator<Item = &Entry> {
        self.entries.iter()
    }

    /// What was noted since a checkpoint, oldest first.
    pub(crate) fn entries_since(&self, here: Checkpoint) -> impl DoubleEndedIterator<Item = &Entry> {
        self.entries.iter().skip(here.0)
    }

    /// Frees the memory that the entries do not need.
    pub fn shrink_to_fit(&mut self) {
        self.entries.shrink_to_fit();
    }

    /// Drops all entries: changes until now can no longer be taken back.
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
