//! Running the program in a directory of its own.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A square with a diagonal, numbered from 1.
pub(crate) const SQUARE: &str = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 3\n0\n";

/// Two triangles of a unit square, as the files of a mesh.
pub(crate) const NODE: &str = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
pub(crate) const ELE: &str = "2 3 0\n1 1 2 3\n2 1 3 4\n";

/// A directory that vanishes with the test.
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    pub(crate) fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// A directory that holds the square.
    pub(crate) fn with_square(name: &str) -> Self {
        let scratch = Self::new(name);
        scratch.write("square.poly", SQUARE);
        scratch
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }

    /// Every file with its content.
    pub(crate) fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let entries = fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap());
        let files = entries.filter(|entry| entry.path().is_file());
        let named = files.map(|entry| {
            let name = entry.file_name().to_string_lossy().into_owned();
            (name, fs::read(entry.path()).unwrap())
        });
        named.collect()
    }

    /// The program with these arguments, to be run here.
    pub(crate) fn command<S: AsRef<OsStr>>(&self, args: impl IntoIterator<Item = S>) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_trimalla"));
        command.args(args).current_dir(&self.0).stdin(Stdio::null());
        command
    }

    /// Runs the program; the arguments are the words of a line.
    pub(crate) fn run(&self, line: &str) -> Run {
        Run::of(self.command(line.split_whitespace()).output().unwrap())
    }

    /// Runs the program with something on its standard input.
    pub(crate) fn run_with(&self, line: &str, input: &str) -> Run {
        let mut command = self.command(line.split_whitespace());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        Run::of(child.wait_with_output().unwrap())
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// How a run ended and what it said.
#[derive(Debug)]
pub(crate) struct Run {
    /// `None` if a signal ended it.
    pub(crate) status: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Run {
    pub(crate) fn of(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Self { status: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }

    /// Fails the test unless the run ended like this, and whatever it says, without a panic.
    #[track_caller]
    pub(crate) fn expect(self, status: i32) -> Self {
        assert_eq!(self.status, Some(status), "{self:#?}");
        assert!(!self.stderr.contains("panicked"), "{self:#?}");
        self
    }

    /// Fails the test unless standard error has this line.
    #[track_caller]
    pub(crate) fn says(self, line: &str) -> Self {
        assert!(self.stderr.lines().any(|l| l == line), "no line {line:?} in {self:#?}");
        self
    }

    /// The one JSON object on standard output.
    #[track_caller]
    pub(crate) fn json(&self) -> serde_json::Map<String, serde_json::Value> {
        assert_eq!(self.stdout.lines().count(), 1, "{self:#?}");
        match serde_json::from_str(&self.stdout).unwrap() {
            serde_json::Value::Object(object) => object,
            other => panic!("no object: {other}"),
        }
    }
}

/// Runs each line, which must end so, say this, and change no file.
#[track_caller]
pub(crate) fn refused(scratch: &Scratch, status: i32, words: &str, lines: &[&str]) {
    let before = scratch.files();
    for line in lines {
        let run = scratch.run(line).expect(status);
        assert!(run.stderr.contains(words), "{line}: {run:#?}");
        assert!(scratch.files() == before, "{line} has changed files");
    }
}
