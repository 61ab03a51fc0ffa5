//! What pictures show, and where: [`svg`](crate::svg) and [`png`](crate::png) paint it.
//!
//! Triangles are coloured by their smallest angle, from red (0°) through yellow (30°) to blue (60°), in twelve classes
//! of five degrees. Classes are painted from good to bad, so that thin triangles are never hidden.

mod angle;
mod frame;
mod overlay;

use std::fmt;
use std::io;

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use crate::bars::BarChart;
use crate::columns::{Points, Segments, check_triangles};
pub(crate) use angle::{CLASS_DEG, CLASSES, Histogram};
pub(crate) use frame::{Frame, MARGIN, Place, SIDE, Space};
pub use overlay::Overlay;
pub(crate) use overlay::Tone;

/// What a picture shows.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PictureOptions {
    /// The heading; empty for none. `.svg` alone.
    pub title: String,
    /// Whether vertices are dots.
    pub show_vertices: bool,
    /// Whether in the picture of a drawing only vertices on no segment are dots.
    pub only_lone_vertices: bool,
    /// Whether scale, histogram and counts stand beside the picture. `.svg` alone.
    pub show_legend: bool,
    /// Bar charts that stand below the picture of a mesh. `.svg` alone.
    pub charts: Vec<BarChart>,
    /// Areas, lines and marks: guards and colours of a gallery, what a point sees.
    pub overlay: Overlay,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self {
            title: String::new(),
            show_vertices: false,
            only_lone_vertices: false,
            show_legend: true,
            charts: Vec::new(),
            overlay: Overlay::default(),
        }
    }
}

impl PictureOptions {
    /// Sets the heading.
    #[must_use]
    pub fn with_title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Shows vertices as dots, or does not.
    #[must_use]
    pub fn with_vertices(mut self, show: bool) -> Self {
        self.show_vertices = show;
        self
    }

    /// Shows, of a drawing, as dots only vertices on no segment, or all vertices.
    #[must_use]
    pub fn with_only_lone_vertices(mut self, only: bool) -> Self {
        self.only_lone_vertices = only;
        self
    }

    /// Shows the legend, or does not.
    #[must_use]
    pub fn with_legend(mut self, show: bool) -> Self {
        self.show_legend = show;
        self
    }

    /// Puts bar charts below the picture of a mesh, in place of those before.
    #[must_use]
    pub fn with_charts(mut self, charts: Vec<BarChart>) -> Self {
        self.charts = charts;
        self
    }

    /// Paints areas, lines and marks, in place of those before.
    #[must_use]
    pub fn with_overlay(mut self, overlay: Overlay) -> Self {
        self.overlay = overlay;
        self
    }
}

/// Red, green and blue, a byte each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Colour(pub(crate) u32);

/// The classes' colours, from the smallest angles to the largest: steps of equal size in a perceptual colour space.
pub(crate) const COLOURS: [Colour; CLASSES] = [
    Colour(0x9e1b32),
    Colour(0xc24537),
    Colour(0xe26b3d),
    Colour(0xef984f),
    Colour(0xf5bf6b),
    Colour(0xf4db93),
    Colour(0xdfe5aa),
    Colour(0xb5dbb2),
    Colour(0x8ac9b4),
    Colour(0x5eb3b3),
    Colour(0x4292a7),
    Colour(0x2b6f97),
];
/// Segments, vertices and letters.
pub(crate) const INK: Colour = Colour(0x1d2733);
/// The sheet, and the edges of triangles.
pub(crate) const PAPER: Colour = Colour(0xffffff);
/// How much edges hide of what is below them, in hundredths.
pub(crate) const EDGE_OPACITY: i64 = 75;
/// Crosses at the seeds of holes, rings at those of regions.
pub(crate) const HOLE: Colour = COLOURS[1];
pub(crate) const REGION: Colour = COLOURS[11];
/// How far a cross or a ring reaches from its seed, and how wide its lines are, in units of the sheet.
pub(crate) const MARK_REACH: f64 = 5.0;
pub(crate) const MARK_WIDTH: f64 = 2.0;
/// How large the marks of an overlay are.
pub(crate) const MARK_SIZE: f64 = 16.0;

impl Colour {
    /// Red, green, blue.
    pub(crate) fn bytes(self) -> [u8; 3] {
        let [_, red, green, blue] = self.0.to_be_bytes();
        [red, green, blue]
    }
}

impl fmt::Display for Colour {
    /// `#1d2733`, or `#fff` where one digit says as much as two.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bytes = self.bytes();
        if bytes.iter().all(|byte| byte % 0x11 == 0) {
            let [red, green, blue] = bytes.map(|byte| byte / 0x11);
            write!(f, "#{red:x}{green:x}{blue:x}")
        } else {
            write!(f, "#{:06x}", self.0)
        }
    }
}

/// A picture: what is painted, in the order of the fields, each above those before. Widths and sizes are in units of
/// the sheet.
#[derive(Debug)]
pub(crate) struct Picture<'a> {
    pub(crate) frame: Frame,
    points: &'a [Point],
    triangles: &'a [[u32; 3]],
    pub(crate) histogram: Histogram,
    pub(crate) edge_width: f64,
    segments: &'a [[u32; 2]],
    pub(crate) segment_width: f64,
    /// The size of the dots, if there are dots.
    pub(crate) dot_size: Option<f64>,
    /// Where the dots are: at all vertices, or only at some.
    dots: Option<Vec<Point>>,
    holes: &'a [Point],
    regions: Vec<Point>,
    overlay: &'a Overlay,
}

impl<'a> Picture<'a> {
    /// The picture of a mesh.
    ///
    /// # Errors
    /// Kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not finite.
    pub(crate) fn of_mesh(mesh: &'a IndexedMesh, options: &'a PictureOptions, space: Space) -> io::Result<Self> {
        Points::of_mesh(mesh).check(0)?;
        check_triangles(mesh)?;
        Segments::of_mesh(mesh).check(mesh.points.len())?;
        let overlay = &options.overlay;
        let frame = Frame::around(&mesh.points.iter().copied().chain(overlay.points()).collect::<Vec<_>>(), space);
        let edge_width = width_for(mesh.triangles.len());
        let has_dots = options.show_vertices || mesh.triangles.is_empty();
        Ok(Self {
            histogram: Histogram::of(mesh, &frame),
            frame,
            points: &mesh.points,
            triangles: &mesh.triangles,
            edge_width,
            segments: &mesh.segments,
            segment_width: (2.5 * edge_width).max(0.3),
            dot_size: has_dots.then(|| (5.0 * edge_width).max(0.6)),
            dots: None,
            holes: &[],
            regions: Vec::new(),
            overlay,
        })
    }

    /// The picture of a drawing.
    ///
    /// # Errors
    /// Kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not finite.
    pub(crate) fn of_pslg(pslg: &'a Pslg, options: &'a PictureOptions, space: Space) -> io::Result<Self> {
        Points::of_pslg(pslg).check(0)?;
        Segments::of_pslg(pslg).check(pslg.points.len())?;
        let regions: Vec<Point> = pslg.regions.iter().map(|region| region.seed).collect();
        let overlay = &options.overlay;
        let shown = [&pslg.points[..], &pslg.holes, &regions, &overlay.points().collect::<Vec<_>>()].concat();
        let frame = Frame::around(&shown, space);
        let edge_width = width_for(pslg.points.len());
        Ok(Self {
            histogram: Histogram::of(&IndexedMesh::default(), &frame),
            frame,
            points: &pslg.points,
            triangles: &[],
            edge_width,
            segments: &pslg.segments,
            segment_width: 1.5 * edge_width,
            dot_size: Some(5.0 * edge_width),
            dots: options.only_lone_vertices.then(|| lone_vertices(pslg)),
            holes: &pslg.holes,
            regions,
            overlay,
        })
    }

    /// The classes that have triangles, in the order in which they are painted; none where areas are painted instead.
    pub(crate) fn classes(&self) -> impl Iterator<Item = usize> {
        let is_shown = self.overlay.has_no_areas();
        (0..CLASSES).rev().filter(move |&class| is_shown && self.histogram.counts[class] > 0)
    }

    /// The areas of the overlay, by their tones.
    pub(crate) fn areas(&self) -> impl Iterator<Item = (Tone, impl Iterator<Item = [Place; 3]>)> {
        let placed = |corners: [Point; 3]| corners.map(|p| self.frame.place(p));
        let of_tone = move |tone| (tone, self.overlay.areas(tone).map(placed));
        Tone::ALL.into_iter().filter(|&tone| self.overlay.areas(tone).next().is_some()).map(of_tone)
    }

    /// Whether areas are painted in place of triangles.
    pub(crate) fn has_areas(&self) -> bool {
        !self.overlay.has_no_areas()
    }

    /// The lines of the overlay.
    pub(crate) fn lines(&self) -> impl ExactSizeIterator<Item = [Place; 2]> {
        self.overlay.lines().iter().map(|ends| ends.map(|p| self.frame.place(p)))
    }

    /// The marks of the overlay.
    pub(crate) fn marks(&self) -> impl ExactSizeIterator<Item = (Colour, Place)> {
        self.overlay.marks().iter().map(|&(tone, p)| (tone.strong(), self.frame.place(p)))
    }

    /// The triangles of a class.
    pub(crate) fn triangles(&self, class: usize) -> impl Iterator<Item = [Place; 3]> {
        let of_class = self.triangles.iter().zip(&self.histogram.class_of);
        of_class.filter(move |(_, c)| usize::from(**c) == class).map(|(corners, _)| corners.map(|v| self.vertex(v)))
    }

    /// The edges of all triangles, each once.
    pub(crate) fn edges(&self) -> impl Iterator<Item = [Place; 2]> {
        let sides = self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let mut edges: Vec<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.dedup();
        edges.into_iter().map(|edge| edge.map(|v| self.vertex(v)))
    }

    pub(crate) fn segments(&self) -> impl ExactSizeIterator<Item = [Place; 2]> {
        self.segments.iter().map(|ends| ends.map(|v| self.vertex(v)))
    }

    /// The vertices that are dots.
    pub(crate) fn vertices(&self) -> impl ExactSizeIterator<Item = Place> {
        self.places(self.dots.as_deref().unwrap_or(self.points))
    }

    /// The seeds of holes, at which there are crosses.
    pub(crate) fn holes(&self) -> impl ExactSizeIterator<Item = Place> {
        self.places(self.holes)
    }

    /// The seeds of regions, at which there are rings.
    pub(crate) fn regions(&self) -> impl ExactSizeIterator<Item = Place> {
        self.places(&self.regions)
    }

    fn places(&self, points: &[Point]) -> impl ExactSizeIterator<Item = Place> {
        points.iter().map(|&point| self.frame.place(point))
    }

    fn vertex(&self, index: u32) -> Place {
        self.frame.place(self.points[index as usize])
    }
}

/// The vertices on no segment.
fn lone_vertices(pslg: &Pslg) -> Vec<Point> {
    let mut is_lone = vec![true; pslg.points.len()];
    for &v in pslg.segments.as_flattened() {
        is_lone[v as usize] = false;
    }
    pslg.points.iter().zip(is_lone).filter(|(_, is_lone)| *is_lone).map(|(&p, _)| p).collect()
}

/// The width of edges: 1 up to a thousand elements, then falling with the length of edges to 0.1 at a hundred thousand.
fn width_for(elements: usize) -> f64 {
    (1000.0 / elements.max(1) as f64).sqrt().clamp(0.02, 1.0)
}
