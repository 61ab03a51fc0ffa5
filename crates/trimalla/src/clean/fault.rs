//! What is found: kinds of faults, and their places.

use std::fmt;

use crate::drawing::{DrawingError, Pslg};
use crate::geometry::{BoundingBox, Point};

/// A kind of fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum FaultKind {
    /// Two segments cross inside both.
    Crossing,
    /// Two segments have more than one point in common.
    Overlap,
    /// A vertex lies on a segment or within the tolerance of it, and is not an end of it.
    TJunction,
    /// Two vertices at one place, two segments with the same ends, or a segment whose ends are at one place.
    Duplicate,
    /// Two vertices nearer than the tolerance.
    NearDuplicate,
    /// A face narrower than the tolerance.
    Sliver,
    /// An end of a segment that nothing else is near.
    Dangling,
    /// Two ends between which an outline is open.
    Gap,
    /// A hole seed that no outline encloses.
    HoleOutside,
    /// A hole seed in a face that lies in another hole.
    WrongNesting,
    /// Two segments that meet at a small angle.
    TinyAngle,
}

impl FaultKind {
    /// All kinds, in the order in which reports count them.
    pub const ALL: [Self; 11] = [
        Self::Crossing,
        Self::Overlap,
        Self::TJunction,
        Self::Duplicate,
        Self::NearDuplicate,
        Self::Sliver,
        Self::Dangling,
        Self::Gap,
        Self::HoleOutside,
        Self::WrongNesting,
        Self::TinyAngle,
    ];

    /// The key by which reports name the kind.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::Overlap => "overlap",
            Self::TJunction => "t-junction",
            Self::Duplicate => "duplicate",
            Self::NearDuplicate => "near-duplicate",
            Self::Sliver => "sliver",
            Self::Dangling => "dangling",
            Self::Gap => "gap",
            Self::HoleOutside => "hole-outside",
            Self::WrongNesting => "wrong-nesting",
            Self::TinyAngle => "tiny-angle",
        }
    }

    /// What the size of a fault is of this kind; `None` where it has none.
    #[must_use]
    pub const fn measure(self) -> Option<&'static str> {
        match self {
            Self::TJunction | Self::NearDuplicate => Some("distance"),
            Self::Gap => Some("gap"),
            Self::Sliver => Some("width"),
            Self::TinyAngle => Some("degrees"),
            Self::Crossing | Self::Overlap | Self::Duplicate | Self::Dangling => None,
            Self::HoleOutside | Self::WrongNesting => None,
        }
    }
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}

/// A fault of a drawing. Indices count from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// What it is.
    pub kind: FaultKind,
    /// Where it is, rounded.
    pub at: Point,
    /// How large it is: a length, or for tiny angles degrees; 0 where the kind has no size.
    pub size: f64,
    /// The vertices concerned: both of a pair; the vertex of a T-junction, an angle or a free end; those around a
    /// sliver.
    pub vertices: Vec<u32>,
    /// The segments concerned.
    pub segments: Vec<u32>,
    /// The hole seed concerned.
    pub hole: Option<u32>,
}

impl Fault {
    pub(super) fn new(kind: FaultKind, at: Point, size: f64) -> Self {
        Self { kind, at, size, vertices: Vec::new(), segments: Vec::new(), hole: None }
    }

    pub(super) fn of_vertices(mut self, vertices: impl Into<Vec<u32>>) -> Self {
        self.vertices = vertices.into();
        self
    }

    pub(super) fn of_segments(mut self, segments: impl Into<Vec<u32>>) -> Self {
        self.segments = segments.into();
        self
    }
}

/// What [`find`](super::find()) found.
#[derive(Clone, Debug, PartialEq)]
pub struct Findings {
    /// The tolerance that was used, in the unit of the drawing.
    pub tolerance: f64,
    /// The faults by kind, then by vertices, segments and hole.
    pub faults: Vec<Fault>,
}

impl Findings {
    /// How many faults of a kind there are.
    #[must_use]
    pub fn count(&self, kind: FaultKind) -> usize {
        self.faults.iter().filter(|fault| fault.kind == kind).count()
    }
}

/// How near is too near.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CleanOptions {
    /// The distance below which features are too near, in the unit of the drawing; `None` for a millionth of the larger
    /// extent of the drawing.
    pub tolerance: Option<f64>,
    /// The angle below which two segments meet too sharply, in degrees.
    pub tiny_angle_deg: f64,
}

impl Default for CleanOptions {
    fn default() -> Self {
        Self { tolerance: None, tiny_angle_deg: 1.0 }
    }
}

impl CleanOptions {
    /// Takes features nearer than this for too near.
    #[must_use]
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = Some(tolerance);
        self
    }

    /// Takes angles below this, in degrees, for tiny.
    #[must_use]
    pub fn with_tiny_angle_deg(mut self, degrees: f64) -> Self {
        self.tiny_angle_deg = degrees;
        self
    }

    /// The tolerance for a drawing, which is never below what its coordinates can tell apart.
    pub(super) fn tolerance_for(&self, points: &[Point]) -> Result<f64, CleanError> {
        let is_angle = (0.0..=60.0).contains(&self.tiny_angle_deg);
        if !is_angle {
            return Err(CleanError::Angle(self.tiny_angle_deg));
        }
        let bounds = BoundingBox::of(points.iter().copied()).unwrap_or_default();
        let asked = match self.tolerance {
            Some(tolerance) if tolerance.is_finite() && tolerance >= 0.0 => tolerance,
            Some(tolerance) => return Err(CleanError::Tolerance(tolerance)),
            None => 2.0 * SHARE * bounds.half_width().max(bounds.half_height()),
        };
        Ok(asked.max(LAST_PLACES * bounds.largest_coordinate()).max(f64::MIN_POSITIVE))
    }
}

/// The tolerance where none is given, as a part of the extent.
const SHARE: f64 = 1e-6;
/// The least tolerance, as a part of the largest coordinate: four last places.
const LAST_PLACES: f64 = 4.0 * f64::EPSILON;

/// Why a drawing cannot be looked at.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CleanError {
    /// The columns of the drawing have other lengths than its vertices and segments.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// A coordinate is not a finite number.
    #[error("vertex {vertex} at {at} is not finite")]
    NotFinite {
        /// The vertex.
        vertex: usize,
        /// Its coordinates.
        at: Point,
    },
    /// A segment names a vertex that there is not.
    #[error("segment {segment} names vertex {vertex}, but there are {vertices} vertices")]
    NoVertex {
        /// The segment.
        segment: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// The tolerance is no length.
    #[error("the tolerance is {0}, not a finite length of at least 0")]
    Tolerance(f64),
    /// The tiny angle is out of range.
    #[error("the tiny angle is {0} degrees, not between 0 and 60")]
    Angle(f64),
}

/// Refuses drawings that are no drawings.
pub(super) fn validate(drawing: &Pslg) -> Result<(), CleanError> {
    drawing.validate()?;
    if let Some(vertex) = drawing.points.iter().position(|p| !p.is_finite()) {
        return Err(CleanError::NotFinite { vertex, at: drawing.points[vertex] });
    }
    let vertices = drawing.points.len();
    for (segment, ends) in drawing.segments.iter().enumerate() {
        if let Some(&vertex) = ends.iter().find(|&&v| v as usize >= vertices) {
            return Err(CleanError::NoVertex { segment, vertex, vertices });
        }
    }
    Ok(())
}
