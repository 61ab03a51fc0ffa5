//! What a refinement starts from.

use std::fmt;
use std::sync::Arc;

use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Workspace};
use crate::domain::FromMesh;
use crate::refine::forecast::outlook::Outlook;
use crate::refine::recipe::options::RefineOptions;
use crate::size::{ByTriangle, SizeBounds, SizeField};

/// What a refinement starts from: a constrained Delaunay triangulation of a domain
/// ([`domain::build`](crate::domain::build)), or a mesh that was taken up
/// ([`domain::from_mesh`](crate::domain::from_mesh())), some of whose edges may fail the circle test.
#[derive(Clone)]
pub struct Start {
    pub(super) cdt: ConstrainedTriangulation,
    pub(super) work: Workspace,
    /// Whether every edge is known to pass the circle test.
    pub(super) is_delaunay: bool,
    /// The size fields besides the options and the regions.
    pub(super) fields: Vec<Arc<dyn SizeField>>,
}

impl fmt::Debug for Start {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Start").field("is_delaunay", &self.is_delaunay).finish_non_exhaustive()
    }
}

impl Start {
    /// The triangulation.
    #[must_use]
    pub fn triangulation(&self) -> &ConstrainedTriangulation {
        &self.cdt
    }

    /// Adds a size field.
    #[must_use]
    pub fn with_size(mut self, field: impl SizeField + 'static) -> Self {
        self.fields.push(Arc::new(field));
        self
    }

    /// The outlook: the forecast, the angle ceiling and the smallest input angle.
    ///
    /// # Complexity
    /// That of the [`forecast()`](crate::refine::forecast()).
    #[must_use]
    pub fn outlook(&self, options: &RefineOptions) -> Outlook {
        let size = SizeBounds::new(options.criteria.max_area, &self.cdt, self.fields.clone());
        Outlook::under(&self.cdt, options, &size)
    }
}

impl From<ConstrainedDelaunay> for Start {
    fn from(cdt: ConstrainedDelaunay) -> Self {
        let (cdt, work) = cdt.into_parts();
        Self { cdt, work, is_delaunay: true, fields: Vec::new() }
    }
}

impl From<ConstrainedTriangulation> for Start {
    fn from(cdt: ConstrainedTriangulation) -> Self {
        Self { cdt, work: Workspace::default(), is_delaunay: false, fields: Vec::new() }
    }
}

impl From<FromMesh> for Start {
    /// The mesh with the area bounds that were given for its triangles.
    fn from(mesh: FromMesh) -> Self {
        let start = Self::from(mesh.cdt);
        match mesh.areas {
            Some(areas) => start.with_size(ByTriangle::new(areas.triangles, &areas.max_areas)),
            None => start,
        }
    }
}
