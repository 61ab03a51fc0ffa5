//! Errors of the library as exceptions with places.

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use trimalla::Point;
use trimalla::constrained::{ConstraintError, MoveError};
use trimalla::delaunay::{BuildError, RemoveError};
use trimalla::domain::{DomainError, MeshError};
use trimalla::drawing::DrawingError;
use trimalla::refine::OptionError;

/// The exceptions.
pub(crate) mod raised {
    use super::{PyValueError, create_exception};

    create_exception!(trimalla, Error, PyValueError, "What trimalla refuses; the base of its other exceptions.");
    create_exception!(trimalla, DrawingError, Error, "The points, segments or seeds are at fault.");
    create_exception!(trimalla, MeshError, Error, "The given mesh is at fault.");
    create_exception!(trimalla, OptionError, Error, "An option is out of range, or there is none of that name.");
    create_exception!(trimalla, FileError, Error, "A file cannot be read or written.");
}

/// Which exception a fault becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    Drawing,
    Mesh,
    Option,
    File,
}

/// What went wrong, with the places that the exception names.
#[derive(Clone, Debug)]
pub(crate) struct Fault {
    class: Class,
    kind: &'static str,
    message: String,
    indices: Vec<usize>,
    points: Vec<Point>,
}

impl Fault {
    pub(crate) fn new(class: Class, kind: &'static str, message: impl Into<String>) -> Self {
        Self { class, kind, message: message.into(), indices: Vec::new(), points: Vec::new() }
    }

    pub(crate) fn option(message: impl Into<String>) -> Self {
        Self::new(Class::Option, "option", message)
    }

    pub(crate) fn shape(message: impl Into<String>) -> Self {
        Self::new(Class::Drawing, "shape", message)
    }

    pub(crate) fn at(mut self, indices: impl IntoIterator<Item = usize>) -> Self {
        self.indices.extend(indices);
        self
    }

    pub(crate) fn near(mut self, points: impl IntoIterator<Item = Point>) -> Self {
        self.points.extend(points);
        self
    }
}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> Self {
        Python::attach(|py| {
            let error = match fault.class {
                Class::Drawing => raised::DrawingError::new_err(fault.message),
                Class::Mesh => raised::MeshError::new_err(fault.message),
                Class::Option => raised::OptionError::new_err(fault.message),
                Class::File => raised::FileError::new_err(fault.message),
            };
            let value = error.value(py);
            let points: Vec<(f64, f64)> = fault.points.iter().map(|p| (p.x, p.y)).collect();
            let set = value
                .setattr("kind", fault.kind)
                .and_then(|()| value.setattr("indices", fault.indices))
                .and_then(|()| value.setattr("points", points));
            set.err().unwrap_or(error)
        })
    }
}

impl From<BuildError> for Fault {
    fn from(error: BuildError) -> Self {
        let fault = |kind| Self::new(Class::Drawing, kind, error.to_string());
        match error {
            BuildError::NotFinite { index, point } => fault("not-finite").at([index]).near([point]),
            BuildError::NoSuchVertex { vertex, .. } => fault("no-such-vertex").at([vertex.index()]),
            BuildError::OutsideDomain(point) => fault("outside-domain").near([point]),
            BuildError::TooManyPoints(_) => fault("too-many-points"),
            BuildError::Cancelled => fault("cancelled"),
            _ => fault("points"),
        }
    }
}

impl From<ConstraintError> for Fault {
    fn from(error: ConstraintError) -> Self {
        let fault = |kind| Self::new(Class::Drawing, kind, error.to_string());
        match &error {
            ConstraintError::Build(build) => build.clone().into(),
            ConstraintError::NoSuchVertex { segment, vertex, .. } => {
                fault("no-such-vertex").at([*segment, vertex.index()])
            }
            ConstraintError::UnusedVertex { segment, vertex } => fault("unused-vertex").at([*segment, vertex.index()]),
            ConstraintError::Crossing(pairs) => {
                fault("crossing").at(pairs.iter().flat_map(|pair| pair.segments)).near(pairs.iter().map(|pair| pair.at))
            }
            ConstraintError::LeavesDomain { segment, from, to } => {
                fault("leaves-domain").at([*segment]).near([*from, *to])
            }
            ConstraintError::CrossingsExhausted { pair, .. } => {
                fault("crossings-exhausted").at(pair.segments).near([pair.at])
            }
            _ => fault("segments"),
        }
    }
}

impl From<DrawingError> for Fault {
    fn from(error: DrawingError) -> Self {
        let fault = |kind| Self::new(Class::Drawing, kind, error.to_string());
        match error {
            DrawingError::SeedNotFinite { seed, at, .. } => fault("seed-not-finite").at([seed]).near([at]),
            _ => fault("shape"),
        }
    }
}

impl From<DomainError> for Fault {
    fn from(error: DomainError) -> Self {
        let fault = |kind| Self::new(Class::Drawing, kind, error.to_string());
        match &error {
            DomainError::Constraint(inner) => inner.clone().into(),
            DomainError::Drawing(inner) => inner.clone().into(),
            DomainError::Flat { .. } => fault("flat"),
            DomainError::OpenOutline { end } => {
                fault("open-outline").at(end.iter().map(|end| end.vertex.index())).near(end.iter().map(|end| end.at))
            }
            DomainError::NothingNested => fault("nothing-nested"),
            DomainError::SeedLeaks { seed, at } => fault("seed-leaks").at([*seed]).near([*at]),
            DomainError::SeedTakesAll { seed, at } => fault("seed-takes-all").at([*seed]).near([*at]),
            DomainError::SeedOnSegment { seed, at, .. } => fault("seed-on-segment").at([*seed]).near([*at]),
            _ => fault("domain"),
        }
    }
}

impl From<MeshError> for Fault {
    fn from(error: MeshError) -> Self {
        let fault = |kind| Self::new(Class::Mesh, kind, error.to_string());
        match &error {
            MeshError::NoTriangles => fault("no-triangles"),
            MeshError::AreaCount { .. } => fault("area-count"),
            MeshError::AreaBound { triangle, .. } => fault("area-bound").at([*triangle]),
            MeshError::VertexChanged { vertex, was, is } => fault("vertex-changed").at([*vertex]).near([*was, *is]),
            MeshError::Drawing(inner) => inner.clone().into(),
            _ => fault("mesh"),
        }
    }
}

impl From<OptionError> for Fault {
    fn from(error: OptionError) -> Self {
        Self::option(error.to_string())
    }
}

impl From<RemoveError> for Fault {
    fn from(error: RemoveError) -> Self {
        let fault = |kind| Self::new(Class::Mesh, kind, error.to_string());
        match error {
            RemoveError::Unused(v) => fault("unused-vertex").at([v.index()]),
            RemoveError::Constrained { vertex, point } => fault("constrained").at([vertex.index()]).near([point]),
            RemoveError::NotFinite(p) => fault("not-finite").near([p]),
            _ => fault("vertex"),
        }
    }
}

impl From<MoveError> for Fault {
    fn from(error: MoveError) -> Self {
        Self::new(Class::Mesh, "move", error.to_string())
    }
}

impl From<trimalla::Error> for Fault {
    fn from(error: trimalla::Error) -> Self {
        match error {
            trimalla::Error::Domain(inner) => inner.into(),
            trimalla::Error::Mesh(inner) => inner.into(),
            trimalla::Error::Option(inner) => inner.into(),
            trimalla::Error::Build(inner) => inner.into(),
            trimalla::Error::NotOfDrawing(_) => Self::new(Class::Mesh, "not-of-drawing", error.to_string()),
            other => Self::new(Class::Drawing, "drawing", other.to_string()),
        }
    }
}

impl From<trimalla_io::IoError> for Fault {
    fn from(error: trimalla_io::IoError) -> Self {
        Self::new(Class::File, "file", error.to_string())
    }
}
