//! Which input segments an edge is part of.
//!
//! A constrained edge carries a mark: one more than the number of a *class*. A class lists the input
//! segments that run along the edge: one as a rule, several where segments overlap.

use std::collections::BTreeMap;

/// The classes of marks, each a sorted list of input segments.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Constraints {
    classes: Vec<Vec<u32>>,
    /// The class of each list, so that equal lists share one.
    class_of: BTreeMap<Vec<u32>, u32>,
}

impl Constraints {
    /// The mark of an edge that belongs to exactly these segments, sorted; a new class where needed.
    ///
    /// The empty list marks edges that bound the domain without being part of any segment.
    pub(crate) fn mark_of(&mut self, segments: &[u32]) -> u32 {
        if let Some(&class) = self.class_of.get(segments) {
            return class + 1;
        }
        let class = self.classes.len() as u32;
        self.classes.push(segments.to_vec());
        self.class_of.insert(segments.to_vec(), class);
        class + 1
    }

    /// The mark of exactly these segments, 0 where they have no class.
    pub(crate) fn existing_mark_of(&self, segments: &[u32]) -> u32 {
        self.class_of.get(segments).map_or(0, |class| class + 1)
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
        mark.checked_sub(1).and_then(|class| self.classes.get(class as usize)).map_or(&[], Vec::as_slice)
    }

    /// Number of classes.
    pub(crate) fn len(&self) -> usize {
        self.classes.len()
    }

    /// Forgets the newest classes, down to that many.
    pub(crate) fn truncate(&mut self, len: usize) {
        for list in self.classes.drain(len..) {
            self.class_of.remove(&list);
        }
    }
}
