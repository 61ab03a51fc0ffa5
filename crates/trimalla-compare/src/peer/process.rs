//! A program run once: text in, text out, within a time limit.

use std::io::{self, Read as _, Write as _};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

/// How a process ended.
#[derive(Debug)]
pub(super) enum Ended {
    /// With status 0, and this on its standard output.
    Answered(Vec<u8>),
    /// With another status, or by a signal.
    Failed,
    /// It was killed: its time was over, or the caller cancelled it.
    Killed,
}

/// How often a running process is held against its limits.
const TICK: Duration = Duration::from_millis(5);

/// The longest answer that is read: a mesh of some ten million vertices.
const LONGEST: u64 = 1 << 30;

/// Runs a program: `input` goes to its standard input, and its standard error is dropped.
///
/// # Errors
/// Those of starting it.
pub(super) fn run(
    mut command: Command,
    input: &str,
    limit: Duration,
    is_cancelled: &dyn Fn() -> bool,
) -> io::Result<Ended> {
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
    // Ctrl-C in a terminal reaches this process alone, which then kills the other.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    let start = Instant::now();
    let mut child = command.spawn()?;
    let (mut to_child, from_child) = (child.stdin.take(), child.stdout.take());
    let (sender, receiver) = sync_channel(1);
    thread::scope(|scope| {
        scope.spawn(move || {
            // A process that ends early reads no further: that shows in its status.
            let _ = to_child.as_mut().map(|pipe| pipe.write_all(input.as_bytes()));
            drop(to_child);
            let mut answer = Vec::new();
            let _ = from_child.map(|pipe| pipe.take(LONGEST + 1).read_to_end(&mut answer));
            let _ = sender.send(answer);
        });
        loop {
            if is_cancelled() || start.elapsed() >= limit {
                return killed(&mut child);
            }
            match receiver.recv_timeout(TICK) {
                Ok(answer) => return ended(&mut child, answer, || is_cancelled() || start.elapsed() >= limit),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return killed(&mut child),
            }
        }
    })
}

/// Waits for a process that has closed its standard output, as long as it may run.
fn ended(child: &mut Child, answer: Vec<u8>, is_over: impl Fn() -> bool) -> io::Result<Ended> {
    while answer.len() as u64 <= LONGEST && !is_over() {
        if let Some(status) = child.try_wait()? {
            return Ok(if status.success() { Ended::Answered(answer) } else { Ended::Failed });
        }
        thread::sleep(TICK);
    }
    killed(child)
}

/// Ends a process; it may have ended by itself meanwhile.
fn killed(child: &mut Child) -> io::Result<Ended> {
    let _ = child.kill();
    child.wait()?;
    Ok(Ended::Killed)
}
