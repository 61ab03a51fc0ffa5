//! Which input segments an edge is part of.
//!
//! A constrained edge carries a mark: one more than the number of a *class*. A class lists the input
//! segments that run along the edge: one as a rule, several where segments overlap.

use std::collections::BTreeMap;

/// The classes of marks, each a sorted list of input segments.
///
/// Nearly all are of one segment: those are found by a look-up, and no class has an allocation of its own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Constraints {
    /// The lists, one behind the other.
    members: Vec<u32>,
    /// Where the list of each class ends.
    ends: Vec<u32>,
    /// The mark of the class of just this segment; 0 where there is none.
    alone: Vec<u32>,
    /// The class of each list of none or several, so that equal lists share one.
    class_of: BTreeMap<Vec<u32>, u32>,
}

impl Constraints {
    /// The mark of an edge that belongs to exactly these segments, sorted; a new class where needed.
    ///
    /// The empty list marks edges that bound the domain without being part of any segment.
    pub(crate) fn mark_of(&mut self, segments: &[u32]) -> u32 {
        let known = self.existing_mark_of(segments);
        if known != 0 {
            return known;
        }
        self.members.extend_from_slice(segments);
        self.ends.push(self.members.len() as u32);
        let mark = self.ends.len() as u32;
        match segments {
            [segment] => {
                let at = *segment as usize;
                if self.alone.len() <= at {
                    self.alone.resize(at + 1, 0);
                }
                self.alone[at] = mark;
            }
            _ => drop(self.class_of.insert(segments.to_vec(), mark)),
        }
        mark
    }

    /// The mark of exactly these segments, 0 where they have no class.
    pub(crate) fn existing_mark_of(&self, segments: &[u32]) -> u32 {
        let mark = match segments {
            [segment] => self.alone.get(*segment as usize),
            _ => self.class_of.get(segments),
        };
        mark.copied().unwrap_or(0)
    }

    /// The mark of an edge of two marks: all segments of either.
    pub(crate) fn joined(&mut self, a: u32, b: u32) -> u32 {
        if a == 0 || a == b {
            return b;
        }
        let mut list = [self.segments(a), self.segments(b)].concat();
        list.sort_unstable();
        list.dedup();
        self.mark_of(&list)
    }

    /// The mark of an edge that has mark `mark` and is no longer part of `segment`; 0 where it is part of none.
    pub(crate) fn without_segment(&mut self, mark: u32, segment: u32) -> u32 {
        let list: Vec<u32> = self.segments(mark).iter().copied().filter(|&s| s != segment).collect();
        if list.is_empty() { 0 } else { self.mark_of(&list) }
    }

    /// The input segments of a mark, sorted; none for mark 0.
    pub(crate) fn segments(&self, mark: u32) -> &[u32] {
        let Some(class) = mark.checked_sub(1).map(|class| class as usize) else { return &[] };
        let Some(&end) = self.ends.get(class) else { return &[] };
        let start = class.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.members[start as usize..end as usize]
    }

    /// Number of classes.
    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// Forgets the newest classes, down to that many.
    pub(crate) fn truncate(&mut self, len: usize) {
        while self.ends.len() > len {
            let list = self.segments(self.ends.len() as u32).to_vec();
            match list[..] {
                [segment] => self.alone[segment as usize] = 0,
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
