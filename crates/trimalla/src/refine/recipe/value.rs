//! Values of options of any type, as the command line, recipe files and reports read and write them.

use std::fmt;

use crate::by_key::Row;

/// The value of an [option](super::OptionRow).
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A key.
    Key(&'static str),
    /// Yes or no.
    Truth(bool),
    /// A number.
    Number(f64),
    /// A whole number, not negative.
    Count(usize),
    /// Any text.
    Text(String),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Key(key) => f.write_str(key),
            Self::Truth(truth) => fmt::Display::fmt(truth, f),
            Self::Number(number) => fmt::Display::fmt(number, f),
            Self::Count(count) => fmt::Display::fmt(count, f),
            Self::Text(text) => f.write_str(text),
        }
    }
}

/// What values an option takes.
#[derive(Clone, Copy, Debug)]
pub enum Values {
    /// One of these keys.
    Keys(&'static [Row]),
    /// `true` or `false`.
    Truth(&'static [Row]),
    /// A number.
    Number {
        /// The allowed numbers in words.
        expected: &'static str,
        /// Whether a number is allowed.
        is_allowed: fn(f64) -> bool,
    },
    /// A whole number, not negative; in words.
    Count(&'static str),
    /// Any text; in words.
    Text(&'static str),
}

impl Values {
    /// A row each key; none where the values have no keys.
    #[must_use]
    pub const fn rows(self) -> &'static [Row] {
        match self {
            Self::Keys(rows) | Self::Truth(rows) => rows,
            _ => &[],
        }
    }

    /// The allowed values in words, to stand after *expected*.
    ///
    /// # Examples
    /// ```
    /// use trimalla::refine::{Protect, Values};
    ///
    /// assert_eq!(Values::Keys(Protect::ROWS).expected(), "one of none, boundary, all");
    /// ```
    #[must_use]
    pub fn expected(self) -> String {
        match self {
            Self::Keys(rows) => {
                let keys: Vec<&str> = rows.iter().map(|row| row.key).collect();
                format!("one of {}", keys.join(", "))
            }
            Self::Truth(_) => "true or false".to_owned(),
            Self::Number { expected, .. } | Self::Count(expected) | Self::Text(expected) => expected.to_owned(),
        }
    }

    /// The value that a word stands for, if it is one of these.
    ///
    /// # Examples
    /// ```
    /// use trimalla::refine::{Value, Values};
    ///
    /// assert_eq!(Values::Count("a whole number").of_text("12"), Some(Value::Count(12)));
    /// assert_eq!(Values::Count("a whole number").of_text("-1"), None);
    /// ```
    #[must_use]
    pub fn of_text(self, text: &str) -> Option<Value> {
        match self {
            Self::Keys(_) | Self::Truth(_) => self.of_key(text),
            Self::Number { is_allowed, .. } => text.parse().ok().filter(|&x| is_allowed(x)).map(Value::Number),
            Self::Count(_) => text.parse().ok().map(Value::Count),
            Self::Text(_) => Some(Value::Text(text.to_owned())),
        }
    }

    /// The value of a key.
    #[must_use]
    pub fn of_key(self, key: &str) -> Option<Value> {
        let row = self.rows().iter().find(|row| row.key == key)?;
        match self {
            Self::Truth(_) => row.key.parse().ok().map(Value::Truth),
            _ => Some(Value::Key(row.key)),
        }
    }
}

/// A value that an option does not take.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("'{option}' takes {expected}, not '{value}'")]
pub struct WrongValue {
    /// The key of the option.
    pub option: &'static str,
    /// What it takes.
    pub expected: String,
    /// What it was given.
    pub value: Value,
}

/// A type that a [`Value`] can hold.
pub(super) trait Plain: Sized {
    /// The value as this type, if it is one.
    fn of(value: &Value) -> Option<Self>;

    /// As a value.
    fn value(&self) -> Value;
}

macro_rules! plain {
    ($($type:ty = $variant:ident;)*) => {$(
        impl Plain for $type {
            fn of(value: &Value) -> Option<Self> {
                match value {
                    Value::$variant(value) => Some(value.clone()),
                    _ => None,
                }
            }

            fn value(&self) -> Value {
                Value::$variant(self.clone())
            }
        }
    )*};
}

plain! {
    bool = Truth;
    f64 = Number;
    usize = Count;
    String = Text;
}

/// The field of an option: it always holds a value, or none at first.
pub(super) trait Slot {
    /// Its value.
    fn get(&self) -> Option<Value>;

    /// Sets its value; returns whether the value has the right type.
    fn set(&mut self, value: &Value) -> bool;
}

impl<T: Plain> Slot for T {
    fn get(&self) -> Option<Value> {
        Some(self.value())
    }

    fn set(&mut self, value: &Value) -> bool {
        T::of(value).map(|value| *self = value).is_some()
    }
}

impl<T: Plain> Slot for Option<T> {
    fn get(&self) -> Option<Value> {
        self.as_ref().map(T::value)
    }

    fn set(&mut self, value: &Value) -> bool {
        T::of(value).map(|value| *self = Some(value)).is_some()
    }
}
