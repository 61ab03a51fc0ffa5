//! Which files the name on the command line stands for, and what the files of the result are called.
//!
//! ```text
//! object          object.poly       object.1.node, object.1.ele, …
//! object.1        object.1.poly     object.2.node, object.2.ele, …
//! object.poly     as object with -p
//! object.1.ele    as object.1 with -r
//! ```

use std::path::{Path, PathBuf};

use trimalla_triangle::Switches;

/// The stem of the files that are read, and that of the files that are written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Names {
    read: PathBuf,
    written: PathBuf,
}

impl Names {
    /// The names that a file on the command line stands for; its ending may ask for a switch.
    pub(super) fn of(file: &Path, switches: &mut Switches) -> Self {
        let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
        match ending.as_str() {
            "poly" => switches.drawing = true,
            "node" => {}
            "ele" => switches.refine = true,
            "area" => (switches.refine, switches.own_areas) = (true, true),
            _ => return Self::of_stem(file.to_owned(), switches),
        }
        Self::of_stem(file.with_extension(""), switches)
    }

    fn of_stem(read: PathBuf, switches: &Switches) -> Self {
        let written = if switches.no_iteration { read.clone() } else { next(&read) };
        Self { read, written }
    }

    /// A file that is read.
    pub(super) fn input(&self, ending: &str) -> PathBuf {
        with_ending(&self.read, ending)
    }

    /// A file that is written.
    pub(super) fn output(&self, ending: &str) -> PathBuf {
        with_ending(&self.written, ending)
    }
}

/// The stem with the iteration number one higher; 1 where there is none.
fn next(stem: &Path) -> PathBuf {
    let number = stem.extension().and_then(|number| number.to_str());
    let is_digits = |text: &&str| text.bytes().all(|byte| byte.is_ascii_digit());
    match number.filter(is_digits).and_then(|number| number.parse::<u32>().ok()?.checked_add(1)) {
        Some(next) => stem.with_extension(next.to_string()),
        None => with_ending(stem, "1"),
    }
}

/// The path with a dot and an ending behind it, whatever it ends in.
fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn assert_written(file: &str, switches: &str, read: &str, written: &str) {
        let names = Names::of(Path::new(file), &mut Switches::parse(switches).unwrap());
        assert_eq!([names.input("node"), names.output("ele")], [read, written].map(PathBuf::from));
    }

    #[test]
    fn numbers_count_up() {
        assert_written("dots", "", "dots.node", "dots.1.ele");
        assert_written("in/dots.9.node", "", "in/dots.9.node", "in/dots.10.ele");
        assert_written("object.1", "pe", "object.1.node", "object.2.ele");
        assert_written("v1.2b", "", "v1.2b.node", "v1.2b.1.ele");
        assert_written("x.4294967295", "", "x.4294967295.node", "x.4294967295.1.ele");
        assert_written("box.poly", "I", "box.node", "box.ele");
        assert_written("up/../x", "", "up/../x.node", "up/../x.1.ele");
    }

    #[test]
    fn endings_ask_for_switches() {
        let mut switches = Switches::default();
        Names::of(Path::new("a.poly"), &mut switches);
        assert!(switches.drawing && !switches.refine);
        Names::of(Path::new("a.1.area"), &mut switches);
        assert!(switches.refine && switches.own_areas);
    }
}
