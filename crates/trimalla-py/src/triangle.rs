//! Triangle's switches on arrays.

use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use trimalla_triangle::{Input, Made, SwitchError, Switches, TriangleError, VoronoiEdge};

use crate::arrays::{drawing as drawing_in, give_indices, give_mesh, give_neighbours, give_points, give_rows, mesh};
use crate::errors::{Class, Fault};
use crate::make::{give_report, words};
use crate::worker::run;

impl From<SwitchError> for Fault {
    fn from(error: SwitchError) -> Self {
        Self::option(error.to_string())
    }
}

impl From<TriangleError> for Fault {
    fn from(error: TriangleError) -> Self {
        match error {
            TriangleError::Mesh(error) => error.into(),
            other => Self::new(Class::Mesh, "no-voronoi", other.to_string()),
        }
    }
}

/// Meshes as a word of switches says; `areas` is empty or has the largest area of each triangle.
#[pyfunction]
pub(crate) fn by_switches<'py>(
    py: Python<'py>,
    input: &Bound<'py, PyDict>,
    areas: PyReadonlyArray1<'py, f64>,
    word: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let switches = Switches::parse(word).map_err(Fault::from)?;
    let asked = switches.clone();
    let made = if switches.refine {
        let areas: Vec<_> = areas.as_array().iter().map(|&area| Some(area).filter(|&area| area > 0.0)).collect();
        let mesh = mesh(input)?;
        run(py, None, move |mut reporter| {
            Ok(trimalla_triangle::triangulate(&Input::Mesh(&mesh, &areas), &switches, &mut reporter)?)
        })?
    } else {
        let drawing = drawing_in(input)?;
        run(py, None, move |mut reporter| {
            Ok(trimalla_triangle::triangulate(&Input::Drawing(&drawing), &switches, &mut reporter)?)
        })?
    };
    give(py, made, &asked)
}

fn give<'py>(py: Python<'py>, made: Made, switches: &Switches) -> PyResult<Bound<'py, PyDict>> {
    let dict = give_mesh(py, made.mesh)?;
    dict.set_item("vertices", made.vertices)?;
    dict.set_item("drawing", switches.drawing)?;
    dict.set_item("refine", switches.refine)?;
    dict.set_item("attributes", switches.attributes)?;
    dict.set_item("no_markers", switches.no_markers)?;
    dict.set_item("has_segments", (switches.drawing || switches.hull) && !switches.no_segments)?;
    dict.set_item("has_vertices", !switches.no_vertices)?;
    dict.set_item("has_triangles", !switches.no_triangles)?;
    dict.set_item("middles", give_indices(py, made.middles)?)?;
    dict.set_item("warnings", words(&made.warnings))?;
    let faults: Vec<String> = made.faults.iter().map(ToString::to_string).collect();
    dict.set_item("faults", faults)?;
    if let Some(report) = &made.report {
        dict.set_item("report", give_report(py, report)?)?;
    }
    if let Some(edges) = made.edges.filter(|_| switches.edges) {
        dict.set_item("edges", give_indices(py, edges.ends)?)?;
        dict.set_item("edge_markers", edges.markers.into_pyarray(py))?;
    }
    if let Some(neighbours) = &made.neighbours {
        dict.set_item("neighbors", give_neighbours(py, neighbours)?)?;
    }
    if let Some(voronoi) = made.voronoi {
        let mut ends: Vec<[u32; 2]> = Vec::new();
        let (mut from, mut directions) = (Vec::new(), Vec::new());
        for edge in voronoi.edges {
            match edge {
                VoronoiEdge::Between(between) => ends.push(between),
                VoronoiEdge::Ray { from: vertex, direction } => {
                    from.push(vertex as i32);
                    directions.extend(direction);
                }
            }
        }
        dict.set_item("voronoi_vertices", give_points(py, &voronoi.vertices.points)?)?;
        dict.set_item("voronoi_edges", give_indices(py, ends)?)?;
        dict.set_item("ray_origins", from.into_pyarray(py))?;
        dict.set_item("ray_directions", give_rows::<f64>(py, directions, 2)?)?;
    }
    Ok(dict)
}
