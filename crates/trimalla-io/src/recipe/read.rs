//! From text to a recipe.

use std::ops::Range;
use std::path::Path;
use std::str;

use toml::Spanned;
use toml::de::{DeTable, DeValue};
use trimalla::refine::{Group, OptionRow, Value, Values};

use crate::error::{Fault, IoError, Place, quote};
use crate::files::Files;
use trimalla::refine::NamedOptions;

/// The key that stands for all steps.
const PRESET: &str = "preset";

/// No recipe is larger: what is, is no recipe.
const LARGEST: u64 = 1 << 20;

/// Reads a recipe file.
///
/// # Errors
/// [`IoError::Missing`], [`IoError::Unreadable`], and those of [`read`].
pub fn read_file(path: impl AsRef<Path>) -> Result<NamedOptions, IoError> {
    read_in(&Files::Disk, path)
}

/// Reads a recipe from a file on the disk or in memory.
///
/// # Errors
/// Those of [`read_file`].
pub fn read_in(files: &Files, path: impl AsRef<Path>) -> Result<NamedOptions, IoError> {
    let path = path.as_ref();
    read(&files.read_bytes(path, LARGEST)?, &path.to_string_lossy())
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
pub fn read(bytes: &[u8], name: &str) -> Result<NamedOptions, IoError> {
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
    /// The preset first, wherever it stands: it would replace every step. A name is the file's own.
    fn recipe(self, table: &DeTable<'_>) -> Result<NamedOptions, IoError> {
        let mut file = NamedOptions::default();
        let entries = self.entries(table, None)?;
        let (presets, others): (Vec<_>, Vec<_>) = entries.into_iter().partition(|(key, ..)| *key == PRESET);
        for (key, _, value) in presets.into_iter().chain(others) {
            match Group::TABLES.into_iter().find(|name| *name == key) {
                Some(name) => {
                    for (key, _, value) in self.entries(self.table(value, name)?, Some(name))? {
                        self.option(&mut file, Some(name), key, value)?;
                    }
                }
                None => self.option(&mut file, None, key, value)?,
            }
        }
        Ok(file)
    }

    /// Sets the option with a key that is known.
    fn option(
        self,
        file: &mut NamedOptions,
        table: Option<&'static str>,
        key: &str,
        given: &Spanned<DeValue<'_>>,
    ) -> Result<(), IoError> {
        let Some(option) = OptionRow::of_table(table).find(|option| option.key == key) else { return Ok(()) };
        let refused = || self.value(given.span(), &option.values.expected());
        let value = value(option.values, given.get_ref()).ok_or_else(refused)?;
        option.set(file, &value).map_err(|_| refused())
    }

    /// The entries of a table in the order of the text, so that the first fault is the one that is told.
    fn entries<'t>(self, entries: &'t DeTable<'_>, table: Option<&'static str>) -> Result<Vec<Entry<'t>>, IoError> {
        let mut entries: Vec<Entry<'t>> =
            entries.iter().map(|(key, value)| (key.get_ref().as_ref(), key.span(), value)).collect();
        entries.sort_by_key(|(_, span, _)| span.start);
        let known = keys(table);
        match entries.iter().find(|(key, ..)| !known.contains(key)) {
            None => Ok(entries),
            Some((_, span, _)) => Err(self.syntax(span.clone(), &format!("one of the keys {}", known.join(", ")))),
        }
    }

    fn table<'t>(self, value: &'t Spanned<DeValue<'_>>, name: &str) -> Result<&'t DeTable<'t>, IoError> {
        let expected = || self.value(value.span(), &format!("a table, such as [{name}]"));
        value.get_ref().as_table().ok_or_else(expected)
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

/// Every key that a table may have, or the file itself.
pub(super) fn keys(table: Option<&'static str>) -> Vec<&'static str> {
    let tables = Group::TABLES.iter().copied().filter(|_| table.is_none());
    OptionRow::of_table(table).map(|option| option.key).chain(tables).collect()
}

/// A value of the file as one of those that an option takes.
fn value(values: Values, given: &DeValue<'_>) -> Option<Value> {
    match values {
        Values::Keys(_) => values.of_key(given.as_str()?),
        Values::Truth(_) => given.as_bool().map(Value::Truth),
        Values::Text(_) => given.as_str().map(|text| Value::Text(text.to_owned())),
        Values::Count(_) => {
            let count = given.as_integer()?;
            usize::from_str_radix(count.as_str(), count.radix()).ok().map(Value::Count)
        }
        Values::Number { is_allowed, .. } => {
            let number = match given {
                DeValue::Float(number) => number.as_str().parse().ok(),
                DeValue::Integer(number) if number.radix() == 10 => number.as_str().parse().ok(),
                _ => None,
            };
            number.filter(|&number| is_allowed(number)).map(Value::Number)
        }
    }
}
