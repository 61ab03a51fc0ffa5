//! Serialization of what has a key.

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
