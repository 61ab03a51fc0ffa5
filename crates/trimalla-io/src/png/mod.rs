//! `.png`: pictures of meshes and drawings in pixels.
//!
//! They show what [`svg`](crate::svg) draws, in the same places and colours, but no letters: no heading, no legend, no
//! charts. Triangles are painted twice, with hard sides and then with smooth ones over them, so that no paper shines
//! through where the smooth sides of two triangles meet. Then every edge is painted once. Where edges would cover the
//! sheet ten times, as those of many needles around one vertex do, none is painted, and no smooth side: they would hide
//! the triangles, and take minutes.
//!
//! The longer side has 1600 pixels. That is as wide as a column of text at 300 dots an inch, fits on common screens,
//! and takes 10 MB of memory. Points that all have one place give a sheet that is all margin, 73 pixels wide.
//!
//! Places are computed in double precision and lie on the sheet whatever the coordinates are. Pixels are computed
//! without the special instructions of a processor, some of which only approximate, so that they do not depend on it.

mod canvas;

use std::io::{self, Write};

use trimalla::drawing::{IndexedMesh, Pslg};

use crate::picture::{
    COLOURS, Colour, EDGE_OPACITY, HOLE, INK, MARGIN, MARK_REACH, MARK_SIZE, MARK_WIDTH, PAPER, Picture,
    PictureOptions, Place, REGION, SIDE, Space,
};
use canvas::{Canvas, Pen, Sides, Spot};

/// Pixels on the longer side of the sheet.
const LONGER_SIDE: f64 = 1600.0;
/// Pixels a unit of the sheet.
const SCALE: f64 = LONGER_SIDE / (SIDE + 2.0 * MARGIN);

/// How many times edges may cover the sheet, each one pixel wide. Those of a million good triangles do about once.
const MOST_LAYERS_OF_EDGES: f64 = 10.0;

/// Draws a mesh. Of the options only `show_vertices` and `overlay` count.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn draw_mesh(out: &mut dyn Write, mesh: &IndexedMesh, options: &PictureOptions) -> io::Result<()> {
    draw(out, &Picture::of_mesh(mesh, options, Space::default())?)
}

/// Draws a drawing: segments, vertices, crosses at hole seeds, rings at region seeds. Of the options only
/// `only_lone_vertices` and `overlay` count.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn draw_pslg(out: &mut dyn Write, pslg: &Pslg, options: &PictureOptions) -> io::Result<()> {
    draw(out, &Picture::of_pslg(pslg, options, Space::default())?)
}

fn draw(out: &mut dyn Write, picture: &Picture<'_>) -> io::Result<()> {
    let (width, height) = picture.frame.size();
    let pixels = |units: f64| (SCALE * units).round() as u32;
    let mut canvas = Canvas::new(pixels(width), pixels(height), PAPER)?;
    let edges: Vec<[Spot; 2]> = picture.edges().map(|ends| ends.map(spot)).collect();
    let is_crowded = length(&edges) > MOST_LAYERS_OF_EDGES * SCALE * SCALE * width * height;
    let sides = if is_crowded { &[Sides::Hard][..] } else { &[Sides::Hard, Sides::Smooth] };
    for &sides in sides {
        for class in picture.classes() {
            let triangles = picture.triangles(class).map(|corners| corners.map(spot));
            canvas.fill_triangles(COLOURS[class], sides, triangles);
        }
        for (tone, areas) in picture.areas() {
            canvas.fill_triangles(tone.pale(), sides, areas.map(|corners| corners.map(spot)));
        }
    }
    if !is_crowded {
        let pen = if picture.has_areas() { pen(INK, picture.edge_width) } else { edge_pen(picture) };
        canvas.draw_lines(&pen, edges.into_iter());
    }
    canvas.draw_lines(&pen(INK, picture.segment_width), picture.segments().map(|ends| ends.map(spot)));
    if let Some(size) = picture.dot_size {
        canvas.fill_dots(INK, (SCALE * size) as f32, picture.vertices().map(spot));
    }
    canvas.draw_lines(&pen(INK, MARK_WIDTH), picture.lines().map(|ends| ends.map(spot)));
    for (colour, place) in picture.marks() {
        for (colour, size) in [(INK, MARK_SIZE + MARK_WIDTH), (colour, MARK_SIZE)] {
            canvas.fill_dots(colour, (SCALE * size) as f32, std::iter::once(spot(place)));
        }
    }
    canvas.draw_lines(&pen(HOLE, MARK_WIDTH), picture.holes().flat_map(cross));
    canvas.draw_rings(&pen(REGION, MARK_WIDTH), (SCALE * MARK_REACH) as f32, picture.regions().map(spot));
    out.write_all(&canvas.into_png()?)
}

/// How many pixels lines of a pixel's width cover.
fn length(lines: &[[Spot; 2]]) -> f64 {
    lines.iter().map(|&[a, b]| f64::from((b[0] - a[0]).abs().max((b[1] - a[1]).abs()))).sum()
}

/// Where a place is in pixels.
fn spot(place: Place) -> Spot {
    [place.x, place.y].map(|hundredths| (SCALE * hundredths as f64 / 100.0) as f32)
}

/// The two lines of a cross.
fn cross(place: Place) -> [[Spot; 2]; 2] {
    let ([x, y], reach) = (spot(place), (SCALE * MARK_REACH) as f32);
    [[[x - reach, y - reach], [x + reach, y + reach]], [[x - reach, y + reach], [x + reach, y - reach]]]
}

fn edge_pen(picture: &Picture<'_>) -> Pen {
    Pen { opacity: EDGE_OPACITY as f32 / 100.0, ..pen(PAPER, picture.edge_width) }
}

/// A pen that hides what is below it, its width in units of the sheet.
fn pen(colour: Colour, width: f64) -> Pen {
    Pen { colour, opacity: 1.0, width: (SCALE * width) as f32 }
}
