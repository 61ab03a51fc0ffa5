//! Sizes of triangles beside the options: fields, how fast sizes grow, how many triangles there are to be.
//!
//! A number of triangles is met by trial: the mesh is made at some scale of the sizes, its triangles are counted, and
//! the scale is corrected. Where sizes alone decide, the count is inversely proportional to the scale, and the second
//! mesh is near enough. Where features of the drawing need many triangles whatever the scale, the next scale is that
//! of the line through the last two counts, both in logarithms.

use std::fmt;
use std::sync::Arc;

use super::quiet::Quiet;
use super::{Refined, refined_at_once};
use crate::geometry::math;
use crate::refine::{
    NoObserver, Observer, OptionError, Outlook, RefineOptions, Refinement, Start, StopReason, gradation,
};
use crate::size::{AreaBound, Graded, Scaled, SizeBounds, SizeError, SizeField, Uniform};

/// A count is near enough if it is off by this part at most.
const NEAR: f64 = 0.02;
/// No more meshes than this are made for a number of triangles.
const MOST_TRIALS: usize = 8;
/// The area of a mean triangle over the area bound, about.
const MEAN_OVER_MAX: f64 = 0.75;

/// Sizes of triangles beside those of the options and of the regions: the least of all counts.
///
/// # Examples
/// ```
/// use trimalla::size::{AreaBound, Graded, SizeSource, Uniform};
/// use trimalla::{MeshOptions, Pslg, Sizing, mesh_sized};
///
/// let square = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
/// // Edges no longer than 0.5, those at the first vertex no longer than 0.05; 2000 triangles in these proportions.
/// let sizing = Sizing::default()
///     .with_field(Uniform(AreaBound::of_edge(0.5)))
///     .with_field(Graded::new(&[SizeSource::at(square.points[0], 0.05)], 0.3)?)
///     .with_triangles(2000);
/// let made = mesh_sized(&square, &MeshOptions::default(), &sizing, &mut trimalla::refine::NoObserver)?;
/// assert!((1900..=2100).contains(&made.mesh.triangles.len()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Default)]
pub struct Sizing {
    fields: Vec<Arc<dyn SizeField>>,
    growth: Option<f64>,
    triangles: Option<usize>,
}

impl Sizing {
    /// Adds a field.
    #[must_use]
    pub fn with_field(mut self, field: impl SizeField + 'static) -> Self {
        self.fields.push(Arc::new(field));
        self
    }

    /// Sets the largest factor between an edge and the next one away from a small feature, or from where small
    /// triangles are asked for.
    ///
    /// # Errors
    /// [`SizeError::Factor`] where it is below 1 or not finite.
    pub fn with_growth(mut self, factor: f64) -> Result<Self, SizeError> {
        if !(factor >= 1.0 && factor.is_finite()) {
            return Err(SizeError::Factor(factor));
        }
        self.growth = Some(factor - 1.0);
        Ok(self)
    }

    /// Sets how many triangles there are to be: the fields are scaled until the mesh has about that many. Without a
    /// field, triangles are as large everywhere.
    ///
    /// Bounds on angles, regions and the area bound of the options hold all the same, so that a mesh may have more.
    #[must_use]
    pub fn with_triangles(mut self, triangles: usize) -> Self {
        self.triangles = Some(triangles.max(1));
        self
    }

    /// Whether nothing is set.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.fields.is_empty() && self.growth.is_none() && self.triangles.is_none()
    }

    /// A start with the fields at some scale of areas, and with the graded field if sizes are to grow slowly.
    fn add_to(&self, mut start: Start, options: &RefineOptions, fields: Vec<Arc<dyn SizeField>>, scale: f64) -> Start {
        if scale == 1.0 {
            start = fields.into_iter().fold(start, Start::with_shared_size);
        } else {
            start = start.with_size(Scaled::new(fields, scale));
        }
        let Some(growth) = self.growth else { return start };
        let bounds = SizeBounds::new(options.criteria.max_area, start.triangulation(), start.sizes().to_vec());
        let sources = gradation(start.triangulation(), options, &bounds, growth);
        // Sources with a length that is positive and finite are never refused.
        match Graded::new(&sources, growth) {
            Ok(field) => start.with_size(field),
            Err(_) => start,
        }
    }
}

impl fmt::Debug for Sizing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { fields, growth, triangles } = self;
        f.debug_struct("Sizing")
            .field("fields", &fields.len())
            .field("growth", growth)
            .field("triangles", triangles)
            .finish()
    }
}

/// Refines a triangulation under these sizes.
pub(super) fn refined(
    start: Start,
    options: &RefineOptions,
    sizing: &Sizing,
    observer: &mut dyn Observer,
) -> Result<Refined, OptionError> {
    match sizing.triangles {
        None => refined_at_once(sizing.add_to(start, options, sizing.fields.clone(), 1.0), options, observer),
        Some(triangles) => refined_to_count(start, options, sizing, triangles, observer),
    }
}

/// Refines again and again, until the mesh has about so many triangles.
fn refined_to_count(
    start: Start,
    options: &RefineOptions,
    sizing: &Sizing,
    triangles: usize,
    observer: &mut dyn Observer,
) -> Result<Refined, OptionError> {
    let mut search = ScaleSearch::new(&start, sizing, triangles);
    let fields = search.fields.clone();
    let at_scale = |scale: f64| sizing.add_to(start.clone(), options, fields.clone(), scale);
    let outlook = announce(at_scale(search.scale()), options, observer)?;
    let mut quiet = Quiet::new(observer);
    let mut best: Option<(f64, Refined)> = None;
    for _ in 0..MOST_TRIALS {
        let scale = search.scale();
        let made = refined_at_once(at_scale(scale), options, &mut quiet)?;
        let error = search.note(made.report.triangles);
        let is_over = quiet.is_cancelled || made.report.stop == StopReason::Budget;
        if best.as_ref().is_none_or(|(_, known)| error < search.error_of(known.report.triangles)) {
            best = Some((scale, made));
        }
        if is_over || error <= NEAR || !search.correct() {
            break;
        }
    }
    let is_cancelled = quiet.is_cancelled;
    match best {
        Some((scale, _)) if !is_cancelled && (observer.wants_events() || observer.clock().is_some()) => {
            refined_at_once(at_scale(scale), options, observer)
        }
        Some((_, made)) => Ok(Refined { outlook, ..made }),
        None => refined_at_once(at_scale(1.0), options, &mut NoObserver),
    }
}

/// Shows the outlook and the beginning to an observer that sees only the progress afterwards.
fn announce(
    start: Start,
    options: &RefineOptions,
    observer: &mut dyn Observer,
) -> Result<Option<Outlook>, OptionError> {
    if observer.wants_events() || observer.clock().is_some() {
        return Ok(None);
    }
    let outlook = observer.wants_outlook().then(|| start.outlook(options));
    if let Some(outlook) = &outlook {
        observer.outlook(outlook);
    }
    let mut refinement = Refinement::new(start, *options)?;
    if refinement.prepare(observer) {
        observer.begins(&mut refinement);
    }
    Ok(outlook)
}

/// The search for the scale at which there are so many triangles.
struct ScaleSearch {
    fields: Vec<Arc<dyn SizeField>>,
    target: f64,
    /// The scale of areas, as a logarithm.
    scale: f64,
    /// Scales and counts so far, as logarithms.
    known: Vec<[f64; 2]>,
}

impl ScaleSearch {
    fn new(start: &Start, sizing: &Sizing, triangles: usize) -> Self {
        let cdt = start.triangulation();
        let area_of = |f| {
            let [a, b, c] = cdt.corners_from_newest(f);
            0.5 * (b - a).cross(c - a)
        };
        let area: f64 = cdt.real_faces().map(area_of).sum();
        let mean = area / triangles as f64;
        let mut fields = sizing.fields.clone();
        if fields.is_empty() {
            fields.push(Arc::new(Uniform(AreaBound::of_area(mean / MEAN_OVER_MAX))));
        }
        Self { fields, target: math::ln(triangles as f64), scale: 0.0, known: Vec::new() }
    }

    fn scale(&self) -> f64 {
        math::exp(self.scale)
    }

    /// How far a count is off, as a part of the number that is asked.
    fn error_of(&self, triangles: usize) -> f64 {
        (math::exp(math::ln(triangles.max(1) as f64) - self.target) - 1.0).abs()
    }

    /// Notes the count at the present scale, and returns how far it is off.
    fn note(&mut self, triangles: usize) -> f64 {
        self.known.push([self.scale, math::ln(triangles.max(1) as f64)]);
        self.error_of(triangles)
    }

    /// Chooses the next scale; returns whether one promises to be better.
    fn correct(&mut self) -> bool {
        let Some(&[[scale, count]]) = self.known.last_chunk() else { return false };
        let slope = self.slope();
        if slope > -1e-3 && count > self.target {
            // Larger triangles are fewer no longer: the rest is needed for features and angles.
            return false;
        }
        let mut next = scale + (self.target - count) / slope.min(-0.05);
        // Between a scale with too many triangles and one with too few.
        let too_many = self.known.iter().filter(|known| known[1] > self.target).map(|known| known[0]);
        let too_few = self.known.iter().filter(|known| known[1] <= self.target).map(|known| known[0]);
        let (low, high) = (too_many.fold(f64::NEG_INFINITY, f64::max), too_few.fold(f64::INFINITY, f64::min));
        if low.is_finite() && high.is_finite() && low < high {
            let margin = 0.1 * (high - low);
            next = next.clamp(low + margin, high - margin);
        } else {
            next = next.clamp(scale - 7.0, scale + 7.0);
        }
        let is_new = next != self.scale;
        self.scale = next;
        is_new
    }

    /// By how much the logarithm of the count changes with that of the scale, from the last two trials.
    fn slope(&self) -> f64 {
        match self.known.last_chunk() {
            Some(&[[x, one], [y, two]]) if x != y => (two - one) / (y - x),
            _ => -1.0,
        }
    }
}
