//! Triangles of monotone pieces, cut off while the sweep finds the corners.
//!
//! A piece keeps a stack: the corners that still need triangles. They are the last corner of one chain before the
//! stack's own, and then a part of the other chain that is nowhere convex, the last corner on top.
//!
//! ```text
//!        u1 ------.------. v          u1, u2, u3, u4 is the stack, all but u1 of the lower chain.
//!         \ u2        .                A corner v of the upper chain sees them all:
//!          '.     .    u4              the triangles (u1, u2, v), (u2, u3, v), (u3, u4, v) are cut off.
//!            u3 '-----'
//! ```
//!
//! A corner of the stack's own chain sees those near the top, as long as the turn is convex.

use super::corners::Mark;
use super::sweep::{Cause, Chain, Pieces, VertexKind};
use crate::geometry::{BoundingBox, Orientation, Point, orient2d};
use crate::trace::{Shape, Trace};

/// No entry.
const NONE: u32 = u32::MAX;

/// An entry of a stack, and the one below it.
#[derive(Clone, Copy, Debug)]
struct Entry {
    mark: Mark,
    below: u32,
}

/// The stack of a piece.
#[derive(Clone, Copy, Debug)]
struct Stack {
    top: u32,
    chain: Chain,
}

/// The stacks of all pieces, which can be used again.
#[derive(Clone, Debug, Default)]
pub(super) struct Stacks {
    entries: Vec<Entry>,
    pieces: Vec<Stack>,
}

/// Cuts off triangles.
#[derive(Debug)]
pub(super) struct Triangles<'a, T: Trace + ?Sized> {
    stacks: &'a mut Stacks,
    triangles: &'a mut Vec<[u32; 3]>,
    trace: &'a mut T,
    /// The height of the sweep line that is shown.
    line: Option<[f64; 2]>,
}

impl<'a, T: Trace + ?Sized> Triangles<'a, T> {
    /// Makes ready for a polygon.
    pub(super) fn new(stacks: &'a mut Stacks, triangles: &'a mut Vec<[u32; 3]>, trace: &'a mut T) -> Self {
        stacks.entries.clear();
        stacks.pieces.clear();
        Self { stacks, triangles, trace, line: None }
    }

    /// Shows the sweep line at every stop, as high as the polygon.
    pub(super) fn show_line(&mut self, bounds: Option<BoundingBox>) {
        self.line = bounds.map(|b| [b.min.y, b.max.y]);
    }

    #[inline]
    fn push(&mut self, mark: Mark, below: u32) -> u32 {
        self.stacks.entries.push(Entry { mark, below });
        self.stacks.entries.len() as u32 - 1
    }

    /// Cuts off the triangle of two successive corners of a chain and a third one.
    #[inline]
    fn cut(&mut self, chain: Chain, first: Mark, second: Mark, at: Mark) {
        let triangle = match chain {
            Chain::Lower => [first.vertex, second.vertex, at.vertex],
            Chain::Upper => [second.vertex, first.vertex, at.vertex],
        };
        self.trace.add(Shape::Triangle(triangle), "cut off");
        self.triangles.push(triangle);
    }

    /// Cuts off the triangles of all corners of a stack with one that sees them all.
    fn cut_all(&mut self, stack: Stack, at: Mark) {
        let mut upper = self.stacks.entries[stack.top as usize];
        while upper.below != NONE {
            let lower = self.stacks.entries[upper.below as usize];
            self.cut(stack.chain, lower.mark, upper.mark, at);
            upper = lower;
        }
    }

    /// Cuts off the triangles of the corners of a stack that a corner of the same chain sees. Returns the top.
    #[inline]
    fn cut_convex(&mut self, stack: Stack, at: Mark) -> u32 {
        let convex = match stack.chain {
            Chain::Lower => Orientation::CounterClockwise,
            Chain::Upper => Orientation::Clockwise,
        };
        let mut top = stack.top;
        let mut upper = self.stacks.entries[top as usize];
        while upper.below != NONE {
            let lower = self.stacks.entries[upper.below as usize];
            if orient2d(lower.mark.point, upper.mark.point, at.point) != convex {
                break;
            }
            self.cut(stack.chain, lower.mark, upper.mark, at);
            top = upper.below;
            upper = lower;
        }
        top
    }
}

impl<T: Trace + ?Sized> Pieces for Triangles<'_, T> {
    fn visit(&mut self, at: Mark, kind: VertexKind) {
        if let Some(heights) = self.line {
            self.trace.look(Shape::Line(heights.map(|y| Point::new(at.point.x, y))), "the sweep line");
        }
        self.trace.look(Shape::Vertex(at.vertex), kind.key());
    }

    fn diagonal(&mut self, from: Mark, to: Mark, cause: Cause) {
        self.trace.add(Shape::Edge([from.vertex, to.vertex]), cause.note());
    }

    #[inline]
    fn begin(&mut self, at: Mark) -> u32 {
        let top = self.push(at, NONE);
        self.stacks.pieces.push(Stack { top, chain: Chain::Lower });
        self.stacks.pieces.len() as u32 - 1
    }

    #[inline]
    fn extend(&mut self, piece: u32, at: Mark, chain: Chain) {
        let stack = self.stacks.pieces[piece as usize];
        let below = if stack.chain == chain {
            self.cut_convex(stack, at)
        } else {
            self.cut_all(stack, at);
            let top = self.stacks.entries[stack.top as usize].mark;
            self.push(top, NONE)
        };
        let top = self.push(at, below);
        self.stacks.pieces[piece as usize] = Stack { top, chain };
    }

    fn finish(&mut self, piece: u32, at: Mark) {
        self.cut_all(self.stacks.pieces[piece as usize], at);
    }

    #[inline]
    fn last(&self, piece: u32) -> (Mark, Chain) {
        let stack = self.stacks.pieces[piece as usize];
        (self.stacks.entries[stack.top as usize].mark, stack.chain)
    }

    fn is_cancelled(&self) -> bool {
        self.trace.is_cancelled()
    }
}
