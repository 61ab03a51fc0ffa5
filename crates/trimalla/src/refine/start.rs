//! What a refinement starts from.

use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Workspace};

/// What a refinement starts from: a constrained Delaunay triangulation of a domain
/// ([`domain::build`](crate::domain::build)), or a mesh that was taken up ([`domain::from_mesh`](crate::domain::from_mesh())),
/// some of whose edges may fail the circle test.
#[derive(Clone, Debug)]
pub struct Start {
    pub(super) cdt: ConstrainedTriangulation,
    pub(super) work: Workspace,
    /// Whether it is known that every edge passes the circle test.
    pub(super) is_delaunay: bool,
}

impl Start {
    /// The triangulation.
    #[must_use]
    pub fn triangulation(&self) -> &ConstrainedTriangulation {
        &self.cdt
    }
}

impl From<ConstrainedDelaunay> for Start {
    fn from(cdt: ConstrainedDelaunay) -> Self {
        let (cdt, work) = cdt.into_parts();
        Self { cdt, work, is_delaunay: true }
    }
}

impl From<ConstrainedTriangulation> for Start {
    fn from(cdt: ConstrainedTriangulation) -> Self {
        Self { cdt, work: Workspace::default(), is_delaunay: false }
    }
}
