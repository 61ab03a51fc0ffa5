//! One side of the new edge: a chain of corners from which ears are cut.

use super::criteria::Criterion;
use crate::geometry::{Orientation, orient2d};

/// Which way a chain turns around its polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hand {
    /// Left of the new edge, seen from its start: the polygon is to the right of the chain.
    Left,
    /// Right of the new edge.
    Right,
}

/// What became of the attempt to cut one more ear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Progress {
    /// An ear was cut.
    Cut,
    /// The last corner is no ear, or too bad a one.
    Stuck,
    /// Only the start is left: the polygon is triangulated.
    Done,
}

/// The corners of one side that are not cut off yet, from the start of the new edge on.
///
/// ```text
///     s                 the chain q a b c before the end s: c is convex, so b c s may be cut off; then b is tried.
///     │ ╲               Corners further back were tried before, when the next one came.
///     │   c
///     │   │
///     │   b
///     │  ╱
///     q a
/// ```
#[derive(Debug)]
pub(super) struct Chain {
    hand: Hand,
    corners: Vec<u32>,
    ears: Vec<[u32; 3]>,
    /// The corner that is farthest to the other side, seen from the start.
    limit: u32,
    /// The corners cut off for the end that is tried now, in this order.
    trial: Vec<u32>,
}

impl Chain {
    /// The chain from the start of the new edge to the first corner.
    pub(super) fn new(hand: Hand, start: u32, first: u32) -> Self {
        Self { hand, corners: vec![start, first], ears: Vec::new(), limit: first, trial: Vec::new() }
    }

    /// Whether a corner of this chain hides the end `s` from the start, or stands before it.
    pub(super) fn hides<C: Criterion>(&self, criterion: &C, s: u32) -> bool {
        let [q, s, limit] = [self.corners[0], s, self.limit].map(|v| criterion.point(v));
        let side = orient2d(q, s, limit);
        match self.hand {
            Hand::Left => side != Orientation::CounterClockwise,
            Hand::Right => side != Orientation::Clockwise,
        }
    }

    /// Its side of the new edge.
    pub(super) const fn hand(&self) -> Hand {
        self.hand
    }

    /// Cuts the last corner off before the end `s`, if that gives a triangle better than the bound.
    pub(super) fn cut<C: Criterion>(&mut self, criterion: &C, s: u32, bound: &C::Cost) -> Progress {
        let &[.., before, last] = &self.corners[..] else { return Progress::Done };
        let ear = match self.hand {
            Hand::Left => [s, last, before],
            Hand::Right => [before, last, s],
        };
        let [a, b, c] = criterion.corners(ear);
        let is_ear = orient2d(a, b, c) == Orientation::CounterClockwise;
        if !is_ear || criterion.compare(&criterion.cost(ear), bound).is_ge() {
            return Progress::Stuck;
        }
        self.corners.pop();
        self.trial.push(last);
        self.ears.push(ear);
        Progress::Cut
    }

    /// The end that was tried becomes the last corner.
    pub(super) fn push<C: Criterion>(&mut self, criterion: &C, s: u32) {
        if !self.hides(criterion, s) {
            self.limit = s;
        }
        self.trial.clear();
        self.corners.push(s);
    }

    /// The end that was tried belongs to the other chain: what was cut for it is put back.
    pub(super) fn undo(&mut self) {
        self.ears.truncate(self.ears.len() - self.trial.len());
        while let Some(corner) = self.trial.pop() {
            self.corners.push(corner);
        }
    }

    /// The triangles that were cut off.
    pub(super) fn into_ears(self) -> Vec<[u32; 3]> {
        self.ears
    }
}
