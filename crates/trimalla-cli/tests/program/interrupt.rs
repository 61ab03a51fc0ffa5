//! Ctrl-C.
#![cfg(unix)]

use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::common::{Run, Scratch};

const TIMEOUT: Duration = Duration::from_secs(20);

fn start(scratch: &Scratch, line: &str, stdin: Stdio) -> Child {
    let mut command = scratch.command(line.split_whitespace());
    command.stdin(stdin).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().unwrap()
}

fn interrupt(child: &Child) {
    let status = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(status.unwrap().success());
}

/// Waits for the end, and fails rather than waiting for ever.
fn end_of(mut child: Child) -> Run {
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > TIMEOUT {
            child.kill().unwrap();
            panic!("the program does not end on Ctrl-C");
        }
        sleep(Duration::from_millis(10));
    }
    Run::of(child.wait_with_output().unwrap())
}

#[test]
fn while_reading_it_ends_at_once() {
    let scratch = Scratch::new("interrupt-reading");
    let child = start(&scratch, "mesh - -o out.ele", Stdio::piped()); // Nothing ever comes.
    sleep(Duration::from_millis(500));
    interrupt(&child);
    end_of(child).expect(130).says("error: interrupted; no file was changed");
    assert!(scratch.files().is_empty());
}

#[test]
fn while_refining_it_cancels_and_touches_no_file() {
    let scratch = Scratch::with_square("interrupt-refining");
    scratch.write("out.ele", "old triangles");
    scratch.write("out.svg", "old picture");
    let before = scratch.files();
    let line = "mesh square.poly --max-area 1e-9 --max-vertices 50000000 -o out.ele -o out.svg --trace t.jsonl --json";
    let mut child = start(&scratch, line, Stdio::null());
    sleep(Duration::from_millis(700));
    if child.try_wait().unwrap().is_some() {
        eprintln!("skipped: nothing refines yet");
        return;
    }
    interrupt(&child);
    let run = end_of(child).expect(130).says("error: interrupted; no file was changed");
    assert_eq!(run.stdout, "");
    assert_eq!(scratch.files(), before);
}

#[test]
fn twice_ends_it_without_waiting() {
    let scratch = Scratch::with_square("interrupt-twice");
    let line = "mesh square.poly --max-area 1e-9 --max-vertices 50000000 -o out.ele";
    let mut child = start(&scratch, line, Stdio::null());
    sleep(Duration::from_millis(700));
    if child.try_wait().unwrap().is_some() {
        eprintln!("skipped: nothing refines yet");
        return;
    }
    interrupt(&child);
    interrupt(&child);
    end_of(child).expect(130);
    assert_eq!(scratch.files().len(), 1);
}
