//! The part of the plane that is seen.

use eframe::egui::{Pos2, Rect, Vec2, pos2};
use trimalla::geometry::{BoundingBox, Point};

/// A view: what is in the middle, and how many points of the screen a unit takes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    pub(crate) center: Point,
    pub(crate) scale: f64,
    /// Whether y grows downwards.
    pub(crate) is_y_down: bool,
    /// The scale at which everything is seen.
    fitting: f64,
}

impl Default for View {
    fn default() -> Self {
        Self { center: Point::new(0.0, 0.0), scale: 100.0, is_y_down: false, fitting: 100.0 }
    }
}

impl View {
    /// The least and the greatest scale: beyond them nothing could be told apart.
    const SCALES: [f64; 2] = [1e-300, 1e300];

    /// How far one zooms out and in, from where everything is seen: beyond the digits of coordinates nothing is there.
    const ZOOMS: [f64; 2] = [1e-3, 1e14];

    /// Shows a box in a part of the screen.
    pub(crate) fn fit(&mut self, bounds: BoundingBox, rect: Rect) {
        let center = bounds.center();
        let (width, height) = (f64::from(rect.width().max(1.0)), f64::from(rect.height().max(1.0)));
        let fits = |extent: f64, room: f64| if extent > 0.0 { 0.9 * room / extent } else { f64::INFINITY };
        let scale = fits(bounds.width(), width).min(fits(bounds.height(), height));
        let scale = if scale.is_finite() { scale } else { 100.0 };
        (self.center, self.fitting) = (center, scale);
        self.set_scale(scale);
    }

    /// Sets the scale, where it is a number above 0.
    pub(crate) fn set_scale(&mut self, scale: f64) {
        if scale > 0.0 {
            self.scale = scale.clamp(Self::SCALES[0], Self::SCALES[1]);
        }
    }

    /// 1 where y grows upwards, as in a textbook.
    fn up(self) -> f64 {
        if self.is_y_down { -1.0 } else { 1.0 }
    }

    /// Where a point is on the screen.
    pub(crate) fn to_screen(self, p: Point, rect: Rect) -> Pos2 {
        // Differences first, so that large coordinates keep their digits.
        let (x, y) = ((p.x - self.center.x) * self.scale, (p.y - self.center.y) * self.scale * self.up());
        let middle = rect.center();
        pos2(middle.x + limited(x), middle.y - limited(y))
    }

    /// The point that is seen at a place of the screen.
    pub(crate) fn to_plane(self, at: Pos2, rect: Rect) -> Point {
        let d = at - rect.center();
        Point::new(self.center.x + f64::from(d.x) / self.scale, self.center.y - f64::from(d.y) / self.scale * self.up())
    }

    /// Moves by so much of the screen.
    pub(crate) fn pan(&mut self, by: Vec2) {
        let (x, y) = (f64::from(by.x) / self.scale, f64::from(by.y) / self.scale * self.up());
        let to = Point::new(self.center.x - x, self.center.y + y);
        if to.is_finite() {
            self.center = to;
        }
    }

    /// Zooms by a factor; the point at a place of the screen stays there.
    pub(crate) fn zoom(&mut self, factor: f64, at: Pos2, rect: Rect) {
        let fixed = self.to_plane(at, rect);
        let [least, most] = Self::ZOOMS.map(|zoom| (zoom * self.fitting).clamp(Self::SCALES[0], Self::SCALES[1]));
        let scale = (self.scale * factor).clamp(least, most);
        if !fixed.is_finite() || !scale.is_finite() {
            return;
        }
        self.scale = scale;
        let moved = self.to_screen(fixed, rect) - at;
        self.pan(-moved);
    }
}

/// A coordinate of the screen, far away at most.
fn limited(x: f64) -> f32 {
    if x.is_nan() { 0.0 } else { x.clamp(-1e6, 1e6) as f32 }
}
