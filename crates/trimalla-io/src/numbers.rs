//! Numbers and numbering: the fields of a record as values, and values as text that reads back to the same bits.

use std::fmt;
use std::str::FromStr;

use crate::error::{Ignored, IoError, Note, Place};
use crate::tokens::{Reader, Token};

/// The vertices that indices in a file may name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexRange {
    /// The index of the first vertex in the file: 0 or 1.
    pub first_index: u32,
    /// How many vertices there are.
    pub count: u32,
}

impl VertexRange {
    /// Every index from `first_index` on, where the number of vertices is not known.
    #[must_use]
    pub fn unbounded(first_index: u32) -> Self {
        Self { first_index, count: u32::MAX - first_index }
    }

    fn describe(self) -> String {
        match self.count {
            0 => "no vertex index, as there are no vertices".to_owned(),
            n => {
                let last = u64::from(self.first_index) + u64::from(n) - 1;
                format!("a vertex index between {} and {last}", self.first_index)
            }
        }
    }
}

/// The numbering of the records of one section: consecutive, from 0 or 1.
#[derive(Debug)]
pub(crate) struct Numbering<'a> {
    noun: &'static str,
    count: u32,
    first: Option<u32>,
    next: u32,
    /// The number of the first record, where there is one.
    first_number: Option<Token<'a>>,
    /// Records with more columns than declared, and the place of the first such column.
    extra: Option<(u64, Place)>,
}

impl<'a> Numbering<'a> {
    /// `count` records called `noun`, numbered from `first` or, where that is `None`, from what the first record says.
    pub(crate) fn new(noun: &'static str, count: u32, first: Option<u32>) -> Self {
        Self { noun, count, first, next: 0, first_number: None, extra: None }
    }

    /// Ends a record; numbers beyond the declared columns are passed over, and [`note_extra`](Self::note_extra) says
    /// so.
    pub(crate) fn end_record(&mut self, reader: &mut Reader<'a>) -> Result<(), IoError> {
        if let Some(place) = reader.pass_over_numbers()? {
            self.extra = Some(self.extra.take().map_or((1, place), |(rows, first)| (rows + 1, first)));
        }
        Ok(())
    }

    /// Notes columns that were passed over.
    pub(crate) fn note_extra(&mut self, reader: &mut Reader<'a>) {
        if let Some((rows, place)) = self.extra.take() {
            reader.note(Note { place, what: Ignored::Columns { noun: self.noun, rows } });
        }
    }

    /// Compares the first number of records that name vertices with the number of the first vertex. If they differ, the
    /// vertices named must show that they are not counted like the records: one of them must not exist if they were.
    /// `named` holds the vertices by index, counted from 0 after the numbers of the vertices.
    pub(crate) fn check_base(
        &self,
        reader: &mut Reader<'a>,
        vertices: VertexRange,
        mut named: impl Iterator<Item = u32>,
    ) -> Result<(), IoError> {
        let (Some(first), Some(token)) = (self.first, self.first_number) else { return Ok(()) };
        if vertices.count == 0 || first == vertices.first_index {
            return Ok(());
        }
        // Counted from 0 instead of 1 every index is one more, and counted from 1 instead of 0 one less.
        let decisive = if first == 0 { vertices.count - 1 } else { 0 };
        if !named.any(|v| v == decisive) {
            let (noun, base) = (self.noun, vertices.first_index);
            return Err(reader.value(token, &format!("{noun} number {base}, as vertices are numbered from {base} on")));
        }
        let what = Ignored::Numbers { noun: self.noun, first, first_vertex: vertices.first_index };
        let place = reader.place(token);
        reader.note(Note { place, what });
        Ok(())
    }

    /// The index of the first record; 1 if nothing decides it.
    pub(crate) fn first_index(&self) -> u32 {
        self.first.unwrap_or(1)
    }

    /// Moves to the next record and checks its number; `false` after the last one.
    pub(crate) fn next(&mut self, reader: &mut Reader<'a>) -> Result<bool, IoError> {
        if self.next == self.count {
            return Ok(false);
        }
        reader.record(|| format!("{} {} of {}", self.noun, u64::from(self.next) + 1, self.count))?;
        let token = reader.expect("a number")?;
        let number = match short_number(token) {
            Some(number) => i128::from(number),
            None => parse(token).ok_or_else(|| reader.syntax(token, &self.describe()))?,
        };
        let fits = match self.first {
            Some(first) => number == i128::from(first) + i128::from(self.next),
            None => matches!(number, 0 | 1),
        };
        if !fits {
            return Err(reader.value(token, &self.describe()));
        }
        if self.next == 0 {
            self.first = Some(u32::from(number == 1));
            self.first_number = Some(token);
        }
        self.next += 1;
        Ok(true)
    }

    fn describe(&self) -> String {
        match self.first {
            Some(first) => format!("{} number {}", self.noun, u64::from(first) + u64::from(self.next)),
            None => format!("0 or 1 as the number of the first {}", self.noun),
        }
    }
}

fn parse<T: FromStr>(token: Token<'_>) -> Option<T> {
    std::str::from_utf8(token.text).ok()?.parse().ok()
}

/// The value of up to nine digits and nothing else: almost every number of a record or vertex.
fn short_number(token: Token<'_>) -> Option<u32> {
    let digits = token.text;
    let is_short = (1..=9).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit);
    is_short.then(|| digits.iter().fold(0, |value, &digit| 10 * value + u32::from(digit - b'0')))
}

fn looks_like_an_integer(text: &[u8]) -> bool {
    let digits = text.strip_prefix(b"-").or_else(|| text.strip_prefix(b"+")).unwrap_or(text);
    !digits.is_empty() && digits.iter().all(u8::is_ascii_digit)
}

impl Reader<'_> {
    /// A count of records or columns. Nothing is allocated for it before the records are read.
    pub(crate) fn count(&mut self, what: &str) -> Result<u32, IoError> {
        let token = self.expect(what)?;
        self.integer_in(token, what, 0, i64::from(u32::MAX)).map(|n| n as u32)
    }

    /// A count that may be missing at the end of a header line.
    pub(crate) fn count_or(&mut self, what: &str, default: u32, largest: u32) -> Result<u32, IoError> {
        match self.field() {
            None => Ok(default),
            Some(token) => self.integer_in(token, what, 0, i64::from(largest)).map(|n| n as u32),
        }
    }

    /// A header field that allows only some values.
    pub(crate) fn one_of_or(&mut self, what: &str, default: u32, allowed: &[u32]) -> Result<u32, IoError> {
        let Some(token) = self.field() else {
            return Ok(default);
        };
        let value = self.integer_in(token, what, i64::MIN, i64::MAX)?;
        let found = allowed.iter().find(|&&a| i64::from(a) == value);
        found.copied().ok_or_else(|| self.value(token, what))
    }

    /// A boundary marker.
    pub(crate) fn marker(&mut self) -> Result<i32, IoError> {
        const WHAT: &str = "a marker between -2147483648 and 2147483647";
        let token = self.expect(WHAT)?;
        self.integer_in(token, WHAT, i64::from(i32::MIN), i64::from(i32::MAX)).map(|n| n as i32)
    }

    /// A vertex index, counted from 0 whatever the file does.
    pub(crate) fn vertex(&mut self, range: VertexRange) -> Result<u32, IoError> {
        let token = self.expect("a vertex index")?;
        match short_number(token).or_else(|| parse(token)).and_then(|n: u32| n.checked_sub(range.first_index)) {
            Some(index) if index < range.count => Ok(index),
            _ if looks_like_an_integer(token.text) => Err(self.value(token, &range.describe())),
            _ => Err(self.syntax(token, &range.describe())),
        }
    }

    /// An index of a record of this file, counted from 0, or `None` where the file says -1.
    pub(crate) fn neighbour(&mut self, first_index: u32, count: u32) -> Result<Option<u32>, IoError> {
        const WHAT: &str = "the number of a triangle, or -1";
        let token = self.expect(WHAT)?;
        let last = i64::from(first_index) + i64::from(count) - 1;
        let number = self.integer_in(token, WHAT, -1, last)?;
        if number == -1 {
            return Ok(None);
        }
        match u32::try_from(number - i64::from(first_index)) {
            Ok(index) => Ok(Some(index)),
            Err(_) => Err(self.value(token, WHAT)),
        }
    }

    /// A finite number.
    pub(crate) fn real(&mut self, what: &str) -> Result<f64, IoError> {
        let token = self.expect(what)?;
        self.real_of(token, what)
    }

    /// The value of a field that must be a finite number.
    pub(crate) fn real_of(&self, token: Token<'_>, what: &str) -> Result<f64, IoError> {
        match parse::<f64>(token) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => Err(self.value(token, &format!("{what}, finite and within the range of a double"))),
            None => Err(self.syntax(token, what)),
        }
    }

    fn integer_in(&self, token: Token<'_>, what: &str, low: i64, high: i64) -> Result<i64, IoError> {
        match parse::<i64>(token) {
            Some(value) if (low..=high).contains(&value) => Ok(value),
            _ if looks_like_an_integer(token.text) => Err(self.value(token, what)),
            _ => Err(self.syntax(token, what)),
        }
    }
}

/// Shows a number with the fewest digits that read back to the same bits, in scientific notation where plain
/// notation would need long runs of zeros.
///
/// Of two such texts the nearer one is taken.
pub(crate) struct Real(pub(crate) f64);

impl Real {
    /// Hands its text on.
    pub(crate) fn with_text<T>(&self, take: impl FnOnce(&str) -> T) -> T {
        match self.0.abs() {
            size if size >= 1e17 => return take(&format!("{:e}", self.0)),
            size if size >= 1e16 => return take(&self.0.to_string()),
            _ => {}
        }
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format_finite(self.0);
        take(text.strip_suffix(".0").unwrap_or(text))
    }
}

impl fmt::Display for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_finite() { self.with_text(|text| f.write_str(text)) } else { self.0.fmt(f) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_keep_their_bits_and_stay_short() {
        let largest = 9_007_199_254_740_993_u64 as f64;
        for value in [5e-324, -0.0, 1.0 / 3.0, largest, 1e308, f64::MAX, f64::MIN_POSITIVE, 1e17, 1e-5, 123.0] {
            let text = Real(value).to_string();
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{text}");
            assert!(text.len() <= 24, "{text}");
        }
    }

    /// The text of the standard library, in the notation used here.
    fn plain(value: f64) -> String {
        let size = value.abs();
        if size == 0.0 || (1e-5..1e17).contains(&size) { format!("{value}") } else { format!("{value:e}") }
    }

    #[test]
    fn reals_look_as_the_standard_library_writes_them() {
        let mut state = 1_u64;
        let mut values =
            vec![0.0, -0.0, 1.0, 1e-5, 9.999e-6, 1e16, 9.99e15, 1e17, 1e22, 1e300, 5e-324, f64::MAX, 0.1 + 0.2];
        for exponent in 0..2047 {
            for _ in 0..8 {
                state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
                values.push(f64::from_bits(state & 0x800f_ffff_ffff_ffff | exponent << 52));
            }
        }
        for value in values {
            let (ours, theirs) = (Real(value).to_string(), plain(value));
            if ours != theirs {
                // Two texts are equally near: the last digits differ by one.
                let digit = |text: &str| text.split('e').next().and_then(|t| t.bytes().last());
                assert_eq!(digit(&ours).map(|d| d + 1), digit(&theirs), "{ours} {theirs}");
                assert_eq!((ours.len(), ours.parse()), (theirs.len(), Ok(value)), "{ours} {theirs}");
            }
        }
    }
}
