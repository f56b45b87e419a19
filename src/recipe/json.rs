//! The JSON form of a recipe: an object of keys and values, numbers as numbers, everything else as text.
//!
//! A whole network's JSON is read too: its member `recipe` is the recipe.

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::Value as Json;

use super::Recipe;
use super::error::RecipeError;
use super::link;
use super::table::TABLE;
use super::value::Value;

/// The longest JSON recipe that is read, in bytes: a network of a million nodes fits.
pub const LONGEST: usize = 256 << 20;

/// All values of a recipe, defaults too: such a recipe stays readable when a default is chosen anew.
pub fn to_json(recipe: &Recipe) -> Json {
    let member = |parameter: &super::Parameter| {
        let value = match recipe.value(parameter.key) {
            Value::Integer(n) => Json::from(*n),
            Value::Number(x) => Json::from(x.to_f64()),
            other => Json::from(parameter.text_of(other)),
        };
        (parameter.name.to_owned(), value)
    };
    Json::Object(TABLE.iter().map(member).collect())
}

/// Reads a recipe over defaults.
///
/// # Errors
/// JSON that is not an object, and everything that [`link::read`] refuses.
pub fn read(text: &str) -> Result<Recipe, RecipeError> {
    link::apply(Recipe::default(), &pairs(text)?)
}

/// Names and values of a JSON recipe, for [`link::apply`].
///
/// # Errors
/// JSON that is not an object of texts and numbers.
pub fn pairs(text: &str) -> Result<Vec<(String, String)>, RecipeError> {
    if text.len() > LONGEST {
        return Err(RecipeError::TooLong { key: "recipe", length: text.len(), max: LONGEST });
    }
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
    Err(RecipeError::JsonType { key: super::error::shown(key), found })
}

/// The members of a recipe object in their order, repeats included: a map would silently keep the last of them.
struct Members(Vec<(String, Json)>);

impl<'de> Deserialize<'de> for Members {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(MembersVisitor)
    }
}

struct MembersVisitor;

impl<'de> Visitor<'de> for MembersVisitor {
    type Value = Members;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("an object of keys and values")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members, A::Error> {
        let mut members = Vec::new();
        while let Some(key) = map.next_key::<String>()? {
            if key == "recipe" {
                // The rest of a network's JSON is passed over.
                members = map.next_value::<Members>()?.0;
                while map.next_entry::<serde::de::IgnoredAny, serde::de::IgnoredAny>()?.is_some() {}
                break;
            }
            members.push((key, map.next_value::<Json>()?));
        }
        Ok(Members(members))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Key;

    #[test]
    fn written_recipe_reads_back() {
        let recipe = link::read("seed=Te+Awa&curl=0.6&sides=ns&style=skeleton").unwrap();
        assert_eq!(read(&to_json(&recipe).to_string()), Ok(recipe));
    }

    #[test]
    fn recipe_of_a_network_is_read() {
        let json = r#"{"recipe": {"trim": 7}, "nodes": {"x": [1, 2]}}"#;
        assert_eq!(read(json).unwrap().integer(Key::Trim), 7);
    }

    #[test]
    fn junk_is_refused_with_its_place() {
        let error = |text: &str| read(text).unwrap_err().to_string();
        assert!(error("{").contains("line 1"));
        assert!(error("[]").contains("an object"));
        assert_eq!(error(r#"{"curl": 1, "curl": 1}"#), "'curl' is given more than once");
        assert_eq!(error(r#"{"curl": null}"#), "curl: a text or a number is wanted, not null");
        assert_eq!(error(r#"{"trim": 1e300}"#), "trim: '1e+300' is not a number");
    }
}
