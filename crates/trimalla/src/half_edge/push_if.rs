//! A branch-free conditional push.

/// Pushes a value if `stays`, without a branch: always stores it, then shortens the list if it does not stay. For
/// unpredictable conditions, where a branch would cost more.
#[inline(always)] // In loops that it is for.
pub(crate) fn push_if<T: Copy>(list: &mut Vec<T>, value: T, stays: bool) {
    list.push(value);
    list.truncate(list.len() - usize::from(!stays));
}
