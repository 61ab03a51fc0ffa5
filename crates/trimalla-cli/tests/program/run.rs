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
    scratch.write("own.tri", "V 0 0 0\nSave own.tri\n");
    assert!(scratch.run("run own.tri").expect(1).stderr.contains("was read"), "a script replaces itself");
    assert_eq!(scratch.read("own.tri"), "V 0 0 0\nSave own.tri\n");
    scratch.run("run nowhere.tri").expect(3);
    scratch.write("binary.tri", [0xff, 0xfe, 0x30]);
    scratch.run("run binary.tri").expect(3);
}

/// `TRIMALLA_KILLS` says how many times; a dozen where it does not.
#[cfg(unix)]
#[test]
fn a_script_that_is_killed_while_it_saves_leaves_a_whole_file() {
    use std::time::{Duration, Instant};

    let kills: u32 = std::env::var("TRIMALLA_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(12);
    let scratch = Scratch::new("run-killed");
    let vertices: String = (0..4000).map(|i| format!("V {i} {i} {}\n", i % 7)).collect();
    // Saved again and again, so that most moments are within a save.
    scratch.write("save.tri", format!("{vertices}{}", "Save d.tri\n".repeat(40)));
    let start = Instant::now();
    scratch.run("run save.tri -q").expect(0);
    let (whole, new) = (start.elapsed(), scratch.read("d.tri"));
    assert_eq!(new, vertices);
    let [mut old_left, mut new_left] = [0, 0];
    for kill in 0..kills {
        scratch.write("d.tri", "V 0 0 0\n");
        let mut child = scratch.command(["run", "save.tri", "-q"]).spawn().unwrap();
        std::thread::sleep(whole * (kill + 1) / (kills + 2) + Duration::from_micros(u64::from(kill) * 37 % 900));
        let _ = child.kill();
        child.wait().unwrap();
        match scratch.read("d.tri") {
            text if text == new => new_left += 1,
            text => {
                assert_eq!(text, "V 0 0 0\n", "half a document");
                old_left += 1;
            }
        }
    }
    eprintln!("{kills} kills: {old_left} left the old document, {new_left} the new one");
    scratch.run("run save.tri -q").expect(0);
    let left = std::fs::read_dir(scratch.path()).unwrap().map(|entry| entry.unwrap().file_name());
    let temporary: Vec<_> = left.filter(|name| name.to_string_lossy().starts_with(".trimalla-")).collect();
    assert!(temporary.is_empty(), "{temporary:?}");
}
