//! The triangulation of an input, in slices.
//!
//! 1. Points, along a curve: those of the incremental algorithm in slices, those of others at once.
//! 2. Segments in their order, in slices; those that cross are split.
//! 3. The outside of a drawing that was read is carved away.
//!
//! Contours go in before the other points, and are triangulated in one slice.

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::{AlgorithmKey, Insertion};
use trimalla::domain::{Contours, DomainRule, carve_exactly};
use trimalla::half_edge::NoJournal;

use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::state::Input;

/// So many points go in in a slice: some milliseconds.
const POINTS: usize = 4096;

/// So many segments go in in a slice.
const SEGMENTS: usize = 2048;

/// A triangulation at work.
pub(crate) enum Building {
    /// Nothing is done yet.
    Asked(AlgorithmKey),
    /// Points are inserted.
    Points(Box<Insertion>),
    /// All points are there, and so many segments.
    Segments(Box<ConstrainedDelaunay>, usize),
}

/// What came of a slice.
pub(crate) enum Built {
    /// There is another one.
    More(Building),
    /// This was the last.
    Done(Mesh),
}

fn fault(error: impl std::fmt::Display) -> CommandError {
    CommandError::new(error.to_string())
}

impl Building {
    /// The next slice of the triangulation of an input: with contours of their inside, of a drawing that was read of
    /// its domain, and of anything else of the convex hull.
    pub(crate) fn advance(self, input: &Input) -> Result<Built, CommandError> {
        let drawing = &input.drawing;
        Ok(Built::More(match self {
            Self::Asked(algorithm) if input.outer.is_some() || !input.inner.is_empty() => {
                return Ok(Built::Done(within_contours(input, algorithm)?));
            }
            Self::Asked(AlgorithmKey::Incremental) => {
                drawing.validate().map_err(fault)?;
                Self::Points(Box::new(Insertion::new(&drawing.points).map_err(fault)?))
            }
            Self::Asked(algorithm) => {
                drawing.validate().map_err(fault)?;
                let points = ConstrainedDelaunay::with_algorithm(&drawing.points, &[], Crossings::Split, algorithm);
                Self::Segments(Box::new(points.map_err(fault)?), 0)
            }
            Self::Points(mut insertion) => {
                if insertion.advance(POINTS) {
                    Self::Points(insertion)
                } else {
                    Self::Segments(Box::new(ConstrainedDelaunay::from_insertion(*insertion)), 0)
                }
            }
            Self::Segments(cdt, done) if done == drawing.segments.len() => {
                return Ok(Built::Done(Mesh::of_delaunay(if input.is_read {
                    carve_exactly(*cdt, drawing, DomainRule::Seeds).map_err(fault)?.0
                } else {
                    *cdt
                })));
            }
            Self::Segments(mut cdt, done) => {
                let end = (done + SEGMENTS).min(drawing.segments.len());
                cdt.insert_segments_with(&drawing.segments[done..end], Crossings::Split, &mut NoJournal)
                    .map_err(fault)?;
                Self::Segments(cdt, end)
            }
        }))
    }

    /// All slices at once.
    pub(crate) fn run(mut self, input: &Input) -> Result<Mesh, CommandError> {
        loop {
            self = match self.advance(input)? {
                Built::More(rest) => rest,
                Built::Done(mesh) => return Ok(mesh),
            };
        }
    }
}

fn within_contours(input: &Input, algorithm: AlgorithmKey) -> Result<Mesh, CommandError> {
    let contours = Contours { outer: input.outer.clone(), holes: input.inner.clone(), ..Contours::default() };
    let mut cdt = contours.triangulate(&input.drawing.points, algorithm).map_err(fault)?;
    cdt.insert_segments(&input.drawing.segments, Crossings::Split).map_err(fault)?;
    Ok(Mesh::of_delaunay(cdt))
}
