//! Long work beside the interpreter: a thread works, and the calling thread looks after signals and callbacks.
//!
//! The thread owns all that it works with, and knows no object of Python. So the calling thread can leave at once where
//! a signal handler or a callback raises: the thread sees the flag at its next report and ends by itself.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread::Builder;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use trimalla::refine::{Observer, Progress};

use crate::errors::Fault;

/// How long the calling thread waits before it looks after signals again.
const TURN: Duration = Duration::from_millis(20);
/// Room for calls that nest, as much as main threads have.
const STACK: usize = 8 << 20;

/// What the two threads share.
#[derive(Debug, Default)]
struct Shared {
    is_cancelled: AtomicBool,
    vertices: AtomicUsize,
    waiting: AtomicUsize,
}

/// Reports progress to the calling thread, and asks whether to go on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reporter(Arc<Shared>);

impl Reporter {
    pub(crate) fn is_cancelled(&self) -> bool {
        self.0.is_cancelled.load(Ordering::Relaxed)
    }
}

impl Observer for Reporter {
    fn progress(&mut self, progress: Progress) -> bool {
        self.0.vertices.store(progress.vertices, Ordering::Relaxed);
        self.0.waiting.store(progress.waiting, Ordering::Relaxed);
        !self.is_cancelled()
    }
}

/// Does the work on a thread of its own, with the interpreter free.
///
/// `progress(vertices, waiting)` is called from the calling thread about every 20 ms while the work lasts; where it
/// returns `False`, the work is cancelled and its result so far is returned.
///
/// # Errors
/// What the work returns; what a signal handler (`KeyboardInterrupt`) or the callback raises, at once.
pub(crate) fn run<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(Reporter) -> Result<T, Fault> + Send + 'static,
) -> PyResult<T> {
    let reporter = Reporter::default();
    let shared = Arc::clone(&reporter.0);
    let (sender, receiver) = channel();
    let body = move || {
        // The receiver is gone where the calling thread has left.
        let _ = sender.send(work(reporter));
    };
    let started = Builder::new().name("trimalla".to_owned()).stack_size(STACK).spawn(body);
    started.map_err(|error| PyRuntimeError::new_err(format!("no thread can be started: {error}")))?;
    let receiver = Mutex::new(receiver);
    loop {
        let waited = py.detach(|| match receiver.lock() {
            Ok(receiver) => receiver.recv_timeout(TURN),
            Err(_) => Err(RecvTimeoutError::Disconnected),
        });
        match waited {
            Ok(done) => return Ok(done?),
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the library has panicked: this is a bug of trimalla"));
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
        let turn = py.check_signals().and_then(|()| told(progress, &shared));
        match turn {
            Ok(true) => {}
            Ok(false) => shared.is_cancelled.store(true, Ordering::Relaxed),
            Err(error) => {
                shared.is_cancelled.store(true, Ordering::Relaxed);
                return Err(error);
            }
        }
    }
}

/// Calls the callback; whether to go on.
fn told(progress: Option<&Bound<'_, PyAny>>, shared: &Shared) -> PyResult<bool> {
    let Some(progress) = progress.filter(|_| !shared.is_cancelled.load(Ordering::Relaxed)) else { return Ok(true) };
    let (vertices, waiting) = (shared.vertices.load(Ordering::Relaxed), shared.waiting.load(Ordering::Relaxed));
    let answer = progress.call1((vertices, waiting))?;
    Ok(answer.is_none() || answer.is_truthy()?)
}
