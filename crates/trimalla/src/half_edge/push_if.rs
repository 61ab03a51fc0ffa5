//! A list filled without branches.

/// Adds a value to a list if it is to stay: it is written down in any case, and taken back if not. Where nobody can
/// guess the answer, a branch would cost more.
#[inline(always)] // In loops that it is for.
pub(crate) fn push_if<T: Copy>(list: &mut Vec<T>, value: T, stays: bool) {
    list.push(value);
    list.truncate(list.len() - usize::from(!stays));
}
