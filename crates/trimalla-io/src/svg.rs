//! `.svg`: pictures of meshes and drawings.
//!
//! Triangles are coloured by their smallest angle, from red (0°) through yellow (30°) to blue (60°), in twelve classes
//! of five degrees; the legend is at the same time the histogram of the classes. All triangles of a class are one path,
//! all subsegments are one path, and coordinates are rounded to hundredths of a unit on a sheet of about 1000 units, so
//! that the file is as small as a picture of so many triangles can be, and the same on every platform.
//! Classes are painted from good to bad, so that thin triangles are never hidden.

mod angle;
mod frame;
mod legend;
mod strip;

use std::io::{self, Write};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use crate::bars::BarChart;
use crate::columns::{Points, Segments, check_triangles};
use angle::{CLASSES, Histogram};
use frame::{Frame, Hundredths};
use legend::Line;
use strip::Strip;

/// What a picture shows.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SvgOptions {
    /// The heading; empty for none.
    pub title: String,
    /// Whether vertices are dots.
    pub show_vertices: bool,
    /// Whether scale, histogram and counts stand beside the picture.
    pub show_legend: bool,
    /// Bar charts that stand below the picture of a mesh.
    pub charts: Vec<BarChart>,
}

impl Default for SvgOptions {
    fn default() -> Self {
        Self { title: String::new(), show_vertices: false, show_legend: true, charts: Vec::new() }
    }
}

impl SvgOptions {
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
}

/// The classes' colours, from the smallest angles to the largest: steps of equal size in a perceptual colour space.
const COLOURS: [&str; CLASSES] = [
    "#9e1b32", "#c24537", "#e26b3d", "#ef984f", "#f5bf6b", "#f4db93", "#dfe5aa", "#b5dbb2", "#8ac9b4", "#5eb3b3",
    "#4292a7", "#2b6f97",
];
const INK: &str = "#1d2733";

/// Draws a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn draw_mesh(out: &mut dyn Write, mesh: &IndexedMesh, options: &SvgOptions) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    let frame = Frame::around(&mesh.points, options);
    let histogram = Histogram::of(mesh, &frame);
    let stroke = stroke_for(mesh.triangles.len());
    let strip = Strip::of(&options.charts, frame.size().0);

    frame.open(out, &options.title, &strip)?;
    draw_triangles(out, mesh, &frame, &histogram, stroke)?;
    draw_segments(out, &mesh.points, &mesh.segments, &frame, (2.5 * stroke).max(0.3))?;
    if options.show_vertices || mesh.triangles.is_empty() {
        draw_dots(out, &mesh.points, &frame, (5.0 * stroke).max(0.6))?;
    }
    if options.show_legend {
        legend::draw_scale(out, &frame, &histogram)?;
        legend::draw_lines(out, &frame, legend::SCALE_ROWS, &mesh_lines(mesh, &histogram))?;
    }
    strip.draw(out, frame.size().1)?;
    writeln!(out, "</svg>")
}

/// Draws a drawing: segments, vertices, crosses at hole seeds, rings at region seeds.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn draw_pslg(out: &mut dyn Write, pslg: &Pslg, options: &SvgOptions) -> io::Result<()> {
    Points::of_pslg(pslg).check(0)?;
    Segments::of_pslg(pslg).check(pslg.points.len())?;
    let seeds: Vec<Point> = pslg.regions.iter().map(|region| region.seed).collect();
    let all: Vec<Point> = [&pslg.points[..], &pslg.holes, &seeds].concat();
    let frame = Frame::around(&all, options);
    let stroke = stroke_for(pslg.points.len());

    frame.open(out, &options.title, &Strip::of(&[], 0.0))?;
    draw_segments(out, &pslg.points, &pslg.segments, &frame, 1.5 * stroke)?;
    draw_dots(out, &pslg.points, &frame, 5.0 * stroke)?;
    draw_marks(out, &pslg.holes, &frame, "m-5-5l10 10m-10 0l10-10", COLOURS[1])?;
    draw_marks(out, &seeds, &frame, "m-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0", COLOURS[11])?;
    if options.show_legend {
        let counts = [
            ("vertices", pslg.points.len()),
            ("segments", pslg.segments.len()),
            ("holes", pslg.holes.len()),
            ("regions", seeds.len()),
        ];
        legend::draw_lines(out, &frame, 0.0, &counts.map(|(noun, count)| Line::count(noun, count)))?;
    }
    writeln!(out, "</svg>")
}

/// The width of edges: 1 up to a thousand elements, then falling with the length of edges to 0.1 at a hundred thousand.
fn stroke_for(elements: usize) -> f64 {
    (1000.0 / elements.max(1) as f64).sqrt().clamp(0.02, 1.0)
}

fn mesh_lines(mesh: &IndexedMesh, histogram: &Histogram) -> Vec<Line> {
    let mut lines = vec![
        Line::count("vertices", mesh.points.len()),
        Line::count("triangles", mesh.triangles.len()),
        Line::count("subsegments", mesh.segments.len()),
    ];
    if let Some(angle_deg) = histogram.smallest_deg {
        lines.push(Line::new("smallest angle", format!("{angle_deg:.2}°")));
    }
    lines
}

/// One path a class, the worst class last.
fn draw_triangles(
    out: &mut dyn Write,
    mesh: &IndexedMesh,
    frame: &Frame,
    histogram: &Histogram,
    stroke: f64,
) -> io::Result<()> {
    writeln!(out, "<g stroke=\"#fff\" stroke-width=\"{stroke:.2}\" stroke-linejoin=\"round\" stroke-opacity=\".75\">")?;
    for class in (0..CLASSES).rev().filter(|&class| histogram.counts[class] > 0) {
        write!(out, "<path fill=\"{}\" d=\"", COLOURS[class])?;
        for (triangle, _) in mesh.triangles.iter().zip(&histogram.class_of).filter(|(_, c)| usize::from(**c) == class) {
            let [a, b, c] = triangle.map(|v| frame.place(mesh.points[v as usize]));
            write!(out, "M{}{}z", a.absolute(), Polyline { from: a, to: &[b, c] })?;
        }
        writeln!(out, "\"/>")?;
    }
    writeln!(out, "</g>")
}

fn draw_segments(
    out: &mut dyn Write,
    points: &[Point],
    segments: &[[u32; 2]],
    frame: &Frame,
    width: f64,
) -> io::Result<()> {
    if segments.is_empty() {
        return Ok(());
    }
    write!(out, "<path fill=\"none\" stroke=\"{INK}\" stroke-width=\"{width:.2}\" stroke-linecap=\"round\" d=\"")?;
    for segment in segments {
        let [a, b] = segment.map(|v| frame.place(points[v as usize]));
        write!(out, "M{}{}", a.absolute(), Polyline { from: a, to: &[b] })?;
    }
    writeln!(out, "\"/>")
}

/// Dots are strokes of no length with round ends: a few bytes each.
fn draw_dots(out: &mut dyn Write, points: &[Point], frame: &Frame, size: f64) -> io::Result<()> {
    if points.is_empty() {
        return Ok(());
    }
    write!(out, "<path fill=\"none\" stroke=\"{INK}\" stroke-width=\"{size:.2}\" stroke-linecap=\"round\" d=\"")?;
    for &point in points {
        write!(out, "M{}h0", frame.place(point).absolute())?;
    }
    writeln!(out, "\"/>")
}

fn draw_marks(out: &mut dyn Write, seeds: &[Point], frame: &Frame, mark: &str, colour: &str) -> io::Result<()> {
    if seeds.is_empty() {
        return Ok(());
    }
    write!(out, "<path fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\" stroke-linecap=\"round\" d=\"")?;
    for &seed in seeds {
        write!(out, "M{}{mark}", frame.place(seed).absolute())?;
    }
    writeln!(out, "\"/>")
}

/// Relative line commands. The steps are differences of rounded places, so they add up without drifting.
struct Polyline<'a> {
    from: frame::Place,
    to: &'a [frame::Place],
}

impl std::fmt::Display for Polyline<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut at = self.from;
        for (i, &next) in self.to.iter().enumerate() {
            let (dx, dy) = (next.x - at.x, next.y - at.y);
            let (before, between) = (
                if i == 0 {
                    "l"
                } else if dx < 0 {
                    ""
                } else {
                    " "
                },
                if dy < 0 { "" } else { " " },
            );
            write!(f, "{before}{}{between}{}", Hundredths(dx), Hundredths(dy))?;
            at = next;
        }
        Ok(())
    }
}
