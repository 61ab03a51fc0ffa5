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

#[test]
fn captions_are_about_the_steps_that_are_shown() {
    use trimalla::trace::{Act, Shape};
    use trimalla_workbench::{Document, Quiet, script};

    for (title, shown, act, shape) in [
        ("Joining pairs", 6, Act::Refuse, Shape::Edge([0, 3])),
        ("Greedy", 20, Act::Refuse, Shape::Edge([4, 5])),
        ("Flips to the end", 12, Act::Add, Shape::Edge([0, 3])),
        ("Flips to the end", 23, Act::Add, Shape::Edge([5, 1])),
        ("Lifting to a paraboloid", 13, Act::Remove, Shape::Triangle([0, 3, 4])),
        ("Monotone pieces", 6, Act::Look, Shape::Vertex(7)),
        ("Monotone pieces", 13, Act::Add, Shape::Edge([5, 3])),
        ("Seidel's trapezoids", 39, Act::Add, Shape::Edge([7, 1])),
        ("Ears", 3, Act::Add, Shape::Triangle([1, 2, 3])),
        ("The art gallery", 51, Act::Add, Shape::Triangle([0, 7, 8])),
        ("The art gallery", 63, Act::Add, Shape::Vertex(1)),
    ] {
        let lesson = script::LEARN.iter().find(|lesson| lesson.title == title).expect("a lesson");
        let watched = format!("Watch {shown}");
        let lines: Vec<&str> = lesson.text.lines().take_while(|line| **line != watched).collect();
        assert!(lines.len() < lesson.text.lines().count(), "{title}: {watched}");
        let mut document = Document::new();
        assert_eq!(script::run(&mut document, &lines.join("\n"), false, &mut Quiet), []);
        let step = document.construction().expect("it is watched").steps()[shown - 1];
        assert_eq!((step.act, step.shape), (act, shape), "{title}: {watched}");
    }
}
