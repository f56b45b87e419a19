//! `--land map.png`: a picture that is the land itself. Links only have room for its outline.

use std::path::Path;
use std::sync::Arc;

use clap::ArgMatches;
use riverseed::domain::Domain;
use riverseed::import::png::Image;
use riverseed::land::Land;
use riverseed::land::trace::{TraceError, trace};
use riverseed::recipe::{Key, LandKind, Recipe, is_decided};

use super::outline::{read_picture, say_what_is_odd};
use super::{Failure, say};

/// Returns `true` if a value of `--land` is the path of a picture, and not a kind of land.
pub fn is_picture(value: &str) -> bool {
    Path::new(value).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"))
}

/// Finds the path of the picture that `--land` names, if it names one.
pub fn path(matches: &ArgMatches) -> Option<&Path> {
    let value = matches.get_one::<String>(Key::Land.parameter().name)?;
    is_picture(value).then(|| Path::new(value))
}

/// Reads the land in a picture, and makes a recipe that of it: drawn land, with the picture's aspect, and its outline for
/// links.
///
/// # Errors
/// Fails if the picture cannot be read, or if it contradicts a given value.
pub fn read(path: &Path, recipe: &mut Recipe, given: &[String]) -> Result<Arc<Land>, Failure> {
    let image = read_picture(path)?;
    let Outlined { aspect, outline } = outlined(path, &image)?;
    let values = [(Key::Land, LandKind::Drawn.word().name), (Key::Aspect, &aspect), (Key::Outline, &outline)];
    for (key, value) in values {
        let before = recipe.clone();
        // `land=auto` says nothing.
        let is_left = is_decided(key) && !recipe.is_named(key);
        let is_given = !is_left && given.iter().any(|name| *name == key.parameter().name);
        recipe.set(key, value)?;
        // A link that this command wrote may be given again with the same picture.
        if is_given && before != *recipe {
            let reason = format!("the picture determines '{}', and another value is given", key.parameter().name);
            return Err(Failure::Land { path: path.into(), reason });
        }
    }
    let land = Land::from_picture(&Domain::of(recipe), image.width, image.height, &image.rgba);
    land.map_err(|error| refused(path, &error))
}

struct Outlined {
    aspect: String,
    outline: String,
}

/// Traces the outline for links, and reports how detailed it is.
fn outlined(path: &Path, image: &Image) -> Result<Outlined, Failure> {
    let traced = trace(image.width, image.height, &image.rgba).map_err(|error| refused(path, &error))?;
    let lines = traced.outline.coasts().iter().chain(traced.outline.ridges());
    let points = lines.map(Vec::len).sum::<usize>();
    say(&format!(
        "the land is {} in full detail; links in files hold only its outline, of {points} points",
        path.display()
    ));
    say_what_is_odd(&traced);
    Ok(Outlined { aspect: format!("{:.2}", traced.aspect), outline: traced.outline.to_string() })
}

fn refused(path: &Path, error: &TraceError) -> Failure {
    Failure::Picture { path: path.into(), reason: error.to_string() }
}
