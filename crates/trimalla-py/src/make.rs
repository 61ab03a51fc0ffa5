//! Meshing: a drawing or a mesh in, a mesh out.

use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use trimalla::delaunay::{AlgorithmKey, Triangulator};
use trimalla::domain::Warning;
use trimalla::refine::Report;
use trimalla::trace::NoTrace;
use trimalla::{DomainOptions, Meshed, Method, Pslg, Triangulated};

use crate::arrays::{drawing as drawing_in, give_indices, give_mesh, mesh as mesh_in, points_of};
use crate::errors::Fault;
use crate::options::Options;
use crate::sizes::sizing;
use crate::worker::run;

/// A mesh, its report or `None`, and warnings in words.
type Made<'py> = (Bound<'py, PyDict>, Option<Bound<'py, PyDict>>, Vec<String>);

/// Meshes a drawing.
#[pyfunction]
#[pyo3(signature = (drawing, options, size, progress=None))]
pub(crate) fn mesh<'py>(
    py: Python<'py>,
    drawing: &Bound<'py, PyDict>,
    options: &Bound<'py, PyDict>,
    size: &Bound<'py, PyDict>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Made<'py>> {
    let drawing = drawing_in(drawing)?;
    let options = Options::of(options)?.mesh_options();
    let sizing = sizing(size, &drawing.points)?;
    let made =
        run(py, progress, move |mut reporter| Ok(trimalla::mesh_sized(&drawing, &options, &sizing, &mut reporter)?))?;
    give(py, made)
}

/// Refines a mesh: `areas` is empty or has the largest area of each triangle, 0 for none.
#[pyfunction]
#[pyo3(signature = (mesh, drawing, areas, options, size, progress=None))]
pub(crate) fn refine<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, PyDict>,
    drawing: Option<&Bound<'py, PyDict>>,
    areas: PyReadonlyArray1<'py, f64>,
    options: &Bound<'py, PyDict>,
    size: &Bound<'py, PyDict>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Made<'py>> {
    let mesh = mesh_in(mesh)?;
    let drawing = drawing.map(drawing_in).transpose()?;
    let areas: Vec<Option<f64>> = areas.as_array().iter().map(|&area| Some(area).filter(|&area| area != 0.0)).collect();
    let options = Options::of(options)?.mesh_options().refine;
    let sizing = sizing(size, &mesh.points)?;
    let made = run(py, progress, move |mut reporter| {
        let made = trimalla::refine_mesh_sized(&mesh, &areas, drawing.as_ref(), &options, &sizing, &mut reporter);
        Ok(made?)
    })?;
    give(py, made)
}

/// Triangulates a drawing by a method, without refinement.
#[pyfunction]
pub(crate) fn triangulate<'py>(
    py: Python<'py>,
    drawing: &Bound<'py, PyDict>,
    method: &str,
    options: &Bound<'py, PyDict>,
) -> PyResult<Made<'py>> {
    let drawing = drawing_in(drawing)?;
    let domain = Options::of(options)?.domain;
    let method: Method = method.parse().map_err(|error: trimalla::UnknownKey| Fault::option(error.to_string()))?;
    let made = run(py, None, move |_| Ok(by_method(&drawing, method, &domain)?))?;
    Ok((give_mesh(py, made.mesh)?, None, words(&made.warnings)))
}

fn by_method(drawing: &Pslg, method: Method, domain: &DomainOptions) -> Result<Triangulated, trimalla::Error> {
    match method {
        Method::Delaunay(AlgorithmKey::Incremental) => Ok(trimalla::triangulate(drawing, domain)?),
        _ => {
            let made = trimalla::triangulate_by(drawing, method, domain, 0, &mut NoTrace)?;
            Ok(Triangulated { mesh: made.mesh, warnings: made.warnings })
        }
    }
}

/// The Delaunay triangulation of points alone: an array of triangles.
#[pyfunction]
pub(crate) fn delaunay<'py>(py: Python<'py>, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let points = points_of(&points.extract()?, "points")?;
    let triangles = run(py, None, move |_| {
        let mut triangulator = Triangulator::new();
        Ok(triangulator.triangulate(&points)?.to_vec())
    })?;
    give_indices(py, triangles)
}

fn give(py: Python<'_>, made: Meshed) -> PyResult<Made<'_>> {
    let report = give_report(py, &made.report)?;
    Ok((give_mesh(py, made.mesh)?, Some(report), words(&made.warnings)))
}

pub(crate) fn words(warnings: &[Warning]) -> Vec<String> {
    warnings.iter().map(ToString::to_string).collect()
}

/// A report as a dictionary; its leftovers as three columns.
pub(crate) fn give_report<'py>(py: Python<'py>, report: &Report) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("complete", report.complete())?;
    dict.set_item("stop", report.stop.key())?;
    dict.set_item("min_angle", report.min_angle_deg)?;
    dict.set_item("max_angle", report.max_angle_deg)?;
    dict.set_item("vertices", report.vertices)?;
    dict.set_item("triangles", report.triangles)?;
    dict.set_item("steiner_points", report.steiner_points)?;
    dict.set_item("edges_flipped", report.edges_flipped)?;
    dict.set_item("points_inserted", report.points_inserted)?;
    dict.set_item("points_rejected", report.points_rejected)?;
    dict.set_item("segments_split", report.segments_split)?;
    let lost: Vec<usize> = report.lost_segments.iter().map(|segment| segment.index()).collect();
    dict.set_item("lost_segments", lost)?;
    let left = &report.leftovers;
    let triangles: Vec<i32> = left.iter().map(|left| left.triangle as i32).collect();
    let angles: Vec<f64> = left.iter().map(|left| left.min_angle_deg).collect();
    dict.set_item("leftover_triangles", triangles.into_pyarray(py))?;
    dict.set_item("leftover_angles", angles.into_pyarray(py))?;
    dict.set_item("leftover_reasons", PyList::new(py, left.iter().map(|left| left.reason.key()))?)?;
    Ok(dict)
}
