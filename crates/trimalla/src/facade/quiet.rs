//! Several runs before one observer.

use crate::refine::{Observer, Progress};

/// Passes on the progress of a run, and nothing else.
pub(super) struct Quiet<'a> {
    pub(super) observer: &'a mut dyn Observer,
    /// Whether the observer has cancelled.
    pub(super) is_cancelled: bool,
}

impl<'a> Quiet<'a> {
    pub(super) fn new(observer: &'a mut dyn Observer) -> Self {
        Self { observer, is_cancelled: false }
    }
}

impl Observer for Quiet<'_> {
    fn progress(&mut self, progress: Progress) -> bool {
        let goes_on = self.observer.progress(progress);
        self.is_cancelled |= !goes_on;
        goes_on
    }
}
