//! Segments that overlap on one line; each line is stored once.
//!
//! Of 10,000 nested segments on a line, each of the 20,000 edges is part of up to 10,000. Lists of segments an edge
//! would be quadratic. So an edge of such a line names the two vertices between which it lies, and the segments along
//! the edge are those of the line that reach from one to the other:
//!
//! ```text
//!     segment 0    a ═══════════════════ d        line: members 0 1 2, ends a d
//!     segment 1          b ═════════════ d        span b–c: covered by 0 and 1
//!     segment 2    a ═════════════ c
//! ```
//!
//! # Invariants
//! 1. The ends of all members, and both vertices of every span, lie exactly on one straight line. Vertices are compared
//!    lexicographically along it, so that coverage is decided exactly.
//! 2. As long as a line is *open*, every edge of its members carries a span of the line, and the members cover one
//!    stretch without gaps. New segments join open lines only.
//! 3. A line closes when one of its edges needs a list of its own, or a member is removed. What its spans say stays
//!    true.
//!
//! Lines and spans cost some twenty bytes for each segment: what names a span is in one place, and the list of spans
//! grows by [blocks](Blocks).
//!
//! Lines that a later segment connects become a tree, whose root stands for all: undoing a connection is one entry.

use std::collections::BTreeSet;

use super::columns;
use crate::drawing::SegmentId;
use crate::half_edge::{Entry, Journal, VertexId};

/// The segments of one line that overlap.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Line {
    /// The line that it was connected to; itself for a root.
    parent: u32,
    /// The lines connected to it.
    children: Vec<u32>,
    /// Its own segments, in the order of their numbers.
    members: Vec<SegmentId>,
    /// Segments of it and of all lines below it.
    size: u32,
    /// The stretch that the members cover, lexicographically lower end first.
    ends: [VertexId; 2],
    /// Whether segments may join.
    is_open: bool,
}

/// A stretch of a line between two of its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    /// The vertices between which the edge lies, lexicographically lower first.
    pub(super) ends: [VertexId; 2],
    /// The lowest segment that covers it, as long as that is not removed: a member of its line in any case.
    pub(super) first: SegmentId,
}

/// A list that grows by blocks: one that doubles takes, while it moves, three times the room of what is in it.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Blocks<T> {
    /// All blocks but the last are full.
    blocks: Vec<Vec<T>>,
}

impl<T> Default for Blocks<T> {
    fn default() -> Self {
        Self { blocks: Vec::new() }
    }
}

impl<T> Blocks<T> {
    /// The entries of a block.
    const LEN: usize = 1 << 10;

    fn len(&self) -> usize {
        let full = self.blocks.len().saturating_sub(1) * Self::LEN;
        full + self.blocks.last().map_or(0, Vec::len)
    }

    fn get(&self, i: usize) -> Option<&T> {
        self.blocks.get(i / Self::LEN)?.get(i % Self::LEN)
    }

    fn push(&mut self, value: T) {
        let is_first = self.blocks.is_empty();
        match self.blocks.last_mut().filter(|block| block.len() < Self::LEN) {
            Some(block) => block.push(value),
            None => {
                // Most drawings have few spans, so that the first block starts small.
                let mut block = Vec::with_capacity(if is_first { 0 } else { Self::LEN });
                block.push(value);
                self.blocks.push(block);
            }
        }
    }

    fn truncate(&mut self, len: usize) {
        self.blocks.truncate(len.div_ceil(Self::LEN));
        if self.len() > len {
            if let Some(last) = self.blocks.last_mut() {
                last.truncate(len - (len - 1) / Self::LEN * Self::LEN);
            }
        }
    }
}

/// All lines on which segments overlap.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Lines {
    /// The line of each segment, counted from 1; 0, or missing, for a segment that overlaps no other.
    line_of: Vec<u32>,
    lines: Vec<Line>,
    spans: Blocks<Span>,
    /// Members that were removed.
    removed: BTreeSet<SegmentId>,
}

impl Lines {
    /// Number of spans.
    pub(super) fn spans(&self) -> usize {
        self.spans.len()
    }

    /// Span number `i`.
    pub(super) fn span(&self, i: usize) -> Option<Span> {
        self.spans.get(i).copied()
    }

    /// Adds a span that a member of its line covers; returns its number.
    pub(super) fn add_span(&mut self, ends: [VertexId; 2], first: SegmentId) -> usize {
        self.spans.push(Span { ends, first });
        self.spans.len() - 1
    }

    /// Drops the newest spans, down to that many.
    pub(super) fn truncate_spans(&mut self, len: usize) {
        self.spans.truncate(len);
    }

    /// The line that stands for a line and all connected to it.
    ///
    /// # Complexity
    /// Logarithmic: the smaller tree is always put below the larger one.
    fn root(&self, mut line: u32) -> u32 {
        while self.lines[line as usize].parent != line {
            line = self.lines[line as usize].parent;
        }
        line
    }

    /// The line of a span.
    pub(super) fn line_of_span(&self, span: Span) -> u32 {
        self.root(self.line_of[span.first.index()] - 1)
    }

    /// The line of a segment, if it overlaps others.
    pub(super) fn line_of_segment(&self, segment: SegmentId) -> Option<u32> {
        let line = self.line_of.get(segment.index())?.checked_sub(1)?;
        Some(self.root(line))
    }

    /// Makes room for so many segments, so that the list of their lines does not grow by doubling.
    pub(super) fn reserve(&mut self, segments: usize) {
        self.line_of.reserve_exact(segments.saturating_sub(self.line_of.len()));
    }

    /// Whether segments may join a line.
    pub(super) fn is_open(&self, line: u32) -> bool {
        self.lines[line as usize].is_open
    }

    /// The stretch that the members of a line cover, lexicographically lower end first.
    pub(super) fn ends(&self, line: u32) -> [VertexId; 2] {
        self.lines[line as usize].ends
    }

    /// The segments of a line and of all connected to it, removed ones left out, in no order.
    pub(super) fn members(&self, line: u32) -> impl Iterator<Item = SegmentId> + '_ {
        let mut open = vec![line];
        let lines = std::iter::from_fn(move || {
            let line = &self.lines[open.pop()? as usize];
            open.extend_from_slice(&line.children);
            Some(&line.members)
        });
        lines.flatten().copied().filter(|segment| !self.is_removed(*segment))
    }

    /// Whether a member was removed.
    pub(super) fn is_removed(&self, segment: SegmentId) -> bool {
        self.removed.contains(&segment)
    }

    /// Makes a line without members that reaches from the first to the second of two vertices.
    pub(super) fn add<J: Journal>(&mut self, ends: [VertexId; 2], j: &mut J) -> u32 {
        let line = self.lines.len() as u32;
        if J::ACTIVE {
            j.note(columns::LINE_ADDED, line, 0);
        }
        self.lines.push(Line { parent: line, children: Vec::new(), members: Vec::new(), size: 0, ends, is_open: true });
        line
    }

    /// Sets the stretch that the members of a line cover.
    pub(super) fn set_ends<J: Journal>(&mut self, line: u32, ends: [VertexId; 2], j: &mut J) {
        let old = std::mem::replace(&mut self.lines[line as usize].ends, ends);
        if J::ACTIVE {
            j.note(columns::LINE_ENDS, line, u64::from(old[0].0) << 32 | u64::from(old[1].0));
        }
    }

    /// Adds a segment, which is a member of no line so far, to a line.
    pub(super) fn enroll<J: Journal>(&mut self, line: u32, segment: SegmentId, j: &mut J) {
        if J::ACTIVE {
            j.note(columns::LINE_MEMBER, segment.0, 0);
        }
        if self.line_of.len() <= segment.index() {
            self.line_of.resize(segment.index() + 1, 0);
        }
        self.line_of[segment.index()] = line + 1;
        self.lines[line as usize].members.push(segment);
        self.lines[line as usize].size += 1;
    }

    /// Connects two lines; returns the one that stands for both.
    pub(super) fn connect<J: Journal>(&mut self, a: u32, b: u32, j: &mut J) -> u32 {
        if a == b {
            return a;
        }
        let size = |line: u32| self.lines[line as usize].size;
        let (upper, lower) = if size(a) < size(b) { (b, a) } else { (a, b) };
        if J::ACTIVE {
            j.note(columns::LINE_CONNECTED, lower, 0);
        }
        self.lines[upper as usize].size += self.lines[lower as usize].size;
        self.lines[upper as usize].children.push(lower);
        self.lines[lower as usize].parent = upper;
        upper
    }

    /// Closes a line: no segment joins it from now on.
    pub(super) fn close<J: Journal>(&mut self, line: u32, j: &mut J) {
        if std::mem::replace(&mut self.lines[line as usize].is_open, false) && J::ACTIVE {
            j.note(columns::LINE_CLOSED, line, 0);
        }
    }

    /// Removes a member of a line, which closes it.
    pub(super) fn remove<J: Journal>(&mut self, segment: SegmentId, j: &mut J) {
        let Some(line) = self.line_of_segment(segment) else { return };
        self.close(line, j);
        if self.removed.insert(segment) && J::ACTIVE {
            j.note(columns::LINE_MEMBER_REMOVED, segment.0, 0);
        }
    }

    /// Puts back one entry.
    pub(super) fn undo(&mut self, entry: Entry) {
        let i = entry.index as usize;
        match entry.column {
            columns::LINE_ADDED => self.lines.truncate(i),
            columns::LINE_ENDS => {
                let [a, b] = [entry.old >> 32, entry.old & u64::from(u32::MAX)];
                self.lines[i].ends = [a, b].map(|v| VertexId(v as u32));
            }
            columns::LINE_MEMBER => {
                let line = &mut self.lines[self.line_of[i] as usize - 1];
                line.members.pop();
                line.size -= 1;
                self.line_of[i] = 0;
                while self.line_of.last() == Some(&0) {
                    self.line_of.pop();
                }
            }
            columns::LINE_CONNECTED => {
                let upper = std::mem::replace(&mut self.lines[i].parent, entry.index) as usize;
                self.lines[upper].children.pop();
                self.lines[upper].size -= self.lines[i].size;
            }
            columns::LINE_CLOSED => self.lines[i].is_open = true,
            columns::LINE_MEMBER_REMOVED => drop(self.removed.remove(&SegmentId(entry.index))),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_of_blocks_is_a_list() {
        let (mut blocks, mut list) = (Blocks::<usize>::default(), Vec::new());
        for len in [0, 1, 1023, 1024, 1025, 3000, 2048, 2047, 1024, 1, 0, 2] {
            while list.len() < len {
                blocks.push(list.len());
                list.push(list.len());
            }
            blocks.truncate(len);
            list.truncate(len);
            assert_eq!(blocks.len(), len);
            assert!((0..len + 2).all(|i| blocks.get(i) == list.get(i)), "{len}");
            let mut again = Blocks::default();
            list.iter().for_each(|&i| again.push(i));
            assert!(blocks == again, "{len}: how it came about does not count");
        }
    }
}
