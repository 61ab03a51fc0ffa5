//! A flag that another thread or a signal handler may raise.

use std::sync::atomic::{AtomicBool, Ordering};

/// A flag; raised once, it stays so until it is lowered.
#[derive(Debug, Default)]
pub struct Cancel(AtomicBool);

impl Cancel {
    pub(crate) fn is_raised(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// A new flag, lowered.
#[unsafe(no_mangle)]
pub extern "C" fn trimalla_cancel_new() -> *mut Cancel {
    Box::into_raw(Box::default())
}

/// Raises the flag (`raised` other than 0) or lowers it. Safe in a signal handler and from any thread.
///
/// # Safety
/// `cancel` is null or a live flag.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_cancel_set(cancel: *const Cancel, raised: std::ffi::c_int) {
    // SAFETY: null is checked by `as_ref`; else the caller promises a live flag, which is atomic.
    if let Some(cancel) = unsafe { cancel.as_ref() } {
        cancel.0.store(raised != 0, Ordering::Relaxed);
    }
}

/// Frees a flag; null is allowed.
///
/// # Safety
/// `cancel` is null, or a live flag that no thread uses any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_cancel_free(cancel: *mut Cancel) {
    if !cancel.is_null() {
        // SAFETY: made by `trimalla_cancel_new`, and freed once, as the caller promises.
        drop(unsafe { Box::from_raw(cancel) });
    }
}
