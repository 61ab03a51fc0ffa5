//! What a caller sees of a refinement: its observer, the events of its steps, their times, and the report.

pub(super) mod event;
pub(super) mod observer;
pub(super) mod report;
pub(super) mod stopwatch;
