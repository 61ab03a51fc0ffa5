//! Arrays that a C caller frees with `free`.

use std::ffi::c_void;
use std::ptr;

use crate::interface::{Fault, INTERNAL};

unsafe extern "C" {
    fn malloc(size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

/// Copies rows into an array of the caller, or into a new one where it has none; a slot that stays empty is null.
///
/// # Safety
/// `slot` is null, or has room for all values.
pub(crate) unsafe fn give<T: Copy>(slot: &mut *mut T, values: &[T], new: &mut Vec<*mut c_void>) -> Result<(), Fault> {
    if slot.is_null() {
        // As Triangle does, an array without elements is one all the same: its pointer can be freed and is not null.
        let bytes = size_of_val(values).max(size_of::<T>());
        // SAFETY: any size may be asked for.
        let memory = unsafe { malloc(bytes) };
        if memory.is_null() {
            return Err(Fault::new(INTERNAL, format!("memory allocation of {bytes} bytes failed")));
        }
        new.push(memory);
        *slot = memory.cast();
    }
    // SAFETY: of that size if it is new, and else the caller promises room; it cannot overlap a vector of ours.
    unsafe { ptr::copy_nonoverlapping(values.as_ptr(), *slot, values.len()) };
    Ok(())
}

/// Frees memory from `malloc`; null is allowed.
///
/// # Safety
/// `memory` is null or came from `malloc` and was not freed.
pub(crate) unsafe fn release(memory: *mut c_void) {
    // SAFETY: as the caller promises.
    unsafe { free(memory) };
}
