//! Splits bytes into lines and fields and knows where each of them stands.
//!
//! A *record* is a line that holds at least one field; blank lines and comments (`#` to the end of the line) are
//! skipped. Lines end with LF, CR LF or a lone CR; the last one needs no end. Blanks are space, tab, vertical tab and
//! form feed. One comma between two fields, or after the last field of a line, separates like a blank. A decimal comma
//! would be read as two fields, so a line with commas must have exactly the declared number of fields:
//! [`Reader::end_record`]. Comments may hold any bytes (old drawings carry
//! Latin-1) except NUL, which no text has: a NUL byte anywhere is refused before anything else is read.

use crate::cursor::{Cursor, ends_line, is_blank};
use crate::error::{Fault, IoError, Note, Place, quote};

/// A field: consecutive bytes that are neither blank nor comment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token<'a> {
    pub(crate) text: &'a [u8],
    line: u64,
    column: u64,
}

/// A place of a [`Reader`] within its current line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark(usize);

/// A cursor over the records and fields of one file.
#[derive(Debug)]
pub(crate) struct Reader<'a> {
    at: Cursor<'a>,
    /// Whether the field read last may be followed by a comma: it is on this line, and no comma was read since.
    takes_comma: bool,
    /// Whether a comma separates fields of this line.
    has_commas: bool,
    notes: Vec<Note>,
}

impl<'a> Reader<'a> {
    /// A cursor at the start of `bytes`; `name` is what errors call the file.
    pub(crate) fn new(bytes: &'a [u8], name: &'a str) -> Result<Self, IoError> {
        Ok(Self { at: Cursor::new(bytes, name)?, takes_comma: false, has_commas: false, notes: Vec::new() })
    }

    /// How many bytes are still to be read: an upper bound for everything a header may promise.
    pub(crate) fn remaining(&self) -> usize {
        self.at.remaining()
    }

    /// Moves to the next field, on this line or a later one; `false` at the end of the file.
    pub(crate) fn advance(&mut self) -> bool {
        loop {
            self.skip_blanks();
            match self.at.byte() {
                None => return false,
                Some(b'\n' | b'\r') => self.end_line(),
                Some(_) => return true,
            }
        }
    }

    /// Moves to the next record, which `expected` describes.
    pub(crate) fn record(&mut self, expected: impl FnOnce() -> String) -> Result<(), IoError> {
        if self.advance() {
            Ok(())
        } else {
            Err(IoError::Syntax(self.at.fault_here(&expected(), "the end of the file")))
        }
    }

    /// The next field of this line, if there is one.
    pub(crate) fn field(&mut self) -> Option<Token<'a>> {
        self.skip_blanks();
        if self.takes_comma && self.at.byte() == Some(b',') {
            (self.takes_comma, self.has_commas) = (false, true);
            self.at.pos += 1;
            self.skip_blanks();
        }
        let rest = self.at.rest();
        let length = match rest.iter().position(|&b| ends_field(b)).unwrap_or(rest.len()) {
            0 if rest.first() == Some(&b',') => 1, // A comma with no field before it: no field of any format.
            0 => return None,
            length => length,
        };
        let token = Token { text: &rest[..length], line: self.at.line, column: self.at.column() };
        self.at.pos += length;
        self.takes_comma = true;
        Some(token)
    }

    /// The next field of this line, which must be there.
    pub(crate) fn expect(&mut self, expected: &str) -> Result<Token<'a>, IoError> {
        let end = self.at.pos;
        match self.field() {
            Some(token) => Ok(token),
            None => {
                self.at.pos = end;
                Err(IoError::Syntax(self.at.fault_here(expected, "the end of the line")))
            }
        }
    }

    /// Checks that this line holds no further field.
    pub(crate) fn end_record(&mut self) -> Result<(), IoError> {
        match self.field() {
            None => Ok(()),
            Some(extra) => Err(self.one_too_many(extra)),
        }
    }

    /// Passes over further numbers on this line; the place of the first, if there are any.
    ///
    /// On a line with commas they are a fault: with decimal commas, the numbers before them would be wrong.
    pub(crate) fn pass_over_numbers(&mut self) -> Result<Option<Place>, IoError> {
        let Some(first) = self.field() else { return Ok(None) };
        let mut next = Some(first);
        while let Some(token) = next {
            let is_number = std::str::from_utf8(token.text).is_ok_and(|text| text.parse::<f64>().is_ok());
            if self.has_commas || !is_number {
                return Err(self.one_too_many(token));
            }
            next = self.field();
        }
        Ok(Some(self.place(first)))
    }

    /// The error for a field beyond those that the line should have: where a decimal comma may be the cause, about
    /// that.
    fn one_too_many(&self, extra: Token<'_>) -> IoError {
        self.refuse_decimal_commas().err().unwrap_or_else(|| self.syntax(extra, "the end of the line"))
    }

    /// Refuses a line with a number that looks as if it had a decimal comma, if commas separate fields of this line.
    pub(crate) fn refuse_decimal_commas(&self) -> Result<(), IoError> {
        match self.has_commas.then(|| self.decimal_comma()).flatten() {
            Some(number) => Err(self.syntax(number, "a point in a decimal number, as commas separate columns")),
            None => Ok(()),
        }
    }

    /// The first number of this line that looks as if it had a decimal comma, such as `0,5`.
    fn decimal_comma(&self) -> Option<Token<'a>> {
        let line = self.at.bytes.get(self.at.line_start..)?.split(|&b| ends_line(b) || b == b'#').next()?;
        let mut words = line.split(|&b| is_blank(b));
        let word = words.find(|word| looks_like_a_decimal_comma(word))?;
        let offset = word.as_ptr() as usize - line.as_ptr() as usize;
        Some(Token { text: word, line: self.at.line, column: offset as u64 + 1 })
    }

    /// Remembers that something was ignored.
    pub(crate) fn note(&mut self, note: Note) {
        self.notes.push(note);
    }

    /// What was ignored so far, in the order of the file.
    pub(crate) fn take_notes(&mut self) -> Vec<Note> {
        std::mem::take(&mut self.notes)
    }

    /// Where a field stands.
    pub(crate) fn place(&self, token: Token<'_>) -> Place {
        self.at.place(token.line, token.column)
    }

    /// Checks that nothing but blanks and comments follows.
    pub(crate) fn end_file(&mut self) -> Result<(), IoError> {
        if !self.advance() {
            return Ok(());
        }
        match self.field() {
            None => Ok(()),
            Some(extra) => Err(self.syntax(extra, "the end of the file")),
        }
    }

    /// The place of the cursor, to be handed to [`since`](Self::since) on the same line.
    pub(crate) fn mark(&self) -> Mark {
        Mark(self.at.pos)
    }

    /// The text of this line from `mark` to the end of the field read last.
    pub(crate) fn since(&self, mark: Mark) -> Token<'a> {
        let column = (mark.0 - self.at.line_start) as u64 + 1;
        Token { text: &self.at.bytes[mark.0..self.at.pos], line: self.at.line, column }
    }

    /// The error for a field that is not what the format wants.
    pub(crate) fn syntax(&self, token: Token<'_>, expected: &str) -> IoError {
        IoError::Syntax(self.fault_at(token, expected))
    }

    /// The error for a field whose value is not allowed.
    pub(crate) fn value(&self, token: Token<'_>, expected: &str) -> IoError {
        IoError::Value(self.fault_at(token, expected))
    }

    fn fault_at(&self, token: Token<'_>, expected: &str) -> Box<Fault> {
        self.at.fault(token.line, token.column, expected, quote(token.text))
    }

    /// Skips blanks, and a comment up to the end of its line.
    fn skip_blanks(&mut self) {
        while self.at.byte().is_some_and(is_blank) {
            self.at.pos += 1;
        }
        if self.at.byte() == Some(b'#') {
            self.at.skip_line();
        }
    }

    /// Steps over the line end under the cursor.
    fn end_line(&mut self) {
        self.at.end_line();
        (self.takes_comma, self.has_commas) = (false, false);
    }
}

fn ends_field(byte: u8) -> bool {
    is_blank(byte) || ends_line(byte) || matches!(byte, b'#' | b',')
}

/// Digits, one comma, digits; a sign before and an exponent behind may be there.
fn looks_like_a_decimal_comma(word: &[u8]) -> bool {
    let mut parts = word.split(|&b| b == b',');
    let (Some(whole), Some(fraction), None) = (parts.next(), parts.next(), parts.next()) else { return false };
    let whole = whole.strip_prefix(b"-").or_else(|| whole.strip_prefix(b"+")).unwrap_or(whole);
    let digits = |text: &[u8]| !text.is_empty() && text.iter().all(u8::is_ascii_digit);
    digits(whole) && fraction.split(|b| matches!(b, b'e' | b'E')).next().is_some_and(digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Line, column and text of every field.
    fn fields(bytes: &[u8]) -> Vec<(u64, u64, String)> {
        let mut reader = Reader::new(bytes, "t").unwrap();
        let mut all = Vec::new();
        while reader.advance() {
            let token = reader.field().unwrap();
            all.push((token.line, token.column, String::from_utf8_lossy(token.text).into_owned()));
        }
        all
    }

    /// Line, column and text of every field, several a line.
    fn all_fields(bytes: &[u8]) -> Vec<(u64, u64, String)> {
        let mut reader = Reader::new(bytes, "t").unwrap();
        let mut all = Vec::new();
        while reader.advance() {
            while let Some(token) = reader.field() {
                all.push((token.line, token.column, String::from_utf8_lossy(token.text).into_owned()));
            }
        }
        all
    }

    fn field(line: u64, column: u64, text: &str) -> (u64, u64, String) {
        (line, column, text.to_owned())
    }

    #[test]
    fn every_line_end_counts_once() {
        let expected = [field(1, 1, "a"), field(2, 2, "b"), field(3, 1, "c"), field(5, 1, "d")];
        assert_eq!(fields(b"a\r\n\tb\rc\n\nd"), expected);
    }

    #[test]
    fn one_comma_separates_like_a_blank() {
        let expected = [field(1, 1, "1"), field(1, 4, "0.5"), field(1, 10, "2"), field(2, 1, "3")];
        assert_eq!(all_fields(b"1, 0.5 , 2,\n3"), expected);
        assert_eq!(
            all_fields(b"1,,2\n,3"),
            [field(1, 1, "1"), field(1, 3, ","), field(1, 4, "2"), field(2, 1, ","), field(2, 2, "3")]
        );
    }

    #[test]
    fn decimal_commas_are_recognised() {
        for (word, is_one) in
            [("0,5", true), ("-10,25e3", true), ("1,5,7", false), ("1.0,5", false), ("1,", false), (",5", false)]
        {
            assert_eq!(looks_like_a_decimal_comma(word.as_bytes()), is_one, "{word}");
        }
    }

    #[test]
    fn comments_and_marks_are_skipped() {
        assert_eq!(fields(b"\xef\xbb\xbf1#x y\n# \xe4\xff\n 2 # 3"), [field(1, 1, "1"), field(3, 2, "2")]);
    }

    #[test]
    fn what_is_no_text_is_named_with_its_place() {
        for (bytes, place, found) in [
            (&b"1 2\n# \0"[..], "t:2:3", "a NUL byte"),
            (b"\xff\xfe1", "t:1:1", "UTF-16"),
            (b"\x1f\x8b\x08", "t:1:1", "gzip-compressed data"),
        ] {
            let error = Reader::new(bytes, "t").unwrap_err().to_string();
            assert_eq!(error, format!("{place}: expected text, found {found}"));
        }
    }
}
