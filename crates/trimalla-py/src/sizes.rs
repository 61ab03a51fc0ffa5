//! Sizes as Python hands them over.

use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use trimalla::geometry::{BoundingBox, Segment};
use trimalla::size::{AreaBound, Graded, SizeSource, Uniform};
use trimalla::{Point, Sizing};

use crate::arrays::give_points;
use crate::errors::Fault;
use crate::sampled::Sampled;

/// Reads `edge` (a length), `sources` (k, 5: a segment and the length along it), `gradation`, `function`, `growth` and
/// `triangles`. The function is called here, so it may raise.
pub(crate) fn sizing(dict: &Bound<'_, PyDict>, points: &[Point]) -> PyResult<Sizing> {
    let mut sizing = Sizing::default();
    if let Some(edge) = present::<f64>(dict, "edge")? {
        sizing = sizing.with_field(Uniform(AreaBound::of_edge(positive(edge, "size")?)));
    }
    if let Some(sources) = dict.get_item("sources")?.filter(|found| !found.is_none()) {
        let growth = present(dict, "gradation")?.unwrap_or(0.3);
        let sources: PyReadonlyArray2<'_, f64> = sources.extract()?;
        let field = Graded::new(&sources_of(&sources)?, growth);
        sizing = sizing.with_field(field.map_err(|error| Fault::option(error.to_string()))?);
    }
    if let Some(function) = dict.get_item("function")?.filter(|found| !found.is_none()) {
        let bounds = BoundingBox::of(points.iter().copied().filter(|p| p.is_finite()));
        if let Some(bounds) = bounds {
            sizing = sizing.with_field(Sampled::of(bounds, |places| lengths(&function, places))?);
        }
    }
    if let Some(factor) = present(dict, "growth")? {
        sizing = sizing.with_growth(factor).map_err(|error| Fault::option(error.to_string()))?;
    }
    if let Some(triangles) = present::<usize>(dict, "triangles")? {
        sizing = sizing.with_triangles(triangles);
    }
    Ok(sizing)
}

fn present<T: for<'a, 'py> FromPyObject<'a, 'py, Error = PyErr>>(
    dict: &Bound<'_, PyDict>,
    key: &str,
) -> PyResult<Option<T>> {
    match dict.get_item(key)? {
        Some(found) if !found.is_none() => Ok(Some(found.extract()?)),
        _ => Ok(None),
    }
}

fn positive(length: f64, what: &str) -> Result<f64, Fault> {
    if length > 0.0 && length.is_finite() {
        Ok(length)
    } else {
        Err(Fault::option(format!("{what} must be positive and finite, not {length}")))
    }
}

fn sources_of(array: &PyReadonlyArray2<'_, f64>) -> Result<Vec<SizeSource>, Fault> {
    let view = array.as_array();
    if view.ncols() != 5 {
        return Err(Fault::option(format!("sources must have 5 columns, not {}", view.ncols())));
    }
    let source = |row: numpy::ndarray::ArrayView1<'_, f64>| {
        SizeSource::along(Segment::new(Point::new(row[0], row[1]), Point::new(row[2], row[3])), row[4])
    };
    Ok(view.rows().into_iter().map(source).collect())
}

/// Calls the function with an array (k, 2); it returns k lengths.
fn lengths(function: &Bound<'_, PyAny>, places: &[Point]) -> PyResult<Vec<f64>> {
    if places.is_empty() {
        return Ok(Vec::new());
    }
    let py = function.py();
    py.check_signals()?;
    let answer: PyReadonlyArray1<'_, f64> = function.call1((give_points(py, places)?,))?.extract()?;
    let lengths: Vec<f64> = answer.as_array().iter().copied().collect();
    if lengths.len() != places.len() {
        return Err(
            Fault::option(format!("size returned {} lengths for {} points", lengths.len(), places.len())).into()
        );
    }
    for (&length, &place) in lengths.iter().zip(places) {
        if length.is_nan() || length <= 0.0 {
            return Err(Fault::option(format!("size returned {length} at {place}; lengths must be positive"))
                .near([place])
                .into());
        }
    }
    Ok(lengths)
}
