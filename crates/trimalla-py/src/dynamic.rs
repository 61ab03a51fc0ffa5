//! A triangulation that changes: insert, remove, move, segments, and back.

use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use trimalla::constrained::Crossings;
use trimalla::delaunay::{Delaunay, Incremental, Inserted};
use trimalla::drawing::SegmentId;
use trimalla::dual::Voronoi;
use trimalla::half_edge::{Checkpoint, FaceId, UndoLog, VertexId};
use trimalla::interpolate::{InterpolationMethod, Surface, interpolate};
use trimalla::locate::Locus;
use trimalla::{ConstrainedDelaunay, Point, Pslg};

use crate::arrays::{give_indices, give_mesh, give_points, indices_of, points_of};
use crate::errors::{Class, Fault};

/// A (constrained) Delaunay triangulation of points, of which every change can be taken back.
#[pyclass(module = "trimalla._native", name = "Triangulation")]
pub(crate) struct Dynamic {
    cdt: ConstrainedDelaunay,
    log: UndoLog,
    /// Where the log was before each change.
    changes: Vec<Checkpoint>,
    /// The vertices alone, and their Voronoi diagram: made when asked for, dropped with each change.
    vertices: Option<Vertices>,
}

struct Vertices {
    delaunay: Delaunay,
    voronoi: Voronoi,
}

impl Dynamic {
    /// Changes the triangulation, or leaves it as it was.
    fn change<T, E: Into<Fault>>(
        &mut self,
        change: impl FnOnce(&mut ConstrainedDelaunay, &mut UndoLog) -> Result<T, E>,
    ) -> PyResult<T> {
        let before = self.log.checkpoint();
        match change(&mut self.cdt, &mut self.log) {
            Ok(done) => {
                self.changes.push(before);
                self.vertices = None;
                Ok(done)
            }
            Err(error) => {
                self.cdt.rollback(&mut self.log, before);
                Err(error.into().into())
            }
        }
    }

    fn vertex(&self, v: i64) -> Result<VertexId, Fault> {
        let count = self.cdt.points().len();
        let found = usize::try_from(v).ok().filter(|&v| v < count).map(VertexId::from_index);
        found.filter(|&v| self.cdt.is_used(v)).ok_or_else(|| {
            Fault::new(Class::Mesh, "no-such-vertex", format!("there is no vertex {v}")).at(usize::try_from(v).ok())
        })
    }

    fn vertices(&mut self) -> Result<&Vertices, Fault> {
        if self.vertices.is_none() {
            let used: Vec<VertexId> = self.cdt.used_vertices().collect();
            let delaunay = Delaunay::of_subset::<Incremental>(self.cdt.points(), &used)?;
            let voronoi = Voronoi::new(&delaunay);
            self.vertices = Some(Vertices { delaunay, voronoi });
        }
        self.vertices.as_ref().ok_or_else(|| Fault::new(Class::Mesh, "vertices", "there are no vertices"))
    }
}

#[pymethods]
impl Dynamic {
    #[new]
    fn new(py: Python<'_>, points: &Bound<'_, PyAny>, segments: &Bound<'_, PyAny>, crossings: &str) -> PyResult<Self> {
        let points = points_of(&points.extract()?, "points")?;
        let segments: numpy::PyReadonlyArray2<'_, i64> = segments.extract()?;
        let segments = indices_of::<2>(segments.as_array(), points.len(), "segment", Class::Drawing)?;
        let crossings = crossings_of(crossings)?;
        let made = py.detach(|| ConstrainedDelaunay::new(&points, &segments, crossings));
        let cdt = made.map_err(Fault::from)?;
        Ok(Self { cdt, log: UndoLog::new(), changes: Vec::new(), vertices: None })
    }

    fn insert(&mut self, py: Python<'_>, points: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        let points = points_of(&points.extract()?, "points")?;
        let insert_all = |cdt: &mut ConstrainedDelaunay, log: &mut UndoLog| {
            let ids = points.iter().map(|&p| cdt.insert_with(p, log).map(|inserted| inserted.vertex().0 as i32));
            ids.collect::<Result<Vec<i32>, _>>()
        };
        let ids = py.detach(|| self.change(insert_all))?;
        Ok(ids.into_pyarray(py).into_any().unbind())
    }

    fn remove(&mut self, py: Python<'_>, vertex: i64, with_segments: bool) -> PyResult<()> {
        let vertex = self.vertex(vertex)?;
        py.detach(|| {
            if with_segments {
                self.change(|cdt, log| cdt.remove_with_segments(vertex, log))
            } else {
                self.change(|cdt, log| cdt.remove_with(vertex, log))
            }
        })
    }

    /// Moves a vertex; the vertex that is at the place then, and whether it is another one.
    fn move_to(&mut self, py: Python<'_>, vertex: i64, x: f64, y: f64) -> PyResult<(u32, bool)> {
        let vertex = self.vertex(vertex)?;
        let moved = py.detach(|| self.change(|cdt, log| cdt.move_vertex_with(vertex, Point::new(x, y), log)))?;
        Ok((moved.vertex().0, matches!(moved, Inserted::Existing(_))))
    }

    fn insert_segment(&mut self, py: Python<'_>, a: i64, b: i64, crossings: &str) -> PyResult<usize> {
        let (a, b, crossings) = (self.vertex(a)?, self.vertex(b)?, crossings_of(crossings)?);
        let id = py.detach(|| self.change(|cdt, log| cdt.insert_segment_with(a, b, crossings, log)))?;
        Ok(id.index())
    }

    fn remove_segment(&mut self, py: Python<'_>, segment: usize) -> PyResult<bool> {
        let Ok(number) = u32::try_from(segment) else { return Ok(false) };
        if segment >= self.cdt.segment_ids().len() {
            return Ok(false);
        }
        py.detach(|| self.change(|cdt, log| Ok::<_, Fault>(cdt.remove_segment_with(SegmentId(number), log))))
    }

    /// Takes back the last change; whether there was one.
    fn undo(&mut self, py: Python<'_>) -> bool {
        let Some(before) = self.changes.pop() else { return false };
        py.detach(|| self.cdt.rollback(&mut self.log, before));
        self.vertices = None;
        true
    }

    #[getter]
    fn changes(&self) -> usize {
        self.changes.len()
    }

    /// The corners of the triangle of each point: -1 three times outside.
    fn locate<'py>(&self, py: Python<'py>, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let points = points_of(&points.extract()?, "points")?;
        let found = py.detach(|| {
            let mut hint = self.cdt.real_faces().next();
            let corners = points.iter().map(|&p| {
                let face = hint.filter(|_| p.is_finite()).and_then(|start| self.face_at(start, p));
                hint = face.or(hint);
                face.map_or([-1; 3], |f| self.cdt.face_vertices(f).map(|v| v.0 as i32))
            });
            corners.flatten().collect::<Vec<i32>>()
        });
        crate::arrays::give_rows(py, found, 3)
    }

    /// The nearest vertex of each point, -1 where there is none.
    fn nearest<'py>(&mut self, py: Python<'py>, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let points = points_of(&points.extract()?, "points")?;
        let found = py.detach(|| {
            let voronoi = &self.vertices()?.voronoi;
            let mut near = VertexId(0);
            let nearest = points.iter().map(|&p| {
                let found = Some(p).filter(|p| p.is_finite()).and_then(|p| voronoi.nearest(near, p));
                near = found.unwrap_or(near);
                found.map_or(-1, |v| v.0 as i32)
            });
            Ok::<_, Fault>(nearest.collect::<Vec<i32>>())
        })?;
        Ok(found.into_pyarray(py).into_any())
    }

    /// The vertices joined to a vertex by edges, counter-clockwise.
    fn neighbours(&self, vertex: i64) -> PyResult<Vec<u32>> {
        Ok(self.cdt.neighbours(self.vertex(vertex)?).map(|v| v.0).collect())
    }

    /// Values between vertices; NaN outside.
    fn interpolate<'py>(
        &mut self,
        py: Python<'py>,
        values: PyReadonlyArray1<'py, f64>,
        points: &Bound<'py, PyAny>,
        method: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let points = points_of(&points.extract()?, "points")?;
        let values: Vec<f64> = values.as_array().iter().copied().collect();
        let found = py.detach(|| self.values_at(&values, &points, method))?;
        let found: Vec<f64> = found.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect();
        Ok(found.into_pyarray(py).into_any())
    }

    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        give_points(py, self.cdt.points())
    }

    /// Which vertices are part of the triangulation.
    #[getter]
    fn used<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        let all = (0..self.cdt.points().len()).map(VertexId::from_index);
        all.map(|v| self.cdt.is_used(v)).collect::<Vec<bool>>().into_pyarray(py).into_any()
    }

    #[getter]
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.cdt.real_faces().map(|f| self.cdt.face_vertices(f).map(|v| v.0));
        give_indices(py, rows.collect())
    }

    #[getter]
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        give_indices(py, self.cdt.canonical_edges().into_iter().map(|ends| ends.map(|v| v.0)).collect())
    }

    /// The triangulation as plain arrays.
    fn mesh<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mesh = py.detach(|| self.cdt.to_indexed(&Pslg::default()));
        give_mesh(py, mesh)
    }

    /// What is wrong with the triangulation, in words: nothing.
    fn check(&self, py: Python<'_>) -> Vec<String> {
        py.detach(|| self.cdt.check().iter().map(ToString::to_string).collect())
    }
}

impl Dynamic {
    /// A face that has the point, if it is not outside.
    fn face_at(&self, start: FaceId, p: Point) -> Option<FaceId> {
        match self.cdt.locate_from(start, p) {
            Locus::Face(face) => Some(face),
            Locus::Edge(h) => Some(h.face()),
            Locus::Vertex(v) => self.cdt.star(v).map(|h| h.face()).find(|&f| self.cdt.is_real(f)),
            _ => None,
        }
    }

    fn values_at(&mut self, values: &[f64], points: &[Point], method: &str) -> Result<Vec<Option<f64>>, Fault> {
        let method = match method {
            "linear" => InterpolationMethod::Linear,
            "natural-neighbour" => InterpolationMethod::NaturalNeighbour,
            "laplace" => InterpolationMethod::Laplace,
            _ => {
                let message = format!("method: expected linear, natural-neighbour or laplace, found '{method}'");
                return Err(Fault::option(message));
            }
        };
        let refused =
            |error: trimalla::interpolate::InterpolateError| Fault::new(Class::Mesh, "values", error.to_string());
        if method == InterpolationMethod::Linear {
            let surface = Surface::new(&self.cdt, values).map_err(refused)?;
            return Ok(surface.heights_at(points));
        }
        interpolate(&self.vertices()?.delaunay, values, points, method).map_err(refused)
    }
}

fn crossings_of(key: &str) -> Result<Crossings, Fault> {
    let found = [Crossings::Refuse, Crossings::Split].into_iter().find(|how| how.key() == key);
    found.ok_or_else(|| Fault::option(format!("crossings: expected one of refuse, split, found '{key}'")))
}
