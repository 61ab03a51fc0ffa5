//! The welcome page and lessons.

use super::*;

#[test]
fn a_shape_of_the_welcome_page_is_triangulated_and_refined() {
    let mut harness = welcome();
    press(&mut harness, "key");
    assert_eq!(figures(&harness).triangles, 213);
    press(&mut harness, "Refine");
    assert!(figures(&harness).min_angle_deg >= 30.0);
}

#[test]
fn every_lesson_plays_to_its_end_and_back() {
    for lesson in trimalla_workbench::script::LEARN {
        let mut harness = welcome();
        press(&mut harness, lesson.title);
        let scenes = trimalla_workbench::script::scenes(lesson.text);
        for shown in 1..=scenes.len() {
            harness.get_by_label(&format!("{shown} of {}", scenes.len()));
            if shown < scenes.len() {
                press(&mut harness, "Next scene");
            }
        }
        let mut whole = trimalla_workbench::Document::new();
        let refused = trimalla_workbench::script::run(&mut whole, lesson.text, false, &mut trimalla_workbench::Quiet);
        assert_eq!(refused, []);
        assert_eq!(*document(&harness), whole, "{}", lesson.title);
        for shown in (0..scenes.len()).rev() {
            press(&mut harness, "Previous scene");
            harness.get_by_label(&format!("{shown} of {}", scenes.len()));
        }
        assert_eq!(document(&harness).undoable().0, 0, "{}", lesson.title);
        press(&mut harness, "End lesson");
        assert!(harness.query_by_role_and_label(Role::Button, "Next scene").is_none());
    }
}

#[test]
fn a_lesson_plays_by_itself() {
    let mut harness = welcome();
    press(&mut harness, "Delaunay by flips");
    harness.get_by_role_and_label(Role::Button, "Play lesson").click();
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::Button, "Pause lesson");
    for _ in 0..3000 {
        harness.step();
        if harness.query_by_role_and_label(Role::Button, "Pause lesson").is_none()
            && harness.state().document().is_some()
        {
            break;
        }
    }
    assert!(document(&harness).script().contains("Flip"));
}
