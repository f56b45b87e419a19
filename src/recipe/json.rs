//! The JSON form of a recipe: an object of keys and values, numbers as numbers, everything else as text.
//!
//! A whole network's JSON is read too: its first member, `recipe`, is the recipe.

use serde::de::{Deserialize, Deserializer, Error, IgnoredAny, MapAccess, Visitor};
use serde_json::Value as Json;

use super::Recipe;
use super::error::RecipeError;
use super::hidden::shown;
use super::link;

/// The longest JSON recipe that is read, in bytes. A network of a million nodes fits.
pub const LONGEST: usize = 256 << 20;

/// Reads a recipe; missing keys keep their defaults, or are the country's.
///
/// # Errors
/// Refuses JSON that is not an object, and everything that [`link::read`] refuses.
pub fn read(text: &str) -> Result<Recipe, RecipeError> {
    link::apply(Recipe::default(), &pairs(text)?)
}

/// Reads the names and values of a JSON recipe, for [`link::apply`].
///
/// # Errors
/// Refuses JSON that is not an object of texts and numbers.
pub fn pairs(text: &str) -> Result<Vec<(String, String)>, RecipeError> {
    if text.len() > LONGEST {
        return Err(RecipeError::TooLong { key: "recipe", length: text.len(), max: LONGEST });
    }
    // Some editors begin every file with a byte order mark.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let members: Members =
        serde_json::from_str(text).map_err(|error| RecipeError::Json { reason: error.to_string() })?;
    let pair = |(key, value): (String, Json)| text_of(&key, value).map(|text| (key, text));
    members.0.into_iter().map(pair).collect()
}

fn text_of(key: &str, value: Json) -> Result<String, RecipeError> {
    let found = match value {
        Json::String(text) => return Ok(text),
        Json::Number(number) => return Ok(number.to_string()),
        Json::Null => "null",
        Json::Bool(_) => "true or false",
        Json::Array(_) => "a list",
        Json::Object(_) => "an object",
    };
    Err(RecipeError::JsonType { key: shown(key), found })
}

/// The members of a recipe object in order, with repeats: a map would silently keep the last of them.
struct Members(Vec<(String, Json)>);

impl<'de> Deserialize<'de> for Members {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(MembersVisitor)
    }
}

struct MembersVisitor;

/// Members without a nested recipe.
struct Plain(Vec<(String, Json)>);

impl<'de> Deserialize<'de> for Plain {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(PlainVisitor)
    }
}

struct PlainVisitor;

impl<'de> Visitor<'de> for PlainVisitor {
    type Value = Plain;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("an object of keys and values")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Plain, A::Error> {
        let mut members = Vec::new();
        while let Some(member) = map.next_entry()? {
            members.push(member);
        }
        Ok(Plain(members))
    }
}

impl<'de> Visitor<'de> for MembersVisitor {
    type Value = Members;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("an object of keys and values")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members, A::Error> {
        let mut members = Vec::new();
        while let Some(key) = map.next_key::<String>()? {
            if key == NETWORK[0] && members.is_empty() {
                members = map.next_value::<Plain>()?.0;
                pass_over_network(map)?;
                break;
            }
            members.push((key, map.next_value()?));
        }
        Ok(Members(members))
    }
}

/// The members of a network's JSON: the recipe first, then members that this reader skips.
const NETWORK: [&str; 14] = [
    "recipe",
    "resolved",
    "domain",
    "growth",
    "measures",
    "pattern",
    "nodes",
    "rivers",
    "oxbows",
    "lakes",
    "distributaries",
    "deltas",
    "names",
    "attractors",
];

fn pass_over_network<'de, A: MapAccess<'de>>(mut map: A) -> Result<(), A::Error> {
    let mut seen = vec![String::from(NETWORK[0])];
    while let Some(key) = map.next_key::<String>()? {
        if !NETWORK.contains(&key.as_str()) {
            return Err(A::Error::custom(format_args!("'{}' does not belong in a network", shown(&key))));
        }
        if seen.contains(&key) {
            return Err(A::Error::custom(format_args!("'{key}' is given more than once")));
        }
        map.next_value::<IgnoredAny>()?;
        seen.push(key);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::NumberKey;

    #[test]
    fn written_recipe_reads_back() {
        let recipe = link::read("seed=Te+Awa&curl=0.6&sides=ns&style=skeleton").unwrap();
        let written = serde_json::to_string(&crate::export::json::recipe(&recipe)).unwrap();
        assert_eq!(read(&written), Ok(recipe));
    }

    #[test]
    fn recipe_of_a_network_is_read() {
        let json = r#"{"recipe": {"trim": 7}, "nodes": {"x": [1, 2]}}"#;
        assert_eq!(read(json).unwrap().number(NumberKey::Trim), 7.0);
    }

    #[test]
    fn junk_is_refused_with_its_place() {
        let error = |text: &str| read(text).unwrap_err().to_string();
        assert!(error("{").contains("line 1"));
        assert!(error("[]").contains("an object"));
        assert_eq!(error(r#"{"curl": 1, "curl": 1}"#), "'curl' is given more than once");
        assert_eq!(error(r#"{"curl": null}"#), "curl: a text or a number is wanted, not null");
        let network = r#"{"recipe": {"trim": 3}, "nodes": 1, "nodes": 2}"#;
        assert!(error(network).contains("'nodes' is given more than once"));
        assert!(error(r#"{"recipe": {"trim": 3}, "junk": 1}"#).contains("'junk' does not belong"));
        assert!(error(r#"{"curl": 1, "recipe": {"trim": 3}}"#).starts_with("recipe: a text or a number is wanted"));
        assert!(error(r#"{"recipe": {"recipe": {"trim": 3}}}"#).starts_with("recipe: a text or a number is wanted"));
        assert_eq!(error(r#"{"trim": 1e300}"#), "trim: '1e+300' is not a number in plain digits");
    }
}
