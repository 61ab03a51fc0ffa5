//! File dialogs: what they are asked for, and what comes of each answer. The window that shows them is not here.

use std::path::{Path, PathBuf};

use trimalla_studio::dialog::{Answer, Purpose, Wish};

use super::*;

/// A window that has dialogs, with a triangle; and a folder that is empty.
fn with_dialogs(folder: &str) -> (Harness<'static, Studio>, PathBuf) {
    let folder = std::env::temp_dir().join(format!("trimalla-studio-{folder}-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let mut harness = Harness::builder()
        .with_size(Vec2::new(1200.0, 800.0))
        .build_ui_state(|ui, studio: &mut Studio| studio.show(ui), Studio::default().with_dialogs());
    press(&mut harness, "Draw");
    for line in ["V 0 0 0", "V 1 4 0", "V 2 0 3", "Triangulate"] {
        enter(&mut harness, line);
    }
    (harness, folder)
}

/// Chooses from 'Write …'; the dialog that is to be opened.
fn write(harness: &mut Harness<'_, Studio>, kind: &str) -> Option<Wish> {
    harness.get_by_role_and_label(Role::Button, "Write …").click();
    harness.run_steps(4);
    harness.get_all_by_label_contains(&format!("{kind}: ")).next().expect("it is in the menu").click();
    harness.run_steps(4);
    settle(harness);
    harness.state_mut().take_wish()
}

fn answer(harness: &mut Harness<'_, Studio>, wish: Wish, answer: Answer) {
    harness.state_mut().answer(wish, answer);
    settle(harness);
    harness.run_steps(2);
}

fn says(harness: &Harness<'_, Studio>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).count() > 0
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn everything_that_is_written_can_be_given_a_place() {
    let (mut harness, folder) = with_dialogs("write");
    for (kind, chosen, wanted) in [
        ("Picture", "a", "a.svg"),
        ("Mesh", "b.ele", "b.ele"),
        ("Script", "c", "c.tri"),
        ("Recipe", "d", "d.toml"),
        ("Player", "e", "e.html"),
    ] {
        if kind == "Player" {
            // A player needs steps.
            enter(&mut harness, "Step");
        }
        let wish = write(&mut harness, kind).expect("a dialog");
        let Purpose::Write { name, ending, .. } = &wish.purpose else { panic!("{wish:?}") };
        assert!(name.ends_with(ending) && wanted.ends_with(ending) && !name.contains('/'), "{wish:?}");
        assert_eq!(wish.kinds[0].1, [&ending[1..]], "{wish:?}");
        assert!(!folder.join(wanted).exists());
        answer(&mut harness, wish, Answer::Chosen(folder.join(chosen)));
        assert!(folder.join(wanted).exists(), "{kind}: {:?}", names(&folder));
        assert!(says(&harness, &format!("it is in {}", folder.join(wanted).display())));
    }
    std::fs::remove_dir_all(&folder).expect("removed");
}

#[test]
fn a_dialog_that_is_closed_writes_nothing() {
    let (mut harness, folder) = with_dialogs("closed");
    let before = document(&harness).script();
    let wish = write(&mut harness, "Picture").expect("a dialog");
    answer(&mut harness, wish, Answer::Closed);
    press(&mut harness, "Browse …");
    let wish = harness.state_mut().take_wish().expect("a dialog");
    answer(&mut harness, wish, Answer::Closed);
    assert_eq!((names(&folder), document(&harness).script()), (vec![], before));
    assert!(!says(&harness, "it is in ") && !says(&harness, "no file dialog"));
    std::fs::remove_dir_all(&folder).expect("removed");
}

#[test]
fn without_a_dialog_files_get_the_name_that_is_shown() {
    let (mut harness, folder) = with_dialogs("none");
    harness.get_by_role_and_label(Role::TextInput, "File").focus();
    harness.run_steps(2);
    let stem = folder.join("shape.poly");
    harness.get_by_role_and_label(Role::TextInput, "File").type_text(&stem.to_string_lossy());
    harness.run_steps(2);
    let wish = write(&mut harness, "Picture").expect("a dialog");
    assert_eq!(wish.folder.as_deref(), Some(&*folder));
    answer(&mut harness, wish, Answer::Impossible);
    assert_eq!(names(&folder), ["shape.1.svg"]);
    assert!(says(&harness, "no file dialog can be shown here"));
    press(&mut harness, "Browse …");
    let wish = harness.state_mut().take_wish().expect("a dialog");
    answer(&mut harness, wish, Answer::Impossible);
    assert!(says(&harness, "type a path into 'File'"));
    std::fs::remove_dir_all(&folder).expect("removed");
}

#[test]
fn what_is_chosen_is_opened() {
    let (mut harness, folder) = with_dialogs("open");
    let drawing = folder.join("square.poly");
    std::fs::write(&drawing, "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n")
        .expect("written");
    let recipe = folder.join("fine.toml");
    press(&mut harness, "Browse …");
    let wish = harness.state_mut().take_wish().expect("a dialog");
    assert_eq!(wish.purpose, Purpose::Open);
    for ending in ["poly", "node", "ele", "mesh", "soup", "txt", "tri", "toml"] {
        assert!(wish.kinds[0].1.iter().any(|other| other == ending), "{ending}");
    }
    answer(&mut harness, wish, Answer::Chosen(drawing));
    assert_eq!(figures(&harness).vertices, 4);
    enter(&mut harness, "Set min-angle 27");
    let wish = write(&mut harness, "Recipe").expect("a dialog");
    answer(&mut harness, wish, Answer::Chosen(recipe.clone()));
    enter(&mut harness, "Set min-angle 12");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run_steps(2);
    let wish = harness.state_mut().take_wish().expect("a dialog by its key");
    assert_eq!(wish.folder.as_deref(), Some(&*folder), "beside the last file");
    answer(&mut harness, wish, Answer::Chosen(recipe));
    assert_eq!(document(&harness).options().min_angle_deg, Some(27.0));
    std::fs::remove_dir_all(&folder).expect("removed");
}

#[test]
fn a_studio_without_dialogs_asks_for_none() {
    let mut harness = harness();
    enter(&mut harness, "V 0 0 0");
    assert!(harness.query_by_label("Browse …").is_none());
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    press(&mut harness, "Open");
    harness.run_steps(2);
    assert_eq!(harness.state_mut().take_wish(), None);
}
