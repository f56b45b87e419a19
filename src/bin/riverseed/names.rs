//! `riverseed names`: the names on a recipe's map, with the marks by which `names` gives others.

use std::collections::BTreeSet;
use std::io::{self, Write};

use clap::ArgMatches;
use riverseed::glyph::lacking;
use riverseed::name::{Names, PlaceKind};
use riverseed::recipe::{Cartouche, Key, Labels, Mark, OwnNames, Recipe};
use riverseed::{Network, Session};

use super::Failure;
use super::grow::{grow, progress};
use super::order::Order;

/// Prints the names, greatest rivers first.
pub fn names(matches: &ArgMatches) -> Result<(), Failure> {
    let order = Order::of(matches)?;
    order.say_what_is_idle(false);
    let progress = progress(&order.recipe, 0);
    let session = grow(order, &progress)?;
    progress.finish_and_clear();
    let names = Names::of(&session);
    say_what_is_unused(&session);
    let mut rows = vec![["mark", "name", "order", "length"].map(String::from)];
    rows.extend(rivers(session.network().unwrap_or(Network::EMPTY), &names));
    rows.extend(others(&names));
    Ok(writeln!(io::stdout().lock(), "{}", table(&rows))?)
}

/// Warns of names of one's own that name nothing on the map.
pub fn say_what_is_unused(session: &Session) {
    if *session.recipe().value(Key::Names) == Key::Names.parameter().default_value() {
        return;
    }
    for mark in Names::of(session).unused(session.recipe()) {
        eprintln!("riverseed: 'names' has no effect on '{mark}': there is no such thing on this map");
    }
}

/// Warns of letters that the type has not, in names of one's own and in the seed of a cartouche.
pub fn say_what_has_no_letters(recipe: &Recipe) {
    let has_cartouche = recipe.get::<Cartouche>() != Cartouche::None;
    if recipe.get::<Labels>() == Labels::None && !has_cartouche {
        return;
    }
    let own = OwnNames::readable(&Key::Names.parameter().text_of(recipe.value(Key::Names)));
    let names: String = own.marks().filter_map(|mark| own.get(mark)).collect();
    if let Some(letters) = listed(&names) {
        eprintln!("riverseed: 'names' is drawn without {letters}: the type has no such letters");
    }
    if let Some(letters) = listed(recipe.seed()).filter(|_| has_cartouche) {
        eprintln!("riverseed: the cartouche is drawn without the seed: the type has no {letters}");
    }
}

/// The characters of a text that the type has no letters for, each once.
fn listed(text: &str) -> Option<String> {
    let letters: BTreeSet<char> = lacking(text).collect();
    let letters: Vec<String> = letters.into_iter().map(|letter| format!("'{}'", letter.escape_debug())).collect();
    (!letters.is_empty()).then(|| letters.join(", "))
}

fn rivers(network: &Network, names: &Names) -> Vec<[String; 4]> {
    let mut numbers: Vec<usize> = (0..network.rivers.len()).collect();
    numbers.sort_by_key(|&i| u32::MAX - network.discharge(&network.rivers[i]));
    let row = |i: usize| {
        let (river, named) = (&network.rivers[i], &names.rivers[i]);
        let length = format!("{:.0}", network.length(river));
        [Mark::River(named.identity).to_string(), named.name.clone(), river.order.to_string(), length]
    };
    numbers.into_iter().map(row).collect()
}

/// What else has a name.
fn others(names: &Names) -> Vec<[String; 4]> {
    let row = |mark: Mark, name: &str| [mark.to_string(), name.into(), String::new(), String::new()];
    let reaches = names.reaches.iter().map(|reach| row(Mark::Reach(reach.identity), &reach.name));
    let places = names.places.iter().map(|place| {
        let mark = match place.kind {
            PlaceKind::Sea => Mark::Sea(place.number),
            PlaceKind::Lake => Mark::Lake(place.number),
            PlaceKind::Island => Mark::Island(place.number),
        };
        row(mark, &place.name)
    });
    reaches.chain(places).chain([row(Mark::Title, &names.title)]).collect()
}

/// A line for each row: marks, orders and lengths to the right.
fn table(rows: &[[String; 4]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let [marks, names, orders, lengths] = [0, 1, 2, 3].map(width);
    let line = |[mark, name, order, length]: &[String; 4]| {
        let line = format!("{mark:>marks$}  {name:names$}  {order:>orders$}  {length:>lengths$}");
        line.trim_end().to_owned()
    };
    rows.iter().map(line).collect::<Vec<_>>().join("\n")
}
