//! Rows of numbers as text, in blocks: what the long files consist of.
//!
//! Numbers are written straight into the block, without the formatting machinery of the standard library, which takes
//! several times as long.

use std::io::{self, Write};

use crate::numbers::Real;

/// A block goes out when it has grown to this many bytes.
const BLOCK: usize = 1 << 16;

/// Rows of fields with a space between them.
pub(crate) struct Rows<'a> {
    out: &'a mut dyn Write,
    /// Rows not yet written, and the fields of the current row, each with a space behind it.
    block: Vec<u8>,
}

impl<'a> Rows<'a> {
    /// No rows yet.
    pub(crate) fn to(out: &'a mut dyn Write) -> Self {
        Self { out, block: Vec::with_capacity(BLOCK + BLOCK / 4) }
    }

    /// Adds an integer to the row.
    pub(crate) fn integer(&mut self, value: impl itoa::Integer) -> &mut Self {
        self.field(itoa::Buffer::new().format(value))
    }

    /// Adds indices to the row, counted from 1.
    pub(crate) fn one_based(&mut self, indices: &[u32]) -> &mut Self {
        for &index in indices {
            self.integer(u64::from(index) + 1);
        }
        self
    }

    /// Adds a finite number to the row, with the fewest digits that read back to the same bits.
    pub(crate) fn real(&mut self, value: f64) -> &mut Self {
        Real(value).with_text(|text| self.field(text));
        self
    }

    /// Adds numbers to the row.
    pub(crate) fn reals(&mut self, values: &[f64]) -> &mut Self {
        for &value in values {
            self.real(value);
        }
        self
    }

    /// Ends the row, which has a field.
    pub(crate) fn end(&mut self) -> io::Result<()> {
        if let Some(space) = self.block.last_mut() {
            *space = b'\n';
        }
        if self.block.len() < BLOCK { Ok(()) } else { self.send() }
    }

    /// Writes the rows that are left.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        self.send()
    }

    fn field(&mut self, text: &str) -> &mut Self {
        self.block.extend_from_slice(text.as_bytes());
        self.block.push(b' ');
        self
    }

    fn send(&mut self) -> io::Result<()> {
        self.out.write_all(&self.block)?;
        self.block.clear();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(fill: impl FnOnce(&mut Rows<'_>)) -> String {
        let mut out = Vec::new();
        let mut rows = Rows::to(&mut out);
        fill(&mut rows);
        rows.end().and_then(|()| rows.finish()).expect("a Vec takes everything");
        String::from_utf8(out).expect("digits")
    }

    #[test]
    fn a_row_has_spaces_between_its_fields() {
        let text = row(|rows| {
            rows.integer(12_u64).reals(&[0.5, -3.0]).integer(-1_i32);
        });
        assert_eq!(text, "12 0.5 -3 -1\n");
    }

    #[test]
    fn many_rows_come_out_whole() {
        let mut out = Vec::new();
        let mut rows = Rows::to(&mut out);
        for i in 0..50_000_u32 {
            rows.integer(i).end().expect("a Vec takes everything");
        }
        rows.finish().expect("a Vec takes everything");
        let expected: String = (0..50_000).map(|i| format!("{i}\n")).collect();
        assert_eq!(String::from_utf8(out).expect("digits"), expected);
    }
}
