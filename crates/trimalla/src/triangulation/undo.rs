//! Taking changes back.

use super::triangulation::{Closure, Triangulation};
use crate::half_edge::{Checkpoint, Entry, Journal, UndoLog, VertexId, columns as mesh_columns};

/// The columns of coordinates and of the state.
pub(super) mod columns {
    use crate::half_edge::{Column, Room};

    const fn column(number: u8) -> Column {
        Column::of(Room::Triangulation, number)
    }

    /// Bits of an abscissa.
    pub(crate) const X: Column = column(0);
    /// Bits of an ordinate.
    pub(crate) const Y: Column = column(1);
    /// Dimension, closure and lone vertex.
    pub(crate) const STATE: Column = column(2);
    /// Vertex `index` no longer duplicates vertex `old`.
    pub(crate) const DUPLICATE_FORGOTTEN: Column = column(3);
    /// Vertex `index` came to duplicate another one.
    pub(crate) const DUPLICATE_NOTED: Column = column(4);
}

/// Dimension, closure and lone vertex in one journal entry.
fn pack(dimension: i8, closure: Closure, lone: Option<VertexId>) -> u64 {
    let lone = lone.map_or(u64::from(u32::MAX), |v| u64::from(v.0));
    let dimension = u64::from((dimension + 1).unsigned_abs());
    lone | dimension << 32 | u64::from(closure == Closure::Domain) << 40
}

impl Triangulation {
    /// Sets dimension and lone vertex, through the journal.
    pub(crate) fn set_state<J: Journal>(&mut self, dimension: i8, closure: Closure, lone: Option<VertexId>, j: &mut J) {
        if J::ACTIVE {
            j.note(columns::STATE, 0, pack(self.dimension, self.closure, self.lone));
        }
        (self.dimension, self.closure, self.lone) = (dimension, closure, lone);
    }

    /// Puts back everything that was overwritten since `to`.
    ///
    /// # Guarantees
    /// Every array, its length, dead slots and free lists are what they were at the checkpoint.
    ///
    /// # Complexity
    /// Linear in the entries recorded since.
    pub fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        while let Some(entry) = log.pop_since(to) {
            self.undo(entry);
        }
    }

    /// The vertices that may have come into use, or gone out of it, by the changes of a log: ascending, each once.
    ///
    /// All others are in use if they were before. So whoever keeps something for each vertex looks at these alone.
    ///
    /// # Complexity
    /// n log n in the entries.
    #[must_use]
    pub fn vertices_changed(&self, log: &UndoLog) -> Vec<VertexId> {
        let lone_before = |entry: &Entry| {
            let before = (entry.column == columns::STATE).then_some(entry.old as u32);
            before.filter(|&v| v != u32::MAX).map(VertexId)
        };
        let mut vertices: Vec<VertexId> = log.vertices().collect();
        vertices.extend(log.entries().filter_map(lone_before));
        vertices.extend(self.lone);
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// Puts back one entry; returns whether this room has the column.
    pub(crate) fn undo(&mut self, entry: Entry) -> bool {
        let i = entry.index as usize;
        match entry.column {
            columns::X => self.points[i].x = f64::from_bits(entry.old),
            columns::Y => self.points[i].y = f64::from_bits(entry.old),
            columns::STATE => self.unpack(entry.old),
            columns::DUPLICATE_FORGOTTEN => {
                #[allow(clippy::cast_possible_truncation, reason = "the journal widened a vertex")]
                let representative = VertexId(entry.old as u32);
                self.put_duplicate((VertexId(entry.index), representative));
            }
            columns::DUPLICATE_NOTED => self.duplicates.retain(|(duplicate, _)| duplicate.0 != entry.index),
            mesh_columns::VERTEX_APPENDED => {
                self.points.truncate(i);
                return self.mesh.undo(entry);
            }
            _ => return self.mesh.undo(entry),
        }
        true
    }

    /// Puts a pair into the sorted list of duplicates.
    pub(super) fn put_duplicate(&mut self, pair: (VertexId, VertexId)) {
        let at = self.duplicates.partition_point(|other| *other < pair);
        self.duplicates.insert(at, pair);
    }

    #[allow(clippy::cast_possible_truncation, reason = "pack widened these fields")]
    fn unpack(&mut self, old: u64) {
        let lone = old as u32;
        self.lone = (lone != u32::MAX).then_some(VertexId(lone));
        self.dimension = ((old >> 32) & 0xff) as i8 - 1;
        self.closure = if old >> 40 & 1 == 1 { Closure::Domain } else { Closure::Hull };
    }
}
