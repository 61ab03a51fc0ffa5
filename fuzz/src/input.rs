//! What a target is given, as one readable file.
//!
//! A drawing is kept as a `.poly` file whose comments hold the rest:
//!
//! ```text
//! # fuzz refine
//! # domain nesting split incremental
//! # more 17
//! # cancel 40
//! # edit insert 0.5 0.25
//! # recipe preset = "off-center"
//! 3 2 0 0
//! ```
//! A file for the readers is kept as it is, after a line such as `# fuzz readers poly`.

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use trimalla::DomainOptions;
use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::refine::NamedOptions;
use trimalla_io::{poly, recipe};
use trimalla_testkit::generators::SplitMix64;

use crate::draws::Draws;

/// A change of a triangulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit {
    /// A point goes in.
    Insert(Point),
    /// A vertex goes out.
    Remove(u32),
    /// A vertex moves.
    Move(u32, Point),
    /// A segment goes in.
    InsertSegment(u32, u32),
    /// A segment goes out.
    RemoveSegment(u32),
    /// A vertex between two subsegments goes out.
    Merge(u32),
    /// The last so many edits are taken back.
    Rollback(u32),
}

/// A drawing and everything that is done with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The drawing.
    pub drawing: Pslg,
    /// How it is read.
    pub domain: DomainOptions,
    /// How it is refined.
    pub recipe: NamedOptions,
    /// The step at which the observer cancels.
    pub cancel: Option<u64>,
    /// Changes.
    pub edits: Vec<Edit>,
    /// Decides what else a target has to choose.
    pub more: u64,
}

/// A file in a format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileCase {
    /// The format.
    pub format: &'static str,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// What a target is given.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// A drawing and more.
    Drawing(Box<Case>),
    /// A file.
    File(FileCase),
}

impl Input {
    /// How large it is, for whoever looks for the smallest.
    #[must_use]
    pub fn size(&self) -> usize {
        match self {
            Self::Drawing(case) => case.drawing.points.len() + case.drawing.segments.len() + case.edits.len(),
            Self::File(file) => file.bytes.len(),
        }
    }

    /// The bytes of its file.
    #[must_use]
    pub fn to_bytes(&self, target: &str) -> Vec<u8> {
        match self {
            Self::Drawing(case) => case.to_text(target),
            Self::File(file) => [format!("# fuzz {target} {}\n", file.format).as_bytes(), &file.bytes].concat(),
        }
    }

    /// The input that bytes written by [`to_bytes`](Self::to_bytes) say, and its target; any `.poly` file is a drawing,
    /// without a target. `formats` are those of files.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub fn of_bytes(bytes: &[u8], formats: &[&'static str]) -> Result<(Self, Option<String>), String> {
        let end = bytes.iter().position(|b| *b == b'\n').unwrap_or(bytes.len());
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        if let ["#", "fuzz", target, format] = head.split(' ').collect::<Vec<_>>()[..] {
            let format = formats.iter().find(|f| **f == format).ok_or(format!("no format is called '{format}'"))?;
            let bytes = bytes.get(end + 1..).unwrap_or_default().to_vec();
            return Ok((Self::File(FileCase { format, bytes }), Some(target.to_owned())));
        }
        let (case, target) = Case::of_text(bytes)?;
        Ok((Self::Drawing(Box::new(case)), target))
    }

    /// Writes `<folder>/<name>.<target>.poly`, or `<folder>/<name>.<target>.input` for a file.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn save(&self, folder: &Path, name: &str, target: &str) -> io::Result<PathBuf> {
        let ending = if matches!(self, Self::Drawing(_)) { "poly" } else { "input" };
        let path = folder.join(format!("{name}.{target}.{ending}"));
        fs::create_dir_all(folder)?;
        fs::write(&path, self.to_bytes(target))?;
        Ok(path)
    }

    /// Reads such a file.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub fn load(path: &Path, formats: &[&'static str]) -> Result<(Self, Option<String>), String> {
        let bytes = fs::read(path).map_err(|e| format!("{}: {e}", path.display()))?;
        Self::of_bytes(&bytes, formats).map_err(|e| format!("{}: {e}", path.display()))
    }
}

impl Case {
    /// A drawing with everything else at its default.
    #[must_use]
    pub fn of(drawing: Pslg) -> Self {
        let (domain, recipe) = (DomainOptions::default(), NamedOptions::default());
        Self { drawing, domain, recipe, cancel: None, edits: Vec::new(), more: 0 }
    }

    /// Draws for what a case leaves open.
    #[must_use]
    pub fn draws(more: u64) -> Draws<'static> {
        let mut mixed = SplitMix64::new(more);
        Draws::seeded(mixed.next_u64())
    }

    fn to_text(&self, target: &str) -> Vec<u8> {
        let mut head = format!("# fuzz {target}\n");
        let DomainOptions { rule, crossings, algorithm } = self.domain;
        let crossings = if crossings == Crossings::Split { "split" } else { "refuse" };
        let _ = writeln!(head, "# domain {} {crossings} {}", rule.key(), algorithm.key());
        let _ = writeln!(head, "# more {}", self.more);
        if let Some(step) = self.cancel {
            let _ = writeln!(head, "# cancel {step}");
        }
        self.edits.iter().for_each(|edit| {
            let _ = writeln!(head, "# edit {}", edit.to_text());
        });
        let plain = lines_of(&self.recipe.preset.map(NamedOptions::of).unwrap_or_default());
        let told = |line: &String| line.starts_with("preset") || !plain.contains(line);
        lines_of(&self.recipe).iter().filter(|l| told(l)).for_each(|line| {
            let _ = writeln!(head, "# recipe {line}");
        });
        let mut bytes = head.into_bytes();
        if let Err(error) = poly::write_pslg(&mut bytes, &self.drawing, 0) {
            bytes.extend(format!("# the drawing cannot be written: {error}\n# {:?}\n", self.drawing).into_bytes());
        }
        bytes
    }

    fn of_text(bytes: &[u8]) -> Result<(Self, Option<String>), String> {
        let none = || Err(trimalla_io::IoError::UnknownInput { path: PathBuf::new(), expected: "vertices" });
        let drawing = poly::read(bytes, "input", none).map_err(|e| e.to_string())?.into_pslg();
        let mut case = Self::of(drawing);
        let (mut target, mut toml) = (None, String::new());
        for line in String::from_utf8_lossy(bytes).lines() {
            let Some((key, value)) = line.strip_prefix("# ").and_then(|l| l.split_once(' ')) else { continue };
            match key {
                "fuzz" => target = Some(value.to_owned()),
                "domain" => case.domain = domain_of(value).ok_or(format!("no domain: {value}"))?,
                "more" => case.more = value.parse().map_err(|e| format!("more {value}: {e}"))?,
                "cancel" => case.cancel = value.parse().ok(),
                "edit" => case.edits.push(Edit::of_text(value).ok_or(format!("no edit: {value}"))?),
                "recipe" => toml.extend([value, "\n"]),
                _ => {}
            }
        }
        case.recipe = recipe::read(toml.as_bytes(), "recipe").map_err(|e| e.to_string())?;
        Ok((case, target))
    }
}

/// A recipe as lines, without comments.
fn lines_of(recipe: &NamedOptions) -> Vec<String> {
    let mut toml = Vec::new();
    let _ = recipe::write(&mut toml, recipe);
    let text = String::from_utf8_lossy(&toml).into_owned();
    text.lines().filter(|l| !l.is_empty() && !l.starts_with('#')).map(str::to_owned).collect()
}

fn domain_of(text: &str) -> Option<DomainOptions> {
    let mut words = text.split_whitespace();
    let (rule, crossings, algorithm) = (words.next()?, words.next()?, words.next()?);
    Some(DomainOptions {
        rule: DomainRule::ALL.into_iter().find(|r| r.key() == rule)?,
        crossings: if crossings == "split" { Crossings::Split } else { Crossings::Refuse },
        algorithm: AlgorithmKey::ALL.into_iter().find(|a| a.key() == algorithm)?,
    })
}

impl Edit {
    fn to_text(self) -> String {
        match self {
            Self::Insert(p) => format!("insert {:e} {:e}", p.x, p.y),
            Self::Remove(v) => format!("remove {v}"),
            Self::Move(v, p) => format!("move {v} {:e} {:e}", p.x, p.y),
            Self::InsertSegment(a, b) => format!("insert-segment {a} {b}"),
            Self::RemoveSegment(s) => format!("remove-segment {s}"),
            Self::Merge(v) => format!("merge {v}"),
            Self::Rollback(n) => format!("rollback {n}"),
        }
    }

    fn of_text(text: &str) -> Option<Self> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let id = |i: usize| words.get(i)?.parse::<u32>().ok();
        let point = |i: usize| Some(Point::new(words.get(i)?.parse().ok()?, words.get(i + 1)?.parse().ok()?));
        Some(match *words.first()? {
            "insert" => Self::Insert(point(1)?),
            "remove" => Self::Remove(id(1)?),
            "move" => Self::Move(id(1)?, point(2)?),
            "insert-segment" => Self::InsertSegment(id(1)?, id(2)?),
            "remove-segment" => Self::RemoveSegment(id(1)?),
            "merge" => Self::Merge(id(1)?),
            "rollback" => Self::Rollback(id(1)?),
            _ => return None,
        })
    }
}
