//! Named options as a map: the keys and tables of recipe files, in any format of serde that describes itself.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, Unexpected, Visitor};
use serde::ser::{SerializeMap as _, Serializer};
use serde::{Deserialize, Serialize};

use super::named::NamedOptions;
use super::table::{Group, OptionRow};
use super::value::{Value, Values};

type Said = Vec<(&'static OptionRow, Value)>;

impl Serialize for NamedOptions {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let own = said_of(self, None);
        let tables = Group::TABLES.map(|name| (name, said_of(self, Some(name))));
        let tables: Vec<_> = tables.into_iter().filter(|(_, said)| !said.is_empty()).collect();
        let mut map = serializer.serialize_map(Some(own.len() + tables.len()))?;
        own.iter().try_for_each(|(option, value)| map.serialize_entry(option.key, value))?;
        tables.iter().try_for_each(|(name, said)| map.serialize_entry(name, &Table(said)))?;
        map.end()
    }
}

/// The options that are set in a table, or in the file itself.
fn said_of(options: &NamedOptions, table: Option<&str>) -> Said {
    OptionRow::of_table(table).filter_map(|option| Some((option, option.get(options)?))).collect()
}

struct Table<'a>(&'a Said);

impl Serialize for Table<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(option, value)| (option.key, value)))
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Key(key) => key.serialize(serializer),
            Self::Truth(truth) => truth.serialize(serializer),
            Self::Number(number) => number.serialize(serializer),
            Self::Count(count) => count.serialize(serializer),
            Self::Text(text) => text.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for NamedOptions {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut said = Said::new();
        deserializer.deserialize_map(Entries { table: None, said: &mut said })?;
        // The preset first, wherever it stands: it replaces every step.
        said.sort_by_key(|(option, _)| option.group != Group::Preset);
        let mut options = Self::default();
        for (option, value) in said {
            option.set(&mut options, &value).map_err(D::Error::custom)?;
        }
        Ok(options)
    }
}

/// Collects the entries of a table, or of the file itself.
struct Entries<'a> {
    table: Option<&'static str>,
    said: &'a mut Said,
}

impl<'de> DeserializeSeed<'de> for Entries<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Entries<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table of options")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let tables = Group::TABLES.iter().copied().filter(|_| self.table.is_none());
        while let Some(key) = map.next_key::<String>()? {
            if let Some(option) = OptionRow::of_table(self.table).find(|option| option.key == key) {
                self.said.push((option, map.next_value_seed(OfOption(option.values))?));
            } else if let Some(table) = tables.clone().find(|table| *table == key) {
                map.next_value_seed(Entries { table: Some(table), said: &mut *self.said })?;
            } else {
                let known = OptionRow::of_table(self.table).map(|option| option.key).chain(tables);
                let known = known.collect::<Vec<_>>().join(", ");
                return Err(A::Error::custom(format!("no option is called '{key}'; known are {known}")));
            }
        }
        Ok(())
    }
}

/// A value that an option takes.
#[derive(Clone, Copy)]
struct OfOption(Values);

impl<'de> DeserializeSeed<'de> for OfOption {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl Visitor<'_> for OfOption {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.expected())
    }

    fn visit_bool<E: Error>(self, given: bool) -> Result<Value, E> {
        match self.0 {
            Values::Truth(_) => Ok(Value::Truth(given)),
            _ => Err(E::invalid_type(Unexpected::Bool(given), &self)),
        }
    }

    fn visit_str<E: Error>(self, given: &str) -> Result<Value, E> {
        let value = match self.0 {
            Values::Keys(_) => self.0.of_key(given),
            Values::Text(_) => Some(Value::Text(given.to_owned())),
            _ => None,
        };
        value.ok_or_else(|| E::invalid_value(Unexpected::Str(given), &self))
    }

    fn visit_u64<E: Error>(self, given: u64) -> Result<Value, E> {
        match self.0 {
            Values::Count(_) => usize::try_from(given)
                .map(Value::Count)
                .map_err(|_| E::invalid_value(Unexpected::Unsigned(given), &self)),
            _ => self.visit_f64(given as f64),
        }
    }

    fn visit_i64<E: Error>(self, given: i64) -> Result<Value, E> {
        u64::try_from(given).map_or_else(|_| self.visit_f64(given as f64), |given| self.visit_u64(given))
    }

    fn visit_f64<E: Error>(self, given: f64) -> Result<Value, E> {
        match self.0 {
            Values::Number { is_allowed, .. } if is_allowed(given) => Ok(Value::Number(given)),
            _ => Err(E::invalid_value(Unexpected::Float(given), &self)),
        }
    }
}
