//! What is done with drawings and meshes beside meshing: files, pictures, checks, comparisons.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};

use trimalla::clean::{CleanOptions, Findings, find, mend};
use trimalla::refine::{OPTIONS, Preset};
use trimalla_compare::{Contender, Experiment, Task, Watch, markdown, records};
use trimalla_io::{Format, PictureOptions, WriteOptions};

use crate::arrays::{drawing as drawing_in, give_drawing, give_indices, give_mesh, give_neighbours, mesh as mesh_in};
use crate::errors::{Class, Fault};
use crate::options::Options;
use crate::worker::{Reporter, run};

/// The edges of a mesh, lower vertex first, sorted.
#[pyfunction]
pub(crate) fn edges<'py>(py: Python<'py>, mesh: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyAny>> {
    let mesh = mesh_in(mesh)?;
    give_indices(py, py.detach(|| mesh.edges()))
}

/// The sides of triangles on the boundary, each with its triangle on the left.
#[pyfunction]
pub(crate) fn boundary<'py>(py: Python<'py>, mesh: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyAny>> {
    let mesh = mesh_in(mesh)?;
    give_indices(py, py.detach(|| mesh.boundary_edges()))
}

/// The neighbour of each triangle opposite each corner, -1 for none.
#[pyfunction]
pub(crate) fn neighbours<'py>(py: Python<'py>, mesh: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyAny>> {
    let mesh = mesh_in(mesh)?;
    give_neighbours(py, &py.detach(|| mesh.neighbours()))
}

/// What is wrong with a mesh, in words.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, mesh: &Bound<'_, PyDict>, is_delaunay: bool) -> PyResult<Vec<String>> {
    let mesh = mesh_in(mesh)?;
    let faults = py.detach(|| {
        if is_delaunay {
            trimalla::triangulation::check_mesh_delaunay(&mesh, &mesh.segments)
        } else {
            trimalla::triangulation::check_mesh(&mesh)
        }
    });
    Ok(faults.iter().map(ToString::to_string).collect())
}

/// Writes a mesh to a file whose format is that of its ending, or to a text.
#[pyfunction]
pub(crate) fn write(py: Python<'_>, path: PathBuf, mesh: &Bound<'_, PyDict>) -> PyResult<()> {
    let mesh = mesh_in(mesh)?;
    let options = WriteOptions::default();
    run(py, None, move |_| Ok(trimalla_io::write_mesh(path, &mesh, &options)?))
}

/// Draws a mesh: the bytes of an SVG or PNG file.
#[pyfunction]
pub(crate) fn picture<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, PyDict>,
    format: &str,
    title: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let mesh = mesh_in(mesh)?;
    let format = match format {
        "svg" => Format::Svg,
        "png" => Format::Png,
        _ => return Err(Fault::option(format!("format: expected svg or png, found '{format}'")).into()),
    };
    let options = WriteOptions::default().with_picture(PictureOptions::default().with_title(title));
    let bytes = run(py, None, move |_| {
        let mut bytes = Vec::new();
        trimalla_io::write_mesh_to(&mut bytes, format, &mesh, &options)
            .map_err(|error| Fault::new(Class::File, "picture", error.to_string()))?;
        Ok(bytes)
    })?;
    Ok(PyBytes::new(py, &bytes))
}

/// Reads a mesh.
#[pyfunction]
pub(crate) fn read_mesh(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let mesh = run(py, None, move |_| Ok(trimalla_io::read_mesh(path)?))?;
    give_mesh(py, mesh)
}

/// Reads a drawing.
#[pyfunction]
pub(crate) fn read_drawing(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let drawing = run(py, None, move |_| Ok(trimalla_io::read_pslg(path)?))?;
    give_drawing(py, drawing)
}

/// Writes a drawing.
#[pyfunction]
pub(crate) fn write_drawing(py: Python<'_>, path: PathBuf, drawing: &Bound<'_, PyDict>) -> PyResult<()> {
    let drawing = drawing_in(drawing)?;
    run(py, None, move |_| Ok(trimalla_io::write_pslg(path, &drawing, &WriteOptions::default())?))
}

/// Finds what is wrong with a drawing, and mends it if asked to: the drawing, faults, and how many changes were made.
#[pyfunction]
#[pyo3(signature = (drawing, tolerance, is_mended))]
pub(crate) fn clean<'py>(
    py: Python<'py>,
    drawing: &Bound<'py, PyDict>,
    tolerance: Option<f64>,
    is_mended: bool,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyList>, usize)> {
    let drawing = drawing_in(drawing)?;
    let options = tolerance.map_or(CleanOptions::default(), |t| CleanOptions::default().with_tolerance(t));
    let refused = |error: trimalla::clean::CleanError| Fault::new(Class::Drawing, "clean", error.to_string());
    let (drawing, findings, changes) = run(py, None, move |_| {
        if is_mended {
            let mended = mend(&drawing, &options).map_err(refused)?;
            Ok((mended.drawing, mended.left, mended.changes.len()))
        } else {
            let findings = find(&drawing, &options).map_err(refused)?;
            Ok((drawing, findings, 0))
        }
    })?;
    Ok((give_drawing(py, drawing)?, give_findings(py, &findings)?, changes))
}

fn give_findings<'py>(py: Python<'py>, findings: &Findings) -> PyResult<Bound<'py, PyList>> {
    let list = PyList::empty(py);
    for fault in &findings.faults {
        let dict = PyDict::new(py);
        dict.set_item("kind", fault.kind.key())?;
        dict.set_item("at", (fault.at.x, fault.at.y))?;
        dict.set_item("size", fault.size)?;
        dict.set_item("vertices", &fault.vertices)?;
        dict.set_item("segments", &fault.segments)?;
        dict.set_item("hole", fault.hole)?;
        list.append(dict)?;
    }
    Ok(list)
}

/// Cancels an experiment when the caller has left.
struct Left(Reporter);

impl Watch for Left {
    fn ran(&self, _: &Task<'_>) {}

    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// Compares presets on drawings: a text in JSON, and one in Markdown.
#[pyfunction]
pub(crate) fn compare(
    py: Python<'_>,
    drawings: Vec<(String, Bound<'_, PyDict>)>,
    presets: Vec<String>,
    angles: Vec<f64>,
    jobs: usize,
    time_limit: f64,
) -> PyResult<(String, String)> {
    let refused = |error: trimalla_compare::CompareError| Fault::option(error.to_string());
    let mut experiment = Experiment::new(angles);
    experiment.time_limit = time_limit;
    for (title, drawing) in drawings {
        experiment.add_drawing(title, drawing_in(&drawing)?).map_err(refused)?;
    }
    for key in presets {
        let preset: Preset = key.parse().map_err(|error: trimalla::UnknownKey| Fault::option(error.to_string()))?;
        experiment.add_contender(Contender::of(preset)).map_err(refused)?;
    }
    run(py, None, move |reporter| {
        let outcomes = experiment.run(jobs.max(1), None, &Left(reporter)).map_err(refused)?;
        let sheets = experiment.sheets(&outcomes, None);
        Ok((records::json(&experiment, &sheets), markdown::text(&experiment, &sheets)))
    })
}

/// The options that there are: name, expected values, summary.
#[pyfunction]
pub(crate) fn option_names() -> Vec<(String, String, String)> {
    let row =
        |row: &trimalla::refine::OptionRow| (row.flag.replace('-', "_"), row.values.expected(), row.summary.to_owned());
    OPTIONS.iter().map(row).collect()
}

/// Writes options as a recipe file; or returns its text where the path is `None`.
#[pyfunction]
pub(crate) fn recipe(path: Option<PathBuf>, options: &Bound<'_, PyDict>) -> PyResult<String> {
    let options = Options::of(options)?;
    let mut bytes = Vec::new();
    trimalla_io::recipe::write(&mut bytes, &options.named)
        .map_err(|error| Fault::new(Class::File, "recipe", error.to_string()))?;
    if let Some(path) = path {
        let mut outputs = trimalla_io::Outputs::default();
        outputs.add_recipe(path, &options.named).map_err(Fault::from)?;
        outputs.commit().map_err(Fault::from)?;
    }
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
