//! Choices that have keys: how they are declared, spelled and read.

/// A key and its meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The key, as scripts, the program and reports spell it.
    pub key: &'static str,
    /// One line on what it does.
    pub summary: &'static str,
    /// Where it comes from, a key of REFERENCES.md; empty for what is ours.
    pub source: &'static str,
}

/// An unknown key.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("nothing is called '{key}'; known are {}", .known.join(", "))]
pub struct UnknownKey {
    /// The key.
    pub key: String,
    /// The known keys.
    pub known: Vec<&'static str>,
}

/// Declares an enum whose variants have keys: each is one line with key, summary and source.
macro_rules! keyed {
    ($(#[$doc:meta])* $name:ident, { $($(#[$vdoc:meta])* $variant:ident = $key:literal, $summary:literal, $source:literal;)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum $name { $($(#[$vdoc])* #[doc = concat!("`", $key, "`: ", $summary, ".")] $variant,)* }

        impl $name {
            /// Every choice.
            pub const ALL: [Self; [$($key,)*].len()] = [$(Self::$variant,)*];

            /// The row of every choice, in the order of [`ALL`](Self::ALL).
            pub const ROWS: &'static [$crate::by_key::Row] =
                &[$($crate::by_key::Row { key: $key, summary: $summary, source: $source },)*];

            /// Its key, what it does, and its source.
            #[must_use]
            pub const fn row(self) -> $crate::by_key::Row {
                Self::ROWS[self as usize]
            }

            /// Its key.
            #[must_use]
            pub const fn key(self) -> &'static str {
                self.row().key
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.key())
            }
        }

        impl std::str::FromStr for $name {
            type Err = $crate::by_key::UnknownKey;

            fn from_str(s: &str) -> Result<Self, $crate::by_key::UnknownKey> {
                Self::ALL.iter().copied().find(|c| c.key() == s).ok_or_else(|| $crate::by_key::UnknownKey {
                    key: s.to_owned(),
                    known: Self::ROWS.iter().map(|row| row.key).collect(),
                })
            }
        }

        serialized_by_key!($name);
    };
}

/// Values of these types are serialized as their keys, the feature `serde` being on. Each has `ALL` and `key`.
macro_rules! serialized_by_key {
    ($($name:ty),*) => {$(
        #[cfg(feature = "serde")]
        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.key())
            }
        }

        #[cfg(feature = "serde")]
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let given = String::deserialize(deserializer)?;
                Self::ALL.iter().copied().find(|choice| choice.key() == given).ok_or_else(|| {
                    let keys: Vec<&str> = Self::ALL.iter().map(|choice| choice.key()).collect();
                    let expected = format!("one of {}", keys.join(", "));
                    serde::de::Error::invalid_value(serde::de::Unexpected::Str(&given), &&expected[..])
                })
            }
        }
    )*};
}
