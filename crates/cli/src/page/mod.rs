//! `riverseed page`: a map as a folder of static files that any host can serve under any path: a page, pictures, a card
//! for chats, an embed page that blogs show by oEmbed, and the element.

mod address;
mod attributes;
mod card;
mod element;
mod exchange;
mod file_names;
mod files;
mod folder;
mod list;
pub mod markup;
mod oembed;
mod place;
mod shots;
mod stage;
mod templates;
mod words;

use std::path::PathBuf;

use clap::ArgMatches;
use riverseed::Map;
use riverseed::annotate::names::Names;
use riverseed::recipe::{Key, link};

use self::address::Address;
use self::element::Element;
use self::folder::Folder;
use self::markup::in_order;
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
    let asked = Asked::of(matches, &order)?;
    let names = files::names(&asked.element, asked.address.as_ref());
    let folder = Folder::open(&folder_of(matches, order.recipe.seed())?, &names, matches.get_flag("replace"))?;
    order.say_what_is_idle(&[true]);
    say_what_has_no_letters(&order.recipe, &say);
    if asked.address.is_none() {
        say("without --address, chats show no card for the page, and blogs do not embed its map");
    }
    let size = matches.get_one("size").copied().unwrap_or(shots::SIZE);
    let progress = progress(&order.recipe, size);
    let mut session = grow(order, &progress, &say)?;
    let shots = Shots::take(&mut session, size, asked.title.as_deref(), &progress)?;
    let map = session.finish()?;
    say_what_is_unused(&map, &say);
    folder.write(&files::all(&asked.content(&map, &shots)?, shots)?)?;
    progress.finish_and_clear();
    Ok(())
}

/// The options of a call, besides its recipe.
struct Asked {
    title: Option<String>,
    description: Option<String>,
    address: Option<Address>,
    maker: Option<Address>,
    element: Element,
}

impl Asked {
    fn of(matches: &ArgMatches, order: &Order) -> Result<Self, Failure> {
        let seed = order.recipe.seed();
        let text = |option: &str| matches.get_one::<String>(option);
        Ok(Self {
            title: words::given(matches, "title")?,
            description: words::given(matches, "description")?,
            address: text("address").map(|text| address_of(text, seed)).transpose()?,
            maker: text("maker").map(|text| Address::read("--maker", text)).transpose()?,
            element: Element::asked(matches, order)?,
        })
    }

    /// Collects all that the page of a finished map says.
    fn content(self, map: &Map, shots: &Shots) -> Result<Content, Failure> {
        let (recipe, names) = (map.recipe(), Names::of(map));
        let name = in_order(&self.title.unwrap_or_else(|| words::name(&names, recipe)));
        let link = link::write_for_file(recipe);
        let letters = self.element.script().and_then(|_| attributes::letters(map));
        let (width, height) = shots.size();
        Ok(Content {
            title: name.clone(),
            description: in_order(&self.description.unwrap_or_else(|| words::description(map, &names))),
            alternative: in_order(&words::alternative(&names, &name)),
            settings: words::settings(&link)?,
            aspect: Key::Aspect.parameter().text_of(recipe.value(Key::Aspect)),
            ratio: map.domain().size,
            picture: Shot { width, height },
            attributes: attributes::of(&link)?.into_iter().chain(letters).collect(),
            name,
            link,
            address: self.address,
            maker: self.maker,
            element: self.element,
        })
    }
}

/// Returns the folder to write, with the seed in its place.
fn folder_of(matches: &ArgMatches, seed: &str) -> Result<PathBuf, Failure> {
    let path = matches.get_one::<PathBuf>("output").cloned().unwrap_or_default();
    match path.to_str() {
        Some(text) => with_seed(text, seed).map(PathBuf::from),
        None => Ok(path),
    }
}

/// Reads the address of that folder. A percent sign in the folder's name is `%25` there.
fn address_of(text: &str, seed: &str) -> Result<Address, Failure> {
    let escaped = if text.contains(PLACE) { with_seed(PLACE, seed)? } else { String::new() };
    Address::read("--address", &text.replace(PLACE, &escaped.replace('%', "%25")))
}
