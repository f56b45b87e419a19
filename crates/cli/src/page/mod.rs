//! `riverseed page`: a map as a folder of static files that any host can serve under any path: a page, pictures, a card
//! for chats, an embed page that blogs show by oEmbed, and the element.

mod address;
mod attributes;
mod card;
mod composition;
mod element;
mod folder;
mod oembed;
mod shots;
mod templates;
mod words;

use std::path::PathBuf;

use clap::ArgMatches;
use riverseed::annotate::names::Names;
use riverseed::domain::Domain;
use riverseed::recipe::{Key, link};

use self::address::Address;
use self::element::Element;
use self::folder::Folder;
use self::shots::Shots;
use self::templates::{Content, Shot};
use super::batch::{PLACE, with_seed};
use super::grow::grow;
use super::grow::progress;
use super::names::{say_what_has_no_letters, say_what_is_unused};
use super::order::Order;
use super::{Failure, say};

/// Writes the folder.
pub fn page(matches: &ArgMatches) -> Result<(), Failure> {
    let order = Order::of(matches)?;
    let address = matches.get_one::<String>("address").map(|text| address_of(text, order.recipe.seed())).transpose()?;
    let maker = matches.get_one::<String>("maker").map(|text| Address::read("--maker", text)).transpose()?;
    let element = Element::asked(matches, &order)?;
    let [title, description] = [words::given(matches, "title")?, words::given(matches, "description")?];
    let folder = Folder::open(&folder_of(matches, order.recipe.seed())?, matches.get_flag("replace"))?;
    order.say_what_is_idle(&[true]);
    say_what_has_no_letters(&order.recipe, &say);
    if address.is_none() {
        say("without --address, chats show no card for the page, and blogs do not embed its map");
    }
    let size = matches.get_one("size").copied().unwrap_or(shots::SIZE);
    let recipe = order.recipe.clone();
    let progress = progress(&recipe, size);
    let mut session = grow(order, &progress, &say)?;
    let shots = Shots::take(&mut session, size, title.as_deref(), &progress)?;
    let map = session.finish()?;
    say_what_is_unused(&map, &say);
    let names = Names::of(&map);
    let name = title.unwrap_or_else(|| words::name(&names, &recipe));
    let link = link::write_for_file(&recipe);
    let (width, height) = shots.size();
    let content = Content {
        title: name.clone(),
        description: description.unwrap_or_else(|| words::description(&map, &names)),
        alternative: words::alternative(&names, &name),
        settings: words::settings(&link)?,
        aspect: Key::Aspect.parameter().text_of(recipe.value(Key::Aspect)),
        ratio: Domain::of(&recipe).size,
        picture: Shot { width, height },
        attributes: attributes::of(&link)?,
        name,
        link,
        address,
        maker,
        element,
    };
    folder.write(&content, &shots)?;
    progress.finish_and_clear();
    Ok(())
}

/// The folder to write, with the seed in its place.
fn folder_of(matches: &ArgMatches, seed: &str) -> Result<PathBuf, Failure> {
    let path = matches.get_one::<PathBuf>("output").cloned().unwrap_or_default();
    match path.to_str() {
        Some(text) => with_seed(text, seed).map(PathBuf::from),
        None => Ok(path),
    }
}

/// The address of that folder. A percent sign in the folder's name is `%25` there.
fn address_of(text: &str, seed: &str) -> Result<Address, Failure> {
    let encoded = |escaped: String| escaped.replace('%', "%25");
    let parts = text.split(PLACE).map(str::to_owned).collect::<Vec<_>>();
    let seed = if parts.len() > 1 { encoded(with_seed(PLACE, seed)?) } else { String::new() };
    Address::read("--address", &parts.join(&seed))
}
