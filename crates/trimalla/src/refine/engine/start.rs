//! What a refinement starts from.

use std::fmt;
use std::sync::Arc;

use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Workspace};
use crate::domain::FromMesh;
use crate::refine::criteria::bad_triangles::UserTest;
use crate::refine::forecast::outlook::Outlook;
use crate::refine::recipe::options::RefineOptions;
use crate::refine::steps::Steps;
use crate::refine::watch::stopwatch::Clock;
use crate::size::{ByTriangle, SizeBounds, SizeField, TriangleInRegion};

/// What a refinement starts from: a constrained Delaunay triangulation of a domain
/// ([`domain::build`](crate::domain::build)), or a mesh that was taken up
/// ([`domain::from_mesh`](crate::domain::from_mesh())), some of whose edges may fail the circle test.
///
/// What it begins with besides is what the caller adds: size fields, steps and a test of the caller's own, a clock.
#[derive(Clone)]
pub struct Start {
    pub(super) cdt: ConstrainedTriangulation,
    pub(super) work: Workspace,
    /// Whether every edge is known to pass the circle test.
    pub(super) is_delaunay: bool,
    /// The size fields besides the options and the regions.
    pub(super) fields: Vec<Arc<dyn SizeField>>,
    pub(super) setup: Setup,
}

/// What the caller adds to a recipe.
#[derive(Clone, Default)]
pub(super) struct Setup {
    /// The five steps, if they are not those of the recipe.
    pub(super) steps: Option<Steps>,
    /// A test besides the criteria.
    pub(super) test: Option<Arc<UserTest>>,
    /// A clock that measures the steps.
    pub(super) clock: Option<Clock>,
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

    /// Puts these steps in the place of the recipe's.
    ///
    /// # Examples
    /// ```
    /// use std::sync::Arc;
    /// use trimalla::geometry::Triangle;
    /// use trimalla::half_edge::FaceId;
    /// use trimalla::refine::steps::{SelectStep, Steps, View};
    /// use trimalla::refine::{NoObserver, RefineOptions, Refinement, Start};
    /// # use trimalla::{constrained::Crossings, delaunay::AlgorithmKey, domain::{DomainRule, build}, drawing::Pslg, geometry::Point};
    /// # let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
    /// # let pslg = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
    /// # let (cdt, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
    ///
    /// /// The lowest triangle first.
    /// struct LowestFirst;
    ///
    /// impl SelectStep for LowestFirst {
    ///     fn priority(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
    ///         let [a, b, c] = view.cdt.corners(face);
    ///         Triangle::new(a, b, c).centroid().y.max(0.0)
    ///     }
    /// }
    ///
    /// let options = RefineOptions::default().with_max_area(0.5);
    /// let steps = Steps { select: Arc::new(LowestFirst), ..Steps::of(&options) };
    /// let mut refinement = Refinement::new(Start::from(cdt).with_steps(steps), options)?;
    /// refinement.run(&mut NoObserver);
    /// assert!(refinement.finish().1.complete());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_steps(mut self, steps: Steps) -> Self {
        self.setup.steps = Some(steps);
        self
    }

    /// Adds a test of the caller's own, in place of the one before, if there was one: triangles that it refuses are
    /// bad, too.
    ///
    /// The test gets a triangle and the attribute of its region. It must return the same result for the same triangle,
    /// or the mesh depends on the order of tests. Whatever it returns, the limits end the refinement.
    ///
    /// # Examples
    /// ```
    /// use trimalla::refine::{NoObserver, RefineOptions, Refinement, Start};
    /// use trimalla::size::TriangleInRegion;
    /// # use trimalla::{constrained::Crossings, delaunay::AlgorithmKey, domain::{DomainRule, build}, drawing::Pslg, geometry::Point};
    /// # let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
    /// # let pslg = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
    /// # let (cdt, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
    /// // The smaller the farther left.
    /// let coarse = |at: TriangleInRegion| at.triangle.area() > 0.05 + 0.1 * at.triangle.centroid().x;
    /// let mut refinement = Refinement::new(Start::from(cdt).with_test(coarse), RefineOptions::default())?;
    /// refinement.run(&mut NoObserver);
    /// # assert!(refinement.finish().1.triangles > 20);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_test(mut self, test: impl Fn(TriangleInRegion) -> bool + Send + Sync + 'static) -> Self {
        self.setup.test = Some(Arc::new(test));
        self
    }

    /// Measures the steps by a clock, if there is one: [`Report::step_times`](crate::refine::Report::step_times).
    #[must_use]
    pub fn with_clock(mut self, clock: Option<Clock>) -> Self {
        self.setup.clock = clock;
        self
    }

    /// Adds a size field that others hold, too.
    #[must_use]
    pub fn with_shared_size(mut self, field: Arc<dyn SizeField>) -> Self {
        self.fields.push(field);
        self
    }

    /// The size fields beside the options and the regions.
    #[must_use]
    pub fn sizes(&self) -> &[Arc<dyn SizeField>] {
        &self.fields
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
        Self { cdt, work, is_delaunay: true, fields: Vec::new(), setup: Setup::default() }
    }
}

impl From<ConstrainedTriangulation> for Start {
    fn from(cdt: ConstrainedTriangulation) -> Self {
        Self { cdt, work: Workspace::default(), is_delaunay: false, fields: Vec::new(), setup: Setup::default() }
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
