//! What came of the recipes: figures in a table, angles as curves.

use eframe::egui::{Grid, Ui, Vec2};
use egui_plot::{Legend, Line, Plot, PlotPoints};

use super::slot::Slot;
use crate::viewer::switches::Switches;

pub(super) fn show(ui: &mut Ui, slots: &[Slot], switches: &Switches) {
    ui.horizontal_top(|ui| {
        show_figures(ui, slots, switches);
        show_angles(ui, slots);
    });
}

fn show_figures(ui: &mut Ui, slots: &[Slot], switches: &Switches) {
    Grid::new("figures").striped(true).show(ui, |ui| {
        let below = format!("below {}°", switches.threshold_deg);
        for heading in ["", "vertices", "added", "triangles", "smallest angle", "largest angle", &below, "seconds"] {
            ui.strong(heading);
        }
        ui.end_row();
        for slot in slots {
            ui.label(slot.title());
            if let Some(figures) = slot.figures() {
                let faces = &slot.scene().faces;
                let bad = faces.iter().filter(|face| f64::from(face.min_angle_deg) < switches.threshold_deg).count();
                for count in [figures.vertices, figures.steiner, figures.triangles] {
                    ui.label(count.to_string());
                }
                for angle in [figures.min_angle_deg, figures.max_angle_deg] {
                    ui.label(format!("{angle:.2}°"));
                }
                ui.label(bad.to_string());
                ui.label(slot.seconds().map_or_else(|| "–".to_owned(), |seconds| format!("{seconds:.3}")));
            }
            ui.end_row();
        }
    });
}

/// The share of triangles by their smallest angle.
fn show_angles(ui: &mut Ui, slots: &[Slot]) {
    let plot = Plot::new("angles").legend(Legend::default()).x_axis_label("smallest angle, degrees");
    plot.y_axis_label("% of triangles")
        .include_y(0.0)
        .include_x(0.0)
        .include_x(60.0)
        .set_margin_fraction(Vec2::ZERO)
        .allow_scroll(false)
        .show(ui, |plot| {
            for slot in slots {
                let angles = &slot.scene().angles;
                let share = |(bin, &count): (usize, &usize)| {
                    let [low, high] = angles.range_deg(bin);
                    [f64::midpoint(low, high), 100.0 * count as f64 / angles.total() as f64]
                };
                if angles.total() > 0 {
                    let points: Vec<[f64; 2]> = angles.counts.iter().enumerate().map(share).collect();
                    plot.line(Line::new(slot.title(), PlotPoints::from(points)));
                }
            }
        });
}
