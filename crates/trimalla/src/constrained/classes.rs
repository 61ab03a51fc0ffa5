//! Classes: the input segments that an edge is part of.
//!
//! A constrained edge carries a mark, which names a *class*: the input segments that run along the edge. Nearly all
//! classes are of one segment. Where segments overlap on one line, the class is a span of that line (see `lines.rs`),
//! and its segments are computed. Where segments that are not on one line share an edge, for rounding, the class lists
//! them.

use std::collections::BTreeMap;

use super::columns;
use super::lines::{Lines, Span};
use crate::drawing::SegmentId;
use crate::half_edge::{Entry, Journal, VertexId};

/// The bit that is set in the mark of a span; the other bits are its number.
const SPAN: u32 = 1 << 31;

/// The classes of marks.
///
/// A list is a sorted list of input segments. Lists of one segment are found by a look-up, and no class has an
/// allocation of its own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Classes {
    /// The members of all lists, one list behind the other.
    members: Vec<SegmentId>,
    /// Where each list ends.
    ends: Vec<u32>,
    /// The mark of the list of just this segment; 0 where there is none.
    alone: Vec<u32>,
    /// The mark of each list of none or several, so that equal lists share one.
    class_of: BTreeMap<Vec<SegmentId>, u32>,
    /// The lines on which segments overlap.
    pub(super) lines: Lines,
}

/// How many classes there are of either kind.
#[derive(Clone, Copy, Debug)]
struct ClassCount {
    lists: u32,
    spans: u32,
}

/// What a mark names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class<'a> {
    /// A list of segments, sorted.
    List(&'a [SegmentId]),
    /// The segments of a line that cover a span.
    Span(Span),
}

impl Classes {
    /// The mark of an edge that belongs to exactly these segments, sorted; a new class where needed.
    ///
    /// The empty list marks edges that bound the domain without being part of any segment.
    pub(super) fn mark_of<J: Journal>(&mut self, segments: &[SegmentId], j: &mut J) -> u32 {
        let known = self.existing_mark_of(segments);
        if known != 0 {
            return known;
        }
        self.note_count(j);
        self.members.extend_from_slice(segments);
        self.ends.push(self.members.len() as u32);
        let mark = self.ends.len() as u32;
        match segments {
            [segment] => {
                let at = segment.index();
                if self.alone.len() <= at {
                    self.alone.resize(at + 1, 0);
                }
                self.alone[at] = mark;
            }
            _ => drop(self.class_of.insert(segments.to_vec(), mark)),
        }
        mark
    }

    /// Notes how many classes there are, as one is about to be added.
    fn note_count<J: Journal>(&self, j: &mut J) {
        if J::ACTIVE {
            let ClassCount { lists, spans } = self.count();
            j.note(columns::CLASSES, lists, u64::from(spans));
        }
    }

    /// The mark of exactly these segments, 0 where they have no class.
    fn existing_mark_of(&self, segments: &[SegmentId]) -> u32 {
        let mark = match segments {
            [segment] => self.alone.get(segment.index()),
            _ => self.class_of.get(segments),
        };
        mark.copied().unwrap_or(0)
    }

    /// The mark of a new span of a line, between two vertices on it, the lexicographically lower one first; `first` is
    /// the lowest segment that covers it, and a member of the line.
    pub(super) fn mark_of_span<J: Journal>(&mut self, ends: [VertexId; 2], first: SegmentId, j: &mut J) -> u32 {
        self.note_count(j);
        SPAN | self.lines.add_span(ends, first) as u32
    }

    /// What a mark names; the empty list for mark 0.
    #[inline]
    pub(super) fn class(&self, mark: u32) -> Class<'_> {
        let span = if mark & SPAN == 0 { None } else { self.lines.span((mark & !SPAN) as usize) };
        span.map_or_else(|| Class::List(self.list(mark)), Class::Span)
    }

    /// The segments of a mark that names a list, sorted; none for any other.
    fn list(&self, mark: u32) -> &[SegmentId] {
        let Some(class) = mark.checked_sub(1).map(|class| class as usize) else { return &[] };
        let Some(&end) = self.ends.get(class) else { return &[] };
        let start = class.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.members[start as usize..end as usize]
    }

    /// The line of a mark that names a span.
    pub(super) fn line_of_mark(&self, mark: u32) -> Option<u32> {
        match self.class(mark) {
            Class::Span(span) => Some(self.lines.line_of_span(span)),
            Class::List(_) => None,
        }
    }

    /// Closes the line of a mark that names a span: no segment joins it from now on.
    pub(super) fn close_line_of<J: Journal>(&mut self, mark: u32, j: &mut J) {
        if let Some(line) = self.line_of_mark(mark) {
            self.lines.close(line, j);
        }
    }

    /// Number of classes.
    fn count(&self) -> ClassCount {
        ClassCount { lists: self.ends.len() as u32, spans: self.lines.spans() as u32 }
    }

    /// Puts back one entry.
    pub(super) fn undo(&mut self, entry: Entry) {
        match entry.column {
            columns::CLASSES => self.truncate(ClassCount { lists: entry.index, spans: entry.old as u32 }),
            _ => self.lines.undo(entry),
        }
    }

    /// Drops the newest classes, down to that many.
    fn truncate(&mut self, count: ClassCount) {
        self.lines.truncate_spans(count.spans as usize);
        while self.ends.len() > count.lists as usize {
            let list = self.list(self.ends.len() as u32).to_vec();
            match list[..] {
                [segment] => self.alone[segment.index()] = 0,
                _ => drop(self.class_of.remove(&list)),
            }
            self.ends.pop();
            self.members.truncate(self.members.len() - list.len());
        }
        while self.alone.last() == Some(&0) {
            self.alone.pop();
        }
    }
}
