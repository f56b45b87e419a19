//! `riverseed table --json`: all parameters, presets and countries as data, for programs and the page.

use std::io::{self, Write};

use riverseed::recipe::country::{COUNTRIES, Country};
use riverseed::recipe::preset::{PRESETS, Preset};
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Decimal, Kind, LONGEST_OUTLINE, Parameter, is_decided};
use serde_json::{Map, Value, json};

/// Writes the data.
pub fn print() -> io::Result<()> {
    let mut out = io::stdout().lock();
    let rows: Vec<Value> = TABLE.iter().map(row).collect();
    let presets: Vec<Value> = PRESETS.iter().map(preset).collect();
    let countries: Vec<Value> = COUNTRIES.iter().map(country).collect();
    let table = json!({ "parameters": rows, "presets": presets, "countries": countries });
    writeln!(out, "{table:#}")
}

fn row(parameter: &Parameter) -> Value {
    let mut row = Map::new();
    let mut set = |name: &str, value: Value| row.insert(name.into(), value);
    set("key", parameter.name.into());
    set("label", parameter.label.into());
    set("help", parameter.help.into());
    set("group", parameter.group.into());
    set("stage", parameter.stage.name().into());
    set("kind", kind_name(parameter.kind).into());
    set("unit", parameter.unit.into());
    set("scale", if parameter.logarithmic { "log" } else { "linear" }.into());
    set("default", parameter.text_of(&parameter.default_value()).into());
    if is_decided(parameter.key) {
        set("decided", true.into());
    }
    row.extend(range(parameter.kind));
    row.into()
}

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Text { .. } => "text",
        Kind::Integer { .. } => "integer",
        Kind::Number { .. } => "number",
        Kind::Outline => "outline",
        Kind::Choice { .. } => "choice",
        Kind::Sides { .. } => "sides",
    }
}

/// Lists the range or the choices of a kind of value.
fn range(kind: Kind) -> Vec<(String, Value)> {
    let named = |name: &str, value: Value| (name.to_owned(), value);
    match kind {
        Kind::Text { longest, .. } => vec![named("maxLength", longest.into())],
        Kind::Outline => vec![named("maxLength", LONGEST_OUTLINE.into())],
        Kind::Integer { min, max, .. } => {
            vec![named("min", min.into()), named("max", max.into()), named("step", 1.into())]
        }
        Kind::Number { min, max, step, .. } => {
            let number = |name: &str, value: Decimal| named(name, value.to_f64().into());
            vec![number("min", min), number("max", max), number("step", step)]
        }
        Kind::Choice { choices, .. } => {
            vec![named("choices", choices.iter().map(|word| choice(word.name, word.label)).collect())]
        }
        Kind::Sides { .. } => {
            let sides = [("n", "North"), ("e", "East"), ("s", "South"), ("w", "West")];
            vec![named("choices", sides.into_iter().map(|(value, label)| choice(value, label)).collect())]
        }
    }
}

fn choice(value: &str, label: &str) -> Value {
    json!({ "value": value, "label": label })
}

fn preset(preset: &Preset) -> Value {
    let values =
        preset.values.iter().map(|&(key, text)| json!([key.parameter().name, canonical(key.parameter(), text)]));
    let values: Vec<Value> = values.collect();
    json!({ "name": preset.name, "label": preset.label, "help": preset.help, "values": values })
}

fn country(country: &Country) -> Value {
    let mut data = json!({ "name": country.name, "label": country.label, "help": country.help });
    if let Some(style) = country.style {
        data["style"] = style.word().name.into();
    }
    data
}

/// Writes a value in the spelling that links use.
fn canonical(parameter: &Parameter, text: &str) -> String {
    parameter.parse(text).map_or_else(|_| text.into(), |value| parameter.text_of(&value))
}
