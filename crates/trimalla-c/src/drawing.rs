//! Drawings that a caller fills.

use std::ffi::c_int;

use trimalla::{Point, Pslg, Region};

use crate::interface::{CError, Fault, call, handle, slice};

/// A drawing under construction.
#[derive(Debug, Default)]
pub struct Drawing(pub(crate) Pslg);

/// A new drawing without points.
#[unsafe(no_mangle)]
pub extern "C" fn trimalla_drawing_new() -> *mut Drawing {
    Box::into_raw(Box::default())
}

/// Frees a drawing; null is allowed.
///
/// # Safety
/// `drawing` is null or a live drawing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_drawing_free(drawing: *mut Drawing) {
    if !drawing.is_null() {
        // SAFETY: made by `trimalla_drawing_new`, and freed once, as the caller promises.
        drop(unsafe { Box::from_raw(drawing) });
    }
}

/// Adds points.
///
/// # Safety
/// `drawing` is a live drawing; `xy` has `2 * count` numbers, `markers` is null or has `count`; `error` is null or has
/// room for one error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_add_points(
    drawing: *mut Drawing,
    xy: *const f64,
    count: usize,
    markers: *const i32,
    error: *mut CError,
) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of each pointer; the helpers check the rest.
        let (drawing, xy, markers) = unsafe {
            let twice = count.checked_mul(2).ok_or_else(|| Fault::argument("too many points"))?;
            (handle(drawing, "drawing")?, slice(xy, twice, "coordinates")?, column(markers, count, "markers")?)
        };
        let before = drawing.0.points.len();
        drawing.0.points.extend(xy.chunks_exact(2).map(|p| Point::new(p[0], p[1])));
        add_column(&mut drawing.0.point_markers, before, markers, count);
        Ok(())
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, body) }
}

/// Sets the attributes of all points: `per_point` numbers each, row after row.
///
/// # Safety
/// `drawing` is a live drawing; `values` has `per_point` numbers for each point; `error` is null or has room for one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_set_attributes(
    drawing: *mut Drawing,
    values: *const f64,
    per_point: usize,
    error: *mut CError,
) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of each pointer; the helpers check the rest.
        let (drawing, values) = unsafe {
            let drawing = handle(drawing, "drawing")?;
            let count = drawing.0.points.len().checked_mul(per_point);
            let count = count.ok_or_else(|| Fault::argument("too many attributes"))?;
            (drawing, slice(values, count, "attributes")?)
        };
        drawing.0.attributes_per_point = per_point;
        drawing.0.point_attributes = values.to_vec();
        Ok(())
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, body) }
}

/// Adds segments, as pairs of indices of points, counted from 0.
///
/// # Safety
/// `drawing` is a live drawing; `ends` has `2 * count` numbers, `markers` is null or has `count`; `error` is null or
/// has room for one error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_add_segments(
    drawing: *mut Drawing,
    ends: *const u32,
    count: usize,
    markers: *const i32,
    error: *mut CError,
) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of each pointer; the helpers check the rest.
        let (drawing, ends, markers) = unsafe {
            let twice = count.checked_mul(2).ok_or_else(|| Fault::argument("too many segments"))?;
            (handle(drawing, "drawing")?, slice(ends, twice, "ends of segments")?, column(markers, count, "markers")?)
        };
        let before = drawing.0.segments.len();
        drawing.0.segments.extend(ends.chunks_exact(2).map(|ends| [ends[0], ends[1]]));
        add_column(&mut drawing.0.segment_markers, before, markers, count);
        Ok(())
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, body) }
}

/// Adds a hole: what can be reached from this point without crossing a segment is removed.
///
/// # Safety
/// `drawing` is a live drawing; `error` is null or has room for one error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_add_hole(drawing: *mut Drawing, x: f64, y: f64, error: *mut CError) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of `drawing`.
        unsafe { handle(drawing, "drawing")? }.0.holes.push(Point::new(x, y));
        Ok(())
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, body) }
}

/// Adds a region around a point: an attribute, and the largest area of its triangles; 0 or less for none.
///
/// # Safety
/// `drawing` is a live drawing; `error` is null or has room for one error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_add_region(
    drawing: *mut Drawing,
    x: f64,
    y: f64,
    attribute: f64,
    max_area: f64,
    error: *mut CError,
) -> c_int {
    let body = || {
        if max_area.is_nan() || max_area.is_infinite() {
            return Err(Fault::argument(format!("the largest area of a region is {max_area}")));
        }
        let region = Region { seed: Point::new(x, y), attribute, max_area: Some(max_area).filter(|&area| area > 0.0) };
        // SAFETY: as the caller promises of `drawing`.
        unsafe { handle(drawing, "drawing")? }.0.regions.push(region);
        Ok(())
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, body) }
}

/// A column that may be missing.
///
/// # Safety
/// `data` is null or has `count` elements.
unsafe fn column<'a>(data: *const i32, count: usize, what: &str) -> Result<&'a [i32], Fault> {
    // SAFETY: not null here, and the caller promises the elements.
    if data.is_null() { Ok(&[]) } else { unsafe { slice(data, count, what) } }
}

/// Adds entries to a column that is empty as long as nobody has given one: zeros stand in for those missing.
fn add_column(column: &mut Vec<i32>, before: usize, added: &[i32], count: usize) {
    if column.is_empty() && added.is_empty() {
        return;
    }
    column.resize(before, 0);
    column.extend_from_slice(added);
    column.resize(before + count, 0);
}
