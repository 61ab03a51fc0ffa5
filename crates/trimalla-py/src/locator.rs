//! Where points lie in a mesh, and values between its vertices.

use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use trimalla::Point;
use trimalla::half_edge::FaceId;
use trimalla::interpolate::Surface;
use trimalla::locate::Locus;
use trimalla::triangulation::Triangulation;

use crate::arrays::{mesh as mesh_in, points_of};
use crate::errors::{Class, Fault};

/// A mesh in which points are located.
#[pyclass(module = "trimalla._native", frozen)]
pub(crate) struct Locator {
    triangulation: Triangulation,
}

#[pymethods]
impl Locator {
    #[new]
    fn new(py: Python<'_>, mesh: &Bound<'_, PyDict>) -> PyResult<Self> {
        let mesh = mesh_in(mesh)?;
        let made = py.detach(|| Triangulation::from_indexed(&mesh));
        let triangulation = made.map_err(|faults| {
            let first = faults.first().map(ToString::to_string).unwrap_or_default();
            Fault::new(Class::Mesh, "mesh", first)
        })?;
        Ok(Self { triangulation })
    }

    /// The triangle of each point, -1 outside.
    fn locate<'py>(&self, py: Python<'py>, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let points = points_of(&points.extract()?, "points")?;
        let found = py.detach(|| {
            let mut start = FaceId(0);
            let faces = points.iter().map(|&p| match self.face_at(start, p) {
                Some(face) => {
                    start = face;
                    face.index() as i32
                }
                None => -1,
            });
            faces.collect::<Vec<i32>>()
        });
        Ok(found.into_pyarray(py).into_any())
    }

    /// Values between vertices, linear in each triangle; NaN outside.
    fn interpolate<'py>(
        &self,
        py: Python<'py>,
        values: PyReadonlyArray1<'py, f64>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let points = points_of(&points.extract()?, "points")?;
        let values: Vec<f64> = values.as_array().iter().copied().collect();
        let found = py.detach(|| {
            let surface = Surface::new(&self.triangulation, &values)
                .map_err(|error| Fault::new(Class::Mesh, "values", error.to_string()))?;
            let heights = surface.heights_at(&points);
            Ok::<_, Fault>(heights.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect::<Vec<f64>>())
        })?;
        Ok(found.into_pyarray(py).into_any())
    }
}

impl Locator {
    /// A face that has the point, if it is not outside.
    fn face_at(&self, start: FaceId, p: Point) -> Option<FaceId> {
        let t = &self.triangulation;
        if !p.is_finite() || t.dimension() < 2 {
            return None;
        }
        match t.locate_from(start, p) {
            Locus::Face(face) => Some(face),
            Locus::Edge(h) => Some(h.face()),
            Locus::Vertex(v) => t.star(v).map(|h| h.face()).find(|&f| t.is_real(f)),
            _ => None,
        }
    }
}
