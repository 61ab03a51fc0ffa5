//! Meshing, and the arrays of a mesh.

use std::ffi::{CString, c_char, c_int};
use std::ptr;
use std::sync::OnceLock;

use trimalla::refine::{Progress, Report};
use trimalla::{IndexedMesh, Point};

use crate::cancel::Cancel;
use crate::drawing::Drawing;
use crate::interface::{BAD_ARGUMENT, CANCELLED, CError, Fault, call, handle};
use crate::options::Options;

/// A mesh, with its arrays as C reads them.
#[derive(Debug)]
pub struct Mesh {
    mesh: IndexedMesh,
    /// `2 * points` numbers.
    xy: Vec<f64>,
    report: Option<Report>,
    warnings: Vec<CString>,
    /// `3 * triangles` indices, -1 for none; made when asked for.
    neighbours: OnceLock<Vec<i32>>,
    /// `2 * edges` indices; made when asked for.
    edges: OnceLock<Vec<u32>>,
}

impl Mesh {
    fn new(mesh: IndexedMesh, report: Option<Report>, warnings: impl Iterator<Item = String>) -> Self {
        let xy = mesh.points.iter().flat_map(|&Point { x, y }| [x, y]).collect();
        let warnings = warnings.map(|text| CString::new(text).unwrap_or_default()).collect();
        Self { mesh, xy, report, warnings, neighbours: OnceLock::new(), edges: OnceLock::new() }
    }
}

/// What came of a refinement, as C sees it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct CReport {
    min_angle: f64,
    max_angle: f64,
    points_added: u64,
    below_bound: u64,
    complete: c_int,
}

/// Meshes a drawing.
///
/// # Safety
/// `drawing` is live; `options` and `cancel` are null or live; `mesh` has room for one pointer; `error` is null or has
/// room for one error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_mesh_drawing(
    drawing: *mut Drawing,
    options: *const Options,
    cancel: *const Cancel,
    mesh: *mut *mut Mesh,
    error: *mut CError,
) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of each pointer.
        let (drawing, options, cancel) = unsafe { (handle(drawing, "drawing")?, options.as_ref(), cancel.as_ref()) };
        let is_cancelled = || cancel.is_some_and(Cancel::is_raised);
        if is_cancelled() {
            return Err(Fault::new(CANCELLED, "cancelled"));
        }
        let mut observer = |_: Progress| !is_cancelled();
        let made = trimalla::mesh_with(&drawing.0, &Options::mesh_options(options), &mut observer)?;
        if is_cancelled() {
            return Err(Fault::new(CANCELLED, "cancelled"));
        }
        let warnings = made.warnings.iter().map(ToString::to_string);
        Ok(Mesh::new(made.mesh, Some(made.report), warnings))
    };
    // SAFETY: as the caller promises of `mesh` and `error`.
    unsafe { hand_out(mesh, error, body) }
}

/// Triangulates a drawing without adding a point, but where segments cross.
///
/// # Safety
/// See [`trimalla_mesh_drawing`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_triangulate(
    drawing: *mut Drawing,
    options: *const Options,
    mesh: *mut *mut Mesh,
    error: *mut CError,
) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of each pointer.
        let (drawing, options) = unsafe { (handle(drawing, "drawing")?, options.as_ref()) };
        let made = trimalla::triangulate(&drawing.0, &Options::mesh_options(options).domain);
        let made = made.map_err(trimalla::Error::from)?;
        let warnings = made.warnings.iter().map(ToString::to_string);
        Ok(Mesh::new(made.mesh, None, warnings))
    };
    // SAFETY: as the caller promises of `mesh` and `error`.
    unsafe { hand_out(mesh, error, body) }
}

/// Stores what a body makes, or null.
///
/// # Safety
/// `mesh` is null or has room for one pointer; `error` is null or has room for one error.
unsafe fn hand_out(mesh: *mut *mut Mesh, error: *mut CError, body: impl FnOnce() -> Result<Mesh, Fault>) -> c_int {
    let whole = || {
        if mesh.is_null() {
            return Err(Fault::new(BAD_ARGUMENT, "the place for the mesh is null"));
        }
        // SAFETY: not null, and the caller promises room for one pointer.
        unsafe { mesh.write(ptr::null_mut()) };
        let made = Box::new(body()?);
        // SAFETY: not null, and the caller promises room for one pointer.
        unsafe { mesh.write(Box::into_raw(made)) };
        Ok(())
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, whole) }
}

/// Frees a mesh and its arrays; null is allowed.
///
/// # Safety
/// `mesh` is null or live; nobody uses its arrays any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_mesh_free(mesh: *mut Mesh) {
    if !mesh.is_null() {
        // SAFETY: made by `trimalla_mesh_drawing`, and freed once, as the caller promises.
        drop(unsafe { Box::from_raw(mesh) });
    }
}

/// Declares functions that read a mesh: a count, or the start of an array; 0 or null where there is no mesh.
macro_rules! readers {
    ($($(#[$doc:meta])* $name:ident: $kind:ty, |$mesh:ident| $value:expr, $none:expr;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `mesh` is null or live.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(mesh: *const Mesh) -> $kind {
            // SAFETY: null is checked by `as_ref`; else the caller promises a live mesh.
            let found = unsafe { mesh.as_ref() };
            found.map_or($none, |$mesh| $value)
        }
    )*};
}

/// The start of an array; null where it has no elements.
fn start<T>(array: &[T]) -> *const T {
    if array.is_empty() { ptr::null() } else { array.as_ptr() }
}

fn flat<const N: usize>(rows: &[[u32; N]]) -> *const u32 {
    start(rows.as_flattened())
}

fn neighbours(mesh: &Mesh) -> &[i32] {
    mesh.neighbours.get_or_init(|| {
        let rows = mesh.mesh.neighbours();
        rows.into_iter().flatten().map(|beyond| beyond.and_then(|t| i32::try_from(t).ok()).unwrap_or(-1)).collect()
    })
}

fn edges(mesh: &Mesh) -> &[u32] {
    mesh.edges.get_or_init(|| mesh.mesh.edges().into_iter().flatten().collect())
}

readers! {
    /// The number of points.
    trimalla_point_count: usize, |m| m.mesh.points.len(), 0;
    /// The number of points that were in the drawing; they come first.
    trimalla_input_point_count: usize, |m| m.mesh.input_points, 0;
    /// The points, x and y in turn.
    trimalla_points: *const f64, |m| start(&m.xy), ptr::null();
    /// A marker a point.
    trimalla_point_markers: *const i32, |m| start(&m.mesh.point_markers), ptr::null();
    /// The number of attributes a point.
    trimalla_attributes_per_point: usize, |m| m.mesh.attributes_per_point, 0;
    /// The attributes of points, row after row.
    trimalla_point_attributes: *const f64, |m| start(&m.mesh.point_attributes), ptr::null();
    /// The number of triangles.
    trimalla_triangle_count: usize, |m| m.mesh.triangles.len(), 0;
    /// The corners of triangles, counter-clockwise.
    trimalla_triangles: *const u32, |m| flat(&m.mesh.triangles), ptr::null();
    /// The number of attributes a triangle: 1 where the drawing has regions, else 0.
    trimalla_attributes_per_triangle: usize, |m| m.mesh.attributes_per_triangle, 0;
    /// The attributes of triangles.
    trimalla_triangle_attributes: *const f64, |m| start(&m.mesh.triangle_attributes), ptr::null();
    /// The neighbour of each triangle opposite each corner, -1 for none.
    trimalla_neighbours: *const i32, |m| start(neighbours(m)), ptr::null();
    /// The number of subsegments.
    trimalla_segment_count: usize, |m| m.mesh.segments.len(), 0;
    /// The ends of subsegments.
    trimalla_segments: *const u32, |m| flat(&m.mesh.segments), ptr::null();
    /// A marker a subsegment.
    trimalla_segment_markers: *const i32, |m| start(&m.mesh.segment_markers), ptr::null();
    /// The number of edges of triangles.
    trimalla_edge_count: usize, |m| edges(m).len() / 2, 0;
    /// The ends of edges, the lower index first.
    trimalla_edges: *const u32, |m| start(edges(m)), ptr::null();
    /// The number of warnings.
    trimalla_warning_count: usize, |m| m.warnings.len(), 0;
}

/// A warning in words; null where there is none of that index.
///
/// # Safety
/// `mesh` is null or live.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_warning(mesh: *const Mesh, index: usize) -> *const c_char {
    // SAFETY: null is checked by `as_ref`; else the caller promises a live mesh.
    let warning = unsafe { mesh.as_ref() }.and_then(|mesh| mesh.warnings.get(index));
    warning.map_or(ptr::null(), |text| text.as_ptr())
}

/// What came of the refinement; zeros where there was none.
///
/// # Safety
/// `mesh` is null or live; `report` is null or has room for one report.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_report(mesh: *const Mesh, report: *mut CReport) {
    // SAFETY: null is checked by `as_ref`; else the caller promises a live mesh.
    let made = unsafe { mesh.as_ref() }.and_then(|mesh| mesh.report.as_ref());
    let found = made.map_or_else(CReport::default, |made| CReport {
        min_angle: made.min_angle_deg,
        max_angle: made.max_angle_deg,
        points_added: made.steiner_points as u64,
        below_bound: made.leftovers.len() as u64,
        complete: c_int::from(made.complete()),
    });
    if !report.is_null() {
        // SAFETY: not null, and the caller promises room for one report.
        unsafe { report.write(found) };
    }
}

/// The version of the library.
#[unsafe(no_mangle)]
pub extern "C" fn trimalla_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}
