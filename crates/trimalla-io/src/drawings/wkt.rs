//! Well-known text: `POLYGON ((0 0, 9 0, 9 9))`, one geometry after the other.
//!
//! Read here and not by a crate: those that exist name no line, and follow nested collections by recursion without a
//! bound.

use trimalla::geometry::Point;

use super::sketch::{Fill, Kind, Path, Sketch, Vertex, fault_at};
use crate::error::{IoError, quote};

/// Collections in collections are followed as deep as this.
const DEEPEST: usize = 64;

/// Reads a file.
pub(super) fn read(bytes: &[u8], name: &str) -> Result<Sketch, IoError> {
    let mut reader =
        Reader { bytes, name, at: 0, line: 1, line_start: 0, sketch: Sketch::new("line", "geometry"), number: 0 };
    if bytes.starts_with(b"\xef\xbb\xbf") {
        reader.at = 3;
    }
    loop {
        reader.skip_blanks();
        while matches!(reader.peek(), Some(b';' | b',')) {
            reader.at += 1;
            reader.skip_blanks();
        }
        if reader.peek().is_none() {
            return Ok(reader.sketch);
        }
        reader.number += 1;
        reader.geometry()?;
    }
}

/// Whether a text begins like a geometry.
pub(super) fn is_likely(text: &[u8]) -> bool {
    const WORDS: [&[u8]; 8] =
        [b"POINT", b"LINESTRING", b"POLYGON", b"MULTI", b"GEOMETRYCOLLECTION", b"SRID=", b"TRIANGLE", b"TIN"];
    WORDS.iter().any(|word| text.len() >= word.len() && text[..word.len()].eq_ignore_ascii_case(word))
}

struct Reader<'a> {
    bytes: &'a [u8],
    name: &'a str,
    at: usize,
    line: u32,
    line_start: usize,
    sketch: Sketch,
    number: u32,
}

impl<'a> Reader<'a> {
    /// One geometry, or a collection of them.
    fn geometry(&mut self) -> Result<(), IoError> {
        let mut open = 0;
        loop {
            let origin = self.line;
            let mut word = self.word()?;
            if word.starts_with("SRID=") {
                // The number of a coordinate system and a semicolon.
                self.skip_until(b';');
                word = self.word()?;
            }
            let is_empty = self.dimensions_and_empty()?;
            if word == "GEOMETRYCOLLECTION" {
                if !is_empty {
                    self.expect(b'(')?;
                    open += 1;
                    if open > DEEPEST {
                        return Err(self.fault("a collection that is less deep"));
                    }
                    continue;
                }
            } else if !is_empty {
                self.body(&word, origin)?;
            }
            // After a geometry within collections: the next one, or the end of some of them.
            while open > 0 {
                self.skip_blanks();
                match self.peek() {
                    Some(b',') => {
                        self.at += 1;
                        break;
                    }
                    Some(b')') => {
                        self.at += 1;
                        open -= 1;
                    }
                    _ => return Err(self.fault("',' or ')'")),
                }
            }
            if open == 0 {
                return Ok(());
            }
        }
    }

    fn body(&mut self, word: &str, origin: u32) -> Result<(), IoError> {
        let (depth, kind) = match word {
            "POINT" => (1, Kind::Points),
            "MULTIPOINT" => (1, Kind::Points),
            "LINESTRING" | "LINEARRING" => (1, Kind::Lines),
            "MULTILINESTRING" => (2, Kind::Lines),
            "POLYGON" | "TRIANGLE" => (2, Kind::Area(Fill::EvenOdd)),
            "MULTIPOLYGON" | "TIN" => (3, Kind::Area(Fill::EvenOdd)),
            _ => return Err(self.fault("POINT, LINESTRING, POLYGON, MULTI… or GEOMETRYCOLLECTION")),
        };
        let layer = self.sketch.layers.number(&format!("geometry {}", self.number));
        let is_closed = matches!(kind, Kind::Area(_));
        for polygon in self.lists(depth)? {
            let paths = polygon.into_iter().filter_map(|ring| Path::of(ring, is_closed)).collect();
            self.sketch.add(kind, layer, origin, paths);
        }
        Ok(())
    }

    /// Lists in lists of positions, in parentheses: `depth` of them.
    fn lists(&mut self, depth: u32) -> Result<Vec<Vec<Vec<Vertex>>>, IoError> {
        match depth {
            1 => Ok(vec![vec![self.positions()?]]),
            2 => Ok(vec![self.several(Self::positions)?]),
            _ => self.several(|reader| reader.several(Self::positions)),
        }
    }

    fn several<T>(&mut self, mut one: impl FnMut(&mut Self) -> Result<T, IoError>) -> Result<Vec<T>, IoError> {
        self.expect(b'(')?;
        let mut all = vec![one(self)?];
        while self.comma_or_end()? {
            all.push(one(self)?);
        }
        Ok(all)
    }

    /// `(x y, x y, …)`; the points of a `MULTIPOINT` may have parentheses of their own. `EMPTY` is a list without any.
    fn positions(&mut self) -> Result<Vec<Vertex>, IoError> {
        self.skip_blanks();
        if self.peek().is_some_and(|b| b.is_ascii_alphabetic()) {
            return if self.word()? == "EMPTY" { Ok(Vec::new()) } else { Err(self.fault("'(' or EMPTY")) };
        }
        self.several(|reader| {
            reader.skip_blanks();
            let has_own = reader.peek() == Some(b'(');
            reader.at += usize::from(has_own);
            let (x, y) = (reader.number("an x coordinate")?, reader.number("a y coordinate")?);
            let mut more = [f64::NAN; 2];
            let mut count = 0;
            loop {
                reader.skip_blanks();
                match (reader.peek(), more.get_mut(count)) {
                    (Some(b',' | b')'), _) => break,
                    (_, Some(slot)) => *slot = reader.number("a height, ',' or ')'")?,
                    _ => return Err(reader.fault("',' or ')'")),
                }
                count += 1;
            }
            if has_own {
                reader.expect(b')')?;
            }
            Ok(Vertex { at: Point::new(x, y), z: more[0] })
        })
    }

    fn comma_or_end(&mut self) -> Result<bool, IoError> {
        self.skip_blanks();
        match self.peek() {
            Some(b @ (b',' | b')')) => {
                self.at += 1;
                Ok(b == b',')
            }
            _ => Err(self.fault("',' or ')'")),
        }
    }

    /// `Z`, `M` or `ZM` (a measure is left out), and whether the geometry is `EMPTY`.
    fn dimensions_and_empty(&mut self) -> Result<bool, IoError> {
        for _ in 0..2 {
            self.skip_blanks();
            if !self.peek().is_some_and(|b| b.is_ascii_alphabetic()) {
                return Ok(false);
            }
            let start = (self.at, self.line, self.line_start);
            match &self.word()?[..] {
                "EMPTY" => return Ok(true),
                "Z" | "ZM" => {}
                "M" => self.sketch.skipped.add("geometries with measures, which count as heights", self.line),
                _ => {
                    (self.at, self.line, self.line_start) = start;
                    return Err(self.fault("'(', Z, M, ZM or EMPTY"));
                }
            }
        }
        Ok(false)
    }

    fn number(&mut self, expected: &str) -> Result<f64, IoError> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let length = rest.iter().take_while(|b| !b.is_ascii_whitespace() && !b"(),;".contains(b)).count();
        let text = &rest[..length];
        let value = std::str::from_utf8(text).ok().and_then(|t| t.parse::<f64>().ok()).filter(|v| v.is_finite());
        let value = value.ok_or_else(|| self.fault(expected))?;
        self.at += length;
        Ok(value)
    }

    /// The next word, in capitals.
    fn word(&mut self) -> Result<String, IoError> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let length = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'=').count();
        if length == 0 || length > 64 {
            return Err(self.fault("the name of a geometry"));
        }
        self.at += length;
        Ok(String::from_utf8_lossy(&rest[..length]).to_ascii_uppercase())
    }

    fn expect(&mut self, byte: u8) -> Result<(), IoError> {
        self.skip_blanks();
        if self.peek() != Some(byte) {
            return Err(self.fault(&format!("'{}'", byte as char)));
        }
        self.at += 1;
        Ok(())
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn skip_until(&mut self, byte: u8) {
        while self.peek().is_some_and(|b| b != byte && b != b'\n') {
            self.at += 1;
        }
        self.at += usize::from(self.peek() == Some(byte));
    }

    /// Blanks, and lines that begin with `#`.
    fn skip_blanks(&mut self) {
        while let Some(b) = self.peek() {
            if b == b'\n' {
                self.line += 1;
                self.line_start = self.at + 1;
            } else if b == b'#' {
                while self.peek().is_some_and(|b| b != b'\n') {
                    self.at += 1;
                }
                continue;
            } else if !b.is_ascii_whitespace() && b != b'"' {
                return;
            }
            self.at += 1;
        }
    }

    fn fault(&self, expected: &str) -> IoError {
        let rest = &self.bytes[self.at.min(self.bytes.len())..];
        let length = rest.iter().take_while(|b| !b.is_ascii_whitespace()).count().max(1).min(rest.len());
        let found = if rest.is_empty() { "the end of the file".to_owned() } else { quote(&rest[..length]) };
        fault_at(self.name, u64::from(self.line), (self.at - self.line_start) as u64 + 1, expected, found)
    }
}
