//! One input tried: a panic is caught and becomes a fault.

use std::cell::RefCell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

use crate::judge::{Verdict, fault};

thread_local! {
    /// Where the last panic of this thread was, and what it said.
    static LAST: RefCell<Option<(String, String)>> = const { RefCell::new(None) };
}

/// Runs something; a panic becomes a fault of the kind `panic at FILE:LINE`.
///
/// # Errors
/// The fault.
pub fn caught(run: impl FnOnce() -> Verdict) -> Verdict {
    note_panics();
    match panic::catch_unwind(AssertUnwindSafe(run)) {
        Ok(verdict) => verdict,
        Err(_) => {
            let (place, said) = LAST.take().unwrap_or_default();
            fault(format!("panic at {place}"), said)
        }
    }
}

/// From the first call on, panics are noted and not printed.
fn note_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        panic::set_hook(Box::new(|info| {
            let place = info.location().map_or(String::new(), |l| {
                let file = l.file().rsplit_once("crates/").map_or(l.file(), |(_, file)| file);
                format!("{file}:{}", l.line())
            });
            let said = info.payload_as_str().unwrap_or("").to_owned();
            LAST.set(Some((place, said)));
        }));
    });
}
