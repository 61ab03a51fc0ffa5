//! Runs that are killed while they save: files are whole, groups are whole after the next run, and nothing is left
//! behind.
//!
//! `scripts/kills.sh` runs the first test with more kills.
#![cfg(unix)]

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::common::{Run, Scratch};

/// Everything that a run can write, in two directories.
const OUTPUTS: &str =
    "-o m.ele -o m.svg -o sub/m.vtu --save-recipe r.toml --trace t.jsonl --frames f --player p.html -q";

/// Files by name, those in folders too.
type State = BTreeMap<String, Vec<u8>>;

fn line(area: &str) -> String {
    format!("mesh square.poly --max-area {area} {OUTPUTS}")
}

/// A directory with the drawing and the other directory.
fn scene(name: &str) -> Scratch {
    let scratch = Scratch::with_square(name);
    fs::create_dir(scratch.path().join("sub")).unwrap();
    scratch
}

fn state(directory: &Path) -> State {
    let mut state = State::new();
    for entry in fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_name().unwrap().to_string_lossy().into_owned();
        if !entry.is_dir() {
            state.insert(name, fs::read(&entry).unwrap());
        } else if !name.starts_with('.') {
            state.extend(self::state(&entry).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            state.insert(format!("{name}/"), Vec::new());
        }
    }
    state
}

fn is_temporary(name: &str) -> bool {
    name.split('/').any(|part| part.starts_with(".trimalla-"))
}

/// What was found after kills.
#[derive(Debug, Default)]
struct Tally {
    done: usize,
    old: usize,
    new: usize,
    mixed: usize,
    with_temporaries: usize,
    completed: usize,
}

impl Tally {
    /// Looks at the files right after a kill: each is whole.
    fn look(&mut self, found: &State, old: &State, new: &State) {
        self.with_temporaries += usize::from(found.keys().any(|name| is_temporary(name)));
        let kept: State = found.clone().into_iter().filter(|(name, _)| !is_temporary(name)).collect();
        for (name, bytes) in &kept {
            let is_whole = [old, new].iter().any(|state| state.get(name) == Some(bytes));
            assert!(is_whole, "half a file: {name}");
        }
        match (kept == *old, kept == *new) {
            (true, _) => self.old += 1,
            (_, true) => self.new += 1,
            _ => self.mixed += 1,
        }
    }
}

/// Xorshift: the moments of the kills are the same in each run of the test.
struct Moments(u64);

impl Moments {
    fn next(&mut self, until: Duration) -> Duration {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        let nanoseconds = u64::try_from(until.as_nanos()).unwrap().max(1);
        Duration::from_nanos(self.0 % nanoseconds)
    }
}

fn start(scratch: &Scratch, line: &str) -> Child {
    let mut command = scratch.command(line.split_whitespace());
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// Completes what is left, by a run that writes other files into both directories.
fn next_run(scratch: &Scratch) -> Run {
    let run = scratch.run("mesh square.poly -o other.poly -o sub/other.poly").expect(0);
    for other in ["other.poly", "sub/other.poly"] {
        fs::remove_file(scratch.path().join(other)).unwrap();
    }
    run
}

#[test]
fn g02_killed_at_random_moments_nothing_is_half_and_nothing_stays() {
    let kills: usize = env::var("TRIMALLA_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(24);
    let scratch = scene("kills");
    let areas = ["0.02", "0.013"];
    let mut took = Duration::ZERO;
    let states = areas.map(|area| {
        let start = Instant::now();
        scratch.run(&line(area)).expect(0);
        took = took.max(start.elapsed());
        state(scratch.path())
    });
    assert_ne!(states[0], states[1]);
    let (mut moments, mut tally, mut now) = (Moments(0x9e37_79b9_7f4a_7c15), Tally::default(), 1);
    for _ in 0..kills {
        let next = 1 - now;
        let mut child = start(&scratch, &line(areas[next]));
        sleep(moments.next(took));
        tally.done += usize::from(child.try_wait().unwrap().is_some());
        let _ = child.kill();
        child.wait().unwrap();
        tally.look(&state(scratch.path()), &states[now], &states[next]);
        tally.completed += usize::from(next_run(&scratch).stderr.contains("all are there now"));
        let after = state(scratch.path());
        assert!(!after.keys().any(|name| is_temporary(name)), "{:?}", after.keys());
        now = usize::from(after == states[1]);
        assert!(after == states[now], "mixed after the next run");
    }
    eprintln!("{kills} kills: {tally:?}");
}

/// Kills the program as it enters each system call that changes a directory.
#[test]
fn g02_killed_at_each_system_call_nothing_is_half_and_nothing_stays() {
    let scratch = scene("kills-calls");
    let traced = |inject: &str, line: &str| {
        let mut command = Command::new("strace");
        command.args(["-f", "-qq", "-o", "/dev/null", "-e", &format!("inject={inject}")]);
        command.arg(env!("CARGO_BIN_EXE_trimalla")).args(line.split_whitespace()).current_dir(scratch.path());
        command.stdout(Stdio::null()).stderr(Stdio::null()).status()
    };
    let areas = ["0.2", "0.1"]; // Few pictures, as each is a call.
    let states = areas.map(|area| {
        scratch.run(&line(area)).expect(0);
        state(scratch.path())
    });
    let can_trace = traced("fsync:delay_enter=1:when=1", &line(areas[1])).is_ok_and(|status| status.success());
    if !can_trace {
        eprintln!("skipped: no strace that may trace here");
        return;
    }
    let mut calls = vec!["?rename,?renameat,?renameat2"];
    if env::var("TRIMALLA_KILLS").is_ok() {
        calls.extend(["?link,?linkat", "?unlink,?unlinkat", "?rmdir", "?mkdir,?mkdirat"]);
        calls.extend(["fdatasync", "fsync", "flock", "write", "?chmod,fchmod,?fchmodat"]);
    }
    let (mut tally, mut now, mut kills) = (Tally::default(), 1, 0);
    for call in calls {
        for number in 1.. {
            let next = 1 - now;
            let status = traced(&format!("{call}:signal=KILL:when={number}"), &line(areas[next])).unwrap();
            tally.look(&state(scratch.path()), &states[now], &states[next]);
            tally.completed += usize::from(next_run(&scratch).stderr.contains("all are there now"));
            let after = state(scratch.path());
            assert!(!after.keys().any(|name| is_temporary(name)), "{call} {number}: {:?}", after.keys());
            now = usize::from(after == states[1]);
            assert!(after == states[now], "{call} {number}: mixed after the next run");
            if status.success() {
                break; // There are not so many of these calls.
            }
            kills += 1;
            assert!(number < 1000, "each {call} ends the run");
        }
    }
    eprintln!("{kills} kills at system calls: {tally:?}");
    assert!(tally.completed > 5, "{tally:?}");
    assert!(tally.mixed > 0, "a kill between two renames leaves a mixture until the next run: {tally:?}");
}

#[test]
fn g05_two_runs_at_a_time_leave_the_files_of_one_of_them() {
    let scratch = scene("kills-two");
    let areas = ["0.2", "0.1"];
    let states = areas.map(|area| {
        scratch.run(&line(area)).expect(0);
        state(scratch.path())
    });
    for _ in 0..10 {
        let children = [0, 1, 0, 1].map(|i| start(&scratch, &line(areas[i])));
        for mut child in children {
            assert!(child.wait().unwrap().success());
        }
        let after = state(scratch.path());
        assert!(states.contains(&after), "{:?}", after.keys());
    }
}

#[test]
fn g05_what_belongs_to_a_living_run_is_left_alone() {
    let scratch = scene("kills-living");
    let mut child = scratch
        .command("mesh square.poly --max-area 1e-9 --max-vertices 50000000 -o out.ele --trace t.jsonl".split(' '))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let temporaries = || state(scratch.path()).keys().filter(|name| is_temporary(name)).count();
    let start = Instant::now();
    while temporaries() < 2 && start.elapsed() < Duration::from_secs(20) {
        sleep(Duration::from_millis(5));
    }
    let run = scratch.run("mesh square.poly -o other.poly").expect(0);
    assert_eq!((temporaries(), run.stderr.as_str()), (2, ""));
    assert!(child.try_wait().unwrap().is_none(), "it ended too early to be a test");
    child.kill().unwrap();
    child.wait().unwrap();
    let run = scratch.run("mesh square.poly -o other.poly").expect(0);
    assert!(run.stderr.contains(": removed 1 temporary file of a run that was killed"), "{run:#?}");
    assert_eq!(temporaries(), 0);
    assert_eq!(scratch.files().keys().collect::<Vec<_>>(), ["other.poly", "square.poly"]);
}

#[test]
fn g06_out_of_memory_leaves_old_files_and_the_next_run_clears() {
    let scratch = scene("kills-memory");
    scratch.write("out.ele", "old triangles");
    let program = env!("CARGO_BIN_EXE_trimalla");
    let line = "mesh square.poly --max-area 1e-8 --max-vertices 50000000 -o out.ele";
    let script = format!("ulimit -c 0; ulimit -v 150000 || exit 99; exec {program} {line}");
    let run = Command::new("sh").args(["-c", &script]).current_dir(scratch.path()).env("RUST_BACKTRACE", "0").output();
    let run = run.unwrap();
    if run.status.code() == Some(99) {
        eprintln!("skipped: no limit of memory here");
        return;
    }
    assert!(!run.status.success(), "{run:?}");
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    assert!(said.contains("memory allocation of"), "{said}");
    assert_eq!(scratch.read("out.ele"), "old triangles");
    scratch.run("mesh square.poly -o other.poly").expect(0);
    assert_eq!(scratch.files().keys().collect::<Vec<_>>(), ["other.poly", "out.ele", "square.poly"]);
}
