//! The words on a map's page.

use clap::ArgMatches;
use riverseed::Map;
use riverseed::annotate::names::Names;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Kind, Parameter, Recipe, link, visible};
use riverseed::scale::figures;
use serde_json::{Value, json};

use super::super::Failure;
use super::markup::in_order;

/// The most characters of a title and of a description.
const LONGEST: usize = 300;

/// Reads the words of an option, if it is given.
///
/// # Errors
/// Refuses words that nobody could see, and too many.
pub fn given(matches: &ArgMatches, option: &'static str) -> Result<Option<String>, Failure> {
    let Some(words) = matches.get_one::<String>(option) else { return Ok(None) };
    let refused = |reason| Err(Failure::Words { option, reason });
    match words.trim() {
        "" => refused("there are no words"),
        words if words.chars().any(char::is_control) => refused("there is a character that cannot be shown"),
        words if words.chars().count() > LONGEST => refused("there are more than 300 characters"),
        words => Ok(Some(words.into())),
    }
}

/// Returns the map's name, or what it grew from if the recipe takes its name away.
pub fn name(names: &Names, recipe: &Recipe) -> String {
    if names.title.is_empty() { visible(&recipe.alternative()) } else { names.title.clone() }
}

/// Writes a sentence or two on the rivers.
pub fn description(map: &Map, names: &Names) -> String {
    let network = map.network();
    let lengths = network.rivers.iter().map(|river| network.length(river));
    let longest = lengths.enumerate().max_by(|(_, one), (_, other)| one.total_cmp(other));
    let Some((i, length)) = longest else { return "A map without rivers, grown from a word.".into() };
    let counted = match network.rivers.len() {
        1 => "One river, grown from a word.".into(),
        count => format!("{count} rivers, grown from a word."),
    };
    let kilometres = figures(map.scale().kilometres(length));
    match names.rivers.get(i).map(|river| river.name.as_str()).filter(|name| !name.is_empty()) {
        Some(name) => format!("{counted} The longest, {name}, is {kilometres} km long."),
        None => format!("{counted} The longest is {kilometres} km long."),
    }
}

/// Writes the words for readers who do not see the picture.
pub fn alternative(names: &Names, name: &str) -> String {
    if names.title.is_empty() { format!("A map: {name}") } else { format!("A map of {} and its rivers", names.title) }
}

/// Lists the settings of a link, as labels and values for a template.
///
/// # Errors
/// Fails if the link cannot be read.
pub fn settings(link: &str) -> Result<Vec<Value>, Failure> {
    let row = |(key, text): (String, String)| match TABLE.iter().find(|row| row.name == key) {
        Some(row) => json!({ "label": row.label, "value": in_order(&worded(row, &text)) }),
        None => json!({ "label": key, "value": in_order(&text) }),
    };
    Ok(link::pairs(link)?.into_iter().map(row).collect())
}

/// Writes a value as the page shows it.
fn worded(row: &Parameter, text: &str) -> String {
    match row.kind {
        Kind::Choice { choices, .. } => {
            choices.iter().find(|word| word.name == text).map_or(text, |word| word.label).into()
        }
        _ if row.unit.is_empty() => text.into(),
        _ => format!("{text} {}", row.unit),
    }
}
