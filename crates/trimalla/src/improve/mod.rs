//! Smaller meshes: Steiner vertices are taken out, and others moved, as long as every angle keeps its bound.
//!
//! After a refinement most Steiner vertices are unnecessary. [`sift()`] removes one after the other: it takes a vertex
//! out, lets the vertices around it move and the edges flip until all angles are met again, proves that, and rolls back
//! where it does not succeed. Input vertices stay, vertices on segments slide along them, and regions, holes and
//! segments remain.
//!
//! # Source
//! The local search of the winners of the CG:SHOP challenge of 2025, carried over from obtuse angles to small ones.

mod bound;
mod climb;
mod kick;
mod patch;
mod random;
mod relax;
mod sift;

pub use bound::AngleBound;

use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation};
use crate::half_edge::FaceId;
use sift::Sifter;

/// What a caller asks of each triangle besides its angles, such as a bound on its area.
pub type Fits<'a> = &'a dyn Fn(&ConstrainedTriangulation, FaceId) -> bool;

/// What [`sift()`] is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SiftOptions {
    /// The smallest angle that triangles must have.
    pub bound: AngleBound,
    /// How much work is spent, from 1 to 9: each step twice as much as the one before.
    pub effort: u8,
    /// Where random choices begin. The same number gives the same mesh.
    pub seed: u64,
}

impl SiftOptions {
    /// A modest effort.
    pub const EFFORT: u8 = 5;

    /// The bound with a modest effort.
    #[must_use]
    pub const fn new(bound: AngleBound) -> Self {
        Self { bound, effort: Self::EFFORT, seed: 0 }
    }
}

/// How far a sift has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The present number of vertices.
    pub vertices: usize,
    /// Stars measured so far, the unit of work.
    pub work: u64,
}

/// What came of a sift.
#[derive(Clone, Debug)]
pub struct Sifted {
    /// The mesh; its vertices have other ids than before, but those of the input.
    pub mesh: ConstrainedDelaunay,
    /// Vertices before.
    pub vertices_before: usize,
    /// Vertices now.
    pub vertices: usize,
    /// Stars measured, the unit of work.
    pub work: u64,
    /// Whether it was cancelled: the mesh is as good as it was then.
    pub is_cancelled: bool,
}

/// What came of a climb.
#[derive(Clone, Debug)]
pub struct Climbed {
    /// The mesh; its vertices have other ids than before, but those of the input.
    pub mesh: ConstrainedDelaunay,
    /// The bound that every triangle is proved to meet now.
    pub bound: AngleBound,
    /// Whether it was cancelled: the mesh is as good as it was then.
    pub is_cancelled: bool,
}

/// Leads a mesh whose triangles all meet a bound to a higher one, as far as that goes: from where refinements end to
/// where none does.
///
/// # Guarantees
/// Those of [`sift()`], but that vertices may come. No angle gets smaller than the bound it begins with; a mesh that
/// does not meet that comes back as it is.
///
/// # Complexity
/// Bounded by the effort: eight times the work of [`sift()`].
#[must_use]
pub fn climb(
    mesh: ConstrainedDelaunay,
    options: &SiftOptions,
    target: AngleBound,
    fits: Fits<'_>,
    goes_on: &mut dyn FnMut(Progress) -> bool,
) -> Climbed {
    let mut sifter = Sifter::new(mesh, options, fits);
    let budget = (sifter.vertices() as u64 * 32_000) << options.effort.clamp(1, 9);
    let mut is_cancelled = false;
    if sifter.meets_bound() {
        sifter.climb(target, &mut |progress: Progress| {
            is_cancelled = is_cancelled || !goes_on(progress);
            !is_cancelled && progress.work < budget
        });
    }
    Climbed { bound: sifter.bound, is_cancelled, mesh: sifter.into_mesh() }
}

/// Takes out as many Steiner vertices as can be found unnecessary within the effort; `goes_on` is called before each
/// attempt, and cancels by `false`.
///
/// # Guarantees
/// The mesh stays constrained Delaunay, with the same input vertices, segments and regions. Each triangle that is made
/// is proved to have no angle below the bound and to fit; those that fail before remain where nothing helps. There are
/// never more vertices than before. The same mesh and options give the same result.
///
/// # Complexity
/// Bounded by the effort: 32,000 stars a vertex at effort 3, twice as many with each further step; an attempt counts as
/// fifty at least. What an attempt takes does not depend on the size of the mesh.
#[must_use]
pub fn sift(
    mesh: ConstrainedDelaunay,
    options: &SiftOptions,
    fits: Fits<'_>,
    goes_on: &mut dyn FnMut(Progress) -> bool,
) -> Sifted {
    let mut sifter = Sifter::new(mesh, options, fits);
    let vertices_before = sifter.vertices();
    let budget = (vertices_before as u64 * 4_000) << options.effort.clamp(1, 9);
    let is_cancelled = std::cell::Cell::new(false);
    let mut watch = |progress: Progress| {
        is_cancelled.set(is_cancelled.get() || !goes_on(progress));
        !is_cancelled.get() && progress.work < budget
    };
    // A pass that finds nothing is followed by a shake and another pass, and then by kicks.
    let mut idle = 0;
    while idle < 2 {
        let Some(found) = sifter.pass(&mut watch) else { break };
        idle = if found == 0 { idle + 1 } else { 0 };
        if found == 0 && sifter.shake(&mut watch).is_none() {
            break;
        }
    }
    while idle == 2 && sifter.kick(&mut watch).is_some() {}
    Sifted {
        vertices_before,
        vertices: sifter.vertices(),
        work: sifter.work(),
        is_cancelled: is_cancelled.get(),
        mesh: sifter.into_mesh(),
    }
}
