//! Triangles picked by their numbers.

use std::collections::BTreeMap;
use std::fmt;

use trimalla::half_edge::{FaceId, VertexId};
use trimalla::refine::Beginning;

use super::words::count;

/// Why a triangle cannot be picked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PickError {
    /// No triangle has the number.
    NoSuchTriangle {
        /// The number.
        number: usize,
        /// The number of the first triangle.
        first: usize,
        /// How many triangles there are.
        triangles: usize,
    },
    /// The triangle of the mesh was flipped away before refinement began.
    Flipped {
        /// Its number.
        number: usize,
    },
}

impl fmt::Display for PickError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoSuchTriangle { number, first, triangles } => {
                let triangles = count(triangles, "triangle");
                write!(
                    f,
                    "there is no triangle {number} to pick: there are {triangles} to start from, numbered from {first} on"
                )
            }
            Self::Flipped { number } => {
                write!(f, "triangle {number} is no more when refinement begins: edges of it were flipped first")
            }
        }
    }
}

impl std::error::Error for PickError {}

/// Triangles by the numbers that they have where refinement starts.
#[derive(Clone, Debug, Default)]
pub struct Picks {
    numbers: Vec<usize>,
    first: usize,
    /// The triangles by their vertices, where they are those of a mesh that may have been flipped since.
    named: Option<Vec<[VertexId; 3]>>,
}

impl Picks {
    /// The triangles with these numbers, where the first one has the number `first_index`; of the triangles of a mesh,
    /// or of the start itself where none are given.
    ///
    /// # Errors
    /// [`PickError::NoSuchTriangle`].
    pub fn new(numbers: &[usize], first_index: u32, triangles: Option<&[[u32; 3]]>) -> Result<Self, PickError> {
        let first = first_index as usize;
        let named =
            triangles.map(|t| numbers.iter().map(|n| number_in(*n, first, t.len()).map(|i| name(t[i]))).collect());
        Ok(Self { numbers: numbers.to_vec(), first, named: named.transpose()? })
    }

    /// Picks the triangles; returns whether the refinement took all of them.
    ///
    /// # Errors
    /// [`PickError`]; none is picked then.
    pub fn pick(&self, begun: &mut dyn Beginning) -> Result<bool, PickError> {
        Ok(self.faces(begun)?.into_iter().all(|f| begun.pick(f)))
    }

    fn faces(&self, begun: &dyn Beginning) -> Result<Vec<FaceId>, PickError> {
        if self.numbers.is_empty() {
            return Ok(Vec::new());
        }
        let cdt = begun.triangulation();
        let start: Vec<FaceId> = cdt.real_faces().collect();
        let Some(named) = &self.named else {
            return self.numbers.iter().map(|&n| number_in(n, self.first, start.len()).map(|i| start[i])).collect();
        };
        let by_name: BTreeMap<_, _> = start.into_iter().map(|f| (sorted(cdt.face_vertices(f)), f)).collect();
        let face =
            |(&number, name): (&usize, &[VertexId; 3])| by_name.get(name).copied().ok_or(PickError::Flipped { number });
        self.numbers.iter().zip(named).map(face).collect()
    }
}

/// The index of the triangle with this number.
fn number_in(number: usize, first: usize, triangles: usize) -> Result<usize, PickError> {
    let index = number.checked_sub(first).filter(|&index| index < triangles);
    index.ok_or(PickError::NoSuchTriangle { number, first, triangles })
}

fn name(triangle: [u32; 3]) -> [VertexId; 3] {
    sorted(triangle.map(VertexId))
}

fn sorted(mut name: [VertexId; 3]) -> [VertexId; 3] {
    name.sort_unstable();
    name
}
