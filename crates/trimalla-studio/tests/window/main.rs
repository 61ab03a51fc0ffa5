//! The window, by label, click and key, without a display.

mod compare;
mod files;
mod learn;
mod panels;
mod steps;
mod tools;
mod trial;
mod viewer;
mod watch;

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use trimalla_studio::Studio;

/// A window as it opens.
fn welcome() -> Harness<'static, Studio> {
    Harness::builder()
        .with_size(Vec2::new(1200.0, 800.0))
        .build_ui_state(|ui, studio: &mut Studio| studio.show(ui), Studio::default())
}

/// A window that shows an empty document.
fn harness() -> Harness<'static, Studio> {
    let mut harness = welcome();
    harness.get_by_role_and_label(Role::Button, "Draw").click();
    harness.run_steps(2);
    harness
}

/// Types a command into the console.
fn enter(harness: &mut Harness<'_, Studio>, line: &str) {
    let input = harness.get_by_role_and_label(Role::TextInput, "Command");
    input.focus();
    harness.run();
    harness.get_by_role_and_label(Role::TextInput, "Command").type_text(line);
    harness.run();
    harness.get_by_role_and_label(Role::Button, "Run").click();
    settle(harness);
}

/// Waits for the command at work.
fn settle(harness: &mut Harness<'_, Studio>) {
    for _ in 0..3000 {
        harness.run_steps(2);
        if harness.state().document().is_some() {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    panic!("the command does not end");
}

fn figures(harness: &Harness<'_, Studio>) -> trimalla_workbench::Figures {
    harness.state().document().expect("nothing is at work").figures()
}

/// Clicks at a place of the window.
fn click_at(harness: &mut Harness<'_, Studio>, at: Pos2) {
    for pressed in [true, false] {
        harness.event(Event::PointerMoved(at));
        harness.event(Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        harness.run_steps(2);
    }
    settle(harness);
}

/// The middle of the drawing.
fn middle(harness: &Harness<'_, Studio>) -> Pos2 {
    harness.get_by_label("Drawing").rect().center()
}

/// Where a point of the plane is in the window, when everything was fitted.
fn place(harness: &Harness<'_, Studio>, bounds: [f64; 4], [x, y]: [f64; 2]) -> Pos2 {
    let rect = harness.get_by_label("Drawing").rect();
    let [left, low, right, high] = bounds;
    let fits = |extent: f64, room: f32| 0.9 * f64::from(room) / extent;
    let scale = fits(right - left, rect.width()).min(fits(high - low, rect.height()));
    let away = Vec2::new(((x - (left + right) / 2.0) * scale) as f32, (((low + high) / 2.0 - y) * scale) as f32);
    rect.center() + away
}

/// Shows everything.
fn fit(harness: &mut Harness<'_, Studio>) {
    press(harness, "Fit");
    harness.run_steps(3);
}

/// Clicks a button.
fn press(harness: &mut Harness<'_, Studio>, name: &str) {
    harness.get_by_role_and_label(Role::Button, name).click();
    settle(harness);
}

/// The document, which no command is at work on.
fn document<'a>(harness: &'a Harness<'_, Studio>) -> &'a trimalla_workbench::Document {
    harness.state().document().expect("nothing is at work")
}

/// Drags from one place to another one.
fn drag(harness: &mut Harness<'_, Studio>, from: Pos2, to: Pos2) {
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    harness.event(Event::PointerMoved(from));
    harness.event(button(from, true));
    harness.run_steps(1);
    for i in 1..=10 {
        harness.event(Event::PointerMoved(from + 0.1 * i as f32 * (to - from)));
        harness.run_steps(1);
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    harness.event(button(to, false));
    harness.run_steps(2);
    settle(harness);
    harness.run_steps(4);
    settle(harness);
}
