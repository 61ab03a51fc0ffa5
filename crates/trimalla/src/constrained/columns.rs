//! The columns of this room in a journal: see [`Column`].

use crate::half_edge::{Column, Room};

const fn column(number: u8) -> Column {
    Column::of(Room::Constrained, number)
}

/// Classes of marks were added, lists from `index` on, spans of lines from `old` on.
pub(super) const CLASSES: Column = column(0);
/// Input segments were added, from `index` on.
pub(super) const SEGMENT: Column = column(1);
/// A line of overlapping segments was added.
pub(super) const LINE_ADDED: Column = column(2);
/// The two ends of a line of overlapping segments.
pub(super) const LINE_ENDS: Column = column(3);
/// A segment joined a line of overlapping segments; `index` is the segment.
pub(super) const LINE_MEMBER: Column = column(4);
/// A line of overlapping segments was connected to another one.
pub(super) const LINE_CONNECTED: Column = column(5);
/// A line of overlapping segments was closed.
pub(super) const LINE_CLOSED: Column = column(6);
/// A member of a line of overlapping segments was removed; `index` is the segment.
pub(super) const LINE_MEMBER_REMOVED: Column = column(7);
/// Vertices from `index` on were given room for a provenance.
pub(super) const PROVENANCE_APPENDED: Column = column(8);
/// A vertex, free until then, got its first words of provenance.
pub(super) const PROVENANCE_STORED: Column = column(9);
/// First word of a vertex's provenance.
pub(super) const PROVENANCE_KIND: Column = column(10);
/// Second word of a vertex's provenance.
pub(super) const PROVENANCE_PLACE: Column = column(11);
/// Vertex `index` has split an edge of the boundary, which the triangles outside follow.
pub(super) const BOUNDARY_SPLIT: Column = column(12);
/// The state of the outside: `index` is whether it is thin, `old` holds the bits of a length.
pub(super) const OUTSIDE: Column = column(13);
/// A region was added.
pub(super) const REGION_ADDED: Column = column(14);
/// Region `index` was removed, with the attribute whose bits `old` holds.
pub(super) const REGION_REMOVED: Column = column(15);
/// The area bound that region `index` had, as bits.
pub(super) const REGION_AREA: Column = column(16);
