//! The pictures of docs/tour, each made by clicks and commands in a window that software draws, and compared with the
//! one that is kept.
//!
//! They need Mesa's software Vulkan, and are ignored where nobody asks for them:
//! `cargo test --test tour -- --ignored`; with `UPDATE_SNAPSHOTS=1` in the environment they are made anew.

use eframe::egui::accesskit::Role;
use eframe::egui::{self, Event, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable as _;
use egui_kittest::{Harness, SnapshotOptions};
use trimalla_studio::Studio;

/// A window on light ground.
fn window() -> Harness<'static, Studio> {
    let builder = Harness::builder().with_size(Vec2::new(1280.0, 800.0)).with_theme(egui::Theme::Light).wgpu();
    let mut harness = builder
        .build_eframe(|created| Studio::new(created.wgpu_render_state.as_ref().map(|state| state.target_format)));
    harness.run_steps(3);
    harness
}

/// A window after some commands.
fn after(commands: &str) -> Harness<'static, Studio> {
    let mut harness = window();
    harness.state_mut().enter(commands);
    settle(&mut harness);
    press(&mut harness, "Fit");
    harness
}

fn settle(harness: &mut Harness<'_, Studio>) {
    for _ in 0..3000 {
        harness.run_steps(2);
        if harness.state().document().is_some() {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    panic!("the command does not end");
}

fn press(harness: &mut Harness<'_, Studio>, name: &str) {
    harness.get_by_role_and_label(Role::Button, name).click();
    settle(harness);
}

/// Clicks into the drawing, at a place relative to its middle.
fn click(harness: &mut Harness<'_, Studio>, away: [f32; 2]) {
    let at: Pos2 = harness.get_by_label("Drawing").rect().center() + Vec2::from(away);
    for pressed in [true, false] {
        harness.event(Event::PointerMoved(at));
        let modifiers = Modifiers::NONE;
        harness.event(Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers });
        harness.run_steps(2);
    }
    settle(harness);
}

/// Compares with the picture that is kept; a few pixels may differ, as drivers round.
fn picture(mut harness: Harness<'_, Studio>, name: &str) {
    harness.run_steps(4);
    let kept = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/tour");
    let options = SnapshotOptions::new().output_path(kept).max_failed_pixels(4000);
    harness.snapshot_options(name, &options);
}

#[test]
#[ignore = "needs software Vulkan"]
fn the_welcome_page() {
    picture(window(), "welcome");
}

#[test]
#[ignore = "needs software Vulkan"]
fn a_drawing_that_was_loaded() {
    picture(after("Example guitar\nTriangulate"), "loaded");
}

#[test]
#[ignore = "needs software Vulkan"]
fn bad_triangles_and_the_circle_of_one() {
    let mut harness = after("Example plate\nTriangulate");
    click(&mut harness, [60.0, 40.0]);
    picture(harness, "bad-triangles");
}

#[test]
#[ignore = "needs software Vulkan"]
fn the_five_steps() {
    let mut harness = after("Example plate\nTriangulate\nSet preset lepp-centroid\nSet min-angle 33");
    harness.get_by_label("The five steps").click();
    harness.run_steps(10);
    picture(harness, "five-steps");
}

#[test]
#[ignore = "needs software Vulkan"]
fn a_step_and_the_row_that_drives() {
    let mut harness = after("Generate random 30 4\nTriangulate\nSet preset lepp-centroid");
    for _ in 0..4 {
        press(&mut harness, "Step");
    }
    picture(harness, "step");
}

#[test]
#[ignore = "needs software Vulkan"]
fn the_path_of_a_triangle() {
    let mut harness = after("Generate random 60 8\nTriangulate");
    click(&mut harness, [-120.0, 90.0]);
    for _ in 0..2 {
        press(&mut harness, "Next triangle");
    }
    picture(harness, "path");
}

/// Eight points around a segment from the left to the right.
const AROUND: &str = "V 0 0 2\nV 1 1 1.2\nV 2 1.4 2.7\nV 3 2 1\nV 4 2.3 2.9\nV 5 3 1.3\nV 6 3.3 2.6\nV 7 4.2 2\nV 8 2.1 0.2\nV 9 2 3.8\n\
                      Triangulate";

fn planned(calls: usize) -> Harness<'static, Studio> {
    let mut harness = after(AROUND);
    harness.state_mut().enter("Plan 0 7");
    settle(&mut harness);
    for _ in 0..calls {
        press(&mut harness, "Next call");
    }
    harness
}

#[test]
#[ignore = "needs software Vulkan"]
fn an_edge_and_what_it_crosses() {
    picture(planned(0), "edge-1-crossed");
}

#[test]
#[ignore = "needs software Vulkan"]
fn the_recursion_beside_an_edge() {
    picture(planned(2), "edge-2-recursion");
}

#[test]
#[ignore = "needs software Vulkan"]
fn an_edge_that_was_inserted() {
    let mut harness = planned(0);
    press(&mut harness, "Insert edge");
    picture(harness, "edge-3-inserted");
}

#[test]
#[ignore = "needs software Vulkan"]
fn a_path_among_constrained_edges() {
    let mut harness = after("Example plate\nTriangulate\nSet preset lepp-centroid\nSet min-angle 20\nRefine");
    click(&mut harness, [-60.0, -30.0]);
    press(&mut harness, "Show");
    harness.get_by_label("The five steps").click();
    harness.run_steps(10);
    picture(harness, "constrained-path");
}

#[test]
#[ignore = "needs software Vulkan"]
fn original_beside_refined() {
    let mut harness = after("Generate random 45 2\nTriangulate");
    press(&mut harness, "Compare");
    press(&mut harness, "Run all");
    for _ in 0..2000 {
        harness.step();
        if harness.query_by_role_and_label(Role::Button, "Cancel all").is_none() {
            break;
        }
    }
    picture(harness, "compare");
}

/// A polygon whose sweep has starts, a merge and a split.
const SWEPT: &str = "V 0 0 0\nV 1 6 0\nV 2 8 3\nV 3 5 2\nV 4 6 6\nV 5 3 3\nV 6 1 6\nV 7 2 2\nOuter 8 0 1 2 3 4 5 6 7";

#[test]
#[ignore = "needs software Vulkan"]
fn what_an_algorithm_has_told() {
    picture(after(&format!("{SWEPT}\nTriangulate seidel\nWatch 38")), "algorithm");
}

#[test]
#[ignore = "needs software Vulkan"]
fn a_lesson() {
    let mut harness = window();
    press(&mut harness, "Delaunay by flips");
    for _ in 0..4 {
        press(&mut harness, "Next scene");
    }
    picture(harness, "lesson");
}
