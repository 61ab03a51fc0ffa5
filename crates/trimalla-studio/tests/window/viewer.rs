//! The viewer, the console and the ways in: switches, themes, completion, what was loaded.

use super::*;

fn says(harness: &Harness<'_, Studio>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).count() > 0
}

fn is_on(harness: &Harness<'_, Studio>, role: Role, name: &str) -> bool {
    format!("{:?}", harness.get_by_role_and_label(role, name)).contains("toggled: True")
}

#[test]
fn every_switch_of_the_drawing_is_flipped_and_back() {
    let mut harness = harness();
    for line in ["Example key", "Triangulate"] {
        enter(&mut harness, line);
    }
    let names = [
        "Edges",
        "Constraints",
        "Boundary",
        "Vertices",
        "Added",
        "Labels",
        "Holes",
        "Circle",
        "All circles",
        "Path",
        "Step shown",
    ];
    for name in names {
        let before = is_on(&harness, Role::CheckBox, name);
        for wanted in [!before, before] {
            harness.get_by_role_and_label(Role::CheckBox, name).click();
            harness.run_steps(3);
            assert_eq!(is_on(&harness, Role::CheckBox, name), wanted, "{name}");
        }
    }
    let figures = figures(&harness);
    assert!(figures.triangles > 10, "the document is as it was: {figures:?}");
}

#[test]
fn light_and_dark_change_with_a_click() {
    let mut harness = harness();
    let before = harness.ctx.theme();
    press(&mut harness, "Dark");
    harness.run_steps(2);
    assert_ne!(harness.ctx.theme(), before);
    press(&mut harness, "Dark");
    harness.run_steps(2);
    assert_eq!(harness.ctx.theme(), before);
}

#[test]
fn the_console_completes_and_remembers() {
    let mut harness = harness();
    let typed = |harness: &Harness<'_, Studio>| {
        harness.get_by_role_and_label(Role::TextInput, "Command").value().expect("a text")
    };
    enter(&mut harness, "V 0 1 2");
    enter(&mut harness, "V 1 3 4");
    harness.get_by_role_and_label(Role::TextInput, "Command").focus();
    harness.run_steps(2);
    for (key, wanted) in
        [(Key::ArrowUp, "V 1 3 4"), (Key::ArrowUp, "V 0 1 2"), (Key::ArrowDown, "V 1 3 4"), (Key::ArrowDown, "")]
    {
        harness.key_press(key);
        harness.run_steps(2);
        assert_eq!(typed(&harness), wanted);
    }
    harness.get_by_role_and_label(Role::TextInput, "Command").type_text("Triang");
    harness.run_steps(2);
    harness.key_press(Key::Tab);
    harness.run_steps(2);
    assert_eq!(typed(&harness), "Triangulate ");
    // The cursor stands behind the name.
    harness.get_by_role_and_label(Role::TextInput, "Command").type_text("DAC");
    harness.run_steps(2);
    press(&mut harness, "Run");
    assert!(document(&harness).script().ends_with("Triangulate DAC\n"), "{}", document(&harness).script());
    enter(&mut harness, "Help LEPP");
    assert!(says(&harness, "longest-edge propagation paths"));
}

#[test]
fn the_panel_names_what_was_loaded() {
    let mut harness = harness();
    enter(&mut harness, "Example key");
    harness.run_steps(2);
    assert!(says(&harness, "of key"));
    enter(&mut harness, "Triangulate");
    harness.run_steps(2);
    assert!(says(&harness, "of key") && says(&harness, "angles "));
    enter(&mut harness, "Clear");
    harness.run_steps(2);
    assert!(!says(&harness, "of key"));
}
