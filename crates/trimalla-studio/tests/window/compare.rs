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
    press(&mut harness, "Run all");
    for _ in 0..2000 {
        harness.step();
        if harness.query_by_role_and_label(Role::Button, "Cancel all").is_none() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    harness.run_steps(3);
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
