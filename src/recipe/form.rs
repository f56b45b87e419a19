//! A recipe as an object: every parameter by its name, numbers as numbers, everything else as text.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::Recipe;
use super::table::TABLE;
use super::value::Value;

/// All values, defaults too: such a recipe stays readable when a default is chosen anew.
impl Serialize for Recipe {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(TABLE.len()))?;
        for parameter in &TABLE {
            match self.value(parameter.key) {
                Value::Integer(n) => map.serialize_entry(parameter.name, n)?,
                Value::Number(x) => map.serialize_entry(parameter.name, &x.to_f64())?,
                other => map.serialize_entry(parameter.name, &parameter.text_of(other))?,
            }
        }
        map.end()
    }
}
