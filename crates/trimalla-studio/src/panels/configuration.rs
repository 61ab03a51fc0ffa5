//! The options of a refinement, each from the table of the library.

use eframe::egui::{ComboBox, DragValue, Ui};
use trimalla::refine::{Group, NamedOptions, OPTIONS, OptionRow, Value, Values};

/// Shows the options; the command of one that was changed.
pub(crate) fn show(ui: &mut Ui, options: &NamedOptions) -> Option<String> {
    ui.heading("Refinement");
    let of = |wanted: fn(&OptionRow) -> bool| OPTIONS.iter().filter(move |row| wanted(row));
    let mut command = None;
    for row in of(|row| matches!(row.group, Group::Criteria | Group::Preset | Group::Limits)) {
        command = show_row(ui, row, options).or(command);
    }
    ui.collapsing("The five steps", |ui| {
        for row in of(|row| matches!(row.group, Group::Step(_) | Group::Protect)) {
            command = show_row(ui, row, options).or(command.take());
        }
    });
    command
}

/// Shows an option; the command that sets it, where it was changed.
fn show_row(ui: &mut Ui, row: &'static OptionRow, options: &NamedOptions) -> Option<String> {
    let present = row.get(options);
    let set = |value: String| Some(format!("Set {} {value}", row.key));
    let mut command = None;
    ui.horizontal(|ui| {
        let label = ui.label(row.key).on_hover_text(row.summary);
        match (row.values, &present) {
            (Values::Keys(keys) | Values::Truth(keys), value) => {
                let chosen = value.as_ref().map_or_else(|| "–".to_owned(), Value::to_string);
                let shown = ComboBox::from_id_salt(row.key).selected_text(&chosen).show_ui(ui, |ui| {
                    for key in keys {
                        let option = ui.selectable_label(key.key == chosen, key.key).on_hover_text(key.summary);
                        if option.clicked() {
                            command = set(key.key.to_owned());
                        }
                    }
                });
                let _ = shown.response.labelled_by(label.id);
            }
            (Values::Number { .. }, value) => {
                let mut number = if let Some(Value::Number(number)) = value { *number } else { 0.0 };
                let is_none = value.is_none();
                let shown =
                    move |number: f64, _| if is_none && number == 0.0 { "none".to_owned() } else { number.to_string() };
                let drag = ui.add(DragValue::new(&mut number).speed(0.1).custom_formatter(shown)).labelled_by(label.id);
                let is_changed = Some(Value::Number(number)) != present && !(is_none && number == 0.0);
                if (drag.drag_stopped() || drag.lost_focus()) && is_changed {
                    command = set(number.to_string());
                }
            }
            (Values::Count(_), value) => {
                let mut count = if let Some(Value::Count(count)) = value { *count } else { 0 };
                let drag = ui.add(DragValue::new(&mut count).speed(100.0)).labelled_by(label.id);
                if drag.drag_stopped() || drag.lost_focus() && Some(Value::Count(count)) != present {
                    command = set(count.to_string());
                }
            }
            (Values::Text(_), _) => {}
        }
    });
    command
}
