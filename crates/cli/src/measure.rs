//! `riverseed measure`: the measures of a recipe's rivers, compared with nature.

use std::io::{self, Write};

use clap::ArgMatches;
use riverseed::analyse::statistics::{Measure, Measures, Nature, TABLE};
use riverseed::export;
use riverseed::scale::MapScale;
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
    let text = if matches.get_flag("json") { as_json(&measures)? } else { table(&measures, &map.scale()) };
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

/// The most columns of the table: those of a terminal or an editor of ordinary width.
const COLUMNS: usize = 100;

/// Writes each measure beside nature's values, with what it is below; then where those values come from, and the pattern.
fn table(measures: &Measures, scale: &MapScale) -> String {
    let sources = sources();
    let row = |measure: &Measure| {
        let nature = measure.nature.map_or(String::new(), |nature| in_words(nature, &sources));
        let (value, unit) = measure.told(measures, scale);
        let unit = value.map_or("", |_| unit);
        let places = measure.places;
        let value = value.map_or("too small".into(), |value| format!("{value:.places$}"));
        [measure.label.into(), value, unit.into(), nature]
    };
    let head = ["", "this map", "", "nature"].map(String::from);
    let rows: Vec<[String; 4]> = [head].into_iter().chain(TABLE.iter().map(row)).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let [labels, values, units] = [0, 1, 2].map(width);
    let line = |[label, value, unit, nature]: &[String; 4]| {
        let line = format!("{label:labels$}  {value:>values$} {unit:units$}  {nature}");
        line.trim_end().to_owned()
    };
    let helps = [String::new()].into_iter().chain(TABLE.iter().map(|measure| indented(measure.help)));
    let rows = rows.iter().map(line).zip(helps).flat_map(|(line, help)| [line, help]).filter(|line| !line.is_empty());
    let notes = sources.iter().enumerate().map(|(i, source)| format!("[{}] {source}", i + 1));
    rows.chain(notes).chain(pattern(measures)).collect::<Vec<_>>().join("\n")
}

/// Lists where nature's values come from, each once.
pub fn sources() -> Vec<&'static str> {
    let mut sources = Vec::new();
    for Nature { source, .. } in TABLE.iter().filter_map(|measure| measure.nature) {
        if !sources.contains(&source) {
            sources.push(source);
        }
    }
    sources
}

/// Breaks a text into lines of the table, further in than its rows.
fn indented(text: &str) -> String {
    const INDENT: &str = "    ";
    let mut lines = vec![INDENT.to_owned()];
    for word in text.split(' ') {
        let line = lines.last_mut().filter(|line| line.chars().count() + 1 + word.chars().count() <= COLUMNS);
        match line {
            Some(line) if line == INDENT => line.push_str(word),
            Some(line) => line.extend([" ", word]),
            None => lines.push(format!("{INDENT}{word}")),
        }
    }
    lines.join("\n")
}

/// Names the pattern and how far each is, such as "Pattern: dendritic" and "dendritic 0.6, deranged 2.1, …".
fn pattern(measures: &Measures) -> Option<String> {
    let pattern = measures.pattern()?;
    let distances = pattern.nearest_first().map(|(name, distance)| format!("{name} {distance:.1}"));
    let distances = indented(&format!("distances: {}", distances.join(", ")));
    Some(format!("Pattern: {}\n{distances}", pattern.name()))
}

/// Writes nature's values and the number of their source, such as `4.1 (3.5 to 5.2) [1]`.
pub fn in_words(nature: Nature, sources: &[&str]) -> String {
    let Nature { median, least, most, source, .. } = nature;
    let note = sources.iter().position(|other| *other == source).map_or(0, |i| i + 1);
    match median {
        Some(median) => format!("{median:?} ({least:?} to {most:?}) [{note}]"),
        None => format!("{least} to {most} [{note}]"),
    }
}
