//! Console, options, undo: the panels.

use super::*;

#[test]
fn commands_are_typed_and_buttons_run_them() {
    let mut harness = harness();
    for line in ["V 0 0 0", "V 1 4 0", "V 2 0 3"] {
        enter(&mut harness, line);
    }
    assert_eq!(figures(&harness).vertices, 3);
    harness.get_by_role_and_label(Role::Button, "Triangulate").click();
    settle(&mut harness);
    assert_eq!(figures(&harness).triangles, 1);
    harness.get_by_role_and_label(Role::Button, "Undo").click();
    settle(&mut harness);
    assert_eq!(figures(&harness).triangles, 0);
    harness.get_by_role_and_label(Role::Button, "Redo").click();
    settle(&mut harness);
    assert_eq!(figures(&harness).triangles, 1);
}

#[test]
fn a_click_picks_a_triangle_and_its_buttons_insert() {
    let mut harness = harness();
    for line in ["V 0 0 0", "V 1 4 0", "V 2 4 4", "V 3 0 4", "Triangulate"] {
        enter(&mut harness, line);
    }
    harness.get_by_role_and_label(Role::Button, "Fit").click();
    harness.run_steps(3);
    let at = middle(&harness) + Vec2::new(20.0, 60.0);
    click_at(&mut harness, at);
    assert_eq!(harness.state().document().expect("nothing is at work").selection().len(), 1);
    harness.get_by_label_contains("path of 2 triangles");
    harness.get_by_role_and_label(Role::Button, "Insert centroid").click();
    settle(&mut harness);
    assert_eq!(figures(&harness).vertices, 5);
    let script = harness.state().document().expect("nothing is at work").script();
    assert!(script.contains("Select ") && script.contains("Centroid "), "every click is a command: {script}");
}

#[test]
fn vertices_are_inserted_joined_and_deleted_by_clicks() {
    let mut harness = harness();
    enter(&mut harness, "Generate grid 9");
    enter(&mut harness, "Triangulate");
    harness.get_by_role_and_label(Role::Button, "Fit").click();
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::Button, "Insert").click();
    harness.run_steps(2);
    let at = middle(&harness) + Vec2::new(50.0, 30.0);
    click_at(&mut harness, at);
    assert_eq!(figures(&harness).vertices, 10);
    harness.get_by_role_and_label(Role::Button, "Delete").click();
    harness.run_steps(2);
    click_at(&mut harness, at);
    assert_eq!(figures(&harness).vertices, 9);
    harness.get_by_role_and_label(Role::Button, "Edge").click();
    harness.run_steps(2);
    let drawing = harness.get_by_label("Drawing").rect();
    // The square fills nine tenths of the shorter side.
    let half = 0.45 * drawing.width().min(drawing.height());
    for corner in [Vec2::new(-half, -half), Vec2::new(half, half)] {
        click_at(&mut harness, drawing.center() + corner);
    }
    harness.get_by_label("Edge 6-2");
    assert_eq!(figures(&harness).constrained, 0, "the edge is only planned");
    harness.get_by_role_and_label(Role::Button, "Insert edge").click();
    settle(&mut harness);
    assert!(figures(&harness).constrained >= 2, "the diagonal is constrained");
}

#[test]
fn options_are_set_by_the_panel_and_a_refinement_goes_step_by_step() {
    let mut harness = harness();
    for line in ["Generate polygon 12 5", "Triangulate", "Set min-angle 20"] {
        enter(&mut harness, line);
    }
    harness.get_by_role_and_label(Role::ComboBox, "preset").click();
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::Button, "lepp-centroid").click();
    settle(&mut harness);
    let preset = |harness: &Harness<'_, Studio>| harness.state().document().expect("at rest").options().preset;
    assert_eq!(preset(&harness).map(|preset| preset.key()), Some("lepp-centroid"));
    let at_first = figures(&harness);
    for _ in 0..4 {
        harness.get_by_role_and_label(Role::Button, "Step").click();
        settle(&mut harness);
    }
    let undoable = |harness: &Harness<'_, Studio>| harness.state().document().expect("at rest").undoable().0;
    let steps = undoable(&harness);
    for _ in 0..4 {
        harness.get_by_role_and_label(Role::Button, "Undo").click();
        settle(&mut harness);
    }
    assert_eq!((undoable(&harness), figures(&harness)), (steps - 4, at_first));
    harness.get_by_role_and_label(Role::Button, "Refine").click();
    settle(&mut harness);
    assert!(figures(&harness).min_angle_deg >= 20.0);
}

#[test]
fn nothing_that_is_clicked_or_zoomed_breaks_it() {
    let mut harness = harness();
    let at = middle(&harness);
    click_at(&mut harness, at);
    for name in ["Step", "Refine", "Undo", "Redo", "Check", "Triangulate", "Open", "Fit", "Clear"] {
        harness.get_by_role_and_label(Role::Button, name).click();
        settle(&mut harness);
    }
    enter(&mut harness, "V 0 nan 1");
    enter(&mut harness, "V 0 1 1");
    for (unit, times) in [(1e4, 60), (-1e4, 120)] {
        for _ in 0..times {
            harness.event(Event::PointerMoved(at));
            harness.event(Event::Zoom(if unit > 0.0 { 4.0 } else { 0.25 }));
            harness.run_steps(1);
        }
        click_at(&mut harness, at);
    }
    harness.key_press(Key::Escape);
    harness.run_steps(2);
    assert_eq!(figures(&harness).vertices, 1);
}

#[test]
fn a_long_refinement_is_cancelled() {
    let mut harness = harness();
    enter(&mut harness, "Generate random 3000 1");
    enter(&mut harness, "Triangulate");
    enter(&mut harness, "Set max-area 0.0000002");
    harness.get_by_role_and_label(Role::Button, "Refine").click();
    harness.run_steps(3);
    assert!(harness.state().document().is_none(), "it takes longer than a frame");
    harness.get_by_role_and_label(Role::Button, "Undo").click();
    harness.run_steps(3);
    harness.get_by_label_contains("a command is at work");
    harness.get_by_role_and_label(Role::Button, "Cancel").click();
    settle(&mut harness);
    assert_eq!(figures(&harness).vertices, 3000);
}

/// Clicks a number of the options, types over it and ends with a key.
fn type_number(harness: &mut Harness<'_, Studio>, name: &str, text: &str, key: Key) {
    let at = harness.get_by_role_and_label(Role::SpinButton, name).rect().center();
    click_at(harness, at);
    for letter in text.chars() {
        harness.event(Event::Text(letter.to_string()));
        harness.run_steps(2);
    }
    harness.key_press(key);
    harness.run_steps(2);
    settle(harness);
}

#[test]
fn numbers_of_the_options_are_typed() {
    let mut harness = harness();
    let min_angle = |harness: &Harness<'_, Studio>| document(harness).options().min_angle_deg;
    type_number(&mut harness, "min-angle", "28.5", Key::Enter);
    assert_eq!(min_angle(&harness), Some(28.5));
    type_number(&mut harness, "max-area", "0.25", Key::Enter);
    assert_eq!(document(&harness).options().max_area, Some(0.25));
    type_number(&mut harness, "max-vertices", "1234", Key::Tab);
    assert_eq!(document(&harness).options().max_vertices, Some(1234));
    type_number(&mut harness, "min-angle", "31", Key::Escape);
    assert_eq!(min_angle(&harness), Some(28.5), "Escape leaves it");
    assert_eq!(document(&harness).undoable().0, 3, "one command for each number");
}

#[test]
fn a_number_that_is_dragged_is_set_once() {
    let mut harness = harness();
    let from = harness.get_by_role_and_label(Role::SpinButton, "min-angle").rect().center();
    drag(&mut harness, from, from + Vec2::new(-60.0, 0.0));
    let angle = document(&harness).options().min_angle_deg.expect("it is set");
    assert!(angle < 28.0, "{angle}");
    let script = document(&harness).script();
    assert_eq!(script.lines().count(), 1, "{script}");
}
