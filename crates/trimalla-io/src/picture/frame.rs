//! The sheet: how coordinates of the plane become places on it.

use trimalla::geometry::Point;

/// The longer side of the drawing, in units of the sheet.
pub(crate) const SIDE: f64 = 1000.0;
/// Free space on every side.
pub(crate) const MARGIN: f64 = 24.0;

/// Space on the sheet for what is no part of the drawing, in its units.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Space {
    /// Height of the heading.
    pub(crate) heading: f64,
    /// Width and least height of the panel to the right of the drawing.
    pub(crate) panel: [f64; 2],
}

/// Maps the plane to the sheet: y up becomes y down, the bounding box fills the drawing.
#[derive(Debug)]
pub(crate) struct Frame {
    /// A power of two that brings coordinates to where differences neither overflow nor vanish.
    factor: f64,
    low: Point,
    span: f64,
    /// Where the upper left corner of the bounding box goes.
    left: f64,
    bottom: f64,
    width: f64,
    height: f64,
    space: Space,
}

/// A place on the sheet, in hundredths of a unit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) x: i64,
    pub(crate) y: i64,
}

impl Frame {
    /// The frame in which `points`, which are finite, fill the drawing, with this space around it.
    pub(crate) fn around(points: &[Point], space: Space) -> Self {
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

        let drawing = unit(dy).max(space.panel[1]);
        Self {
            factor,
            low,
            span,
            left: MARGIN,
            bottom: MARGIN + space.heading + (drawing + unit(dy)) / 2.0,
            width: 2.0 * MARGIN + unit(dx) + space.panel[0],
            height: 2.0 * MARGIN + space.heading + drawing,
            space,
        }
    }

    /// A point's coordinates, scaled so that differences and their products behave.
    pub(crate) fn scaled(&self, point: Point) -> Point {
        Point::new(point.x * self.factor, point.y * self.factor)
    }

    /// Where a point goes.
    pub(crate) fn place(&self, point: Point) -> Place {
        let p = self.scaled(point);
        let unit = |d: f64| {
            if self.span > 0.0 { SIDE * (d / self.span) } else { 0.0 }
        };
        let hundredths = |v: f64| (100.0 * v).round() as i64;
        Place { x: hundredths(self.left + unit(p.x - self.low.x)), y: hundredths(self.bottom - unit(p.y - self.low.y)) }
    }

    /// The left side of the panel and its top.
    pub(crate) fn panel_corner(&self) -> (f64, f64) {
        (self.width - self.space.panel[0], MARGIN + self.space.heading)
    }

    /// Width and height of the sheet, without what may stand below the picture.
    pub(crate) fn size(&self) -> (f64, f64) {
        (self.width, self.height)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_range_fill_the_sheet() {
        for size in [f64::MAX, 1e300, 1.0, 1e-300, 5e-324] {
            let frame = Frame::around(&[Point::new(-size, -size), Point::new(size, size)], Space::default());
            let (low, high) = (frame.place(Point::new(-size, -size)), frame.place(Point::new(size, size)));
            assert_eq!((high.x - low.x, low.y - high.y), (100_000, 100_000), "{size:e}");
        }
    }
}
