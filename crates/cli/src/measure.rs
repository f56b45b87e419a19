//! `riverseed measure`: the measures of a recipe's rivers, compared with nature.

use std::io::{self, Write};

use clap::ArgMatches;
use riverseed::analyse::statistics::{Measure, Measures, Nature, TABLE};
use riverseed::export;
use serde_json::{Map, Value, json};

use super::grow::{grow, progress};
use super::order::Order;
use super::{Failure, say, stdout};

/// Measures the rivers of a recipe and prints the table, or JSON.
pub fn measure(matches: &ArgMatches) -> Result<(), Failure> {
    stdout::check()?;
    let order = Order::of(matches)?;
    order.say_what_is_idle(&[true]);
    let progress = progress(&order.recipe, 0);
    let map = grow(order, &progress, &say)?.finish()?;
    progress.finish_and_clear();
    let measures = Measures::of(&map);
    let text = if matches.get_flag("json") { as_json(&measures)? } else { table(&measures) };
    Ok(writeln!(io::stdout().lock(), "{text}")?)
}

/// Writes the values and patterns as in the JSON of a network, and nature's ranges under the names of the values.
fn as_json(measures: &Measures) -> io::Result<String> {
    let of_nature = |measure: &Measure| Some((measure.name.to_owned(), range(measure.nature?)));
    let nature: Map<String, Value> = TABLE.iter().filter_map(of_nature).collect();
    let measured = serde_json::to_value(export::json::measures(measures))?;
    let pattern = serde_json::to_value(export::json::pattern(measures))?;
    Ok(serde_json::to_string_pretty(&json!({ "measures": measured, "nature": nature, "pattern": pattern }))?)
}

fn range(nature: Nature) -> Value {
    json!({ "median": nature.median, "least": nature.least, "most": nature.most, "source": nature.source })
}

/// Writes a line for each measure, and one that names the pattern.
fn table(measures: &Measures) -> String {
    let row = |measure: &Measure| {
        let nature = measure.nature.map_or(String::new(), in_words);
        let unit = (measure.value)(measures).map_or("", |_| measure.unit);
        [measure.label.into(), value(measure, measures), unit.into(), nature, measure.help.into()]
    };
    let head = ["", "this map", "", "nature", "what it is"].map(String::from);
    let rows: Vec<[String; 5]> = [head].into_iter().chain(TABLE.iter().map(row)).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let (labels, values, units, natures) = (width(0), width(1), width(2), width(3));
    let line = |[label, value, unit, nature, help]: &[String; 5]| {
        format!("{label:labels$}  {value:>values$} {unit:units$}  {nature:natures$}  {help}")
    };
    rows.iter().map(line).chain(pattern(measures)).collect::<Vec<_>>().join("\n")
}

/// Names the pattern and how far each is, such as "Pattern: dendritic (dendritic 0.6, deranged 2.1, …)".
fn pattern(measures: &Measures) -> Option<String> {
    let pattern = measures.pattern()?;
    let distances = pattern.nearest_first().map(|(name, distance)| format!("{name} {distance:.1}"));
    Some(format!("Pattern: {} (distances: {})", pattern.name(), distances.join(", ")))
}

fn value(measure: &Measure, measures: &Measures) -> String {
    let places = measure.places;
    (measure.value)(measures).map_or("too small".into(), |value| format!("{value:.places$}"))
}

/// Nature's values in words, such as "4.1 (3.5 to 5.2), 11 river basins".
fn in_words(nature: Nature) -> String {
    let Nature { median, least, most, source, .. } = nature;
    match median {
        Some(median) => format!("{median:?} ({least:?} to {most:?}), {source}"),
        None => format!("{least} to {most}, {source}"),
    }
}
