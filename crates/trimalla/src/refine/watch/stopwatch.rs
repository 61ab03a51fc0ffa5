//! The time of each step, by a clock of the caller's: the library has none.

use std::fmt;

/// A clock: nanoseconds since some fixed moment.
///
/// # Examples
/// ```
/// use std::sync::OnceLock;
/// use std::time::Instant;
/// use trimalla::refine::Clock;
///
/// fn now() -> u64 {
///     static START: OnceLock<Instant> = OnceLock::new();
///     u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
/// }
/// let clock: Clock = now;
/// assert!(clock() <= clock());
/// ```
pub type Clock = fn() -> u64;

/// Seconds that the parts of a refinement took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StepTimes {
    /// Step 1: testing and splitting subsegments, and deleting free vertices first.
    pub prepare: f64,
    /// Step 2: testing triangles, queueing them and taking them from the queue.
    pub select: f64,
    /// Step 3: proposing places.
    pub point: f64,
    /// Step 4: trying places, and inserting points or rolling back.
    pub insert: f64,
    /// Step 5: recovering released segments.
    pub recover: f64,
    /// Preparing the initial triangulation as the recipe says, and making the report.
    pub rest: f64,
}

impl StepTimes {
    /// Every part by name, in order.
    #[must_use]
    pub const fn by_name(&self) -> [(&'static str, f64); 6] {
        [
            ("prepare", self.prepare),
            ("select", self.select),
            ("point", self.point),
            ("insert", self.insert),
            ("recover", self.recover),
            ("rest", self.rest),
        ]
    }

    /// The sum of all parts.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.by_name().into_iter().map(|(_, seconds)| seconds).sum()
    }
}

/// What time is spent on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::refine) enum Part {
    Prepare,
    Select,
    Point,
    Insert,
    Recover,
    Rest,
    /// The caller's time between calls.
    #[default]
    Outside,
}

/// Adds up the time of each part; nothing without a clock.
#[derive(Clone, Copy, Default)]
pub(in crate::refine) struct Stopwatch {
    clock: Option<Clock>,
    part: Part,
    /// The reading when the part began.
    since: u64,
    /// Nanoseconds, by part.
    spent: [u64; 7],
}

impl Stopwatch {
    pub(in crate::refine) fn new(clock: Option<Clock>) -> Self {
        Self { clock, ..Self::default() }
    }

    /// Sets the clock, if there was none.
    pub(in crate::refine) fn or_clock(mut self, clock: Option<Clock>) -> Self {
        self.clock = self.clock.or(clock);
        self
    }

    /// Begins another part; returns the one that ends, so that the caller can resume it later.
    #[inline]
    pub(in crate::refine) fn enter(&mut self, part: Part) -> Part {
        match self.clock {
            Some(clock) => self.lap(clock(), part),
            None => part,
        }
    }

    #[cold]
    fn lap(&mut self, now: u64, part: Part) -> Part {
        let ended = std::mem::replace(&mut self.part, part);
        self.spent[ended as usize] += now.saturating_sub(self.since);
        self.since = now;
        ended
    }

    /// The measured times; `None` without a clock.
    pub(in crate::refine) fn times(&self) -> Option<StepTimes> {
        self.clock?;
        let seconds = |part: Part| self.spent[part as usize] as f64 * 1e-9;
        Some(StepTimes {
            prepare: seconds(Part::Prepare),
            select: seconds(Part::Select),
            point: seconds(Part::Point),
            insert: seconds(Part::Insert),
            recover: seconds(Part::Recover),
            rest: seconds(Part::Rest),
        })
    }
}

impl fmt::Debug for Stopwatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stopwatch").field("part", &self.part).field("spent", &self.spent).finish_non_exhaustive()
    }
}
