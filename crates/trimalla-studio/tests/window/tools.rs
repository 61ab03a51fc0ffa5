//! The tools: what clicks and drags into the drawing do.

use super::*;

const SQUARE: [f64; 4] = [0.0, 0.0, 4.0, 4.0];

fn square(harness: &mut Harness<'_, Studio>) {
    for line in ["V 0 0 0", "V 1 4 0", "V 2 4 4", "V 3 0 4"] {
        enter(harness, line);
    }
    fit(harness);
}

fn click_on(harness: &mut Harness<'_, Studio>, at: [f64; 2]) {
    let at = place(harness, SQUARE, at);
    click_at(harness, at);
}

#[test]
fn an_outline_and_a_hole_are_drawn_by_clicks() {
    let mut harness = harness();
    square(&mut harness);
    press(&mut harness, "Outline");
    // Clockwise: the command gets it counter-clockwise.
    for corner in [[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0], [0.0, 0.0]] {
        click_on(&mut harness, corner);
    }
    press(&mut harness, "Hole");
    for corner in [[1.0, 1.0], [3.0, 1.0], [2.0, 3.0], [1.0, 1.0]] {
        click_on(&mut harness, corner);
    }
    let script = document(&harness).script();
    assert!(script.contains("Outer 4 1 2 3 0") && script.contains("Inner 3 6 5 4"), "{script}");
    press(&mut harness, "Triangulate");
    assert_eq!(figures(&harness).vertices, 7);
    assert!((figures(&harness).area - 14.0).abs() < 0.2, "{}", figures(&harness).area);
    click_on(&mut harness, [0.0, 0.0]);
    harness.get_by_label_contains("contours come before");
}

#[test]
fn an_edge_is_flipped_and_a_vertex_dragged() {
    let mut harness = harness();
    square(&mut harness);
    press(&mut harness, "Triangulate");
    let has_diagonal = |harness: &Harness<'_, Studio>| {
        document(harness).triangulation().is_some_and(|t| t.edges().any(|h| t.origin(h).0 + t.dest(h).0 == 2))
    };
    let before = has_diagonal(&harness);
    press(&mut harness, "Flip");
    click_on(&mut harness, [2.05, 2.0]);
    assert_ne!(has_diagonal(&harness), before);
    press(&mut harness, "Insert");
    click_on(&mut harness, [1.0, 2.0]);
    let undoable = document(&harness).undoable().0;
    press(&mut harness, "Move");
    let (from, to) = (place(&harness, SQUARE, [1.0, 2.0]), place(&harness, SQUARE, [3.0, 2.5]));
    drag(&mut harness, from, to);
    assert_eq!(document(&harness).undoable().0, undoable + 1, "one command is left of the drag");
    let script = document(&harness).script();
    assert!(script.lines().last().is_some_and(|line| line.starts_with("Move 4 ")), "{script}");
    let v = document(&harness).vertex(4).expect("it is there");
    let at = document(&harness).triangulation().expect("triangulated").point(v);
    assert!((at.x - 3.0).abs() < 0.05 && (at.y - 2.5).abs() < 0.05, "{at}");
    enter(&mut harness, "Check");
    press(&mut harness, "Undo");
    let at = document(&harness).triangulation().expect("triangulated").point(v);
    assert!((at.x - 1.0).abs() < 0.05, "{at}");
}

#[test]
fn a_corner_that_cannot_be_dragged_leaves_everything() {
    let mut harness = harness();
    square(&mut harness);
    let (from, to) = (place(&harness, SQUARE, [0.0, 0.0]), place(&harness, SQUARE, [1.0, 1.0]));
    press(&mut harness, "Move");
    drag(&mut harness, from, to);
    assert!(document(&harness).script().contains("\nMove 0 "), "a point of the drawing moves");
    press(&mut harness, "Undo");
    for line in ["Outer 4 0 1 2 3", "Triangulate"] {
        enter(&mut harness, line);
    }
    let before = document(&harness).script();
    press(&mut harness, "Move");
    drag(&mut harness, from, to);
    assert_eq!(document(&harness).script(), before);
    assert_eq!(figures(&harness).triangles, 2);
    harness.get_by_label_contains("on the boundary");
}

#[test]
fn an_edge_shows_its_two_phases_before_it_is_inserted() {
    let mut harness = harness();
    for line in [
        "V 0 0 2",
        "V 1 1 1.7",
        "V 2 1.2 2.4",
        "V 3 2 1.6",
        "V 4 2.2 2.5",
        "V 5 3 1.7",
        "V 6 3.2 2.4",
        "V 7 4 2",
        "Triangulate",
    ] {
        enter(&mut harness, line);
    }
    fit(&mut harness);
    press(&mut harness, "Edge");
    let bounds = [0.0, 1.6, 4.0, 2.5];
    for end in [[0.0, 2.0], [4.0, 2.0]] {
        let at = place(&harness, bounds, end);
        click_at(&mut harness, at);
    }
    harness.get_by_label("Edge 0-7");
    let plan = document(&harness).edge_plan(0, 7).expect("planned");
    let calls = plan.left.calls.len() + plan.right.calls.len();
    assert!(plan.crossed.len() >= 3 && calls >= 4, "{} edges crossed, {calls} calls", plan.crossed.len());
    for call in 1..=calls {
        press(&mut harness, "Next call");
        harness.get_by_label_contains(&format!("call {call}: base"));
    }
    press(&mut harness, "Previous call");
    harness.get_by_label_contains(&format!("call {}: base", calls - 1));
    press(&mut harness, "Insert edge");
    assert!(document(&harness).script().ends_with("Edge 0 7\n"));
    assert!(harness.query_by_label("Edge 0-7").is_none(), "the panel is gone");
}

#[test]
fn escape_drops_what_was_begun() {
    let mut harness = harness();
    square(&mut harness);
    press(&mut harness, "Outline");
    click_on(&mut harness, [0.0, 0.0]);
    harness.get_by_role_and_label(Role::Button, "Drop");
    harness.key_press(Key::Escape);
    harness.run_steps(2);
    assert!(harness.query_by_role_and_label(Role::Button, "Drop").is_none());
}
