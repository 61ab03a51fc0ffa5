//! The sheet: how coordinates of the plane become places on it, and its heading.

use std::fmt;
use std::io::{self, Write};

use trimalla::geometry::Point;

use super::strip::Strip;
use super::{INK, SvgOptions, legend};

/// The longer side of the drawing, in units of the sheet.
const SIDE: f64 = 1000.0;
/// Free space on every side.
pub(super) const MARGIN: f64 = 24.0;
const HEADING: f64 = 40.0;

/// Maps the plane to the sheet: y up becomes y down, the bounding box fills the drawing.
#[derive(Debug)]
pub(super) struct Frame {
    /// A power of two that brings coordinates to where differences neither overflow nor vanish.
    factor: f64,
    low: Point,
    span: f64,
    /// Where the upper left corner of the bounding box goes.
    left: f64,
    bottom: f64,
    width: f64,
    height: f64,
    heading: f64,
}

/// A place on the sheet, in hundredths of a unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) x: i64,
    pub(super) y: i64,
}

impl Frame {
    /// The frame in which `points`, which are finite, fill the drawing.
    pub(super) fn around(points: &[Point], options: &SvgOptions) -> Self {
        let factor = factor_for(points);
        let scaled = |p: &Point| (p.x * factor, p.y * factor);
        let first = points.first().map_or((0.0, 0.0), scaled);
        let (mut low, mut high) = (Point::new(first.0, first.1), Point::new(first.0, first.1));
        for (x, y) in points.iter().map(scaled) {
            low = Point::new(low.x.min(x), low.y.min(y));
            high = Point::new(high.x.max(x), high.y.max(y));
        }
        let (dx, dy) = (high.x - low.x, high.y - low.y);
        let span = dx.max(dy);
        let unit = |d: f64| if span > 0.0 { SIDE * (d / span) } else { 0.0 };

        let heading = if options.title.is_empty() { 0.0 } else { HEADING };
        let panel = if options.show_legend { legend::WIDTH } else { 0.0 };
        let drawing = unit(dy).max(if options.show_legend { legend::HEIGHT } else { 0.0 });
        Self {
            factor,
            low,
            span,
            left: MARGIN,
            bottom: MARGIN + heading + (drawing + unit(dy)) / 2.0,
            width: 2.0 * MARGIN + unit(dx) + panel,
            height: 2.0 * MARGIN + heading + drawing,
            heading,
        }
    }

    /// A point's coordinates, scaled so that differences and their products behave.
    pub(super) fn scaled(&self, point: Point) -> Point {
        Point::new(point.x * self.factor, point.y * self.factor)
    }

    /// Where a point goes.
    pub(super) fn place(&self, point: Point) -> Place {
        let p = self.scaled(point);
        let unit = |d: f64| {
            if self.span > 0.0 { SIDE * (d / self.span) } else { 0.0 }
        };
        let hundredths = |v: f64| (100.0 * v).round() as i64;
        Place { x: hundredths(self.left + unit(p.x - self.low.x)), y: hundredths(self.bottom - unit(p.y - self.low.y)) }
    }

    /// The left side of the legend and its top.
    pub(super) fn legend_corner(&self) -> (f64, f64) {
        (self.width - legend::WIDTH, MARGIN + self.heading)
    }

    /// Width and height of the sheet, without what may stand below the picture.
    pub(super) fn size(&self) -> (f64, f64) {
        (self.width, self.height)
    }

    /// Opens the picture, with room for a strip below it, and writes background and heading.
    pub(super) fn open(&self, out: &mut dyn Write, title: &str, strip: &Strip<'_>) -> io::Result<()> {
        let (width, height) = (self.width.max(strip.width).round(), (self.height + strip.height).round());
        writeln!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"system-ui,Helvetica,Arial,'DejaVu Sans',sans-serif\">"
        )?;
        if !title.is_empty() {
            writeln!(out, "<title>{}</title>", Escaped(title))?;
        }
        writeln!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>")?;
        if !title.is_empty() {
            let y = MARGIN + 16.0;
            writeln!(
                out,
                "<text x=\"{MARGIN}\" y=\"{y}\" font-size=\"22\" font-weight=\"600\" fill=\"{INK}\">{}</text>",
                Escaped(title)
            )?;
        }
        Ok(())
    }
}

/// 1, unless the largest coordinate is near an end of the range of doubles.
fn factor_for(points: &[Point]) -> f64 {
    const HUGE: f64 = 1e300;
    const TINY: f64 = 1e-280;
    /// 2^-64.
    const DOWN: f64 = 1.0 / 18_446_744_073_709_551_616.0;
    /// 2^512.
    const UP: f64 = 1.340_780_792_994_259_7e154;
    let size = points.iter().fold(0.0_f64, |size, p| size.max(p.x.abs()).max(p.y.abs()));
    if size > HUGE {
        DOWN
    } else if size < TINY {
        UP
    } else {
        1.0
    }
}

impl Place {
    /// The place as the argument of a path's `M`.
    pub(super) fn absolute(self) -> impl fmt::Display {
        struct Pair(Place);
        impl fmt::Display for Pair {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{} {}", Hundredths(self.0.x), Hundredths(self.0.y))
            }
        }
        Pair(self)
    }
}

/// Shows a number of hundredths as a decimal without needless zeros.
pub(super) struct Hundredths(pub(super) i64);

impl fmt::Display for Hundredths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (sign, size) = (if self.0 < 0 { "-" } else { "" }, self.0.unsigned_abs());
        match (size / 100, size % 100) {
            (whole, 0) => write!(f, "{sign}{whole}"),
            (whole, part) => {
                write!(f, "{sign}")?;
                if whole > 0 {
                    write!(f, "{whole}")?;
                }
                if part % 10 == 0 { write!(f, ".{}", part / 10) } else { write!(f, ".{part:02}") }
            }
        }
    }
}

/// Text inside an element; characters that XML does not allow become blanks.
pub(super) struct Escaped<'a>(pub(super) &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '\u{fffe}' | '\u{ffff}' => f.write_str(" ")?,
                c if c.is_control() => f.write_str(" ")?,
                c => write!(f, "{c}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hundredths_are_short() {
        let shown = [0, 5, -50, 100, -1234, 120].map(|n| Hundredths(n).to_string());
        assert_eq!(shown, ["0", ".05", "-.5", "1", "-12.34", "1.2"]);
    }

    #[test]
    fn titles_cannot_break_the_picture() {
        assert_eq!(Escaped("a<b>&\0c").to_string(), "a&lt;b&gt;&amp; c");
    }

    #[test]
    fn the_ends_of_the_range_fill_the_sheet() {
        for size in [f64::MAX, 1e300, 1.0, 1e-300, 5e-324] {
            let frame = Frame::around(
                &[Point::new(-size, -size), Point::new(size, size)],
                &SvgOptions::default().with_legend(false),
            );
            let (low, high) = (frame.place(Point::new(-size, -size)), frame.place(Point::new(size, size)));
            assert_eq!((high.x - low.x, low.y - high.y), (100_000, 100_000), "{size:e}");
        }
    }
}
