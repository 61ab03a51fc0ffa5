//! What an algorithm told, played.

use super::*;

fn polygon(harness: &mut Harness<'_, Studio>) {
    enter(harness, "Generate polygon 12 5");
    choose(harness, "ears");
}

/// Triangulates by an algorithm of the list.
fn choose(harness: &mut Harness<'_, Studio>, key: &str) {
    harness.get_by_role_and_label(Role::Button, "by …").click();
    harness.run_steps(4);
    let begins = format!("{key}: ");
    let all = harness.get_all_by_label_contains(&begins);
    let rows: Vec<_> = all.filter(|row| format!("{row:?}").contains(&format!("label: \"{begins}"))).collect();
    // It may be scrolled out of view.
    rows.first().expect("it is in the list").click_accesskit();
    settle(harness);
    harness.run_steps(3);
}

fn shown(harness: &Harness<'_, Studio>) -> [usize; 2] {
    let construction = document(harness).construction().expect("an algorithm has told");
    [construction.shown(), construction.steps().len()]
}

#[test]
fn an_algorithm_of_the_list_is_watched_step_by_step() {
    let mut harness = harness();
    polygon(&mut harness);
    assert_eq!(figures(&harness).triangles, 10);
    let [at, all] = shown(&harness);
    assert!(at == all && all >= 10);
    for back in 1..=3 {
        press(&mut harness, "Step back");
        harness.run_steps(2);
        assert_eq!(shown(&harness), [all - back, all]);
    }
    press(&mut harness, "Step forward");
    assert_eq!(shown(&harness), [all - 2, all]);
    let script = document(&harness).script();
    assert!(script.ends_with(&format!("Watch {}\n", all - 2)), "{script}");
    let step = document(&harness).construction().expect("told").steps()[all - 3];
    assert!(harness.query_all_by_label_contains(step.note).count() > 0, "what the step does is told in words");
    enter(&mut harness, "Undo 4");
    assert_eq!(shown(&harness), [all, all]);
    // Another one of the list takes its place.
    choose(&mut harness, "monotone");
    let script = document(&harness).script();
    assert!(script.ends_with("Triangulate monotone\n") && !script.contains("ears"), "{script}");
}

#[test]
fn steps_play_by_themselves_and_end() {
    let mut harness = harness();
    polygon(&mut harness);
    let [_, all] = shown(&harness);
    let before = document(&harness).undoable();
    press(&mut harness, "Play steps");
    harness.get_by_role_and_label(Role::Button, "Stop");
    for _ in 0..3000 {
        harness.step();
        if harness.query_by_role_and_label(Role::Button, "Stop").is_none() {
            break;
        }
    }
    settle(&mut harness);
    assert_eq!(shown(&harness), [all, all]);
    assert_eq!(document(&harness).undoable(), before, "at the end all is as it was");
    // A frame is a quarter of a second here.
    press(&mut harness, "Play steps");
    harness.run_steps(2);
    press(&mut harness, "Stop");
    let [at, _] = shown(&harness);
    assert!(0 < at && at < all, "{at}");
    assert_eq!(document(&harness).undoable().0, before.0 + 1, "one command is left of it");
    harness.run_steps(20);
    assert_eq!(shown(&harness)[0], at);
}

#[test]
fn the_slider_leaves_one_command() {
    let mut harness = harness();
    polygon(&mut harness);
    let [_, all] = shown(&harness);
    enter(&mut harness, "Watch 1");
    harness.run_steps(2);
    let before = document(&harness).undoable().0;
    let slider = harness.get_by_role_and_label(Role::Slider, &format!("of {all} steps")).rect();
    let from = slider.left_center() + Vec2::new(10.0, 0.0);
    drag(&mut harness, from, from + Vec2::new(100.0, 0.0));
    let [at, _] = shown(&harness);
    assert!(1 < at && at < all, "{at} of {all}");
    assert_eq!(document(&harness).undoable().0, before + 1);
    enter(&mut harness, "Insert 0.5 0.5");
    harness.run_steps(2);
    assert!(harness.query_by_role_and_label(Role::Button, "Step back").is_none(), "nothing is told of it any more");
}
