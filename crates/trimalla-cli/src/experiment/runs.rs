//! A queue of runs and the threads that empty it.
//!
//! Each thread takes the next run of the queue; outcomes go to the run's place, so that their order is the plan's whatever
//! ends first. A run is cancelled when its time is over, and all are on Ctrl-C.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use trimalla::refine::{Progress, StopReason};

use super::journal::Journal;
use super::outcome::Outcome;
use super::plan::{Plan, Task};
use crate::exit::{Failure, Status};
use crate::progress;

/// What all threads share.
struct Shared<'a> {
    outcomes: Vec<Option<Outcome>>,
    journal: Option<&'a mut Journal>,
    failure: Option<Failure>,
}

/// Does every run that the journal does not know, so many at a time. Outcomes are in the plan's order, `None` for drawings
/// that cannot be run.
pub(crate) fn run_all(
    plan: &Plan,
    jobs: usize,
    journal: Option<&mut Journal>,
    is_shown: bool,
) -> Result<Vec<Option<Outcome>>, Failure> {
    let mut outcomes = vec![None; plan.len()];
    let tasks = plan.tasks();
    if let Some(journal) = &journal {
        tasks.iter().for_each(|task| outcomes[task.index] = journal.find(task));
    }
    let bar = bar(tasks.len(), is_shown);
    let todo: Vec<&Task<'_>> = tasks.iter().filter(|task| outcomes[task.index].is_none()).collect();
    bar.set_position((tasks.len() - todo.len()) as u64);
    let shared = Mutex::new(Shared { outcomes, journal, failure: None });
    let (next, is_over) = (AtomicUsize::new(0), AtomicBool::new(false));
    let work = || {
        while let (false, Some(task)) = (is_over.load(Ordering::SeqCst), todo.get(next.fetch_add(1, Ordering::SeqCst)))
        {
            let ran = run(task);
            let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
            if let Err(failure) = ran.and_then(|outcome| shared.keep(task, outcome)) {
                shared.failure.get_or_insert(failure);
                is_over.store(true, Ordering::SeqCst);
            }
            bar.inc(1);
            bar.set_message(format!("{}, {}, {}°", task.drawing.title, task.contender.label, task.angle_deg));
        }
    };
    thread::scope(|scope| {
        for _ in 1..jobs.min(todo.len()) {
            scope.spawn(work);
        }
        work();
    });
    bar.finish_and_clear();
    let shared = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
    shared.failure.map_or(Ok(shared.outcomes), Err)
}

impl Shared<'_> {
    fn keep(&mut self, task: &Task<'_>, outcome: Outcome) -> Result<(), Failure> {
        if let Some(journal) = &mut self.journal {
            journal.add(task, &outcome)?;
        }
        self.outcomes[task.index] = Some(outcome);
        Ok(())
    }
}

fn run(task: &Task<'_>) -> Result<Outcome, Failure> {
    let start = Instant::now();
    let limit = Duration::try_from_secs_f64(task.time_limit).unwrap_or(Duration::MAX);
    let mut watch = |_: Progress| !progress::is_interrupted() && start.elapsed() < limit;
    if progress::is_interrupted() {
        return Err(interrupted());
    }
    let meshed = trimalla::mesh_with(&task.good.pslg, &task.options, &mut watch);
    let seconds = start.elapsed().as_secs_f64();
    match meshed {
        // Interrupted runs are nobody's outcome.
        Ok(meshed) if meshed.report.stop == StopReason::Cancelled && progress::is_interrupted() => Err(interrupted()),
        Ok(meshed) => Ok(Outcome::of(&meshed.report, seconds)),
        Err(error) => Err(Failure::bad_input(format!("{}: {error}", task.drawing.name))),
    }
}

fn interrupted() -> Failure {
    Failure::new(Status::Interrupted, "interrupted; no table was written")
}

/// A bar on standard error, if that is a terminal and the bar is wanted.
fn bar(length: usize, is_shown: bool) -> ProgressBar {
    if !is_shown {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:30} {pos} of {len} runs, {eta} to go  {wide_msg}");
    ProgressBar::new(length as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
