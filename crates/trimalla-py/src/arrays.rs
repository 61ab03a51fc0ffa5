//! Arrays of numpy as drawings and meshes, and back.
//!
//! The Python side hands over dictionaries of contiguous arrays of the types named here; it converts lists and other
//! types before. Shapes and indices are checked here.

use numpy::ndarray::ArrayView2;
use numpy::{IntoPyArray, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use trimalla::{IndexedMesh, Point, Pslg, Region};

use crate::errors::{Class, Fault};

/// A table of numbers; `None` where the key is missing or `None`.
fn table<'py, T: numpy::Element>(dict: &Bound<'py, PyDict>, key: &str) -> PyResult<Option<PyReadonlyArray2<'py, T>>> {
    match dict.get_item(key)? {
        Some(found) if !found.is_none() => Ok(Some(found.extract()?)),
        _ => Ok(None),
    }
}

/// A column of numbers; empty where the key is missing or `None`.
fn column<T: numpy::Element + Copy>(dict: &Bound<'_, PyDict>, key: &str) -> PyResult<Vec<T>> {
    match dict.get_item(key)? {
        Some(found) if !found.is_none() => {
            let array: PyReadonlyArray1<'_, T> = found.extract()?;
            Ok(array.as_array().iter().copied().collect())
        }
        _ => Ok(Vec::new()),
    }
}

/// Rows of points.
pub(crate) fn points_of(array: &PyReadonlyArray2<'_, f64>, what: &str) -> Result<Vec<Point>, Fault> {
    let view = array.as_array();
    if view.ncols() != 2 {
        return Err(Fault::shape(format!("{what} must have 2 columns, not {}", view.ncols())));
    }
    if let Some(flat) = view.as_slice() {
        return Ok(flat.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect());
    }
    Ok(view.rows().into_iter().map(|p| Point::new(p[0], p[1])).collect())
}

fn points_in(dict: &Bound<'_, PyDict>, key: &str) -> PyResult<Vec<Point>> {
    Ok(table(dict, key)?.map_or(Ok(Vec::new()), |array| points_of(&array, key))?)
}

/// Rows of indices, each of which must be that of a point.
pub(crate) fn indices_of<const N: usize>(
    view: ArrayView2<'_, i64>,
    points: usize,
    what: &str,
    class: Class,
) -> Result<Vec<[u32; N]>, Fault> {
    if view.ncols() != N {
        return Err(Fault::new(class, "shape", format!("{what}s must have {N} columns, not {}", view.ncols())));
    }
    let mut rows = Vec::with_capacity(view.nrows());
    for (i, row) in view.rows().into_iter().enumerate() {
        let mut ends = [0; N];
        for (end, &named) in ends.iter_mut().zip(row) {
            let found = u32::try_from(named).ok().filter(|&v| (v as usize) < points);
            *end = found.ok_or_else(|| {
                let message = format!("{what} {i} names point {named}, but there are {points} points");
                Fault::new(class, "no-such-vertex", message).at([i])
            })?;
        }
        rows.push(ends);
    }
    Ok(rows)
}

/// A table of attributes as how many a row has, and the rows one after the other.
fn attributes(dict: &Bound<'_, PyDict>, key: &str) -> PyResult<(usize, Vec<f64>)> {
    let Some(array) = table::<f64>(dict, key)? else { return Ok((0, Vec::new())) };
    Ok((array.shape()[1], array.as_array().iter().copied().collect()))
}

/// A drawing: `points` float64 (n, 2), `point_markers` int32 (n), `point_attributes` float64 (n, k), `segments` int64
/// (m, 2), `segment_markers` int32 (m), `holes` float64 (h, 2), `regions` float64 (r, 4): x, y, attribute, area.
pub(crate) fn drawing(dict: &Bound<'_, PyDict>) -> PyResult<Pslg> {
    let points = points_in(dict, "points")?;
    let segments = match table::<i64>(dict, "segments")? {
        Some(array) => indices_of::<2>(array.as_array(), points.len(), "segment", Class::Drawing)?,
        None => Vec::new(),
    };
    let (attributes_per_point, point_attributes) = attributes(dict, "point_attributes")?;
    let drawing = Pslg {
        point_markers: column(dict, "point_markers")?,
        attributes_per_point,
        point_attributes,
        segments,
        segment_markers: column(dict, "segment_markers")?,
        holes: points_in(dict, "holes")?,
        regions: regions(dict)?,
        points,
    };
    drawing.validate().map_err(Fault::from)?;
    Ok(drawing)
}

fn regions(dict: &Bound<'_, PyDict>) -> PyResult<Vec<Region>> {
    let Some(array) = table::<f64>(dict, "regions")? else { return Ok(Vec::new()) };
    let view = array.as_array();
    if view.ncols() != 4 {
        let message = format!("regions must have 4 columns (x, y, attribute, largest area), not {}", view.ncols());
        return Err(Fault::shape(message).into());
    }
    let region = |row: numpy::ndarray::ArrayView1<'_, f64>| Region {
        seed: Point::new(row[0], row[1]),
        attribute: row[2],
        max_area: Some(row[3]).filter(|&area| area > 0.0 && area.is_finite()),
    };
    Ok(view.rows().into_iter().map(region).collect())
}

/// A mesh: as a drawing without regions, and `triangles` int64 (t, 3), `triangle_attributes` float64 (t, k),
/// `input_points`.
pub(crate) fn mesh(dict: &Bound<'_, PyDict>) -> PyResult<IndexedMesh> {
    let points = points_in(dict, "points")?;
    let triangles = match table::<i64>(dict, "triangles")? {
        Some(array) => indices_of::<3>(array.as_array(), points.len(), "triangle", Class::Mesh)?,
        None => Vec::new(),
    };
    let segments = match table::<i64>(dict, "segments")? {
        Some(array) => indices_of::<2>(array.as_array(), points.len(), "segment", Class::Mesh)?,
        None => Vec::new(),
    };
    let (attributes_per_point, point_attributes) = attributes(dict, "point_attributes")?;
    let (attributes_per_triangle, triangle_attributes) = attributes(dict, "triangle_attributes")?;
    let input_points = match dict.get_item("input_points")? {
        Some(count) => count.extract::<usize>()?.min(points.len()),
        None => points.len(),
    };
    let made = IndexedMesh {
        point_markers: column(dict, "point_markers")?,
        attributes_per_point,
        point_attributes,
        triangles,
        attributes_per_triangle,
        triangle_attributes,
        segments,
        segment_markers: column(dict, "segment_markers")?,
        holes: points_in(dict, "holes")?,
        input_points,
        points,
    };
    check_columns(&made)?;
    Ok(made)
}

fn check_columns(mesh: &IndexedMesh) -> Result<(), Fault> {
    let (points, triangles) = (mesh.points.len(), mesh.triangles.len());
    let may_lack = |found: usize, expected: usize| found == 0 || found == expected;
    for (what, is_right) in [
        ("point_markers", may_lack(mesh.point_markers.len(), points)),
        ("point_attributes", mesh.point_attributes.len() == points.saturating_mul(mesh.attributes_per_point)),
        (
            "triangle_attributes",
            mesh.triangle_attributes.len() == triangles.saturating_mul(mesh.attributes_per_triangle),
        ),
        ("segment_markers", may_lack(mesh.segment_markers.len(), mesh.segments.len())),
    ] {
        if !is_right {
            return Err(Fault::new(Class::Mesh, "shape", format!("{what} has not as many rows as needed")));
        }
    }
    Ok(())
}

/// Rows of points as an array.
pub(crate) fn give_points<'py>(py: Python<'py>, points: &[Point]) -> PyResult<Bound<'py, PyAny>> {
    let flat: Vec<f64> = points.iter().flat_map(|p| [p.x, p.y]).collect();
    give_rows(py, flat, 2)
}

/// A vector as an array of so many columns, without a copy.
pub(crate) fn give_rows<T: numpy::Element>(py: Python<'_>, flat: Vec<T>, columns: usize) -> PyResult<Bound<'_, PyAny>> {
    let rows = flat.len().checked_div(columns).unwrap_or(0);
    Ok(flat.into_pyarray(py).reshape([rows, columns])?.into_any())
}

/// Rows of indices as an array of int32; the library has fewer than 2^31 points.
pub(crate) fn give_indices<const N: usize>(py: Python<'_>, rows: Vec<[u32; N]>) -> PyResult<Bound<'_, PyAny>> {
    let flat: Vec<i32> = rows.into_flattened().into_iter().map(|v| v as i32).collect();
    give_rows(py, flat, N)
}

/// The neighbours of triangles as an array of int32, -1 for none.
pub(crate) fn give_neighbours<'py>(py: Python<'py>, rows: &[[Option<u32>; 3]]) -> PyResult<Bound<'py, PyAny>> {
    let flat: Vec<i32> = rows.iter().flatten().map(|t| t.map_or(-1, |t| t as i32)).collect();
    give_rows(py, flat, 3)
}

/// A mesh as a dictionary of arrays.
pub(crate) fn give_mesh<'py>(py: Python<'py>, mesh: IndexedMesh) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("input_points", mesh.input_points)?;
    dict.set_item("point_attributes", attribute_rows(py, mesh.point_attributes, mesh.points.len())?)?;
    dict.set_item("triangle_attributes", attribute_rows(py, mesh.triangle_attributes, mesh.triangles.len())?)?;
    dict.set_item("points", give_points(py, &mesh.points)?)?;
    dict.set_item("point_markers", mesh.point_markers.into_pyarray(py))?;
    dict.set_item("triangles", give_indices(py, mesh.triangles)?)?;
    dict.set_item("segments", give_indices(py, mesh.segments)?)?;
    dict.set_item("segment_markers", mesh.segment_markers.into_pyarray(py))?;
    dict.set_item("holes", give_points(py, &mesh.holes)?)?;
    Ok(dict)
}

fn attribute_rows(py: Python<'_>, flat: Vec<f64>, rows: usize) -> PyResult<Bound<'_, PyAny>> {
    let columns = flat.len().checked_div(rows).unwrap_or(0);
    Ok(flat.into_pyarray(py).reshape([rows, columns])?.into_any())
}

/// A drawing as a dictionary of arrays.
pub(crate) fn give_drawing<'py>(py: Python<'py>, drawing: Pslg) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let rows = drawing.points.len();
    dict.set_item("points", give_points(py, &drawing.points)?)?;
    dict.set_item("point_markers", drawing.point_markers.into_pyarray(py))?;
    dict.set_item("point_attributes", attribute_rows(py, drawing.point_attributes, rows)?)?;
    dict.set_item("segments", give_indices(py, drawing.segments)?)?;
    dict.set_item("segment_markers", drawing.segment_markers.into_pyarray(py))?;
    dict.set_item("holes", give_points(py, &drawing.holes)?)?;
    let regions = drawing.regions.iter();
    let flat = regions.flat_map(|r| [r.seed.x, r.seed.y, r.attribute, r.max_area.unwrap_or(0.0)]).collect();
    dict.set_item("regions", give_rows::<f64>(py, flat, 4)?)?;
    Ok(dict)
}
