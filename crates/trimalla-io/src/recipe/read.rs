//! From text to a recipe.

use std::ops::Range;
use std::path::Path;
use std::str;

use toml::Spanned;
use toml::de::{DeTable, DeValue};
use trimalla::refine::{
    Centroid, ConstrainedSecond, Encroachment, Fill, Initial, Insert, LeppRule, PlacePoint, Prepare, PrepareWhen,
    Preset, Protect, Recover, Select, Terminal,
};

use super::{CRITERIA, KEYS, LIMITS, RecipeFile};
use crate::bytes::read_bytes;
use crate::error::{Fault, IoError, Place, quote};

/// No recipe is larger: what is, is no recipe.
const LARGEST: u64 = 1 << 20;

/// Reads a recipe file.
///
/// # Errors
/// [`IoError::Missing`], [`IoError::Unreadable`], and those of [`read`].
pub fn read_file(path: impl AsRef<Path>) -> Result<RecipeFile, IoError> {
    let path = path.as_ref();
    read(&read_bytes(path, LARGEST)?, &path.to_string_lossy())
}

/// Reads a recipe; `name` is what errors call the file.
///
/// # Errors
/// [`IoError::Syntax`] where the text is no TOML or has a key that is not known, [`IoError::Value`] where a value is
/// not allowed.
///
/// # Examples
/// ```
/// use trimalla::refine::Select;
/// use trimalla_io::recipe;
///
/// let text = b"preset = \"lepp-centroid\"\nselect = \"smallest-angle\"\n[criteria]\nmin-angle = 33\n";
/// let file = recipe::read(text, "worst.toml")?;
/// assert_eq!((file.recipe.select, file.min_angle_deg), (Select::SmallestAngle, Some(33.0)));
///
/// let fault = recipe::read(b"terminal = \"first\"\n", "worst.toml").unwrap_err();
/// assert_eq!(fault.to_string(), "worst.toml:1:12: expected one of larger, last, found 'first'");
/// # Ok::<(), trimalla_io::IoError>(())
/// ```
pub fn read(bytes: &[u8], name: &str) -> Result<RecipeFile, IoError> {
    let source = Source { bytes, name };
    let text = str::from_utf8(bytes).map_err(|error| {
        let at = error.valid_up_to();
        source.syntax(at..at + error.error_len().unwrap_or(1), "text in UTF-8")
    })?;
    let start = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let table = DeTable::parse(&text[start..]).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        source.syntax(span.start + start..span.end + start, &format!("TOML ({})", error.message().replace('\n', " ")))
    })?;
    Source { bytes: &bytes[start..], name }.recipe(table.get_ref())
}

type Entry<'a> = (&'a str, Range<usize>, &'a Spanned<DeValue<'a>>);

/// A text and what it is called.
#[derive(Clone, Copy)]
struct Source<'a> {
    bytes: &'a [u8],
    name: &'a str,
}

impl Source<'_> {
    fn recipe(self, table: &DeTable<'_>) -> Result<RecipeFile, IoError> {
        let entries = self.entries(table, &KEYS)?;
        let mut file = RecipeFile::default();
        if let Some((.., value)) = entries.iter().find(|(key, ..)| *key == "preset") {
            file = RecipeFile::of(self.choice(value, Preset::ALL, |p| p.key())?);
        }
        for entry in entries {
            match entry.0 {
                "criteria" => self.criteria(&mut file, entry.2)?,
                "limits" => self.limits(&mut file, entry.2)?,
                _ => self.step(&mut file, &entry)?,
            }
        }
        Ok(file)
    }

    fn step(self, file: &mut RecipeFile, (key, _, value): &Entry<'_>) -> Result<(), IoError> {
        let recipe = &mut file.recipe;
        match *key {
            "name" => file.name = Some(self.string(value, "a name between quotes")?.to_owned()),
            "initial" => recipe.initial = self.choice(value, Initial::ALL, |c| c.key())?,
            "fill" => recipe.fill = self.choice(value, Fill::ALL, |c| c.key())?,
            "prepare" => recipe.prepare = self.choice(value, Prepare::ALL, |c| c.key())?,
            "prepare-when" => recipe.prepare_when = self.choice(value, PrepareWhen::ALL, |c| c.key())?,
            "encroachment" => recipe.encroachment = self.choice(value, Encroachment::ALL, |c| c.key())?,
            "select" => recipe.select = self.choice(value, Select::ALL, |c| c.key())?,
            "until-destroyed" => recipe.until_destroyed = self.truth(value)?,
            "point" => recipe.point = self.choice(value, PlacePoint::ALL, |c| c.key())?,
            "lepp-stop" => recipe.lepp_rule = self.choice(value, &LeppRule::ALL, |c| c.key())?,
            "centroid" => recipe.centroid = self.choice(value, &Centroid::ALL, |c| c.key())?,
            "constrained-second" => {
                recipe.constrained_second = self.choice(value, ConstrainedSecond::ALL, |c| c.key())?;
            }
            "terminal" => recipe.terminal = self.choice(value, Terminal::ALL, |c| c.key())?,
            "insert" => recipe.insert = self.choice(value, Insert::ALL, |c| c.key())?,
            "recover" => recipe.recover = self.choice(value, Recover::ALL, |c| c.key())?,
            "protect" => file.protect = Some(self.choice(value, &Protect::ALL, |c| c.key())?),
            _ => {} // The preset, which came first.
        }
        Ok(())
    }

    fn criteria(self, file: &mut RecipeFile, value: &Spanned<DeValue<'_>>) -> Result<(), IoError> {
        for (key, _, value) in self.entries(self.table(value, "criteria")?, &CRITERIA)? {
            match key {
                "min-angle" => {
                    let is_angle = |d| (0.0..=60.0).contains(&d);
                    file.min_angle_deg = Some(self.number(value, "an angle from 0 to 60 degrees", is_angle)?);
                }
                "max-area" => {
                    let is_area = |a: f64| a > 0.0 && a.is_finite();
                    file.max_area = Some(self.number(value, "a positive finite area", is_area)?);
                }
                _ => {
                    let is_ratio = |r: f64| r >= 1.0 && r.is_finite();
                    file.max_aspect_ratio = Some(self.number(value, "a finite ratio of at least 1", is_ratio)?);
                }
            }
        }
        Ok(())
    }

    fn limits(self, file: &mut RecipeFile, value: &Spanned<DeValue<'_>>) -> Result<(), IoError> {
        for (key, _, value) in self.entries(self.table(value, "limits")?, &LIMITS)? {
            if key == "max-vertices" {
                file.max_vertices = Some(self.count(value, "a number of vertices")?);
            } else {
                let is_length = |l: f64| l >= 0.0 && l.is_finite();
                file.length_floor = Some(self.number(value, "a finite length of at least 0", is_length)?);
            }
        }
        Ok(())
    }

    /// The entries of a table in the order of the text, so that the first fault is the one that is told.
    fn entries<'t>(self, table: &'t DeTable<'_>, known: &[&str]) -> Result<Vec<Entry<'t>>, IoError> {
        let mut entries: Vec<Entry<'t>> =
            table.iter().map(|(key, value)| (key.get_ref().as_ref(), key.span(), value)).collect();
        entries.sort_by_key(|(_, span, _)| span.start);
        match entries.iter().find(|(key, ..)| !known.contains(key)) {
            None => Ok(entries),
            Some((_, span, _)) => Err(self.syntax(span.clone(), &format!("one of the keys {}", known.join(", ")))),
        }
    }

    fn table<'t>(self, value: &'t Spanned<DeValue<'_>>, name: &str) -> Result<&'t DeTable<'t>, IoError> {
        let expected = || self.value(value.span(), &format!("a table, such as [{name}]"));
        value.get_ref().as_table().ok_or_else(expected)
    }

    fn string<'t>(self, value: &'t Spanned<DeValue<'_>>, expected: &str) -> Result<&'t str, IoError> {
        value.get_ref().as_str().ok_or_else(|| self.value(value.span(), expected))
    }

    fn truth(self, value: &Spanned<DeValue<'_>>) -> Result<bool, IoError> {
        value.get_ref().as_bool().ok_or_else(|| self.value(value.span(), "true or false"))
    }

    fn choice<T: Copy>(
        self,
        value: &Spanned<DeValue<'_>>,
        all: &[T],
        key: impl Fn(T) -> &'static str,
    ) -> Result<T, IoError> {
        let given = value.get_ref().as_str();
        all.iter().copied().find(|&c| Some(key(c)) == given).ok_or_else(|| {
            let keys: Vec<&str> = all.iter().map(|&c| key(c)).collect();
            self.value(value.span(), &format!("one of {}", keys.join(", ")))
        })
    }

    fn number(
        self,
        value: &Spanned<DeValue<'_>>,
        expected: &str,
        is_allowed: impl Fn(f64) -> bool,
    ) -> Result<f64, IoError> {
        let number = match value.get_ref() {
            DeValue::Float(f) => f.as_str().parse().ok(),
            DeValue::Integer(i) if i.radix() == 10 => i.as_str().parse().ok(),
            _ => None,
        };
        number.filter(|&n| is_allowed(n)).ok_or_else(|| self.value(value.span(), expected))
    }

    fn count(self, value: &Spanned<DeValue<'_>>, expected: &str) -> Result<usize, IoError> {
        let integer = value.get_ref().as_integer();
        let count = integer.and_then(|i| usize::from_str_radix(i.as_str(), i.radix()).ok());
        count.ok_or_else(|| self.value(value.span(), expected))
    }

    fn syntax(self, span: Range<usize>, expected: &str) -> IoError {
        IoError::Syntax(Box::new(self.fault(span, expected)))
    }

    fn value(self, span: Range<usize>, expected: &str) -> IoError {
        IoError::Value(Box::new(self.fault(span, expected)))
    }

    fn fault(self, span: Range<usize>, expected: &str) -> Fault {
        let start = span.start.min(self.bytes.len());
        let before = &self.bytes[..start];
        let line_start = before.iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
        let line = before.iter().filter(|&&b| b == b'\n').count() as u64 + 1;
        let found = self.bytes.get(start..span.end.min(self.bytes.len())).unwrap_or_default();
        let found = found.strip_prefix(b"\"").and_then(|f| f.strip_suffix(b"\"")).unwrap_or(found);
        let found = match (found, start == self.bytes.len()) {
            ([], true) => "the end of the file".to_owned(),
            ([], false) => quote(&self.bytes[start..(start + 1)]),
            _ => quote(found),
        };
        let column = (start - line_start) as u64 + 1;
        Fault { place: Place { file: self.name.to_owned(), line, column }, expected: expected.to_owned(), found }
    }
}
