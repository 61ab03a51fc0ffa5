//! The words of a command line, taken one after the other.

use std::path::PathBuf;

use trimalla::geometry::Point;

use crate::error::CommandError;

/// A word, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Word<'a> {
    pub(crate) text: &'a str,
    /// The first column, counted in characters from 1.
    pub(crate) column: usize,
}

impl Word<'_> {
    /// A fault of this word.
    pub(crate) fn fault(&self, message: impl Into<String>) -> CommandError {
        CommandError::at(self.column, self.text.chars().count(), message)
    }
}

/// The words of a line, without its comment.
#[derive(Clone, Debug)]
pub(crate) struct Arguments<'a> {
    words: Vec<Word<'a>>,
    taken: usize,
    /// The column behind the last word.
    end: usize,
}

impl<'a> Arguments<'a> {
    /// Splits a line at blanks. `#` at the start of a word begins a comment; a word in quotes may hold both.
    pub(crate) fn of(line: &'a str) -> Self {
        let (mut words, mut column, mut rest) = (Vec::new(), 1, line);
        loop {
            let blanks = rest.len() - rest.trim_start().len();
            column += rest[..blanks].chars().count();
            rest = &rest[blanks..];
            if rest.is_empty() || rest.starts_with('#') {
                break;
            }
            let quoted = rest.strip_prefix('"').and_then(|inner| inner.split_once('"'));
            let (text, taken) = match quoted {
                Some((text, _)) => (text, text.len() + 2),
                None => {
                    let length = rest.find(char::is_whitespace).unwrap_or(rest.len());
                    (&rest[..length], length)
                }
            };
            words.push(Word { text, column });
            column += rest[..taken].chars().count();
            rest = &rest[taken..];
        }
        let end = words.last().map_or(1, |w| w.column + w.text.chars().count());
        Self { words, taken: 0, end }
    }

    /// The next word, if there is one.
    pub(crate) fn next(&mut self) -> Option<Word<'a>> {
        let word = self.words.get(self.taken).copied();
        self.taken += usize::from(word.is_some());
        word
    }

    /// The next word.
    pub(crate) fn word(&mut self, what: &str) -> Result<Word<'a>, CommandError> {
        let end = self.end;
        self.next().ok_or_else(|| CommandError::at(end, 1, format!("expected {what}, found the end of the line")))
    }

    /// The words that are left.
    pub(crate) fn rest(&mut self) -> Vec<Word<'a>> {
        std::iter::from_fn(|| self.next()).collect()
    }

    /// Nothing may be left.
    pub(crate) fn end(&mut self) -> Result<(), CommandError> {
        self.next().map_or(Ok(()), |word| Err(word.fault(format!("unexpected '{}'", word.text))))
    }

    /// The index of a vertex.
    pub(crate) fn index(&mut self) -> Result<u32, CommandError> {
        let word = self.word("the index of a vertex")?;
        index_of(word)
    }

    /// A number of things, 1 where the line ends.
    pub(crate) fn count_or_one(&mut self) -> Result<usize, CommandError> {
        self.next().map_or(Ok(1), |word| count_of(word, "a number of times"))
    }

    /// A finite number.
    pub(crate) fn number(&mut self, what: &str) -> Result<f64, CommandError> {
        let word = self.word(what)?;
        number_of(word, what)
    }

    /// A point.
    pub(crate) fn point(&mut self) -> Result<Point, CommandError> {
        Ok(Point::new(self.number("an x coordinate")?, self.number("a y coordinate")?))
    }

    /// The indices of three different vertices.
    pub(crate) fn triangle(&mut self) -> Result<[u32; 3], CommandError> {
        Ok([self.index()?, self.index()?, self.index()?])
    }

    /// One of some keys, whatever the case of its letters.
    pub(crate) fn key<T: Copy>(word: Word<'_>, keys: &[(&str, T)]) -> Result<T, CommandError> {
        let found = keys.iter().find(|(key, _)| key.eq_ignore_ascii_case(word.text)).map(|(_, value)| *value);
        found.ok_or_else(|| {
            let all: Vec<&str> = keys.iter().map(|(key, _)| *key).collect();
            word.fault(format!("expected {}, found '{}'", all.join(" or "), word.text))
        })
    }

    /// The name of a file.
    pub(crate) fn path(&mut self) -> Result<PathBuf, CommandError> {
        self.word("a file").map(|word| PathBuf::from(word.text))
    }
}

/// The index of a vertex.
pub(crate) fn index_of(word: Word<'_>) -> Result<u32, CommandError> {
    let found = || word.fault(format!("expected the index of a vertex, found '{}'", word.text));
    // The last few are not names of vertices.
    word.text.parse().ok().filter(|&i: &u32| i < 1 << 31).ok_or_else(found)
}

/// A number of things.
pub(crate) fn count_of(word: Word<'_>, what: &str) -> Result<usize, CommandError> {
    word.text.parse().map_err(|_| word.fault(format!("expected {what}, found '{}'", word.text)))
}

/// A finite number.
pub(crate) fn number_of(word: Word<'_>, what: &str) -> Result<f64, CommandError> {
    let fault = || word.fault(format!("expected {what}, a finite number, found '{}'", word.text));
    word.text.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(fault)
}
