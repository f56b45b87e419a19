//! The contents of a file as data of a single type. A page serializes it with one function instead of one for each kind
//! of record, which saves code to download.

use serde::ser::{Serialize, SerializeMap, Serializer};

/// A JSON value, ready to be written.
pub enum Json<'a> {
    /// JSON null.
    Null,
    /// True or false.
    Truth(bool),
    /// A whole number.
    Whole(i64),
    /// A 32-bit number.
    Single(f32),
    /// A 64-bit number.
    Double(f64),
    /// A fixed text.
    Text(&'static str),
    /// A text made at run time.
    Owned(String),
    /// Names and values.
    Object(Vec<(&'static str, Json<'a>)>),
    /// A number of values, each made when it is written, so that a large network is never in memory twice.
    List(usize, Box<dyn Fn(usize) -> Json<'a> + 'a>),
}

impl<'a> Json<'a> {
    /// Makes a list of `count` values, each made when it is written.
    pub(super) fn list(count: usize, item: impl Fn(usize) -> Self + 'a) -> Self {
        Self::List(count, Box::new(item))
    }

    /// Makes a list of numbers.
    #[inline(never)]
    pub(super) fn singles(numbers: Vec<f32>) -> Self {
        Self::list(numbers.len(), move |i| Self::Single(numbers[i]))
    }

    /// Makes a list of numbers.
    #[inline(never)]
    pub(super) fn doubles(numbers: Vec<f64>) -> Self {
        Self::list(numbers.len(), move |i| Self::Double(numbers[i]))
    }

    /// Makes a list of points, each a list of three numbers.
    #[inline(never)]
    pub(super) fn points(points: Vec<[f32; 3]>) -> Self {
        Self::list(points.len(), move |i| Self::singles(points[i].to_vec()))
    }

    /// Makes a list of whole numbers.
    #[inline(never)]
    pub(super) fn wholes(numbers: Vec<u32>) -> Self {
        Self::list(numbers.len(), move |i| Self::Whole(numbers[i].into()))
    }
}

/// The members of an object while it is put together. They are added by functions that are not inlined, which would be
/// several times as much code to download.
#[derive(Default)]
pub(super) struct Members<'a>(Vec<(&'static str, Json<'a>)>);

impl<'a> Members<'a> {
    /// Returns `true` if there is a member of this name.
    pub fn holds(&self, name: &str) -> bool {
        self.0.iter().any(|(other, _)| *other == name)
    }

    #[inline(never)]
    pub fn value(&mut self, name: &'static str, value: Json<'a>) -> &mut Self {
        self.0.push((name, value));
        self
    }

    #[inline(never)]
    pub fn object(&mut self, name: &'static str, members: Self) -> &mut Self {
        self.value(name, Json::Object(members.0))
    }

    #[inline(never)]
    pub fn whole(&mut self, name: &'static str, number: u32) -> &mut Self {
        self.value(name, Json::Whole(number.into()))
    }

    /// Adds a whole number, or null if it equals `none`.
    #[inline(never)]
    pub fn unless(&mut self, name: &'static str, number: u32, none: u32) -> &mut Self {
        if number == none { self.value(name, Json::Null) } else { self.whole(name, number) }
    }

    #[inline(never)]
    pub fn single(&mut self, name: &'static str, number: f32) -> &mut Self {
        self.value(name, Json::Single(number))
    }

    #[inline(never)]
    pub fn double(&mut self, name: &'static str, number: f64) -> &mut Self {
        self.value(name, Json::Double(number))
    }

    #[inline(never)]
    pub fn text(&mut self, name: &'static str, text: &'static str) -> &mut Self {
        self.value(name, Json::Text(text))
    }

    #[inline(never)]
    pub fn owned(&mut self, name: &'static str, text: String) -> &mut Self {
        self.value(name, Json::Owned(text))
    }
}

impl<'a> From<Members<'a>> for Json<'a> {
    fn from(members: Members<'a>) -> Self {
        Self::Object(members.0)
    }
}

impl Serialize for Json<'_> {
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
