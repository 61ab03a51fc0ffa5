//! `trimalla run`.

use crate::common::Scratch;

const TRIANGLE: &str = "V 0 0 0\nV 1 4 0\nV 2 0 3\nTriangulate\n";

#[test]
fn commands_come_from_a_file_or_from_standard_input() {
    let scratch = Scratch::new("run");
    scratch.write("t.tri", format!("# a triangle\n{TRIANGLE}Show 0\n"));
    let shown = scratch.run("run t.tri").expect(0).stdout;
    assert_eq!(shown, "1 triangles\nvertex 0 at (0, 0)\nneighbours: 1 2\n");
    assert_eq!(scratch.run("run t.tri --quiet").expect(0).stdout, "");
    let echoed = scratch.run("run t.tri --echo").expect(0).stdout;
    assert!(echoed.starts_with("> V 0 0 0\n> V 1 4 0\n"), "{echoed}");
    let piped = scratch.run_with("run -", TRIANGLE).expect(0).stdout;
    assert_eq!(piped, "1 triangles\n");
}

#[test]
fn a_refused_command_is_shown_with_its_line_and_ends_the_script() {
    let scratch = Scratch::new("run-refused");
    scratch.write("bad.tri", "V 0 0 0\nV 1 0 nan\nV 2 1 1\nSave left.tri\n");
    let refused = scratch.run("run bad.tri").expect(1).stderr;
    assert!(refused.contains("bad.tri:2:7") && refused.contains("a finite number, found 'nan'"), "{refused}");
    assert!(refused.contains("2 │ V 1 0 nan"), "{refused}");
    assert!(!scratch.path().join("left.tri").exists(), "the script went on");
    scratch.write("bad.tri", "V 0 0 0\nNonsense\nV 1 1\nV 1 1 1\nSave left.tri\n");
    let refused = scratch.run("run bad.tri --keep-going").expect(1).stderr;
    assert!(refused.contains("bad.tri:2:1") && refused.contains("bad.tri:3:5"), "{refused}");
    assert_eq!(scratch.read("left.tri"), "V 0 0 0\nV 1 1 1\n");
    scratch.run("run nowhere.tri").expect(3);
    scratch.write("binary.tri", [0xff, 0xfe, 0x30]);
    scratch.run("run binary.tri").expect(3);
}
