//! A queue of runs and the threads that empty it.
//!
//! Each thread takes the next run of the queue; outcomes go to the run's place, so that their order is the experiment's
//! whatever ends first. A run is cancelled when its time is over, and all are when the caller says so.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use trimalla::domain;
use trimalla::refine::{Clock, Progress, Refinement, Start, StopReason};

use crate::error::CompareError;
use crate::experiment::{Experiment, Task};
use crate::journal::Journal;
use crate::outcome::Outcome;
use crate::peer::Question;
use crate::sheet::Times;

/// Watches an experiment, from several threads at a time.
pub trait Watch: Sync {
    /// Called before the first run: how many there are, and how many of them a journal knows already.
    fn begins(&self, _runs: usize, _known: usize) {}

    /// Called when a run has ended.
    fn ran(&self, _task: &Task<'_>) {}

    /// Called again and again; `true` ends the experiment.
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// Watches nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoWatch;

impl Watch for NoWatch {}

/// The outcomes of an experiment, in its order; `None` for drawings that cannot be run.
#[derive(Clone, Debug)]
pub struct Outcomes(pub(crate) Vec<Option<Outcome>>);

/// What all threads share.
struct Shared<'a> {
    outcomes: Vec<Option<Outcome>>,
    journal: Option<&'a mut Journal>,
    failure: Option<CompareError>,
}

impl Experiment {
    /// Does every run that the journal does not know, so many at a time.
    ///
    /// # Guarantees
    /// Every run is bounded in vertices and in time. But for times, the outcomes depend neither on the number of jobs
    /// nor on which run ends first.
    ///
    /// # Errors
    /// [`CompareError`]; what was done until then is in the journal.
    pub fn run(&self, jobs: usize, journal: Option<&mut Journal>, watch: &dyn Watch) -> Result<Outcomes, CompareError> {
        let mut outcomes = vec![None; self.len()];
        let tasks = self.tasks();
        if let Some(journal) = &journal {
            tasks.iter().for_each(|task| outcomes[task.index] = journal.find(task));
        }
        let todo: Vec<&Task<'_>> = tasks.iter().filter(|task| outcomes[task.index].is_none()).collect();
        watch.begins(tasks.len(), tasks.len() - todo.len());
        let shared = Mutex::new(Shared { outcomes, journal, failure: None });
        let (next, is_over) = (AtomicUsize::new(0), AtomicBool::new(false));
        let work = || {
            while let (false, Some(task)) =
                (is_over.load(Ordering::SeqCst), todo.get(next.fetch_add(1, Ordering::SeqCst)))
            {
                let ran = task.run(watch);
                let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
                if let Err(failure) = ran.and_then(|outcome| shared.keep(task, outcome)) {
                    shared.failure.get_or_insert(failure);
                    is_over.store(true, Ordering::SeqCst);
                }
                watch.ran(task);
            }
        };
        thread::scope(|scope| {
            for _ in 1..jobs.min(todo.len()) {
                scope.spawn(work);
            }
            work();
        });
        let shared = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
        shared.failure.map_or(Ok(Outcomes(shared.outcomes)), Err)
    }
}

impl Shared<'_> {
    fn keep(&mut self, task: &Task<'_>, outcome: Outcome) -> Result<(), CompareError> {
        if let Some(journal) = &mut self.journal {
            journal.add(task, &outcome)?;
        }
        self.outcomes[task.index] = Some(outcome);
        Ok(())
    }
}

impl Task<'_> {
    fn run(&self, watch: &dyn Watch) -> Result<Outcome, CompareError> {
        if watch.is_cancelled() {
            return Err(CompareError::Interrupted);
        }
        let limit = Duration::try_from_secs_f64(self.experiment.time_limit).unwrap_or(Duration::MAX);
        match self.contender.peer() {
            Some(_) => self.question(limit).run(&|| watch.is_cancelled()).ok_or(CompareError::Interrupted),
            None => self.refine(limit, watch),
        }
    }

    fn question(&self, limit: Duration) -> Question<'_> {
        Question {
            pslg: &self.good.pslg,
            domain: &self.experiment.domain,
            angle_deg: self.angle_deg,
            max_vertices: self.options.limits.max_vertices,
            limit,
        }
    }

    /// Triangulates and refines, both timed together.
    fn refine(&self, limit: Duration, watch: &dyn Watch) -> Result<Outcome, CompareError> {
        let start = Instant::now();
        let mut refinement = self.begin()?;
        let stop = refinement.run(&mut |_: Progress| !watch.is_cancelled() && start.elapsed() < limit);
        let (_, report) = refinement.finish();
        let seconds = start.elapsed().as_secs_f64();
        if stop == StopReason::Cancelled && watch.is_cancelled() {
            return Err(CompareError::Interrupted); // An interrupted run has no outcome.
        }
        Ok(Outcome::of(&report, seconds))
    }

    fn begin(&self) -> Result<Refinement, CompareError> {
        let rule = &self.experiment.domain;
        let (cdt, _) = domain::build(&self.good.pslg, rule.rule, rule.crossings, rule.algorithm)
            .map_err(|source| CompareError::Drawing { drawing: self.drawing.name.clone(), source })?;
        let clock = (self.experiment.times == Times::BySteps).then_some(now as Clock);
        let start = Start::from(cdt).with_steps(self.contender.steps(&self.options)).with_clock(clock);
        Refinement::new(start, self.options)
            .map_err(|source| CompareError::Option { contender: self.contender.label.clone(), source })
    }
}

/// Nanoseconds since the first reading.
fn now() -> u64 {
    static START: OnceLock<Instant> = OnceLock::new();
    u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
}
