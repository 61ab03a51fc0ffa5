//! What the second newcomer stumbled over.

use super::*;

/// Where the middle of the view is, and how many points a unit takes.
fn view(harness: &Harness<'_, Studio>) -> [String; 3] {
    ["Center x", "y", "Scale"]
        .map(|name| harness.get_by_role_and_label(Role::SpinButton, name).value().expect("a number"))
}

fn says(harness: &Harness<'_, Studio>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).count() > 0
}

#[test]
fn the_first_corners_of_an_outline_leave_the_view() {
    let mut harness = welcome();
    press(&mut harness, "Draw my own");
    let before = view(&harness);
    for away in [[-200.0, 100.0], [200.0, 100.0], [150.0, -100.0], [-150.0, -80.0]] {
        let at = middle(&harness) + Vec2::from(away);
        click_at(&mut harness, at);
        assert_eq!(view(&harness), before);
    }
    let at = middle(&harness) + Vec2::new(-200.0, 100.0);
    click_at(&mut harness, at);
    let script = document(&harness).script();
    assert!(script.contains("Outer 4 0 1 2 3"), "{script}");
    assert!(script.lines().all(|line| line.len() < 30), "coordinates have the digits of the screen: {script}");
}

#[test]
fn what_is_generated_on_an_empty_page_is_fitted() {
    let mut harness = harness();
    enter(&mut harness, "Generate polygon 20 1");
    enter(&mut harness, "Clear");
    let at = middle(&harness);
    harness.event(Event::PointerMoved(at));
    harness.event(Event::Zoom(0.1));
    harness.run_steps(3);
    let before = view(&harness);
    enter(&mut harness, "Generate random 100 1");
    harness.run_steps(3);
    assert_ne!(view(&harness), before);
    let fitted = view(&harness);
    enter(&mut harness, "Generate circle 50");
    assert_eq!(view(&harness), fitted, "what is added leaves the view");
}

#[test]
fn nothing_is_written_of_an_empty_drawing_and_names_are_free() {
    let folder = std::env::temp_dir().join(format!("trimalla-studio-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let mut harness = harness();
    let stem = folder.join("shape.poly");
    let field = |harness: &mut Harness<'_, Studio>, text: &str| {
        harness.get_by_role_and_label(Role::TextInput, "File").focus();
        harness.run_steps(2);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.get_by_role_and_label(Role::TextInput, "File").type_text(text);
        harness.run_steps(2);
    };
    field(&mut harness, &stem.to_string_lossy());
    let write = |harness: &mut Harness<'_, Studio>| {
        harness.get_by_role_and_label(Role::Button, "Write …").click();
        harness.run_steps(4);
        harness.get_all_by_label_contains("Picture: ").next().expect("the first one is of lines").click();
        settle(harness);
        harness.run_steps(2);
    };
    write(&mut harness);
    assert!(says(&harness, "there is nothing to write"));
    assert_eq!(std::fs::read_dir(&folder).expect("the folder").count(), 0);
    for line in ["V 0 0 0", "V 1 4 0", "V 2 0 3", "Triangulate"] {
        enter(&mut harness, line);
    }
    write(&mut harness);
    let path = folder.join("shape.1.svg");
    assert!(path.exists() && says(&harness, &format!("it is in {}", path.display())));
    write(&mut harness);
    assert!(folder.join("shape.1-2.svg").exists(), "the first one is not replaced");
    field(&mut harness, &folder.join("shape.1.svg").to_string_lossy());
    write(&mut harness);
    assert!(!folder.join("shape.1-3.svg").exists(), "a name that was given is taken");
    std::fs::remove_dir_all(&folder).expect("removed");
}

#[test]
fn an_outline_waits_while_another_tool_is_in_hand() {
    let mut harness = welcome();
    press(&mut harness, "Draw my own");
    let corners = [[-100.0, 100.0], [100.0, 100.0], [0.0, -100.0]];
    let click = |harness: &mut Harness<'_, Studio>, away: [f32; 2]| {
        let at = middle(harness) + Vec2::from(away);
        click_at(harness, at);
    };
    click(&mut harness, corners[0]);
    click(&mut harness, corners[1]);
    press(&mut harness, "Pick");
    assert!(says(&harness, "'Outline' goes on with it"));
    press(&mut harness, "Outline");
    click(&mut harness, corners[2]);
    click(&mut harness, corners[0]);
    assert!(document(&harness).script().contains("Outer 3 0 1 2"), "{}", document(&harness).script());
    enter(&mut harness, "Undo");
    click(&mut harness, corners[0]);
    press(&mut harness, "Triangulate");
    harness.run_steps(2);
    assert!(says(&harness, "it was not closed before 'Triangulate'"));
    assert!(harness.query_by_role_and_label(Role::Button, "Drop").is_none());
}

#[test]
fn buttons_on_the_right_stay_where_they_are() {
    let mut harness = harness();
    for line in ["Generate random 60 8", "Triangulate"] {
        enter(&mut harness, line);
    }
    harness.run_steps(3);
    let names = ["Insert midpoint", "Show", "Previous triangle", "Next triangle"];
    let places = |harness: &Harness<'_, Studio>| {
        let mut rects: Vec<_> =
            names.iter().map(|name| harness.get_by_role_and_label(Role::Button, name).rect()).collect();
        rects.push(harness.get_by_role_and_label(Role::SpinButton, "min-angle").rect());
        rects.push(harness.get_by_label("Drawing").rect());
        rects
    };
    let before = places(&harness);
    for line in ["Select 46 24 28", "Step", "Step 3", "Refine", "Undo 4", "Select 46 24 28"] {
        enter(&mut harness, line);
        harness.run_steps(2);
        assert_eq!(places(&harness), before, "{line}");
    }
    press(&mut harness, "Next triangle");
    assert_eq!(places(&harness), before);
}

#[test]
fn digits_take_tools_on_the_page_of_the_drawing_alone() {
    let mut harness = welcome();
    let is_taken = |harness: &Harness<'_, Studio>| {
        let at = harness.get_by_role_and_label(Role::Button, "Outline");
        format!("{at:?}").contains("toggled: True")
    };
    harness.key_press(Key::Num3);
    harness.run_steps(2);
    press(&mut harness, "Draw");
    harness.run_steps(2);
    assert!(!is_taken(&harness));
    harness.key_press(Key::Num3);
    harness.run_steps(2);
    assert!(is_taken(&harness));
}

#[test]
fn a_refinement_that_misses_its_bounds_says_why() {
    let mut harness = harness();
    for line in ["V 0 0 0", "V 1 10 0.4", "V 2 10 -0.4", "Outer 3 0 2 1", "Triangulate", "Refine"] {
        enter(&mut harness, line);
    }
    assert!(says(&harness, "Bounds missed: ") && says(&harness, "at sharp corners of the drawing"));
    enter(&mut harness, "Undo");
    harness.run_steps(2);
    assert!(!says(&harness, "Bounds missed: "));
    for line in ["Clear", "Generate polygon 60 2", "Triangulate", "Set max-vertices 80", "Set min-angle 33", "Refine"] {
        enter(&mut harness, line);
    }
    assert!(says(&harness, "as the budget of 80 vertices is used up"));
}

#[test]
fn the_threshold_follows_the_angle_that_is_asked_until_it_is_moved() {
    let mut harness = harness();
    let bad = |harness: &Harness<'_, Studio>| {
        harness.get_by_role_and_label(Role::SpinButton, "Bad below").value().expect("a number")
    };
    enter(&mut harness, "Set min-angle 22");
    harness.run_steps(2);
    assert_eq!(bad(&harness), "22.0");
    let slider = harness.get_by_role_and_label(Role::Slider, "Bad below").rect();
    click_at(&mut harness, slider.left_center() + Vec2::new(20.0, 0.0));
    let moved = bad(&harness);
    assert_ne!(moved, "22.0");
    enter(&mut harness, "Set min-angle 25");
    harness.run_steps(2);
    assert_eq!(bad(&harness), moved);
}

#[test]
fn a_lesson_shows_neither_hints_nor_its_tests() {
    let mut harness = welcome();
    press(&mut harness, "Delaunay by flips");
    for _ in 0..3 {
        press(&mut harness, "Next scene");
    }
    assert!(document(&harness).script().contains("Flip 1 5"));
    assert!(says(&harness, "Flip 1 5") && !says(&harness, "Expect"));
}

#[test]
fn a_small_window_has_room_for_the_drawing() {
    let mut harness = harness();
    enter(&mut harness, "Example key");
    enter(&mut harness, "Triangulate");
    harness.set_size(Vec2::new(640.0, 480.0));
    harness.run_steps(6);
    let drawing = harness.get_by_label("Drawing").rect();
    assert!(drawing.width() > 250.0 && drawing.height() > 90.0, "{drawing}");
    assert!(drawing.max.x <= 640.0 && drawing.max.y <= 480.0, "{drawing}");
    for (role, name) in [(Role::Button, "Fit"), (Role::Slider, "History"), (Role::CheckBox, "Vertices")] {
        let place = harness.get_by_role_and_label(role, name).rect();
        assert!(place.max.x < 640.0, "{name}: {place}");
    }
    let console = harness.get_by_role_and_label(Role::TextInput, "Command").rect();
    assert!(console.min.y > 300.0 && console.max.y < 480.0, "{console}");
}

#[test]
fn what_cannot_be_opened_leaves_tool_and_view() {
    let mut harness = harness();
    for line in ["V 0 0 0", "V 1 4 0", "V 2 0 3", "Triangulate"] {
        enter(&mut harness, line);
    }
    press(&mut harness, "Flip");
    let at = middle(&harness);
    harness.event(Event::PointerMoved(at));
    harness.event(Event::Zoom(3.0));
    harness.run_steps(3);
    let before = view(&harness);
    let is_taken = |harness: &Harness<'_, Studio>| {
        format!("{:?}", harness.get_by_role_and_label(Role::Button, "Flip")).contains("toggled: True")
    };
    for name in ["nothing-is-there.poly", "nothing-is-there.tri"] {
        harness.state_mut().open(name);
        settle(&mut harness);
        harness.run_steps(3);
        assert_eq!((view(&harness), is_taken(&harness)), (before.clone(), true), "{name}");
    }
}

#[test]
fn every_row_on_top_takes_clicks() {
    let mut harness = harness();
    let at = harness.get_by_role_and_label(Role::CheckBox, "Step shown").rect().center();
    click_at(&mut harness, at);
    let switch = format!("{:?}", harness.get_by_role_and_label(Role::CheckBox, "Step shown"));
    assert!(switch.contains("toggled: False"), "{switch}");
}
