//! Nothing is destroyed: what is read, what is no regular file, and what another run has made.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::common::{ELE, NODE, Run, SQUARE, Scratch, refused};

#[test]
fn g03_traces_replace_nothing_that_is_read() {
    let scratch = Scratch::with_square("spared-trace");
    scratch.write("k.node", NODE);
    scratch.write("k.ele", ELE);
    scratch.write("k.poly", SQUARE);
    scratch.write("r.toml", "select = \"first\"\n");
    scratch.write("k.area", "2\n1 0.5\n2 0.5\n");
    fs::create_dir(scratch.path().join("sub")).unwrap();
    fs::hard_link(scratch.path().join("square.poly"), scratch.path().join("hard.poly")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("../square.poly", scratch.path().join("sub/soft")).unwrap();
    refused(
        &scratch,
        2,
        "would overwrite the input",
        &[
            "mesh square.poly --trace square.poly",
            "mesh square --trace ./sub/../square.poly",
            "mesh square.poly --trace hard.poly",
            "mesh hard.poly -o square.poly",
            #[cfg(unix)]
            "mesh square.poly --trace sub/soft",
            "refine k.ele --trace k.node",
            "refine k.ele --trace k.ele",
            "refine k.ele --trace k.area",
            "refine k.ele --trace k.poly",
            "refine k.ele -o k.poly",
            "refine k.ele --input square.poly --trace square.poly",
            "mesh square --recipe r.toml --trace r.toml",
            "mesh square --recipe r.toml --save-recipe r.toml",
            "mesh square --recipe r.toml -o ./r.toml --format svg",
        ],
    );
    refused(
        &scratch,
        2,
        "would overwrite one another",
        &[
            "mesh square -o a.svg --trace a.svg",
            "mesh square -o a.ele --trace a.node",
            "mesh square --save-recipe a.toml --trace ./a.toml",
            "mesh square --trace a --frames a",
        ],
    );
}

#[test]
fn g03_frames_replace_nothing_that_is_not_theirs() {
    let scratch = Scratch::with_square("spared-frames");
    for folder in ["full", "inputs", "empty"] {
        fs::create_dir(scratch.path().join(folder)).unwrap();
    }
    scratch.write("full/000001.svg", "a picture");
    scratch.write("full/holiday.jpg", "the beach");
    scratch.write("inputs/000001.svg", SQUARE);
    scratch.write("none.svg", "a file");
    let own = "the folder holds something else than pictures of steps: holiday.jpg";
    refused(&scratch, 4, own, &["mesh square --frames full"]);
    assert_eq!(scratch.read("full/000001.svg"), "a picture");
    refused(&scratch, 4, "not a directory", &["mesh square --frames none.svg"]);
    refused(&scratch, 4, "no such directory", &["mesh square --frames none/f", "mesh square --frames square.poly/f"]);
    refused(&scratch, 2, "holds a file that is read", &["mesh square --frames .", "mesh square.poly --frames .."]);
    refused(
        &scratch,
        2,
        "lies in the folder",
        &["mesh square --frames empty -o empty/a.svg", "mesh square --frames empty --trace empty/t"],
    );
    refused(&scratch, 2, "pictures need a folder", &["mesh square --frames -"]);
    // An empty folder, and one of an earlier run with more pictures, are replaced as a whole.
    let pictures = || fs::read_dir(scratch.path().join("empty")).unwrap().count();
    scratch.run("mesh square --max-area 0.02 --frames empty -q").expect(0);
    let many = pictures();
    scratch.run("mesh square --frames empty -q").expect(0);
    assert!(pictures() < many, "{many}");
    // The folder in which the program runs cannot be replaced.
    let mut command = Command::new(env!("CARGO_BIN_EXE_trimalla"));
    command.args(["mesh", "../square.poly", "--frames", "."]).current_dir(scratch.path().join("empty"));
    let run = Run::of(command.output().unwrap()).expect(4);
    assert!(run.stderr.contains("the folder is the current one, or around it"), "{run:#?}");
}

#[test]
fn traces_and_frames_appear_with_the_mesh_or_not_at_all() {
    let scratch = Scratch::with_square("spared-together");
    scratch.write("t.jsonl", "old trace");
    scratch.write("t.jsonl.part", "somebody's part");
    fs::create_dir(scratch.path().join("f")).unwrap();
    scratch.write("f/000001.svg", "old picture");
    let before = scratch.files();
    for line in [
        "mesh square --trace t.jsonl --frames f -o nowhere/a.svg",
        "mesh square --trace t.jsonl --frames f -o square.poly/a.svg",
        "mesh square --trace t.jsonl --frames f -o /dev/full --format svg",
        "mesh square --trace /dev/full --frames f -o a.svg",
    ] {
        if line.contains("/dev/full") && !Path::new("/dev/full").exists() {
            continue;
        }
        assert!([2, 4].contains(&scratch.run(line).status.unwrap()), "{line}");
        assert!(scratch.files() == before, "{line}");
        assert_eq!(scratch.read("f/000001.svg"), "old picture", "{line}");
        assert_eq!(fs::read_dir(scratch.path()).unwrap().count(), before.len() + 1, "{line}");
    }
    let run = scratch.run("mesh square --max-area 0.05 --trace t.jsonl --frames f -o a.svg").expect(0);
    assert!(run.stdout.contains("a.svg, t.jsonl, f"), "{run:#?}");
    let steps = scratch.read("t.jsonl").lines().count();
    assert_eq!(fs::read_dir(scratch.path().join("f")).unwrap().count(), steps);
    assert_eq!(scratch.read("t.jsonl.part"), "somebody's part");
}

#[test]
fn g04_a_trace_on_standard_output_is_alone_there() {
    let scratch = Scratch::with_square("spared-stdout");
    let run = scratch.run("mesh square --max-area 0.05 --trace -").expect(0);
    assert!(run.stdout.lines().all(|line| serde_json::from_str::<serde_json::Value>(line).is_ok()), "{run:#?}");
    assert!(run.stderr.contains("triangles"), "the report moves: {run:#?}");
    refused(
        &scratch,
        2,
        "standard output",
        &[
            "mesh square --trace - --json",
            "mesh square --trace - -o - --format svg",
            "mesh square --trace - --save-recipe -",
            "mesh square --trace - -o /dev/stdout --format svg",
        ],
    );
    assert_eq!(scratch.files().len(), 1);
    // A reader that goes away has had enough.
    let mut command = scratch.command("mesh square --max-area 1e-4 --trace - -o kept.svg".split(' '));
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let run = Run::of(child.wait_with_output().unwrap()).expect(0);
    assert!(!run.stderr.contains("error"), "{run:#?}");
    assert!(scratch.files().contains_key("kept.svg"));
}

#[cfg(unix)]
#[test]
fn g04_closed_streams_are_no_panic() {
    let scratch = Scratch::with_square("spared-closed");
    let program = env!("CARGO_BIN_EXE_trimalla");
    for line in [
        "mesh square.poly -o a.svg >&-",
        "mesh square.poly -o - --format svg >&-",
        "mesh square.poly -o a.svg <&- 2>&-",
    ] {
        let script = format!("exec {program} {line}");
        let run = Command::new("sh").args(["-c", &script]).current_dir(scratch.path()).output().unwrap();
        Run::of(run).expect(0);
    }
    assert_eq!(scratch.read("square.poly"), SQUARE);
    assert!(scratch.read("a.svg").ends_with("</svg>\n"));
}

#[cfg(unix)]
#[test]
fn g04_devices_pipes_links_and_read_only_files_stay_what_they_are() {
    use std::os::unix::fs::{FileTypeExt as _, PermissionsExt as _, symlink};
    let scratch = Scratch::with_square("spared-special");
    let at = |name: &str| scratch.path().join(name);
    scratch.write("real", "old");
    symlink("real", at("link")).unwrap();
    symlink("nothing-yet", at("dangling")).unwrap();
    symlink("/dev/null", at("null")).unwrap();
    scratch.write("locked", "locked");
    fs::set_permissions(at("locked"), fs::Permissions::from_mode(0o444)).unwrap();
    for option in ["--trace", "--save-recipe"] {
        for name in ["link", "dangling", "null"] {
            scratch.run(&format!("mesh square -q {option} {name}")).expect(0);
            assert!(fs::symlink_metadata(at(name)).unwrap().is_symlink(), "{option} {name}");
        }
        let run = scratch.run(&format!("mesh square {option} locked")).expect(4);
        assert!(run.stderr.contains("the file is read-only"), "{run:#?}");
        scratch.run(&format!("mesh square {option} .")).expect(4);
    }
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    assert_ne!(scratch.read("real"), "old");
    assert!(at("nothing-yet").is_file());
    assert_eq!(scratch.read("locked"), "locked");
    // A pipe is written directly.
    if Command::new("mkfifo").arg(at("pipe")).status().is_ok_and(|status| status.success()) {
        let reader = std::thread::spawn({
            let pipe = at("pipe");
            move || fs::read_to_string(pipe).unwrap()
        });
        scratch.run("mesh square -q --trace pipe").expect(0);
        assert!(reader.join().unwrap().contains("\"outcome\":\"finished\""));
        assert!(fs::metadata(at("pipe")).unwrap().file_type().is_fifo());
    }
}

#[cfg(unix)]
#[test]
fn g01_a_file_size_limit_and_a_full_device_leave_everything() {
    let scratch = Scratch::with_square("spared-limit");
    scratch.write("m.svg", "old picture");
    scratch.write("t", "old trace");
    let before = scratch.files();
    let program = env!("CARGO_BIN_EXE_trimalla");
    for line in [
        "mesh square.poly --max-area 0.0005 -o m.svg -o m.ele",
        "mesh square.poly --max-area 0.0005 --trace t -o m.ele",
        "mesh square.poly --max-area 0.0005 --frames f -o m.ele",
        "mesh square.poly --max-area 0.0005 -q --trace /dev/full -o m.ele",
    ] {
        // The shell ignores the signal that goes with the limit, and the program inherits that.
        let script = format!("trap '' XFSZ; ulimit -f 16 || exit 99; exec {program} {line}");
        let run = Command::new("sh").args(["-c", &script]).current_dir(scratch.path()).output().unwrap();
        if run.status.code() == Some(99) {
            eprintln!("skipped: no limit of file sizes here");
            return;
        }
        let run = Run::of(run).expect(4);
        assert!(run.stderr.contains("error: cannot write"), "{line}: {run:#?}");
        assert!(scratch.files() == before, "{line}");
        assert_eq!(fs::read_dir(scratch.path()).unwrap().count(), before.len(), "{line}");
    }
}

#[test]
fn g03_a_journal_replaces_nothing() {
    let scratch = Scratch::with_square("spared-journal");
    scratch.write("empty.toml", ""); // A recipe: the default one.
    scratch.write("data.json", "{\"a\": 1}"); // Not a torn line of a journal.
    let compare = "compare square.poly --algorithms off-center --angles 20 --no-times";
    refused(
        &scratch,
        2,
        "overwrite",
        &[
            &format!("{compare} --recipes empty.toml --resume empty.toml"),
            &format!("{compare} --csv a --resume a"),
            &format!("{compare} --csv a --json a.journal"),
        ],
    );
    scratch.write("bad.poly", "no drawing");
    refused(
        &scratch,
        2,
        "would overwrite the input",
        &["compare square.poly bad.poly --csv bad.poly", "compare square.poly bad --csv ./bad.poly"],
    );
    refused(&scratch, 3, "expected the outcome of a run", &[&format!("{compare} --csv a --resume data.json")]);
    // A folder of plots is made when there is something to put into it.
    scratch.run(&format!("{compare} --svg plots/of/square --csv nowhere/a.csv")).expect(4);
    assert!(!scratch.path().join("plots").exists());
    scratch.run(&format!("{compare} --svg plots/of/square")).expect(0);
    assert_eq!(fs::read_dir(scratch.path().join("plots/of/square")).unwrap().count(), 2);
}
