//! `.svg`: pictures of meshes and drawings.
//!
//! Triangles are coloured by their smallest angle, from red (0°) through yellow (30°) to blue (60°), in twelve classes
//! of five degrees; the legend is at the same time the histogram of the classes. All triangles of a class are one path,
//! all subsegments are one path, and coordinates are rounded to hundredths of a unit on a sheet of about 1000 units, so
//! that the file is as small as a picture of so many triangles can be, and the same on every platform.
//! Classes are painted from good to bad, so that thin triangles are never hidden.

mod faults;
mod legend;
mod strip;
mod text;

use std::io::{self, Write};

use trimalla::drawing::{IndexedMesh, Pslg};

use crate::picture::{
    COLOURS, Colour, EDGE_OPACITY, HOLE, Histogram, INK, MARK_REACH, MARK_SIZE, MARK_WIDTH, PAPER, Picture,
    PictureOptions, Place, REGION, Space,
};
pub use faults::draw_faults;
use legend::Line;
use strip::Strip;
use text::{Hundredths, Polyline, absolute};

const HEADING: f64 = 40.0;

/// Draws a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn draw_mesh(out: &mut dyn Write, mesh: &IndexedMesh, options: &PictureOptions) -> io::Result<()> {
    let picture = Picture::of_mesh(mesh, options, space_for(options))?;
    let strip = Strip::of(&options.charts, picture.frame.size().0);

    text::open(out, &picture.frame, &options.title, &strip)?;
    draw_triangles(out, &picture)?;
    draw_areas(out, &picture)?;
    draw_segments(out, &picture)?;
    draw_dots(out, &picture)?;
    draw_overlay(out, &picture)?;
    if options.show_legend {
        let has_scale = options.overlay.has_no_areas();
        if has_scale {
            legend::draw_scale(out, &picture.frame, &picture.histogram)?;
        }
        let rows_above = if has_scale { legend::SCALE_ROWS } else { 0.0 };
        let lines = mesh_lines(mesh, &picture.histogram).into_iter().chain(overlay_lines(options));
        legend::draw_lines(out, &picture.frame, rows_above, &lines.collect::<Vec<_>>())?;
    }
    strip.draw(out, picture.frame.size().1)?;
    writeln!(out, "</svg>")
}

/// Draws a drawing: segments, vertices (all, or those on no segment), crosses at hole seeds, rings at region seeds.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn draw_pslg(out: &mut dyn Write, pslg: &Pslg, options: &PictureOptions) -> io::Result<()> {
    let picture = Picture::of_pslg(pslg, options, space_for(options))?;

    text::open(out, &picture.frame, &options.title, &Strip::of(&[], 0.0))?;
    draw_areas(out, &picture)?;
    draw_segments(out, &picture)?;
    draw_dots(out, &picture)?;
    draw_overlay(out, &picture)?;
    let (r, d) = (MARK_REACH, 2.0 * MARK_REACH);
    draw_marks(out, picture.holes(), &format!("m-{r}-{r}l{d} {d}m-{d} 0l{d}-{d}"), HOLE)?;
    draw_marks(out, picture.regions(), &format!("m-{r} 0a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0-{d} 0"), REGION)?;
    if options.show_legend {
        let counts = [
            ("vertices", pslg.points.len()),
            ("segments", pslg.segments.len()),
            ("holes", pslg.holes.len()),
            ("regions", pslg.regions.len()),
        ];
        let lines = counts.map(|(noun, count)| Line::count(noun, count)).into_iter().chain(overlay_lines(options));
        legend::draw_lines(out, &picture.frame, 0.0, &lines.collect::<Vec<_>>())?;
    }
    writeln!(out, "</svg>")
}

/// Space for heading and legend, if there are any.
fn space_for(options: &PictureOptions) -> Space {
    Space {
        heading: if options.title.is_empty() { 0.0 } else { HEADING },
        panel: if options.show_legend { [legend::WIDTH, legend::HEIGHT] } else { [0.0; 2] },
    }
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
fn draw_triangles(out: &mut dyn Write, picture: &Picture<'_>) -> io::Result<()> {
    let (width, opacity) = (picture.edge_width, Hundredths(EDGE_OPACITY));
    if picture.has_areas() {
        return Ok(());
    }
    writeln!(
        out,
        "<g stroke=\"{PAPER}\" stroke-width=\"{width:.2}\" stroke-linejoin=\"round\" stroke-opacity=\"{opacity}\">"
    )?;
    for class in picture.classes() {
        write!(out, "<path fill=\"{}\" d=\"", COLOURS[class])?;
        for [a, b, c] in picture.triangles(class) {
            write!(out, "M{}{}z", absolute(a), Polyline { from: a, to: &[b, c] })?;
        }
        writeln!(out, "\"/>")?;
    }
    writeln!(out, "</g>")
}

/// One path a tone, and the edges of the triangles below on top.
fn draw_areas(out: &mut dyn Write, picture: &Picture<'_>) -> io::Result<()> {
    for (tone, areas) in picture.areas() {
        write!(out, "<path fill=\"{}\" d=\"", tone.pale())?;
        for [a, b, c] in areas {
            write!(out, "M{}{}z", absolute(a), Polyline { from: a, to: &[b, c] })?;
        }
        writeln!(out, "\"/>")?;
    }
    let edges = picture.has_areas().then(|| picture.edges());
    draw_lines(out, picture.edge_width, edges.into_iter().flatten())
}

/// Lines, and marks with a ring around each.
fn draw_overlay(out: &mut dyn Write, picture: &Picture<'_>) -> io::Result<()> {
    draw_lines(out, MARK_WIDTH, picture.lines())?;
    for (colour, place) in picture.marks() {
        for (colour, size) in [(INK, MARK_SIZE + MARK_WIDTH), (colour, MARK_SIZE)] {
            open_strokes(out, colour, size)?;
            writeln!(out, "M{}h0\"/>", absolute(place))?;
        }
    }
    Ok(())
}

fn draw_lines(out: &mut dyn Write, width: f64, lines: impl Iterator<Item = [Place; 2]>) -> io::Result<()> {
    let mut lines = lines.peekable();
    if lines.peek().is_none() {
        return Ok(());
    }
    open_strokes(out, INK, width)?;
    for [a, b] in lines {
        write!(out, "M{}{}", absolute(a), Polyline { from: a, to: &[b] })?;
    }
    writeln!(out, "\"/>")
}

fn overlay_lines(options: &PictureOptions) -> impl Iterator<Item = Line> {
    options.overlay.counts().iter().map(|&(noun, count)| Line::count(noun, count))
}

fn draw_segments(out: &mut dyn Write, picture: &Picture<'_>) -> io::Result<()> {
    draw_lines(out, picture.segment_width, picture.segments())
}

/// Dots are strokes of no length with round ends: a few bytes each.
fn draw_dots(out: &mut dyn Write, picture: &Picture<'_>) -> io::Result<()> {
    let vertices = picture.vertices();
    let Some(size) = picture.dot_size.filter(|_| vertices.len() > 0) else { return Ok(()) };
    open_strokes(out, INK, size)?;
    for place in vertices {
        write!(out, "M{}h0", absolute(place))?;
    }
    writeln!(out, "\"/>")
}

fn draw_marks(
    out: &mut dyn Write,
    seeds: impl ExactSizeIterator<Item = Place>,
    mark: &str,
    colour: Colour,
) -> io::Result<()> {
    if seeds.len() == 0 {
        return Ok(());
    }
    write!(out, "<path fill=\"none\" stroke=\"{colour}\" stroke-width=\"{MARK_WIDTH}\" stroke-linecap=\"round\" d=\"")?;
    for seed in seeds {
        write!(out, "M{}{mark}", absolute(seed))?;
    }
    writeln!(out, "\"/>")
}

/// Opens a path of lines with round ends.
fn open_strokes(out: &mut dyn Write, colour: Colour, width: f64) -> io::Result<()> {
    write!(out, "<path fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width:.2}\" stroke-linecap=\"round\" d=\"")
}
