//! The drawing of a scene: triangles by the graphics card, all else above them.

pub(crate) mod gpu;
mod near;
pub(crate) mod overlay;
pub(crate) mod plane_painter;
pub(crate) mod switches;
pub(crate) mod view;

use std::sync::Arc;

use eframe::egui::{self, Response, Sense, Ui};
use eframe::wgpu::TextureFormat;
use trimalla::geometry::math;

use self::gpu::{Drawn, Uniform};
use self::plane_painter::PlanePainter;
use self::switches::Switches;
use self::view::View;
use crate::scene::Scene;

/// A viewer: one of those that stand side by side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viewer {
    /// Its number: each has buffers of its own.
    pub(crate) number: u64,
    /// What the window's card draws into; `None` without a window.
    pub(crate) format: Option<TextureFormat>,
}

/// A viewer that was shown.
pub(crate) struct Shown {
    pub(crate) response: Response,
    pub(crate) painter: PlanePainter,
}

impl Viewer {
    /// Shows a scene in the room that is left; pans and zooms the view. With `fits` everything is seen.
    pub(crate) fn show(
        self,
        ui: &mut Ui,
        (scene, name): (&Arc<Scene>, &str),
        view: &mut View,
        switches: &Switches,
        fits: bool,
    ) -> Shown {
        let (response, painter) = ui.allocate_painter(ui.available_size(), Sense::click_and_drag());
        let rect = response.rect;
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, name));
        if let Some(bounds) = scene.bounds.filter(|_| fits) {
            view.fit(bounds, rect);
        }
        zoom(ui, &response, view);
        let is_dark = ui.visuals().dark_mode;
        let above = PlanePainter::new(&painter, (*view, rect), is_dark);
        if !scene.faces.is_empty() && rect.is_positive() {
            match self.format.filter(|_| !gpu::is_too_near(*view, scene)) {
                Some(format) => {
                    let look = (is_dark, ui.ctx().pixels_per_point());
                    let uniform = Uniform::new((*view, rect), scene, switches, look);
                    let drawn = Drawn { viewer: self.number, scene: scene.clone(), format, uniform };
                    painter.with_clip_rect(rect).add(drawn.into_shape(rect));
                }
                None => near::draw(&above, scene, switches, is_dark),
            }
        }
        overlay::draw(&above, scene, switches);
        Shown { response, painter: above }
    }
}

/// Zooms by wheel and fingers, to the pointer; pans by the middle or right button.
fn zoom(ui: &Ui, response: &Response, view: &mut View) {
    if response.dragged_by(egui::PointerButton::Middle) || response.dragged_by(egui::PointerButton::Secondary) {
        view.pan(response.drag_delta());
    }
    let Some(at) = response.hover_pos() else { return };
    let (wheel, pinch) = ui.input(|i| (i.smooth_scroll_delta.y, i.zoom_delta()));
    let factor = f64::from(pinch) * math::exp(f64::from(wheel) / 300.0);
    if factor != 1.0 {
        view.zoom(factor, at, response.rect);
    }
}
