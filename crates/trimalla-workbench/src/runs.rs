//! What runs of refinements did, as values.

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::Triangle;
use trimalla::quality::Histogram;
use trimalla::refine::lepp::lepp;
use trimalla::refine::{Criteria, LeppRule, NamedOptions, Overview, Prepare, Report, Ruler};

use crate::document::Document;
use crate::figures::Figures;
use crate::mesh::Refining;

/// What a run of a refinement was asked, and what it did.
///
/// # Source
/// The information that is shown after each run, section 3.6.4 of `[MeshSuite]`.
#[derive(Clone, Debug, PartialEq)]
pub struct RunInformation {
    /// What was asked: the five steps, criteria and limits.
    pub options: NamedOptions,
    /// Size and smallest angle before.
    pub before: Overview,
    /// Size and smallest angle after.
    pub after: Overview,
    /// How many triangles are left that the criteria refuse.
    pub leftovers: usize,
    /// Lengths of the longest-edge propagation paths that were followed: the number of paths with 0, 1, 2, … triangles.
    pub path_lengths: Vec<u64>,
}

impl RunInformation {
    /// What a refinement did that was asked this, and began with a mesh of this size.
    pub(crate) fn new(options: NamedOptions, before: Overview, report: &Report) -> Self {
        let min_angle_deg = (report.triangles > 0).then_some(report.min_angle_deg);
        let after = Overview { vertices: report.vertices, triangles: report.triangles, min_angle_deg };
        Self { options, before, after, leftovers: report.leftovers.len(), path_lengths: report.lepp_lengths.clone() }
    }

    /// What the refinement at work has done until now.
    ///
    /// # Complexity
    /// Linear.
    pub(crate) fn until_now(refining: &Refining) -> Self {
        let (_, report) = refining.refinement.without_history().finish();
        Self::new(refining.options.clone(), refining.before, &report)
    }

    /// The information as lines: name and value.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        let Self { options, before, after, .. } = self;
        let recipe = &options.recipe;
        let prepared = recipe.prepare != Prepare::None;
        let when = if prepared { format!(", {}", recipe.prepare_when.key()) } else { String::new() };
        let until = if recipe.until_destroyed { ", until destroyed" } else { "" };
        let criteria = options.refine_options().criteria;
        let angle = |overview: &Overview| overview.min_angle_deg.map_or("none".to_owned(), |deg| format!("{deg:.4}"));
        let mut lines = vec![
            format!("pre-process: {}{when}", recipe.prepare.key()),
            format!("selection: {}{until}", recipe.select.key()),
            format!("angle asked: {} degrees", options.min_angle_deg.unwrap_or(Criteria::DEFAULT_MIN_ANGLE_DEG)),
        ];
        lines.extend(criteria.max_area.map(|area| format!("largest area asked: {area}")));
        lines.extend([
            format!("new point: {}", recipe.point.key()),
            format!("insertion: {}", recipe.insert.key()),
            format!("smallest angle: {} degrees before, {} after", angle(before), angle(after)),
            format!("triangles: {} before, {} after", before.triangles, after.triangles),
            format!("vertices: {} before, {} after", before.vertices, after.vertices),
        ]);
        lines
    }
}

/// Size and smallest angle of a triangulation.
///
/// # Complexity
/// Linear.
pub(crate) fn overview_of(t: &ConstrainedTriangulation) -> Overview {
    let figures = Figures::of_triangulation(t, t.input_points());
    let min_angle_deg = (figures.triangles > 0).then_some(figures.min_angle_deg);
    Overview { vertices: t.input_points() + t.steiner_vertices(), triangles: figures.triangles, min_angle_deg }
}

fn smallest_angle_deg([a, b, c]: [trimalla::geometry::Point; 3]) -> f64 {
    Triangle::new(a, b, c).min_angle().degrees()
}

/// What a program reads of refinements, and shows while they go on.
impl Document {
    /// What the refinement that goes step by step has done until now.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn run_so_far(&self) -> Option<RunInformation> {
        self.refining().map(RunInformation::until_now)
    }

    /// The smallest angles of all triangles, in bins of one degree.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn angle_histogram(&self) -> Histogram {
        let mut histogram = Histogram::new(60, 60.0);
        if let Some(t) = self.triangulation() {
            t.real_faces().for_each(|f| histogram.add(smallest_angle_deg(t.face_points(f))));
        }
        histogram
    }

    /// The lengths of the longest-edge propagation paths of all triangles: the number of paths with 0, 1, 2, …
    /// triangles. Paths go on to the boundary, as in `LEPP` and `Show`.
    ///
    /// # Complexity
    /// The sum of the lengths; two or three a triangle.
    #[must_use]
    pub fn path_lengths(&self) -> Vec<u64> {
        let mut lengths = Vec::new();
        if let Some(t) = self.triangulation() {
            let ruler = Ruler::for_box(t.bounding_box());
            t.real_faces().for_each(|f| count(&mut lengths, lepp(t, ruler, f, LeppRule::StopAtBoundary).len()));
        }
        lengths
    }
}

/// Counts a path of this length.
pub(crate) fn count(lengths: &mut Vec<u64>, length: usize) {
    if lengths.len() <= length {
        lengths.resize(length + 1, 0);
    }
    lengths[length] += 1;
}
