//! The JSON form of a network is what its JSON Schema says, and so is what the README says of it.
//!
//! `RIVERSEED_REFRESH=1 cargo test --test schema` writes the schema's part about recipes and the README's table anew, and then
//! fails.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![cfg(feature = "cli")]

mod common;

use std::fs;

use common::plain::plain;
use jsonschema::Validator;
use riverseed::export::json as to_json;
use riverseed::recipe::{Key, Kind, Parameter, link, table::TABLE};
use riverseed::session::Session;
use serde_json::{Map, Value, json};

const SCHEMA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src/export/network.schema.json");
const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");

fn schema() -> Value {
    serde_json::from_str(&fs::read_to_string(SCHEMA).unwrap()).unwrap()
}

fn written(link: &str, with_attractors: bool) -> Value {
    let mut session = Session::new(link::read(&plain(link)).unwrap(), 1, 1).unwrap();
    while session.advance(64).unwrap() {}
    let mut text = Vec::new();
    to_json::write(&mut text, &session, with_attractors).unwrap();
    serde_json::from_slice(&text).unwrap()
}

/// Networks of all kinds, of which some have lakes.
const LINKS: [&str; 5] = [
    "seed=kauri&land=rectangle&attractors=600&meander-rounds=60",
    "seed=rimu&land=rectangle&attractors=800&great=9&gentle=1&meander-rounds=150&meander-strength=1",
    "seed=kea&land=archipelago&attractors=600&mouths=9&curl=0.9&stretch=5&meander=flow&style=map",
    "seed=totara&land=island&growth=brownian&sensitivity=40&trim=10",
    "seed=nothing&land=drawn&rough=0&aspect=1&attractors=100&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1..M4M4zHM4zHzHM4zHM4M4",
];

fn errors(validator: &Validator, value: &Value) -> Vec<String> {
    validator.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).take(5).collect()
}

#[test]
fn what_is_written_is_valid() {
    assert!(jsonschema::meta::is_valid(&schema()));
    let validator = jsonschema::draft202012::new(&schema()).unwrap();
    let mut lakes = 0;
    for (link, with_attractors) in LINKS.iter().flat_map(|link| [(link, false), (link, true)]) {
        let network = written(link, with_attractors);
        assert_eq!(errors(&validator, &network), Vec::<String>::new(), "{link}");
        assert_eq!(network.get("attractors").is_some(), with_attractors);
        lakes += network["oxbows"].as_array().unwrap().len();
    }
    assert!(lakes > 10);
}

#[test]
fn what_is_wrong_is_not_valid() {
    let validator = jsonschema::draft202012::new(&schema()).unwrap();
    let network = written(LINKS[1], true);
    let wrong: [(&str, Value); 12] = [
        ("/recipe/seed", json!(7)),
        ("/recipe/aspect", json!(5)),
        ("/recipe/style", json!("neon")),
        ("/resolved/spacing", json!("12")),
        ("/domain/width", json!(-1)),
        ("/growth/complete", json!("yes")),
        ("/nodes/parent/0", json!(-2)),
        ("/nodes/order/0", json!(0)),
        ("/rivers/0/parent", json!("none")),
        ("/rivers/0/points/0", json!([1.0, 2.0])),
        ("/oxbows/0/born", json!(1.5)),
        ("/attractors/x/0", json!(null)),
    ];
    for (place, value) in wrong {
        let mut network = network.clone();
        *network.pointer_mut(place).unwrap() = value;
        assert_eq!(errors(&validator, &network).len(), 1, "{place}");
    }
    for place in ["", "/recipe", "/resolved", "/domain", "/growth", "/nodes", "/rivers/0", "/oxbows/0", "/attractors"] {
        let mut more = network.clone();
        more.pointer_mut(place).unwrap()["more"] = json!(1);
        assert!(!validator.is_valid(&more), "a member more in '{place}'");
        for name in network.pointer(place).unwrap().as_object().unwrap().keys().filter(|name| *name != "attractors") {
            let mut less = network.clone();
            less.pointer_mut(place).unwrap().as_object_mut().unwrap().remove(name);
            assert!(!validator.is_valid(&less), "'{place}' without {name}");
        }
    }
}

/// What the table of parameters says of recipes, as a schema.
fn recipe_schema() -> Value {
    let row = |parameter: &Parameter| {
        let mut row = json!({ "description": parameter.help });
        let more = match parameter.kind {
            Kind::Text { longest, .. } => json!({ "type": "string", "maxLength": longest }),
            Kind::Integer { min, max, .. } => json!({ "type": "integer", "minimum": min, "maximum": max }),
            Kind::Number { min, max, .. } => {
                json!({ "type": "number", "minimum": min.to_f64(), "maximum": max.to_f64() })
            }
            Kind::Choice { choices } => {
                let mut words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
                words.sort_unstable();
                json!({ "type": "string", "enum": words })
            }
            Kind::Sides { .. } => json!({ "type": "string", "pattern": "^n?e?s?w?$", "minLength": 1 }),
            Kind::Outline => json!({ "type": "string", "maxLength": riverseed::recipe::LONGEST_OUTLINE }),
        };
        row.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        (parameter.name.to_owned(), row)
    };
    json!({
        "type": "object",
        "additionalProperties": false,
        "required": TABLE.iter().map(|parameter| parameter.name).collect::<Vec<_>>(),
        "properties": TABLE.iter().map(row).collect::<Map<_, _>>(),
    })
}

#[test]
fn the_schema_s_recipe_is_the_table_of_parameters() {
    let mut schema = schema();
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        schema["$defs"]["recipe"] = recipe_schema();
        fs::write(SCHEMA, serde_json::to_string_pretty(&schema).unwrap() + "\n").unwrap();
        panic!("the schema is written anew: run without RIVERSEED_REFRESH");
    }
    assert!(
        schema["$defs"]["recipe"] == recipe_schema(),
        "write it anew: RIVERSEED_REFRESH=1 cargo test --test schema"
    );
    assert_eq!(schema["$defs"]["recipe"]["properties"].as_object().unwrap().len(), Key::Style as usize + 1);
}

/// What the README says of a member: its description, then its own members, each with what it holds.
fn told(member: &Value) -> String {
    let description = member["description"].as_str().unwrap();
    let own = if member["type"] == "array" { &member["items"]["properties"] } else { &member["properties"] };
    let Some(own) = own.as_object() else { return description.to_owned() };
    let told_of = |(name, own): (&String, &Value)| match own["description"].as_str() {
        Some(description) => format!("`{name}` ({description})"),
        None => format!("`{name}`"),
    };
    format!("{description}: {}", own.iter().map(told_of).collect::<Vec<_>>().join(", "))
}

#[test]
fn the_readme_s_table_of_members_is_the_schema_s() {
    const HEAD: &str = "| member | what it holds |\n| --- | --- |\n";
    if !std::path::Path::new(README).exists() {
        return;
    }
    let schema = schema();
    let members = schema["properties"].as_object().unwrap();
    let table: String = members.iter().map(|(name, member)| format!("| `{name}` | {} |\n", told(member))).collect();
    let readme = fs::read_to_string(README).unwrap();
    let (before, rest) = readme.split_once(HEAD).unwrap();
    let (found, after) = rest.split_once("\n\n").unwrap();
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        fs::write(README, format!("{before}{HEAD}{table}\n{after}")).unwrap();
        panic!("the README's table is written anew: run without RIVERSEED_REFRESH");
    }
    assert!(found == table.trim_end(), "write it anew: RIVERSEED_REFRESH=1 cargo test --test schema");
}
