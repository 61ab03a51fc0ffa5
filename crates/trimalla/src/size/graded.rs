//! Sizes given at points and along segments, growing with the distance from them.
//!
//! ```text
//!     length
//!       |    \                 /       Each source is a cone: its length there, and the growth times the distance
//!       |     \       \       /        around. The size is the lower envelope of all cones.
//!       |      \     / \     /
//!       |       \   /   \   /
//!       |        \ /     \ /
//!       └─────────o───────o──────
//! ```
//!
//! Of all functions that are no larger than asked at the sources and grow no faster than the growth, the envelope is
//! the largest one. So it is smooth enough for good triangles, whatever the sources ask for, and depends on no mesh.
//!
//! # Source
//! The envelope is the extension of `[McShane34]`; bounding the growth of a mesh size, `[Persson06]`.

use super::source_tree::SourceTree;
use super::{AreaBound, SizeField, TriangleInRegion};
use crate::geometry::{Point, Segment};

/// A place where edges are to have a length: a point, or all of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeSource {
    /// The place; a point is a segment without length.
    pub place: Segment,
    /// The length of edges there, in coordinate units.
    pub length: f64,
}

impl SizeSource {
    /// Edges of this length at a point.
    #[must_use]
    pub const fn at(point: Point, length: f64) -> Self {
        Self { place: Segment::new(point, point), length }
    }

    /// Edges of this length all along a segment.
    #[must_use]
    pub const fn along(place: Segment, length: f64) -> Self {
        Self { place, length }
    }
}

/// Why there is no graded field.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SizeError {
    /// A length is not positive and finite.
    #[error("the length at source {source_index} must be positive and finite, not {length}")]
    Length {
        /// Which source.
        source_index: usize,
        /// Its length.
        length: f64,
    },
    /// A coordinate is not finite.
    #[error("the place of source {source_index} must be finite")]
    Place {
        /// Which source.
        source_index: usize,
    },
    /// The growth is negative or not finite.
    #[error("the growth must be finite and not negative, not {0}")]
    Growth(f64),
    /// The factor between neighbouring edges is below 1 or not finite.
    #[error("the factor between neighbouring sizes must be finite and at least 1, not {0}")]
    Factor(f64),
}

/// Lengths that differ by less than this part are compared by areas.
const NEARLY: f64 = 1e-9;

/// Small near chosen points and segments, growing with the distance from them.
///
/// The bound on a triangle is the area of an equilateral triangle whose edges have the least length that the field has
/// at one of its corners.
///
/// The forecast and the lattice that fills wide parts leave this field out: inside a wide triangle it has many values.
///
/// # Examples
/// ```
/// use trimalla::geometry::{Point, Segment};
/// use trimalla::size::{Graded, SizeSource};
///
/// let [a, b, c] = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]].map(Point::from);
/// let field = Graded::new(&[SizeSource::along(Segment::new(a, b), 0.5), SizeSource::at(c, 0.25)], 0.5)?;
/// assert_eq!([a, b, c].map(|p| field.length_at(p)), [0.5, 0.5, 0.25]);
/// assert_eq!(field.length_at(Point::new(4.0, 2.0)), 1.5);
/// # Ok::<(), trimalla::size::SizeError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Graded {
    tree: SourceTree,
    growth: f64,
}

impl Graded {
    /// The field of some sources; the length grows by `growth` per distance, 0 for not at all.
    ///
    /// # Errors
    /// [`SizeError`] names what is out of range.
    ///
    /// # Complexity
    /// n log n.
    pub fn new(sources: &[SizeSource], growth: f64) -> Result<Self, SizeError> {
        if !(growth >= 0.0 && growth.is_finite()) {
            return Err(SizeError::Growth(growth));
        }
        for (source_index, &SizeSource { place, length }) in sources.iter().enumerate() {
            if !(length > 0.0 && length.is_finite()) {
                return Err(SizeError::Length { source_index, length });
            }
            if !place.ends().into_iter().all(Point::is_finite) {
                return Err(SizeError::Place { source_index });
            }
        }
        Ok(Self { tree: SourceTree::new(sources.to_vec()), growth })
    }

    /// The length of edges at a point; infinite without sources.
    ///
    /// # Complexity
    /// About the logarithm of the number of sources where they are spread and ask for similar lengths.
    #[must_use]
    pub fn length_at(&self, p: Point) -> f64 {
        self.tree.least_length_at(p, self.growth)
    }
}

impl SizeField for Graded {
    fn bound(&self, at: &TriangleInRegion) -> AreaBound {
        let lengths = at.triangle.corners.map(|corner| self.length_at(corner));
        AreaBound::of_edge(lengths.into_iter().fold(f64::INFINITY, f64::min))
    }

    /// The length at one corner decides for most triangles: at the others it differs by the growth along the side at
    /// most.
    fn admits(&self, at: &TriangleInRegion, area: f64) -> bool {
        let needed = AreaBound::of_area(area).edge();
        let [a, b, c] = at.triangle.corners;
        let length = self.length_at(a);
        // Rounded lengths a little off the bound are left to the exact comparison.
        if length < (1.0 - NEARLY) * needed {
            return false;
        }
        let reach = self.growth * (b - a).length_sq().max((c - a).length_sq()).sqrt();
        length - reach > (1.0 + NEARLY) * needed || area <= self.bound(at).area()
    }

    fn sure_bound(&self) -> AreaBound {
        AreaBound::of_edge(self.tree.least_length())
    }
}
