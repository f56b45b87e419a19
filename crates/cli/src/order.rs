//! The recipe of a call, from its link, file and options.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::ArgMatches;
use riverseed::land::Land;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Key, LandKind, Recipe, RecipeError, given, json, link};

use super::{Failure, mask, say};

/// The recipe of a call, and the land itself if it is given as a picture.
#[derive(Clone)]
pub struct Order {
    pub recipe: Recipe,
    /// The names of parameters that were given on purpose.
    pub given: Vec<String>,
    pub land: Option<Arc<Land>>,
}

impl Order {
    pub fn of(matches: &ArgMatches) -> Result<Self, Failure> {
        let (mut recipe, given) = recipe(matches)?;
        let land = mask::path(matches).map(|path| mask::read(path, &mut recipe, &given)).transpose()?;
        Ok(Self { recipe, given, land })
    }

    /// Warns of given values that have no effect in any of the files. `are_pictures` holds `true` for each file that is
    /// a picture. The recipe must be that of each map: what is idle in one country may not be in that of another seed.
    pub fn say_what_is_idle(&self, are_pictures: &[bool]) {
        let kind = if self.land.is_some() { LandKind::Drawn } else { Land::kind_of(&self.recipe) };
        let reason = |key, is_picture| match (key, &self.land) {
            (Key::Roughness | Key::Drowning, Some(_)) => Some("the picture determines the coast"),
            _ if is_picture => self.recipe.inactive_reason(key, kind),
            _ => self.recipe.inactive_reason_in_data(key, kind),
        };
        let in_all = |key| {
            let reasons = are_pictures.iter().map(|is_picture| reason(key, *is_picture));
            reasons.reduce(|one, other| one.and(other)).flatten()
        };
        for name in &self.given {
            if let Some(reason) = Key::from_name(name).and_then(in_all) {
                say(&format!("'{name}' has no effect: {reason}"));
            }
        }
    }
}

/// Reads link, file and options in the order in which they were given. Also returns the names of parameters that were
/// given on purpose. A network's file states every parameter, so only those that differ from the default count. A
/// picture of a land is not a part of the recipe.
fn recipe(matches: &ArgMatches) -> Result<(Recipe, Vec<String>), Failure> {
    let mut parts: Vec<(usize, Vec<(String, String)>)> = Vec::new();
    let mut part = |id: &str, pairs: Vec<(String, String)>| {
        parts.extend(matches.index_of(id).map(|index| (index, pairs)));
    };
    if let Some(text) = matches.get_one::<String>("link") {
        part("link", handed_over(text)?);
    }
    if let Some(path) = matches.get_one::<PathBuf>("recipe") {
        part("recipe", json::pairs(&read_recipe(path)?)?);
    }
    for name in TABLE.iter().map(|parameter| parameter.name).chain([link::PRESET]) {
        let values: Vec<&String> = matches.get_many(name).into_iter().flatten().collect();
        if values.len() > 1 {
            return Err(RecipeError::Duplicate { key: name.into() }.into());
        }
        if let [value] = values[..]
            && !(name == Key::Land.parameter().name && mask::is_picture(value))
        {
            part(name, option(name, value)?);
        }
    }
    // A preset is read first, wherever it occurs.
    parts.sort_by_key(|(index, pairs)| (pairs.iter().all(|(name, _)| name != link::PRESET), *index));
    let mut given: Vec<String> = Vec::new();
    let mut recipe = Recipe::default();
    let file = matches.index_of("recipe");
    for (index, pairs) in parts {
        recipe = link::apply(recipe, &pairs)?;
        let names = pairs.into_iter().map(|(name, _)| name);
        let names = names.filter(|name| Some(index) != file || is_set(&recipe, name));
        given.extend(names.filter(|name| !given.contains(name)).collect::<Vec<_>>());
    }
    Ok((recipe, given))
}

/// Reads what was handed over as a link, and says what had to be mended or left out.
pub fn handed_over(text: &str) -> Result<Vec<(String, String)>, Failure> {
    let (pairs, notices) = given::pairs(text)?;
    notices.iter().for_each(|notice| say(&notice.message));
    Ok(pairs)
}

/// Reads the value of an option. An address in place of the seed is a whole link.
fn option(name: &str, value: &str) -> Result<Vec<(String, String)>, Failure> {
    let is_link = name == Key::Seed.parameter().name && given::is_address(value);
    if is_link { handed_over(value) } else { Ok(vec![(name.into(), value.into())]) }
}

/// Returns `true` if a recipe's value of a parameter is neither the default nor its country's.
fn is_set(recipe: &Recipe, name: &str) -> bool {
    Key::from_name(name).is_some_and(|key| recipe.is_named(key))
}

/// Reads a recipe's file, up to a limit.
fn read_recipe(path: &Path) -> Result<String, Failure> {
    let mut text = String::new();
    let file = File::open(path).map_err(Failure::file(path))?;
    file.take(json::LONGEST as u64 + 1).read_to_string(&mut text).map_err(Failure::file(path))?;
    Ok(text)
}
