//! Two triangulations of the same points, slots aside.
#![allow(dead_code, reason = "every test uses a part of it")]

use std::fmt::Debug;

use trimalla::triangulation::Triangulation;

/// Says in what two triangulations of the same points differ, if in anything but slots.
pub(crate) fn alike(a: &Triangulation, b: &Triangulation) -> Result<(), String> {
    same("dimensions", &[a.dimension()], &[b.dimension()])?;
    same("triangles", &a.canonical(), &b.canonical())?;
    same("edges", &a.canonical_edges(), &b.canonical_edges())?;
    same("duplicates", a.duplicates(), b.duplicates())
}

/// Says that two answers differ, and where they first do.
pub(crate) fn same<T: PartialEq + Debug>(what: &str, left: &[T], right: &[T]) -> Result<(), String> {
    if left == right {
        return Ok(());
    }
    let at = left.iter().zip(right).take_while(|(l, r)| l == r).count();
    let (lengths, first) = ((left.len(), right.len()), (left.get(at), right.get(at)));
    Err(format!("{what} differ at {at} of {lengths:?}: {first:?}"))
}
