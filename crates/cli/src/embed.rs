//! `riverseed embed`: the element for a map, and as JSON all that a generator of pages needs to embed it, so that none has
//! to read links itself.

use std::io::{self, Write};

use clap::ArgMatches;
use riverseed::recipe::link::{self, Notice};
use riverseed::recipe::reading::{self, ReadOptions};
use riverseed::recipe::{EDITION, Key, Recipe, Value as Given};
use serde_json::{Value, json};

use super::order::handed_over;
use super::page::markup::escaped;
use super::{Failure, stdout};

/// Prints the element for the map of the call.
///
/// # Errors
/// Refuses what `render` refuses.
pub fn embed(matches: &ArgMatches) -> Result<(), Failure> {
    stdout::check()?;
    let text = matches.get_one::<String>("link").map_or("", String::as_str);
    let recipe = link::apply(Recipe::default(), &handed_over(text)?)?;
    let link = reading::read_given(text, "", ReadOptions::default()).shared_link();
    let mut out = io::stdout().lock();
    match matches.get_flag("json") {
        true => writeln!(out, "{:#}", facts(&recipe, &link))?,
        false => writeln!(out, "{}", element(&link))?,
    }
    Ok(())
}

/// Writes the element. As a block it is as wide as its column.
fn element(link: &str) -> String {
    format!("<river-seed recipe=\"{}\" style=\"display:block\"></river-seed>", escaped(link))
}

/// Lists the facts about an embed of a map.
fn facts(recipe: &Recipe, link: &str) -> Value {
    json!({
        "link": link,
        "seed": recipe.seed(),
        "edition": EDITION,
        "alternative": recipe.alternative(),
        "aspect": aspect(recipe),
        "beyond_element": beyond_element(link),
    })
}

/// Returns the map's width over its height, as precisely as links write it.
fn aspect(recipe: &Recipe) -> Option<f64> {
    match recipe.value(Key::Aspect) {
        Given::Number(number) => Some(number.to_f64()),
        _ => None, // never: the row of the key holds numbers
    }
}

/// Lists in words what exceeds the element's limits. If anything does, the element draws a smaller map than the picture.
fn beyond_element(link: &str) -> Vec<String> {
    let within = reading::read(link, ReadOptions { widget: true, dark: false });
    within.notices.into_iter().map(|Notice { message, .. }| message).collect()
}
