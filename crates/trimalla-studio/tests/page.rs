//! The studio as a page has it: commands slice by slice, files in memory; without a display.

use eframe::egui::Vec2;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use trimalla_io::{Files, Memory};
use trimalla_studio::Studio;
use trimalla_workbench::{Document, Quiet, script};

fn harness(memory: &Memory) -> Harness<'static, Studio> {
    let studio = Studio::default().in_slices(Files::Memory(memory.clone()));
    Harness::builder()
        .with_size(Vec2::new(1200.0, 800.0))
        .build_ui_state(|ui, studio: &mut Studio| studio.show(ui), studio)
}

/// Shows frames until the commands are done; how many.
fn settle(harness: &mut Harness<'_, Studio>) -> usize {
    for frames in 0..10_000 {
        if harness.state().document().is_some() {
            harness.run_steps(2);
            return frames;
        }
        harness.run_steps(1);
    }
    panic!("the command does not end");
}

#[test]
fn a_script_leads_to_the_same_document_over_many_frames() {
    let text = "Generate polygon 40 3\nTriangulate\nSet max-area 0.000001\nRefine\nSelect 0 1 2\nV 0 0 0\nClear\n";
    let mut harness = harness(&Memory::default());
    harness.state_mut().run_script(text.to_owned());
    assert!(harness.state().document().is_none(), "it takes longer than a frame");
    assert!(settle(&mut harness) > 2);
    let mut whole = Document::new();
    let refused = script::run(&mut whole, text, false, &mut Quiet);
    assert_eq!(refused.len(), 1, "what comes after an error is not run");
    let document = harness.state().document().expect("at rest");
    assert_eq!(*document, whole);
    assert_eq!(document.script(), whole.script());
    harness.get_by_label_contains("below the bounds");
}

#[test]
fn a_refinement_is_cancelled_between_two_frames() {
    let mut harness = harness(&Memory::default());
    harness.state_mut().run_script("Generate random 3000 1\nTriangulate\nSet max-area 0.0000002\n".to_owned());
    settle(&mut harness);
    harness.get_by_role_and_label(Role::Button, "Refine").click();
    harness.run_steps(3);
    assert!(harness.state().document().is_none(), "it takes longer than three frames");
    harness.get_by_role_and_label(Role::Button, "Cancel").click();
    assert!(settle(&mut harness) <= 4, "it stops at once");
    harness.get_by_label_contains("cancelled; nothing has changed");
    let figures = harness.state().document().expect("at rest").figures();
    assert_eq!(figures.vertices, 3000);
}

#[test]
fn other_long_commands_go_on_between_frames_and_are_cancelled() {
    for (before, line) in [
        ("Clear", "Generate random 1000000 1"),
        ("Generate random 500000 1", "Triangulate"),
        ("Generate random 20000 1\nTriangulate", "LEPP 33"),
    ] {
        let mut harness = harness(&Memory::default());
        harness.state_mut().run_script(before.to_owned());
        settle(&mut harness);
        let figures = harness.state().document().expect("at rest").figures();
        harness.state_mut().enter(line);
        harness.run_steps(2);
        assert!(harness.state().document().is_none(), "{line} takes longer than two frames");
        harness.get_by_role_and_label(Role::Button, "Cancel").click();
        assert!(settle(&mut harness) <= 4, "{line} stops at once");
        assert_eq!(harness.state().document().expect("at rest").figures(), figures, "{line}");
        harness.state_mut().enter(line);
        assert!(settle(&mut harness) > 2, "{line}");
        assert_ne!(harness.state().document().expect("at rest").figures(), figures, "{line}");
    }
}

#[test]
fn files_are_opened_from_memory_and_exported_to_it() {
    let memory = Memory::default();
    memory.put("three.poly", "3 2 0 0\n0 0 0\n1 4 0\n2 0 3\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n");
    memory.put("run.tri", "Load three.poly\nTriangulate\nExport out.ele\n");
    let mut harness = harness(&memory);
    harness.state_mut().open("three.poly");
    settle(&mut harness);
    assert_eq!(harness.state().document().expect("at rest").figures().vertices, 3);
    harness.state_mut().open("run.tri");
    settle(&mut harness);
    assert_eq!(harness.state().document().expect("at rest").figures().triangles, 1);
    assert!(memory.get("out.node").is_some());
    harness.state_mut().open("nowhere.tri");
    harness.run_steps(2);
    harness.get_by_label_contains("nowhere.tri: no such file");
}

#[test]
fn the_menu_writes_what_led_here() {
    let memory = Memory::default();
    let mut harness = harness(&memory);
    harness.state_mut().run_script("Example star\nTriangulate\nRefine\n".to_owned());
    settle(&mut harness);
    for (entry, file) in
        [("Script: star.tri", "star.tri"), ("Picture: star.png", "star.png"), ("Player: star.html", "star.html")]
    {
        harness.get_by_role_and_label(Role::Button, "Write …").click();
        harness.run_steps(3);
        harness.get_by_role_and_label(Role::Button, entry).click();
        harness.run_steps(3);
        settle(&mut harness);
        assert!(memory.get(file).is_some_and(|content| !content.is_empty()), "{file}");
    }
    let script = memory.get("star.tri").expect("the script");
    assert_eq!(&*script, b"Example star\nTriangulate\nRefine\n");
}
