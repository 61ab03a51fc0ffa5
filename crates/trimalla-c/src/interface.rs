//! The interface between C and Rust: errors as values, panics caught, arrays as slices.

use std::ffi::{c_char, c_int};
use std::panic::{AssertUnwindSafe, catch_unwind};

use trimalla::constrained::ConstraintError;
use trimalla::delaunay::BuildError;
use trimalla::domain::DomainError;
use trimalla::drawing::DrawingError;
use trimalla::geometry::Point;

/// Bytes of a message, the zero at its end included.
pub const MESSAGE_BYTES: usize = 512;

/// All is done.
pub const OK: c_int = 0;
/// An argument cannot be: a null pointer, a count that does not fit, a call out of order.
pub const BAD_ARGUMENT: c_int = 1;
/// The drawing is at fault.
pub const BAD_DRAWING: c_int = 2;
/// An option is unknown or out of range.
pub const BAD_OPTION: c_int = 3;
/// The caller has cancelled.
pub const CANCELLED: c_int = 4;
/// A fault of the library itself.
pub const INTERNAL: c_int = 5;

/// Why a call failed, as C sees it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CError {
    code: c_int,
    message: [c_char; MESSAGE_BYTES],
    index: i64,
    x: f64,
    y: f64,
}

/// Why a call failed.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    pub(crate) code: c_int,
    pub(crate) message: String,
    pub(crate) index: Option<usize>,
    pub(crate) at: Option<Point>,
}

impl Fault {
    /// A fault without a place.
    pub(crate) fn new(code: c_int, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), index: None, at: None }
    }

    /// An argument that cannot be.
    pub(crate) fn argument(message: impl Into<String>) -> Self {
        Self::new(BAD_ARGUMENT, message)
    }
}

impl From<trimalla::Error> for Fault {
    fn from(error: trimalla::Error) -> Self {
        let code = if matches!(error, trimalla::Error::Option(_)) { BAD_OPTION } else { BAD_DRAWING };
        let (index, at) = place_of(&error);
        Self { index, at, ..Self::new(code, error.to_string()) }
    }
}

/// The vertex, segment or seed at fault, and where it lies.
fn place_of(error: &trimalla::Error) -> (Option<usize>, Option<Point>) {
    let trimalla::Error::Domain(error) = error else { return (None, None) };
    match error {
        DomainError::OpenOutline { end: Some(end) } => (Some(end.vertex.index()), Some(end.at)),
        DomainError::SeedLeaks { seed, at }
        | DomainError::SeedTakesAll { seed, at }
        | DomainError::SeedOnSegment { seed, at, .. }
        | DomainError::Drawing(DrawingError::SeedNotFinite { seed, at, .. }) => (Some(*seed), Some(*at)),
        DomainError::Constraint(ConstraintError::Build(BuildError::NotFinite { index, point })) => {
            (Some(*index), Some(*point))
        }
        DomainError::Constraint(ConstraintError::NoSuchVertex { segment, .. }) => (Some(*segment), None),
        DomainError::Constraint(ConstraintError::Crossing(pairs)) => {
            let first = pairs.first();
            (first.map(|pair| pair.segments[0]), first.map(|pair| pair.at))
        }
        _ => (None, None),
    }
}

impl CError {
    fn of(fault: Option<&Fault>) -> Self {
        let mut error = Self { code: OK, message: [0; MESSAGE_BYTES], index: -1, x: f64::NAN, y: f64::NAN };
        let Some(fault) = fault else { return error };
        error.code = fault.code;
        let mut length = fault.message.len().min(MESSAGE_BYTES - 1);
        while !fault.message.is_char_boundary(length) {
            length -= 1;
        }
        for (slot, byte) in error.message.iter_mut().zip(fault.message[..length].bytes()) {
            *slot = byte as c_char;
        }
        error.index = fault.index.and_then(|index| i64::try_from(index).ok()).unwrap_or(-1);
        if let Some(at) = fault.at {
            (error.x, error.y) = (at.x, at.y);
        }
        error
    }
}

/// Runs the body of a C function: a panic becomes an error; the error is stored and its code returned.
///
/// # Safety
/// `error` is null or points to memory for one error.
pub(crate) unsafe fn call(error: *mut CError, body: impl FnOnce() -> Result<(), Fault>) -> c_int {
    let result = caught(body);
    let stored = CError::of(result.as_ref().err());
    if !error.is_null() {
        // SAFETY: not null, and the caller promises memory for one error; it need not be initialized.
        unsafe { error.write(stored) };
    }
    stored.code
}

/// Runs a body, and turns a panic into a fault.
pub(crate) fn caught<T>(body: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("panic");
        Err(Fault::new(INTERNAL, format!("fault of the library: {text}")))
    })
}

/// An array of C as a slice; null is allowed where there are no elements.
///
/// # Safety
/// `data` is null, or points to `count` initialized elements that nobody changes for `'a`.
pub(crate) unsafe fn slice<'a, T>(data: *const T, count: usize, what: &str) -> Result<&'a [T], Fault> {
    if count == 0 {
        return Ok(&[]);
    }
    if data.is_null() {
        return Err(Fault::argument(format!("the array of {what} is null, and {count} elements are announced")));
    }
    if !data.is_aligned() {
        return Err(Fault::argument(format!("the array of {what} is not aligned")));
    }
    if count > isize::MAX as usize / size_of::<T>().max(1) {
        return Err(Fault::argument(format!("{count} {what} are more than memory holds")));
    }
    // SAFETY: not null, aligned, of a size that fits, and the caller promises that many elements.
    Ok(unsafe { std::slice::from_raw_parts(data, count) })
}

/// A handle that a caller gave back.
///
/// # Safety
/// `handle` is null, or points to a value that this library has handed out and not freed, used by no other thread.
pub(crate) unsafe fn handle<'a, T>(handle: *mut T, what: &str) -> Result<&'a mut T, Fault> {
    // SAFETY: null is checked by `as_mut`; else the caller promises a live value of this type for itself alone.
    unsafe { handle.as_mut() }.ok_or_else(|| Fault::argument(format!("the {what} is null")))
}
