//! `riverseed names`: the names on a recipe's map, with their marks, by which `names` can replace them.

use std::collections::BTreeSet;
use std::io::{self, Write};

use clap::ArgMatches;
use riverseed::annotate::glyph::lacking;
use riverseed::annotate::names::{Names, RiverName};
use riverseed::recipe::{Key, Labels, Mark, Recipe};
use riverseed::scale::{MapScale, figures};
use riverseed::{Map, Network, River};

use super::grow::{grow, progress};
use super::order::Order;
use super::{Failure, Say, say, stdout};

/// Prints the names: the map's, then the rivers', the greatest first, then those of places.
pub fn names(matches: &ArgMatches) -> Result<(), Failure> {
    stdout::check()?;
    let order = Order::of(matches)?;
    order.say_what_is_idle(&[false]);
    let progress = progress(&order.recipe, 0);
    let map = grow(order, &progress, &say)?.finish()?;
    progress.finish_and_clear();
    let (names, network) = (Names::of(&map), map.network());
    say_what_is_unused(&map, &say);
    let mut rows = vec![["mark", "name", "order", "km"].map(String::from)];
    let scale = map.scale();
    rows.extend(names.marked(network).into_iter().map(|(mark, name)| row(network, &names, &scale, mark, name)));
    Ok(writeln!(io::stdout().lock(), "{}", table(&rows))?)
}

/// Warns of own names that name nothing on the map.
pub fn say_what_is_unused(map: &Map, say: Say<'_>) {
    if *map.recipe().value(Key::Names) == Key::Names.parameter().default_value() {
        return;
    }
    for mark in Names::of(map).unused(map.recipe()) {
        say(&format!("'names' has no effect on '{mark}': there is no such thing on this map"));
    }
}

/// Warns of letters that the type lacks, in own names and in the seed of a cartouche.
pub fn say_what_has_no_letters(recipe: &Recipe, say: Say<'_>) {
    let has_cartouche = recipe.has_title();
    if recipe.get::<Labels>() == Labels::None && !has_cartouche {
        return;
    }
    let own = recipe.own_names();
    let names: String = own.marks().filter_map(|mark| own.get(mark)).collect();
    if let Some(letters) = listed(&names) {
        say(&format!("'names' is drawn without {letters}: the type has no such letters"));
    }
    if let Some(letters) = listed(recipe.seed()).filter(|_| has_cartouche) {
        say(&format!("the cartouche is drawn without the seed: the type has no {letters}"));
    }
}

/// Lists the characters of a text that the type lacks, each once; `None` if it has all of them.
fn listed(text: &str) -> Option<String> {
    let letters: BTreeSet<char> = lacking(text).collect();
    let letters: Vec<String> = letters.into_iter().map(|letter| format!("'{}'", letter.escape_debug())).collect();
    (!letters.is_empty()).then(|| letters.join(", "))
}

/// Makes the row of a name: its mark, the name, and for a river its order and its length in kilometres.
fn row(network: &Network, names: &Names, scale: &MapScale, mark: Mark, name: &str) -> [String; 4] {
    let is_it = |(_, named): &(&River, &RiverName)| Mark::River(named.identity) == mark;
    let river = network.rivers.iter().zip(&names.rivers).find(is_it).map(|(river, _)| river);
    let [order, length] = river.map_or([String::new(), String::new()], |river| {
        [river.order.to_string(), figures(scale.kilometres(network.length(river)))]
    });
    [mark.to_string(), name.into(), order, length]
}

/// Writes a line for each row, with marks, orders and lengths aligned to the right.
fn table(rows: &[[String; 4]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let [marks, names, orders, lengths] = [0, 1, 2, 3].map(width);
    let line = |[mark, name, order, length]: &[String; 4]| {
        let line = format!("{mark:>marks$}  {name:names$}  {order:>orders$}  {length:>lengths$}");
        line.trim_end().to_owned()
    };
    rows.iter().map(line).collect::<Vec<_>>().join("\n")
}
