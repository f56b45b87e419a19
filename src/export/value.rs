//! What is to be written, as one type of data: so a page, which pays for each byte of code, serializes it by one function,
//! and not by one for each kind of record.

use serde::ser::{Serialize, SerializeMap, Serializer};

/// Data as JSON knows it.
pub enum Value<'a> {
    /// Nothing.
    Null,
    /// True or false.
    Truth(bool),
    /// A whole number.
    Whole(i64),
    /// A number.
    Single(f32),
    /// A number.
    Double(f64),
    /// A text.
    Text(&'static str),
    /// A text made for this.
    Owned(String),
    /// Names and values.
    Object(Vec<(&'static str, Value<'a>)>),
    /// So many values, each made when it is written: a large network is never there twice.
    List(usize, Box<dyn Fn(usize) -> Value<'a> + 'a>),
}

impl<'a> Value<'a> {
    /// A list.
    pub(super) fn list(count: usize, item: impl Fn(usize) -> Self + 'a) -> Self {
        Self::List(count, Box::new(item))
    }

    /// A list of numbers.
    pub(super) fn singles(numbers: Vec<f32>) -> Self {
        Self::list(numbers.len(), move |i| Self::Single(numbers[i]))
    }

    /// A list of numbers.
    pub(super) fn doubles(numbers: Vec<f64>) -> Self {
        Self::list(numbers.len(), move |i| Self::Double(numbers[i]))
    }

    /// A list of whole numbers.
    pub(super) fn wholes(numbers: Vec<u32>) -> Self {
        Self::list(numbers.len(), move |i| Self::whole(numbers[i]))
    }

    /// A whole number.
    pub(super) fn whole(number: u32) -> Self {
        Self::Whole(number.into())
    }

    /// A number, or nothing for one that stands for nothing.
    pub(super) fn unless(number: u32, none: u32) -> Self {
        if number == none { Self::Null } else { Self::whole(number) }
    }
}

impl Serialize for Value<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Null => serializer.serialize_unit(),
            Self::Truth(truth) => serializer.serialize_bool(*truth),
            Self::Whole(number) => serializer.serialize_i64(*number),
            Self::Single(number) => serializer.serialize_f32(*number),
            Self::Double(number) => serializer.serialize_f64(*number),
            Self::Text(text) => serializer.serialize_str(text),
            Self::Owned(text) => serializer.serialize_str(text),
            Self::Object(members) => {
                let mut map = serializer.serialize_map(Some(members.len()))?;
                for (name, value) in members {
                    map.serialize_entry(name, value)?;
                }
                map.end()
            }
            Self::List(count, item) => serializer.collect_seq((0..*count).map(item)),
        }
    }
}
