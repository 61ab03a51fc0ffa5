//! The options of a refinement, each from the table of the library.

use eframe::egui::emath::Numeric;
use eframe::egui::{ComboBox, DragValue, Id, Key, Response, Ui};
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
                let _ = shown.response.labelled_by(label.id).on_hover_text(row.summary);
            }
            (Values::Number { .. }, value) => {
                let number = if let Some(Value::Number(number)) = value { *number } else { 0.0 };
                let is_none = value.is_none();
                let shown =
                    move |number: f64, _| if is_none && number == 0.0 { "none".to_owned() } else { number.to_string() };
                let number = edited(ui, (row, &label), number, |drag| drag.speed(0.1).custom_formatter(shown));
                command = number.and_then(|number| set(number.to_string()));
            }
            (Values::Count(_), value) => {
                let count = if let Some(Value::Count(count)) = value { *count } else { 0 };
                let count = edited(ui, (row, &label), count, |drag| drag.speed(100.0));
                command = count.and_then(|count| set(count.to_string()));
            }
            (Values::Text(_), _) => {}
        }
    });
    command
}

/// Shows a number that is typed or dragged; what it is to be, at Enter, at the loss of focus or at the end of a drag.
///
/// The panel is made from the document in each frame: what a drag has got to is kept until the command is run.
fn edited<N: Numeric + Default + Send + Sync>(
    ui: &mut Ui,
    (row, label): (&OptionRow, &Response),
    present: N,
    made: impl for<'a> FnOnce(DragValue<'a>) -> DragValue<'a>,
) -> Option<N> {
    let [id, escaped] = ["dragged", "escaped"].map(|what| Id::unique((what, row.key)));
    let kept: Option<N> = ui.data_mut(|data| data.remove_temp(id));
    let mut number = kept.unwrap_or(present);
    let drag = made(DragValue::new(&mut number)).update_while_editing(false);
    let response = ui.add(drag).labelled_by(label.id).on_hover_text(row.summary);
    if response.dragged() && !response.drag_stopped() {
        ui.data_mut(|data| data.insert_temp(id, number));
        return None;
    }
    // The toolkit takes the text in the frame after the one that dropped it.
    let is_escaped = response.lost_focus() && ui.input(|i| i.key_pressed(Key::Escape));
    let was_escaped = ui.data_mut(|data| data.remove_temp::<bool>(escaped)).is_some();
    if is_escaped {
        ui.data_mut(|data| data.insert_temp(escaped, true));
    }
    (number != present && !is_escaped && !was_escaped).then_some(number)
}
