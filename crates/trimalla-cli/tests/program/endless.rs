//! Files that are none: whatever is read is bounded, and its fault is named with status 3.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::symlink;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::common::{Run, Scratch};

/// Longer than a pipe is waited for.
const TIMEOUT: Duration = Duration::from_secs(25);

/// What reads a file called X of this name.
const READERS: [(&str, &str); 7] = [
    ("x.poly", "mesh x.poly"),
    ("x.ele", "refine x.ele"),
    ("x.poly", "mesh square --max-area 0.1 -o m.ele --recipe x.poly"),
    ("x.toml", "mesh square --recipe x.toml"),
    ("x.toml", "compare square --algorithms off-center --angles 20 --recipes x.toml"),
    ("x.csv", "compare square --algorithms off-center --angles 20 --baseline x.csv"),
    ("x.journal", "compare square --algorithms off-center --angles 20 --csv a.csv --resume x.journal"),
];

fn start(scratch: &Scratch, line: &str) -> Child {
    let mut command = scratch.command(line.split_whitespace());
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Waits for the end, and fails rather than waiting for ever.
fn end_of(mut child: Child, line: &str) -> Run {
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > TIMEOUT {
            child.kill().unwrap();
            panic!("it does not end: {line}");
        }
        sleep(Duration::from_millis(10));
    }
    Run::of(child.wait_with_output().unwrap())
}

/// Runs every reader on what `make` puts under the name that it reads; all at the same time.
fn all_refuse(name: &str, make: impl Fn(&Scratch, &str)) {
    let runs = READERS.iter().enumerate().map(|(i, (file, line))| {
        let scratch = Scratch::with_square(&format!("endless-{name}-{i}"));
        make(&scratch, file);
        let child = start(&scratch, line);
        (scratch, child, *line)
    });
    for (scratch, child, line) in runs.collect::<Vec<_>>() {
        let run = end_of(child, line).expect(3);
        assert!(run.stderr.starts_with("error: "), "{line}: {run:#?}");
        assert!(!scratch.path().join("a.csv").exists() && !scratch.path().join("m.ele").exists(), "{line}");
    }
}

#[test]
fn e10_a_device_of_endless_zeros() {
    all_refuse("zeros", |scratch, file| symlink("/dev/zero", scratch.path().join(file)).unwrap());
}

#[test]
fn e10_a_directory() {
    all_refuse("directory", |scratch, file| fs::create_dir(scratch.path().join(file)).unwrap());
}

#[test]
fn e10_a_link_to_itself() {
    all_refuse("loop", |scratch, file| symlink(file, scratch.path().join(file)).unwrap());
}

#[test]
fn e10_a_pipe_to_which_nobody_writes() {
    all_refuse("pipe", |scratch, file| {
        let made = Command::new("mkfifo").arg(scratch.path().join(file)).status().unwrap();
        assert!(made.success());
    });
}

#[test]
fn e10_a_recipe_through_a_pipe() {
    let scratch = Scratch::with_square("endless-writer");
    let pipe = scratch.path().join("x.toml");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let writer = std::thread::spawn(move || fs::write(pipe, "name = \"piped\"\n"));
    let run = scratch.run("mesh square --recipe x.toml").expect(0);
    assert!(run.stdout.contains("piped"), "{run:#?}");
    writer.join().unwrap().unwrap();
}

#[test]
fn e10_a_pipe_without_end() {
    let scratch = Scratch::with_square("endless-yes");
    let pipe = scratch.path().join("x.toml");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let mut writer =
        Command::new("sh").args(["-c", "exec yes '# text' >x.toml"]).current_dir(scratch.path()).spawn().unwrap();
    let line = "mesh square --recipe x.toml";
    let run = end_of(start(&scratch, line), line).expect(3);
    assert!(run.stderr.contains("longer than the 1048576 bytes"), "{run:#?}");
    writer.wait().unwrap();
}

#[test]
fn e10_a_file_that_grows_while_it_is_read() {
    let scratch = Scratch::with_square("endless-grows");
    scratch.write("x.poly", "# text\n".repeat(1 << 16));
    let grower = "while :; do cat square.poly square.poly square.poly square.poly; done >>x.poly";
    let mut grower =
        Command::new("sh").args(["-c", grower]).current_dir(scratch.path()).stderr(Stdio::null()).spawn().unwrap();
    sleep(Duration::from_millis(50));
    // It is read to the length that it had, and is at fault whether it grew meanwhile or not.
    for line in ["mesh x.poly", "mesh x.poly -o m.ele", "check x.poly"] {
        end_of(start(&scratch, line), line).expect(3);
    }
    grower.kill().unwrap();
    grower.wait().unwrap();
}

#[test]
fn e10_names_of_all_kinds() {
    let scratch = Scratch::with_square("endless-names");
    for name in ["new\nline", &"x".repeat(4096), "\u{1b}[31m"] {
        let run = Run::of(scratch.command(["mesh", &format!("{name}.poly")]).output().unwrap()).expect(3);
        assert!(!run.stderr.contains('\u{1b}') && run.stderr.lines().count() == 1, "{run:#?}");
        let run = Run::of(scratch.command(["mesh", "square", "--recipe", name]).output().unwrap()).expect(3);
        assert!(!run.stderr.contains('\u{1b}') && run.stderr.lines().count() == 1, "{run:#?}");
    }
    fs::write(scratch.path().join("new\nline.poly"), crate::common::SQUARE).unwrap();
    let written = scratch.command(["mesh", "new\nline", "-o", "out\nput.ele", "--trace", "tr\nace"]).output().unwrap();
    Run::of(written).expect(0);
    assert!(scratch.path().join("out\nput.poly").exists());
}
