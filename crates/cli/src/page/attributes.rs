//! The attributes of the element `<river-seed>` for a link.

use riverseed::Map;
use riverseed::picture::carried::Carried;
use riverseed::recipe::link;
use serde_json::{Value, json};

use super::super::Failure;

/// Parameters whose names mean something else in HTML. As attributes they have a prefix.
const PREFIXED: [&str; 2] = ["style", "width"];

/// Makes the attributes for a link, as names and values for a template.
///
/// # Errors
/// Fails if the link cannot be read.
pub fn of(link: &str) -> Result<Vec<Value>, Failure> {
    Ok(link::pairs(link)?.into_iter().map(|(key, value)| attribute(&named(&key), &value)).collect())
}

/// Returns the attribute with the letters of a map, which spare readers the engine that knows names; `None` if it has none to carry.
pub fn letters(map: &Map) -> Option<Value> {
    Carried::write(map, &[map.recipe()]).map(|letters| attribute("letters", &letters))
}

/// Makes an attribute for a template.
pub fn attribute(name: &str, value: &str) -> Value {
    json!({ "name": name, "value": value })
}

fn named(key: &str) -> String {
    if PREFIXED.contains(&key) { format!("river-{key}") } else { key.into() }
}
