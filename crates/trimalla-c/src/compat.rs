//! Triangle's in/out structure: `include/triangle_compat.h`.
//!
//! ```text
//!   in ──> Input (slices of the caller's arrays, copied) ──> trimalla-triangle ──> out, vorout (malloc)
//! ```
//! Every count and index is checked before it is followed. A call that fails leaves counts of 0 in `out` and frees what
//! it has allocated; its message is that of [`triangulate_error`], and a line on standard error, as a caller written
//! for Triangle asks for none.

use std::cell::RefCell;
use std::ffi::{CString, c_char, c_int, c_void};
use std::io::Write as _;
use std::ptr;

use trimalla::refine::NoObserver;
use trimalla::{IndexedMesh, Point, Pslg, Region};
use trimalla_triangle::{Edges, Input, Made, Switches, Voronoi, VoronoiEdge, triangulate as mesh_of};

use crate::interface::{BAD_OPTION, Fault, caught, slice};
use crate::memory::{give, release};
use crate::options::text;

/// Triangle's in/out structure. The header says what each field holds.
#[repr(C)]
#[derive(Debug)]
#[expect(missing_docs, reason = "the header explains the fields, whose names and order are Triangle's")]
pub struct TriangulateIo {
    pub pointlist: *mut f64,
    pub pointattributelist: *mut f64,
    pub pointmarkerlist: *mut c_int,
    pub numberofpoints: c_int,
    pub numberofpointattributes: c_int,
    pub trianglelist: *mut c_int,
    pub triangleattributelist: *mut f64,
    pub trianglearealist: *mut f64,
    pub neighborlist: *mut c_int,
    pub numberoftriangles: c_int,
    pub numberofcorners: c_int,
    pub numberoftriangleattributes: c_int,
    pub segmentlist: *mut c_int,
    pub segmentmarkerlist: *mut c_int,
    pub numberofsegments: c_int,
    pub holelist: *mut f64,
    pub numberofholes: c_int,
    pub regionlist: *mut f64,
    pub numberofregions: c_int,
    pub edgelist: *mut c_int,
    pub edgemarkerlist: *mut c_int,
    pub normlist: *mut f64,
    pub numberofedges: c_int,
}

thread_local! {
    static ERROR: RefCell<Option<CString>> = const { RefCell::new(None) };
}

/// Triangulates as the switches say.
///
/// # Safety
/// `switches` has a zero at its end; `input` and `out` are live structures whose arrays have as many elements as they
/// announce; arrays of `out` and `vorout` are null or have room for the result; `vorout` is null or live.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn triangulate(
    switches: *mut c_char,
    input: *mut TriangulateIo,
    out: *mut TriangulateIo,
    vorout: *mut TriangulateIo,
) {
    // SAFETY: as the caller promises.
    let done = caught(|| unsafe { run(switches, input, out, vorout) });
    let message = done.err().map(|fault| fault.message);
    if let Some(message) = &message {
        let _ = writeln!(std::io::stderr(), "error: {message}");
        for structure in [out, vorout] {
            // SAFETY: null is checked by `as_mut`; else the caller promises a live structure.
            if let Some(structure) = unsafe { structure.as_mut() } {
                clear_counts(structure);
            }
        }
    }
    let message = message.map(|text| CString::new(text).unwrap_or_default());
    ERROR.with_borrow_mut(|error| *error = message);
}

/// Why the last call of [`triangulate`] in this thread failed; null if it did not.
#[unsafe(no_mangle)]
pub extern "C" fn triangulate_error() -> *const c_char {
    ERROR.with_borrow(|error| error.as_ref().map_or(ptr::null(), |text| text.as_ptr()))
}

/// Frees an array that [`triangulate`] has allocated; null is allowed.
///
/// # Safety
/// `memory` is null or came from [`triangulate`] and was not freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trifree(memory: *mut c_void) {
    // SAFETY: as the caller promises: all arrays come from `malloc`.
    unsafe { release(memory) };
}

/// # Safety
/// See [`triangulate`].
unsafe fn run(
    switches: *mut c_char,
    input: *mut TriangulateIo,
    out: *mut TriangulateIo,
    vorout: *mut TriangulateIo,
) -> Result<(), Fault> {
    // SAFETY: as the caller promises of each pointer.
    let (word, input, out, mut vorout) =
        unsafe { (text(switches, "text of switches")?, input.as_ref(), out.as_mut(), vorout.as_mut()) };
    let (Some(input), Some(out)) = (input, out) else {
        return Err(Fault::argument("the structure in or out is null"));
    };
    let switches = Switches::parse(word).map_err(|error| Fault::new(BAD_OPTION, error.to_string()))?;
    if switches.voronoi && vorout.is_none() {
        return Err(Fault::argument("-v needs the structure vorout"));
    }
    let first = c_int::from(!switches.from_zero);
    // SAFETY: as the caller promises of the arrays of `input`.
    let made = unsafe { made(input, &switches, first)? };
    let mut new = Vec::new();
    // SAFETY: as the caller promises of the arrays of `out` and `vorout`.
    let given = unsafe { fill(out, vorout.as_deref_mut(), input, &made, &switches, first, &mut new) };
    if given.is_err() {
        [Some(out), vorout].into_iter().flatten().for_each(|structure| forget(structure, &new));
        // SAFETY: each came from `malloc` a moment ago, and no structure names it any more.
        new.into_iter().for_each(|memory| unsafe { release(memory) });
    }
    given
}

/// # Safety
/// The arrays of `input` have as many elements as it announces.
unsafe fn made(input: &TriangulateIo, switches: &Switches, first: c_int) -> Result<Made, Fault> {
    if !switches.refine {
        // SAFETY: as the caller promises.
        let drawing = unsafe { drawing(input, switches, first)? };
        return mesh_of(&Input::Drawing(&drawing), switches, &mut NoObserver).map_err(of_triangle);
    }
    // SAFETY: as the caller promises.
    let (mesh, areas) = unsafe { (mesh(input, switches, first)?, areas(input, switches)?) };
    mesh_of(&Input::Mesh(&mesh, &areas), switches, &mut NoObserver).map_err(of_triangle)
}

fn of_triangle(error: trimalla_triangle::TriangleError) -> Fault {
    match error {
        trimalla_triangle::TriangleError::Mesh(error) => error.into(),
        other => Fault::argument(other.to_string()),
    }
}

/// A count that is not negative.
fn count(n: c_int, what: &str) -> Result<usize, Fault> {
    usize::try_from(n).map_err(|_| Fault::argument(format!("the number of {what} is {n}")))
}

/// An index of the caller's, counted from 0.
fn index(named: c_int, first: c_int, points: usize, what: &str, row: usize) -> Result<u32, Fault> {
    let counted = u32::try_from(i64::from(named) - i64::from(first)).ok().filter(|&v| (v as usize) < points);
    counted.ok_or_else(|| {
        let last = points as i64 - 1 + i64::from(first);
        let row = row as i64 + i64::from(first);
        Fault::argument(format!("{what} {row} names point {named}, not between {first} and {last}"))
    })
}

/// The points with their markers and attributes.
///
/// # Safety
/// As for [`made`].
unsafe fn points(input: &TriangulateIo) -> Result<Pslg, Fault> {
    let n = count(input.numberofpoints, "points")?;
    let width = count(input.numberofpointattributes, "attributes a point")?;
    // SAFETY: as the caller promises; counts cannot overflow, as they were of 31 bits.
    let (xy, markers, attributes) = unsafe {
        let markers: &[c_int] =
            if input.pointmarkerlist.is_null() { &[] } else { slice(input.pointmarkerlist, n, "point markers")? };
        (slice(input.pointlist, 2 * n, "points")?, markers, slice(input.pointattributelist, n * width, "attributes")?)
    };
    Ok(Pslg {
        points: xy.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect(),
        point_markers: markers.to_vec(),
        attributes_per_point: width,
        point_attributes: attributes.to_vec(),
        ..Pslg::default()
    })
}

/// # Safety
/// As for [`made`].
unsafe fn drawing(input: &TriangulateIo, switches: &Switches, first: c_int) -> Result<Pslg, Fault> {
    // SAFETY: as the caller promises.
    let mut drawing = unsafe { points(input)? };
    if !switches.drawing {
        return Ok(drawing);
    }
    // SAFETY: as the caller promises.
    (drawing.segments, drawing.segment_markers) = unsafe { segments(input, first, drawing.points.len())? };
    if !switches.no_holes {
        let n = count(input.numberofholes, "holes")?;
        // SAFETY: as the caller promises.
        let holes = unsafe { slice(input.holelist, 2 * n, "holes")? };
        drawing.holes = holes.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect();
    }
    if switches.attributes || switches.own_areas {
        let n = count(input.numberofregions, "regions")?;
        // SAFETY: as the caller promises.
        let regions = unsafe { slice(input.regionlist, 4 * n, "regions")? };
        let region = |r: &[f64]| Region {
            seed: Point::new(r[0], r[1]),
            attribute: r[2],
            max_area: Some(r[3]).filter(|&area| area > 0.0),
        };
        drawing.regions = regions.chunks_exact(4).map(region).collect();
    }
    Ok(drawing)
}

/// The segments and their markers.
///
/// # Safety
/// As for [`made`].
unsafe fn segments(input: &TriangulateIo, first: c_int, points: usize) -> Result<(Vec<[u32; 2]>, Vec<i32>), Fault> {
    let n = count(input.numberofsegments, "segments")?;
    // SAFETY: as the caller promises.
    let (ends, markers) = unsafe {
        let markers: &[c_int] =
            if input.segmentmarkerlist.is_null() { &[] } else { slice(input.segmentmarkerlist, n, "segment markers")? };
        (slice(input.segmentlist, 2 * n, "segments")?, markers)
    };
    let of = |row: usize, named: c_int| index(named, first, points, "segment", row);
    let rows = ends.chunks_exact(2).enumerate().map(|(row, ends)| Ok([of(row, ends[0])?, of(row, ends[1])?]));
    Ok((rows.collect::<Result<_, Fault>>()?, markers.to_vec()))
}

/// # Safety
/// As for [`made`].
unsafe fn mesh(input: &TriangulateIo, switches: &Switches, first: c_int) -> Result<IndexedMesh, Fault> {
    // SAFETY: as the caller promises.
    let points = unsafe { points(input)? };
    let n = count(input.numberoftriangles, "triangles")?;
    let corners = count(input.numberofcorners, "corners a triangle")?;
    let width = count(input.numberoftriangleattributes, "attributes a triangle")?;
    if corners != 3 && corners != 6 {
        return Err(Fault::argument(format!("{corners} corners a triangle; 3 and 6 can be")));
    }
    // SAFETY: as the caller promises.
    let (rows, attributes) = unsafe {
        let attributes = slice(input.triangleattributelist, n * width, "attributes of triangles")?;
        (slice(input.trianglelist, n * corners, "triangles")?, attributes)
    };
    let of = |row: usize, named: c_int| index(named, first, points.points.len(), "triangle", row);
    let rows = rows.chunks_exact(corners).enumerate();
    let triangles = rows.map(|(row, t)| Ok([of(row, t[0])?, of(row, t[1])?, of(row, t[2])?]));
    let triangles = triangles.collect::<Result<Vec<_>, Fault>>()?;
    let (segments, segment_markers) = if switches.drawing {
        // SAFETY: as the caller promises.
        unsafe { segments(input, first, points.points.len())? }
    } else {
        Default::default()
    };
    Ok(IndexedMesh {
        triangles,
        attributes_per_triangle: width,
        triangle_attributes: attributes.to_vec(),
        segments,
        segment_markers,
        input_points: points.points.len(),
        points: points.points,
        point_markers: points.point_markers,
        attributes_per_point: points.attributes_per_point,
        point_attributes: points.point_attributes,
        ..IndexedMesh::default()
    })
}

/// The area bounds of triangles, where they count.
///
/// # Safety
/// As for [`made`].
unsafe fn areas(input: &TriangulateIo, switches: &Switches) -> Result<Vec<Option<f64>>, Fault> {
    if !switches.own_areas {
        return Ok(Vec::new());
    }
    let n = count(input.numberoftriangles, "triangles")?;
    // SAFETY: as the caller promises.
    let areas = unsafe { slice(input.trianglearealist, n, "areas of triangles")? };
    Ok(areas.iter().map(|&area| Some(area).filter(|&area| area > 0.0)).collect())
}

/// Fills the structures of the caller; what is allocated on the way is listed.
///
/// # Safety
/// Arrays of the structures are null or have room.
unsafe fn fill(
    out: &mut TriangulateIo,
    vorout: Option<&mut TriangulateIo>,
    input: &TriangulateIo,
    made: &Made,
    switches: &Switches,
    first: c_int,
    new: &mut Vec<*mut c_void>,
) -> Result<(), Fault> {
    let mesh = &made.mesh;
    let number = |v: u32| v as c_int + first;
    let counts = [mesh.points.len(), 6 * mesh.triangles.len(), 2 * made.edge_counts[0], 2 * mesh.segments.len()];
    if counts.into_iter().any(|n| n >= c_int::MAX as usize) {
        return Err(Fault::argument("the mesh has more items than its structure can count"));
    }
    clear_counts(out);
    // SAFETY: as the caller promises of each array.
    unsafe {
        if !switches.no_vertices {
            give_points(out, mesh, new)?;
        }
        out.numberofpoints = mesh.points.len() as c_int;
        out.numberofpointattributes = mesh.attributes_per_point as c_int;
        if !switches.no_triangles {
            give_triangles(out, made, &number, new)?;
        }
        out.numberoftriangles = mesh.triangles.len() as c_int;
        out.numberofcorners = if made.middles.is_empty() { 3 } else { 6 };
        out.numberoftriangleattributes = mesh.attributes_per_triangle as c_int;
        if let Some(neighbours) = &made.neighbours {
            let flat = neighbours.iter().flatten().map(|t| t.map_or(-1, &number));
            give(&mut out.neighborlist, &flat.collect::<Vec<c_int>>(), new)?;
        }
        if !switches.no_segments && (switches.drawing || switches.hull) {
            let flat: Vec<c_int> = mesh.segments.iter().flatten().map(|&v| number(v)).collect();
            give(&mut out.segmentlist, &flat, new)?;
            if !switches.no_markers {
                give(&mut out.segmentmarkerlist, &mesh.segment_markers, new)?;
            }
            out.numberofsegments = mesh.segments.len() as c_int;
        }
        if let Some(edges) = made.edges.as_ref().filter(|_| switches.edges) {
            give_edges(out, edges, &number, new)?;
        }
        if let (Some(vorout), Some(voronoi)) = (vorout, &made.voronoi) {
            give_voronoi(vorout, voronoi, &number, new)?;
        }
    }
    // Seeds are the caller's own arrays, for its convenience.
    (out.holelist, out.numberofholes) = (input.holelist, input.numberofholes);
    (out.regionlist, out.numberofregions) = (input.regionlist, input.numberofregions);
    Ok(())
}

/// # Safety
/// Arrays of `out` are null or have room.
unsafe fn give_points(out: &mut TriangulateIo, mesh: &IndexedMesh, new: &mut Vec<*mut c_void>) -> Result<(), Fault> {
    let xy: Vec<f64> = mesh.points.iter().flat_map(|p| [p.x, p.y]).collect();
    // SAFETY: as the caller promises of each array.
    unsafe {
        give(&mut out.pointlist, &xy, new)?;
        if mesh.attributes_per_point > 0 {
            give(&mut out.pointattributelist, &mesh.point_attributes, new)?;
        }
        if !mesh.point_markers.is_empty() {
            give(&mut out.pointmarkerlist, &mesh.point_markers, new)?;
        }
    }
    Ok(())
}

/// # Safety
/// Arrays of `out` are null or have room.
unsafe fn give_triangles(
    out: &mut TriangulateIo,
    made: &Made,
    number: &dyn Fn(u32) -> c_int,
    new: &mut Vec<*mut c_void>,
) -> Result<(), Fault> {
    let mesh = &made.mesh;
    let mut nodes: Vec<c_int> = Vec::with_capacity(mesh.triangles.len() * 6);
    for (t, corners) in mesh.triangles.iter().enumerate() {
        nodes.extend(corners.iter().chain(made.middles.get(t).into_iter().flatten()).map(|&v| number(v)));
    }
    // SAFETY: as the caller promises of each array.
    unsafe {
        give(&mut out.trianglelist, &nodes, new)?;
        if mesh.attributes_per_triangle > 0 {
            give(&mut out.triangleattributelist, &mesh.triangle_attributes, new)?;
        }
    }
    Ok(())
}

/// # Safety
/// Arrays of `out` are null or have room.
unsafe fn give_edges(
    out: &mut TriangulateIo,
    edges: &Edges,
    number: &dyn Fn(u32) -> c_int,
    new: &mut Vec<*mut c_void>,
) -> Result<(), Fault> {
    let flat: Vec<c_int> = edges.ends.iter().flatten().map(|&v| number(v)).collect();
    // SAFETY: as the caller promises of each array.
    unsafe {
        give(&mut out.edgelist, &flat, new)?;
        if !edges.markers.is_empty() {
            give(&mut out.edgemarkerlist, &edges.markers, new)?;
        }
    }
    out.numberofedges = edges.ends.len() as c_int;
    Ok(())
}

/// # Safety
/// Arrays of `out` are null or have room.
unsafe fn give_voronoi(
    out: &mut TriangulateIo,
    voronoi: &Voronoi,
    number: &dyn Fn(u32) -> c_int,
    new: &mut Vec<*mut c_void>,
) -> Result<(), Fault> {
    let vertices = &voronoi.vertices;
    let xy: Vec<f64> = vertices.points.iter().flat_map(|p| [p.x, p.y]).collect();
    let ends = voronoi.edges.iter().flat_map(|edge| match *edge {
        VoronoiEdge::Between(ends) => ends.map(number),
        VoronoiEdge::Ray { from, .. } => [number(from), -1],
    });
    let directions = voronoi.edges.iter().flat_map(|edge| match *edge {
        VoronoiEdge::Between(_) => [0.0, 0.0],
        VoronoiEdge::Ray { direction, .. } => direction,
    });
    clear_counts(out);
    // SAFETY: as the caller promises of each array.
    unsafe {
        give(&mut out.pointlist, &xy, new)?;
        if vertices.attributes_per_point > 0 {
            give(&mut out.pointattributelist, &vertices.point_attributes, new)?;
        }
        give(&mut out.edgelist, &ends.collect::<Vec<c_int>>(), new)?;
        give(&mut out.normlist, &directions.collect::<Vec<f64>>(), new)?;
    }
    out.numberofpoints = vertices.points.len() as c_int;
    out.numberofpointattributes = vertices.attributes_per_point as c_int;
    out.numberofedges = voronoi.edges.len() as c_int;
    Ok(())
}

/// Sets to null what a structure names of the given memory.
fn forget(structure: &mut TriangulateIo, memory: &[*mut c_void]) {
    fn forget_one<T>(slot: &mut *mut T, memory: &[*mut c_void]) {
        if memory.contains(&slot.cast()) {
            *slot = ptr::null_mut();
        }
    }
    let s = structure;
    for slot in [&mut s.pointlist, &mut s.pointattributelist, &mut s.triangleattributelist, &mut s.normlist] {
        forget_one(slot, memory);
    }
    for slot in [
        &mut s.pointmarkerlist,
        &mut s.trianglelist,
        &mut s.neighborlist,
        &mut s.segmentlist,
        &mut s.segmentmarkerlist,
        &mut s.edgelist,
        &mut s.edgemarkerlist,
    ] {
        forget_one(slot, memory);
    }
}

/// Sets every count of a structure to 0.
fn clear_counts(structure: &mut TriangulateIo) {
    for count in [
        &mut structure.numberofpoints,
        &mut structure.numberofpointattributes,
        &mut structure.numberoftriangles,
        &mut structure.numberofcorners,
        &mut structure.numberoftriangleattributes,
        &mut structure.numberofsegments,
        &mut structure.numberofholes,
        &mut structure.numberofregions,
        &mut structure.numberofedges,
    ] {
        *count = 0;
    }
}
