//! Step by step, back, play, keys.

use super::*;

fn polygon(harness: &mut Harness<'_, Studio>) {
    for line in ["Generate polygon 12 5", "Triangulate", "Set preset lepp-centroid", "Set min-angle 25"] {
        enter(harness, line);
    }
}

#[test]
fn a_step_says_what_it_did() {
    let mut harness = harness();
    polygon(&mut harness);
    for _ in 0..3 {
        press(&mut harness, "Step");
    }
    harness.get_by_label("Step 3");
    harness.get_by_label_contains("triangles replaced by");
    press(&mut harness, "Back");
    harness.get_by_label("Step 2");
}

#[test]
fn arrows_step_and_go_back() {
    let mut harness = harness();
    polygon(&mut harness);
    // The console has the focus after typing; a click into the drawing takes it.
    let at = middle(&harness) + Vec2::new(0.0, 200.0);
    click_at(&mut harness, at);
    let before = document(&harness).undoable().0;
    for _ in 0..3 {
        harness.key_press(Key::ArrowRight);
        settle(&mut harness);
    }
    assert_eq!(document(&harness).undoable().0, before + 3);
    harness.key_press(Key::ArrowLeft);
    settle(&mut harness);
    assert_eq!(document(&harness).undoable(), (before + 2, 1));
}

#[test]
fn a_path_is_walked_triangle_by_triangle() {
    let mut harness = harness();
    for line in ["Generate random 60 8", "Triangulate", "Select 46 24 28"] {
        enter(&mut harness, line);
    }
    harness.run_steps(5);
    harness.get_by_label("path of 3 triangles");
    for _ in 0..4 {
        press(&mut harness, "Next triangle");
    }
    press(&mut harness, "Previous triangle");
    assert_eq!(document(&harness).undoable().0, 3, "to look changes nothing");
}

#[test]
fn looking_at_a_triangle_keeps_what_was_taken_back() {
    let mut harness = harness();
    polygon(&mut harness);
    press(&mut harness, "Step");
    press(&mut harness, "Step");
    press(&mut harness, "Back");
    let (done, undone) = document(&harness).undoable();
    let at = middle(&harness);
    click_at(&mut harness, at);
    harness.key_press(Key::ArrowRight);
    settle(&mut harness);
    assert_eq!((undone, document(&harness).undoable()), (1, (done + 1, 0)), "the right arrow goes forward");
}

#[test]
fn playing_ends_with_the_refinement() {
    let mut harness = harness();
    polygon(&mut harness);
    harness.get_by_role_and_label(Role::Button, "Play").click();
    for _ in 0..2000 {
        harness.step();
        std::thread::sleep(std::time::Duration::from_millis(1));
        if harness.query_by_role_and_label(Role::Button, "Pause").is_none() && figures(&harness).min_angle_deg >= 25.0 {
            break;
        }
    }
    settle(&mut harness);
    assert!(figures(&harness).min_angle_deg >= 25.0, "{}", figures(&harness).min_angle_deg);
    assert!(harness.query_by_role_and_label(Role::Button, "Pause").is_none());
}

#[test]
fn a_triangle_is_treated_until_it_is_destroyed() {
    let mut harness = harness();
    polygon(&mut harness);
    let (names, _) = {
        let document = document(&harness);
        let t = document.triangulation().expect("triangulated");
        let face = t.real_faces().next().expect("a face");
        (t.face_vertices(face).map(|v| document.name(v)), face)
    };
    let [i, j, k] = names;
    enter(&mut harness, &format!("Select {i} {j} {k}"));
    harness.run_steps(5);
    press(&mut harness, "Until destroyed");
    let script = document(&harness).script();
    assert!(document(&harness).face(names).is_none(), "{script}");
}
