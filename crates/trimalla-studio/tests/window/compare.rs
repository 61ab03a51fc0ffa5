//! Recipes side by side.

use super::*;

#[test]
fn recipes_run_side_by_side_and_leave_the_document() {
    let mut harness = harness();
    enter(&mut harness, "Example key");
    press(&mut harness, "Compare");
    press(&mut harness, "Run all");
    harness.get_by_label_contains("there is no triangulation to refine yet");
    press(&mut harness, "Draw");
    press(&mut harness, "Triangulate");
    let before = figures(&harness);
    press(&mut harness, "Compare");
    press(&mut harness, "Add recipe");
    run_all(&mut harness);
    // The document as it is, and a drawing of each recipe.
    for name in
        ["Drawing, original", "Drawing, off-center, 30°", "Drawing, lepp-centroid, 30°", "Drawing, lepp-midpoint, 30°"]
    {
        harness.get_by_label(name);
    }
    harness.get_by_label(&before.triangles.to_string());
    assert_eq!(figures(&harness), before, "the document is as it was");
}

#[test]
fn a_small_window_shows_four_recipes() {
    for size in [Vec2::new(700.0, 500.0), Vec2::new(320.0, 200.0)] {
        let mut harness = harness();
        enter(&mut harness, "Example star");
        enter(&mut harness, "Triangulate");
        assert!(figures(&harness).triangles > 0);
        press(&mut harness, "Compare");
        press(&mut harness, "Add recipe");
        harness.set_size(size);
        harness.run_steps(4);
        press(&mut harness, "Run all");
        harness.run_steps(10);
        for name in ["original", "off-center, 30°", "lepp-centroid, 30°", "lepp-midpoint, 30°"] {
            harness.get_by_label(&format!("Drawing, {name}"));
        }
    }
}

/// Runs all recipes to their ends.
fn run_all(harness: &mut Harness<'_, Studio>) {
    press(harness, "Run all");
    harness.run_steps(2);
    for _ in 0..2000 {
        harness.step();
        if harness.query_by_role_and_label(Role::Button, "Cancel all").is_none() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    harness.run_steps(3);
}

#[test]
fn recipes_begin_before_the_steps_of_a_refinement() {
    let mut harness = harness();
    for line in ["Generate random 60 8", "Triangulate", "Set preset lepp-centroid", "Set min-angle 20", "Step 4"] {
        enter(&mut harness, line);
    }
    let mut begun = trimalla_workbench::Document::new();
    let mut counts = Vec::new();
    for recipe in
        ["", "Set preset off-center\nSet min-angle 20\nRefine", "Set preset lepp-centroid\nSet min-angle 20\nRefine"]
    {
        let text = format!("Clear\nGenerate random 60 8\nTriangulate\n{recipe}");
        assert_eq!(trimalla_workbench::script::run(&mut begun, &text, false, &mut trimalla_workbench::Quiet), []);
        counts.push(begun.figures().triangles.to_string());
    }
    let before = document(&harness).script();
    press(&mut harness, "Compare");
    run_all(&mut harness);
    harness.get_by_label_contains("begin from the triangulation before the first 'Step'");
    for count in &counts {
        assert!(harness.query_all_by_label(count).count() > 0, "{counts:?}");
    }
    assert_ne!(counts[1], counts[2]);
    assert_eq!(document(&harness).script(), before);
}

#[test]
fn results_of_an_earlier_drawing_are_marked_and_the_original_is_shown_at_once() {
    let mut harness = harness();
    enter(&mut harness, "Example star");
    enter(&mut harness, "Triangulate");
    let triangles = figures(&harness).triangles.to_string();
    press(&mut harness, "Compare");
    harness.run_steps(2);
    assert!(harness.query_all_by_label(&triangles).count() > 0, "the original is shown before the recipes run");
    run_all(&mut harness);
    assert!(harness.query_by_label_contains("of an earlier drawing").is_none());
    enter(&mut harness, "Clear");
    harness.run_steps(2);
    assert!(harness.query_all_by_label_contains("of an earlier drawing").count() >= 2);
    enter(&mut harness, "Undo");
    harness.run_steps(2);
    assert!(harness.query_by_label_contains("of an earlier drawing").is_none());
}

#[test]
fn more_options_stay_until_a_click_outside() {
    let mut harness = harness();
    press(&mut harness, "Compare");
    let place = |harness: &Harness<'_, Studio>| {
        harness.get_all_by_role_and_label(Role::Button, "more").map(|button| button.rect()).collect::<Vec<_>>()
    };
    let before = place(&harness);
    press(&mut harness, "Add recipe");
    assert_eq!(place(&harness)[..2], before[..], "a recipe that is added moves no field of the others");
    click_at(&mut harness, before[0].center());
    let at = harness.get_by_label("The five steps").rect().center();
    click_at(&mut harness, at);
    // Longer than between the clicks of a double click.
    harness.run_steps(30);
    let at = harness.get_by_role_and_label(Role::SpinButton, "min-angle").rect().center();
    click_at(&mut harness, at);
    for letter in ["2", "7"] {
        harness.event(Event::Text(letter.to_owned()));
        harness.run_steps(2);
    }
    harness.key_press(Key::Enter);
    harness.run_steps(3);
    let spin = harness.get_by_role_and_label(Role::SpinButton, "min-angle").value();
    assert_eq!(spin.as_deref(), Some("27"));
    harness.get_by_label("Drawing, off-center, 27°");
    // A list in it opens and is clicked, and all stays.
    let at = harness.get_by_role_and_label(Role::ComboBox, "preset").rect().center();
    click_at(&mut harness, at);
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::Button, "circumcenter").click();
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::SpinButton, "min-angle");
    let outside = harness.get_by_role_and_label(Role::TextInput, "Command").rect().center();
    click_at(&mut harness, outside);
    harness.run_steps(3);
    assert!(harness.query_by_role_and_label(Role::SpinButton, "min-angle").is_none(), "it is closed");
}
