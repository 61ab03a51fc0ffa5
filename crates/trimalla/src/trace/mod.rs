//! What an algorithm does, told step by step to whoever draws it; and how it is cancelled.
//!
//! An algorithm takes a [`Trace`] and tells it each [`Step`]: what it looks at, adds, removes and refuses. With
//! [`NoTrace`] the calls compile to nothing. Vertices are told by their indices in the input, so that a picture
//! needs only the input and the steps.

use crate::geometry::{Circle, Point};

/// What a step is about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A vertex.
    Vertex(u32),
    /// The edge between two vertices.
    Edge([u32; 2]),
    /// The triangle of three vertices.
    Triangle([u32; 3]),
    /// A line between two points that need not be vertices: a sweep line, the side of a trapezoid.
    Line([Point; 2]),
    /// A circle.
    Circle(Circle),
}

/// What is done to the shape of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Act {
    /// It is looked at; the next step forgets it.
    Look,
    /// It is there from now on.
    Add,
    /// It is no longer there.
    Remove,
    /// It was looked at and is not added.
    Refuse,
}

/// One step of an algorithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What is done.
    pub act: Act,
    /// To what.
    pub shape: Shape,
    /// Why, or what the shape is, in a few words.
    pub note: &'static str,
}

/// Is told the steps of an algorithm.
pub trait Trace {
    /// A step was made.
    fn step(&mut self, step: Step);

    /// Whether somebody has cancelled: the algorithm ends with an error soon.
    fn is_cancelled(&self) -> bool {
        false
    }

    /// Whether anybody listens: where nobody does, work that is only told may be left out.
    fn is_listening(&self) -> bool {
        true
    }

    /// Something is looked at.
    fn look(&mut self, shape: Shape, note: &'static str) {
        self.step(Step { act: Act::Look, shape, note });
    }

    /// Something is added.
    fn add(&mut self, shape: Shape, note: &'static str) {
        self.step(Step { act: Act::Add, shape, note });
    }

    /// Something is removed.
    fn remove(&mut self, shape: Shape, note: &'static str) {
        self.step(Step { act: Act::Remove, shape, note });
    }

    /// Something is not added.
    fn refuse(&mut self, shape: Shape, note: &'static str) {
        self.step(Step { act: Act::Refuse, shape, note });
    }
}

/// Nobody is told.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoTrace;

impl Trace for NoTrace {
    #[inline]
    fn step(&mut self, _: Step) {}

    fn is_listening(&self) -> bool {
        false
    }
}

/// Keeps every step.
impl Trace for Vec<Step> {
    fn step(&mut self, step: Step) {
        self.push(step);
    }
}

/// Keeps the first steps, and counts all of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recorder {
    steps: Vec<Step>,
    most: usize,
    count: u64,
}

impl Recorder {
    /// Keeps no more steps than `most`.
    #[must_use]
    pub const fn of_first(most: usize) -> Self {
        Self { steps: Vec::new(), most, count: 0 }
    }

    /// The steps that were kept.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// How many steps there were.
    #[must_use]
    pub const fn count(&self) -> u64 {
        self.count
    }
}

impl Trace for Recorder {
    fn step(&mut self, step: Step) {
        self.count += 1;
        if self.steps.len() < self.most {
            self.steps.push(step);
        }
    }

    fn is_listening(&self) -> bool {
        self.most > 0
    }
}

/// Tells steps by other numbers of the vertices: of a part of an input by those of the whole.
#[derive(Debug)]
pub(crate) struct Renumbered<'a, T: ?Sized> {
    trace: &'a mut T,
    /// The number of each vertex.
    of: &'a [u32],
}

impl<'a, T: Trace + ?Sized> Renumbered<'a, T> {
    /// Tells `trace` of vertex `of[v]` where vertex `v` is told.
    pub(crate) const fn new(trace: &'a mut T, of: &'a [u32]) -> Self {
        Self { trace, of }
    }
}

impl<T: Trace + ?Sized> Trace for Renumbered<'_, T> {
    fn step(&mut self, step: Step) {
        let number = |v: u32| self.of.get(v as usize).copied().unwrap_or(v);
        let shape = match step.shape {
            Shape::Vertex(v) => Shape::Vertex(number(v)),
            Shape::Edge(ends) => Shape::Edge(ends.map(number)),
            Shape::Triangle(corners) => Shape::Triangle(corners.map(number)),
            other => other,
        };
        self.trace.step(Step { shape, ..step });
    }

    fn is_cancelled(&self) -> bool {
        self.trace.is_cancelled()
    }

    fn is_listening(&self) -> bool {
        self.trace.is_listening()
    }
}
