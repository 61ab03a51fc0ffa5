//! Taking changes back.

use super::triangulation::{Closure, Triangulation};
use crate::mesh::{Checkpoint, Column, Entry, Journal, UndoLog, VertexId};

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
            j.note(Column::State, 0, pack(self.dimension, self.closure, self.lone));
        }
        (self.dimension, self.closure, self.lone) = (dimension, closure, lone);
    }

    /// Puts back everything that was overwritten since `to`.
    ///
    /// # Guarantees
    /// Every array, its length, dead slots and free lists are what they were at the checkpoint.
    ///
    /// # Complexity
    /// Linear in the entries noted since.
    pub fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        while let Some(entry) = log.pop_since(to) {
            self.undo(entry);
        }
    }

    /// Puts back one entry; says whether the column is known here.
    pub(crate) fn undo(&mut self, entry: Entry) -> bool {
        let i = entry.index as usize;
        match entry.column {
            Column::X => self.points[i].x = f64::from_bits(entry.old),
            Column::Y => self.points[i].y = f64::from_bits(entry.old),
            Column::State => self.unpack(entry.old),
            Column::DuplicateForgotten => self.note_duplicate(VertexId(entry.index), entry.old),
            Column::VertexAppended => {
                self.points.truncate(i);
                return self.mesh.undo(entry);
            }
            _ => return self.mesh.undo(entry),
        }
        true
    }

    #[allow(clippy::cast_possible_truncation, reason = "the journal widened a vertex")]
    fn note_duplicate(&mut self, duplicate: VertexId, representative: u64) {
        let pair = (duplicate, VertexId(representative as u32));
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
