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
use super::batch::with_seed;
use super::grow::grow;
use super::grow::progress;
use super::names::{say_what_has_no_letters, say_what_is_unused};
use super::order::Order;
use super::{Failure, say};

/// Writes the folder.
pub fn page(matches: &ArgMatches) -> Result<(), Failure> {
    let order = Order::of(matches)?;
    let address = matches.get_one::<String>("address").map(|text| Address::read("--address", text)).transpose()?;
    let maker = matches.get_one::<String>("maker").map(|text| Address::read("--maker", text)).transpose()?;
    let element = Element::asked(matches, &order)?;
    let out = matches.get_one::<PathBuf>("output").map(|path| with_seed(path, order.recipe.seed()));
    let folder = Folder::open(&out.unwrap_or_default(), matches.get_flag("replace"))?;
    order.say_what_is_idle(&[true]);
    say_what_has_no_letters(&order.recipe, &say);
    if address.is_none() {
        say("without --address, chats show no card for the page, and blogs do not embed its map");
    }
    let size = matches.get_one("size").copied().unwrap_or(shots::SIZE);
    let recipe = order.recipe.clone();
    let progress = progress(&recipe, size);
    let mut session = grow(order, &progress, &say)?;
    let shots = Shots::take(&mut session, size, &progress)?;
    let map = session.finish()?;
    say_what_is_unused(&map, &say);
    let names = Names::of(&map);
    let own = |option: &str| matches.get_one::<String>(option).cloned();
    let name = own("title").unwrap_or_else(|| words::name(&names, &recipe));
    let link = link::write_for_file(&recipe);
    let (width, height) = shots.size();
    let content = Content {
        title: name.clone(),
        description: own("description").unwrap_or_else(|| words::description(&map, &names)),
        alternative: words::alternative(&names, &name),
        settings: words::settings(&link::write(&recipe))?,
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
