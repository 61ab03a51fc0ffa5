//! Pixels, and how shapes get onto them: a batch of shapes at a time, so that memory does not grow with their number.

use std::io;

use tiny_skia::{Color, FillRule, LineCap, Paint, Path, PathBuilder, Pixmap, Rect, Shader, Stroke, Transform};

use crate::picture::Colour;

/// Shapes painted at once. A path takes some 300 bytes a triangle while it is painted, and the time of painting 4096
/// triangles is far above that of passing over the rows of the picture once more.
const BATCH: usize = 4096;

/// Dots below this size are squares: nobody sees the difference, and they have fewer sides.
const SMALLEST_CIRCLE: f32 = 2.0;

/// A place in pixels: to the right and down.
pub(super) type Spot = [f32; 2];

/// How the sides of triangles are painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sides {
    /// A pixel gets the colour if the triangle has its middle.
    Hard,
    /// A pixel gets as much of the colour as the triangle has of it.
    Smooth,
}

/// How lines are painted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    pub(super) colour: Colour,
    /// How much of what is below a line it hides, from 0 to 1.
    pub(super) opacity: f32,
    /// In pixels. Lines of less than one pixel are painted one wide, and hide less.
    pub(super) width: f32,
}

/// A sheet of pixels.
#[derive(Debug)]
pub(super) struct Canvas {
    pixels: Pixmap,
}

impl Canvas {
    /// A sheet of one colour.
    ///
    /// # Errors
    /// Kind `InvalidInput` where a side is 0 or the sheet is larger than memory can be.
    pub(super) fn new(width: u32, height: u32, colour: Colour) -> io::Result<Self> {
        let no_sheet =
            || io::Error::new(io::ErrorKind::InvalidInput, format!("no picture of {width} x {height} pixels"));
        let mut pixels = Pixmap::new(width, height).ok_or_else(no_sheet)?;
        pixels.fill(color(colour, 1.0));
        Ok(Self { pixels })
    }

    /// Fills triangles.
    pub(super) fn fill_triangles(&mut self, colour: Colour, sides: Sides, triangles: impl Iterator<Item = [Spot; 3]>) {
        let paint = Paint { anti_alias: sides == Sides::Smooth, ..paint(colour, 1.0) };
        let add = |path: &mut PathBuilder, [a, b, c]: [Spot; 3]| {
            path.move_to(a[0], a[1]);
            path.line_to(b[0], b[1]);
            path.line_to(c[0], c[1]);
            path.close();
        };
        in_batches(triangles, add, |path| self.fill(path, &paint));
    }

    /// Draws lines with round ends.
    pub(super) fn draw_lines(&mut self, pen: &Pen, lines: impl Iterator<Item = [Spot; 2]>) {
        let add = |path: &mut PathBuilder, [a, b]: [Spot; 2]| {
            path.move_to(a[0], a[1]);
            path.line_to(b[0], b[1]);
        };
        in_batches(lines, add, |path| self.stroke(path, pen));
    }

    /// Draws circles of this radius.
    pub(super) fn draw_rings(&mut self, pen: &Pen, radius: f32, middles: impl Iterator<Item = Spot>) {
        in_batches(middles, |path, [x, y]| path.push_circle(x, y, radius), |path| self.stroke(path, pen));
    }

    /// Fills dots of this size.
    pub(super) fn fill_dots(&mut self, colour: Colour, size: f32, middles: impl Iterator<Item = Spot>) {
        let paint = paint(colour, 1.0);
        let radius = size / 2.0;
        let add = |path: &mut PathBuilder, [x, y]: Spot| {
            if size >= SMALLEST_CIRCLE {
                path.push_circle(x, y, radius);
            } else if let Some(square) = Rect::from_xywh(x - radius, y - radius, size, size) {
                path.push_rect(square);
            }
        };
        in_batches(middles, add, |path| self.fill(path, &paint));
    }

    /// The file.
    ///
    /// # Errors
    /// Those of the encoder.
    pub(super) fn into_png(self) -> io::Result<Vec<u8>> {
        self.pixels.encode_png().map_err(io::Error::other)
    }

    fn fill(&mut self, path: &Path, paint: &Paint<'_>) {
        self.pixels.fill_path(path, paint, FillRule::Winding, Transform::identity(), None);
    }

    fn stroke(&mut self, path: &Path, pen: &Pen) {
        let stroke = Stroke { width: pen.width, line_cap: LineCap::Round, ..Stroke::default() };
        self.pixels.stroke_path(path, &paint(pen.colour, pen.opacity), &stroke, Transform::identity(), None);
    }
}

/// Paints shapes, a batch of them as one path.
fn in_batches<T>(shapes: impl Iterator<Item = T>, add: impl Fn(&mut PathBuilder, T), mut paint: impl FnMut(&Path)) {
    let mut shapes = shapes.peekable();
    let mut builder = PathBuilder::new();
    while shapes.peek().is_some() {
        shapes.by_ref().take(BATCH).for_each(|shape| add(&mut builder, shape));
        // A path of nothing is none.
        builder = builder.finish().map_or_else(PathBuilder::new, |path| {
            paint(&path);
            path.clear()
        });
    }
}

fn paint(colour: Colour, opacity: f32) -> Paint<'static> {
    Paint { shader: Shader::SolidColor(color(colour, opacity)), ..Paint::default() }
}

fn color(colour: Colour, opacity: f32) -> Color {
    let [red, green, blue] = colour.bytes();
    Color::from_rgba8(red, green, blue, (255.0 * opacity).round() as u8)
}
