//! A cursor over the words and lines of text formats of other programs, which knows where each of them stands.
//!
//! [`tokens`](crate::tokens) reads the formats whose records share one shape; the formats here have their own comments,
//! keywords and separators, so only places, numbers and errors are common to them. Words are separated by blanks and
//! ends of lines; lines end with LF, CR LF or a lone CR.

use std::str::FromStr;

use crate::cursor::{Cursor, ends_line, is_blank};
use crate::error::{IoError, quote};

/// A piece of the text: a word, or a line without the blanks around it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Word<'a> {
    pub(crate) text: &'a [u8],
    line: u64,
    column: u64,
}

impl<'a> Word<'a> {
    /// The text, if it is UTF-8.
    pub(crate) fn str(self) -> Option<&'a str> {
        std::str::from_utf8(self.text).ok()
    }

    /// Whether this is the given text, in whatever case.
    pub(crate) fn is(self, text: &str) -> bool {
        self.text.eq_ignore_ascii_case(text.as_bytes())
    }

    /// The value of the text, if it is one of this type.
    pub(crate) fn parse<T: FromStr>(self) -> Option<T> {
        self.str()?.parse().ok()
    }

    /// The part of this piece from one byte to another, without the blanks around it.
    pub(crate) fn part(self, from: usize, to: usize) -> Self {
        let text = self.text.get(from..to).unwrap_or_default();
        let blanks = text.iter().take_while(|&&b| is_blank(b)).count();
        let end = text.iter().rposition(|&b| !is_blank(b)).map_or(blanks, |last| last + 1);
        Self { text: &text[blanks..end], line: self.line, column: self.column + (from + blanks) as u64 }
    }

    /// The pieces between separators, without the blanks around them; empty ones are kept.
    pub(crate) fn split(self, separator: u8) -> impl Iterator<Item = Self> {
        let mut from = 0;
        let mut is_done = false;
        std::iter::from_fn(move || {
            if is_done {
                return None;
            }
            let rest = &self.text[from..];
            let length = rest.iter().position(|&b| b == separator);
            let piece = self.part(from, from + length.unwrap_or(rest.len()));
            is_done = length.is_none();
            from += length.unwrap_or(rest.len()) + 1;
            Some(piece)
        })
    }

    /// The words of a line.
    pub(crate) fn words(self) -> impl Iterator<Item = Self> {
        let mut from = 0;
        std::iter::from_fn(move || {
            from += self.text[from..].iter().take_while(|&&b| is_blank(b)).count();
            let length = self.text[from..].iter().take_while(|&&b| !is_blank(b)).count();
            let word = self.part(from, from + length);
            from += length;
            (length > 0).then_some(word)
        })
    }
}

/// A cursor over one file.
#[derive(Clone, Debug)]
pub(crate) struct Text<'a>(Cursor<'a>);

impl<'a> Text<'a> {
    /// A cursor at the start of `bytes`; `name` is what errors call the file.
    pub(crate) fn new(bytes: &'a [u8], name: &'a str) -> Result<Self, IoError> {
        Cursor::new(bytes, name).map(Self)
    }

    /// A cursor of the same text at a byte.
    pub(crate) fn at(&self, offset: usize) -> Self {
        let mut at = self.clone();
        at.0.seek(offset.min(self.0.bytes.len()));
        at
    }

    /// A cursor of the same text at the start of a line, counted from 1, or at the end.
    pub(crate) fn at_line(&self, line: u32) -> Self {
        let mut at = self.clone();
        while at.0.line < u64::from(line) && at.remaining() > 0 {
            at.skip_line();
            if at.remaining() > 0 {
                at.0.end_line();
            }
        }
        at
    }

    /// A cursor of the same text that sees only the bytes from one to another.
    pub(crate) fn between(&self, from: usize, to: usize) -> Self {
        let mut at = self.at(from);
        at.0.bytes = &self.0.bytes[..to.min(self.0.bytes.len())];
        at
    }

    /// The error for what stands at the cursor.
    pub(crate) fn error(&self, expected: &str, found: &str) -> IoError {
        IoError::Syntax(self.0.fault_here(expected, found))
    }

    /// How many bytes are still to be read: an upper bound for all that a header may promise.
    pub(crate) fn remaining(&self) -> usize {
        self.0.remaining()
    }

    /// The next word, on this line or a later one.
    pub(crate) fn word(&mut self) -> Option<Word<'a>> {
        loop {
            match self.0.byte()? {
                b'\n' | b'\r' => self.0.end_line(),
                b if is_blank(b) => self.0.pos += 1,
                _ => break,
            }
        }
        let rest = self.0.rest();
        let length = rest.iter().position(|&b| is_blank(b) || ends_line(b)).unwrap_or(rest.len());
        let word = Word { text: &rest[..length], line: self.0.line, column: self.0.column() };
        self.0.pos += length;
        Some(word)
    }

    /// The next word, without moving on.
    pub(crate) fn peek(&self) -> Option<Word<'a>> {
        self.clone().word()
    }

    /// What is left of this line, if there is more than blanks, or else the next line that is not blank.
    pub(crate) fn line(&mut self) -> Option<Word<'a>> {
        loop {
            let rest = self.0.rest();
            let length = rest.iter().position(|&b| ends_line(b)).unwrap_or(rest.len());
            let whole = Word { text: &rest[..length], line: self.0.line, column: self.0.column() };
            let is_last = length == rest.len();
            self.0.pos += length;
            let trimmed = whole.part(0, length);
            if !trimmed.text.is_empty() {
                return Some(trimmed);
            }
            if is_last {
                return None;
            }
            self.0.end_line();
        }
    }

    /// Passes over the rest of this line.
    pub(crate) fn skip_line(&mut self) {
        self.0.skip_line();
    }

    /// The next word, which must be there.
    pub(crate) fn expect(&mut self, expected: &str) -> Result<Word<'a>, IoError> {
        self.word().ok_or_else(|| self.ended(expected))
    }

    /// The error for a file that ends too early.
    pub(crate) fn ended(&self, expected: &str) -> IoError {
        let mut at_end = self.clone();
        at_end.0.seek(self.0.bytes.len());
        IoError::Syntax(at_end.0.fault_here(expected, "the end of the file"))
    }

    /// A finite number.
    pub(crate) fn real(&mut self, expected: &str) -> Result<f64, IoError> {
        let word = self.expect(expected)?;
        self.real_of(word, expected)
    }

    /// The value of a word that must be a finite number.
    pub(crate) fn real_of(&self, word: Word<'_>, expected: &str) -> Result<f64, IoError> {
        match word.parse::<f64>() {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => Err(self.value(word, &format!("{expected}, finite and within the range of a double"))),
            None => Err(self.syntax(word, expected)),
        }
    }

    /// A whole number of this type.
    pub(crate) fn whole<T: FromStr>(&mut self, expected: &str) -> Result<T, IoError> {
        let word = self.expect(expected)?;
        self.whole_of(word, expected)
    }

    /// The value of a word that must be a whole number of this type.
    pub(crate) fn whole_of<T: FromStr>(&self, word: Word<'_>, expected: &str) -> Result<T, IoError> {
        word.parse().ok_or_else(|| self.syntax(word, expected))
    }

    /// The error for text that is not what the format wants.
    pub(crate) fn syntax(&self, word: Word<'_>, expected: &str) -> IoError {
        IoError::Syntax(self.0.fault(word.line, word.column, expected, quote(word.text)))
    }

    /// The error for text whose value is not allowed.
    pub(crate) fn value(&self, word: Word<'_>, expected: &str) -> IoError {
        IoError::Value(self.0.fault(word.line, word.column, expected, quote(word.text)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_lines_know_their_places() {
        let mut text = Text::new(b"\xef\xbb\xbf a  bc\r\n\n  d e \rf", "t").unwrap();
        let shown = |word: Option<Word<'_>>| {
            word.map(|word| (word.line, word.column, String::from_utf8_lossy(word.text).into_owned()))
        };
        assert_eq!(shown(text.word()), Some((1, 2, "a".to_owned())));
        assert_eq!(shown(text.peek()), Some((1, 5, "bc".to_owned())));
        assert_eq!(shown(text.line()), Some((1, 5, "bc".to_owned())));
        assert_eq!(shown(text.line()), Some((3, 3, "d e".to_owned())));
        assert_eq!(shown(text.word()), Some((4, 1, "f".to_owned())));
        assert_eq!((shown(text.word()), shown(text.line())), (None, None));
        assert_eq!(text.ended("more").to_string(), "t:4:2: expected more, found the end of the file");
    }

    #[test]
    fn lines_split_at_separators_and_blanks() {
        let line = Text::new(b"  1, 2.5,,x y", "t").unwrap().line().unwrap();
        let columns: Vec<_> = line.split(b',').map(|w| (w.column, w.str().unwrap_or_default())).collect();
        assert_eq!(columns, [(3, "1"), (6, "2.5"), (10, ""), (11, "x y")]);
        assert_eq!(line.words().map(|w| w.column).collect::<Vec<_>>(), [3, 6, 13]);
    }
}
