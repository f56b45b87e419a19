//! The JSON Schema of a network's JSON form. Its part on recipes follows the table of parameters, and the description
//! in `docs/files.md` follows the schema. A test of the page (`www/tests/unit/schema.test.ts`), where a validator costs
//! little, checks that networks are valid.
//!
//! `RIVERSEED_REFRESH=1 cargo test --all-features --test all schema` writes the schema's part about recipes and the page's
//! table again, and then fails.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::sync::{Mutex, MutexGuard, PoisonError};

use riverseed::recipe::{Kind, LONGEST_OUTLINE, Parameter, is_decided, table::TABLE};
use serde_json::{Map, Value, json};

const SCHEMA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../src/export/network.schema.json");
const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/files.md");

/// Guards the files: a refresh in one test writes what the other reads.
static FILES: Mutex<()> = Mutex::new(());

fn files() -> MutexGuard<'static, ()> {
    FILES.lock().unwrap_or_else(PoisonError::into_inner)
}

fn schema() -> Value {
    serde_json::from_str(&fs::read_to_string(SCHEMA).unwrap()).unwrap()
}

/// The schema of a parameter's value.
fn row(parameter: &Parameter) -> (String, Value) {
    let mut row = json!({ "description": parameter.help });
    let more = match parameter.kind {
        Kind::Text { longest, .. } => json!({ "type": "string", "maxLength": longest }),
        Kind::Integer { min, max, .. } => json!({ "type": "integer", "minimum": min, "maximum": max }),
        Kind::Number { min, max, .. } => {
            json!({ "type": "number", "minimum": min.to_f64(), "maximum": max.to_f64() })
        }
        Kind::Choice { choices, .. } => {
            let mut words: Vec<&str> = choices.iter().map(|word| word.name).collect();
            words.sort_unstable();
            json!({ "type": "string", "enum": words })
        }
        Kind::Sides { .. } => json!({ "type": "string", "pattern": "^n?e?s?w?$", "minLength": 1 }),
        Kind::Outline => json!({ "type": "string", "maxLength": LONGEST_OUTLINE }),
    };
    row.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    (parameter.name.to_owned(), row)
}

/// The schema of recipes, from the table of parameters. What is left to the country is not there.
fn recipe_schema() -> Value {
    let always: Vec<&str> = TABLE.iter().filter(|row| !is_decided(row.key)).map(|row| row.name).collect();
    json!({
        "type": "object",
        "additionalProperties": false,
        "required": always,
        "properties": TABLE.iter().map(row).collect::<Map<_, _>>(),
    })
}

/// Adds to the schema of resolved values those that the country decides, as far as they are not written in another way.
fn with_decided(mut resolved: Value) -> Value {
    for parameter in TABLE.iter().filter(|row| is_decided(row.key)) {
        let (name, row) = row(parameter);
        let members = resolved["properties"].as_object_mut().unwrap();
        let is_other = members.get(&name).is_some_and(|member| member["description"] != row["description"]);
        if !is_other && members.insert(name.clone(), row).is_none() {
            resolved["required"].as_array_mut().unwrap().push(name.into());
        }
    }
    resolved
}

#[test]
fn the_schema_s_recipe_is_the_table_of_parameters() {
    let _files = files();
    let mut schema = schema();
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        schema["$defs"]["recipe"] = recipe_schema();
        let resolved = schema["properties"]["resolved"].take();
        schema["properties"]["resolved"] = with_decided(resolved);
        fs::write(SCHEMA, serde_json::to_string_pretty(&schema).unwrap() + "\n").unwrap();
        panic!("the schema is written again: run without RIVERSEED_REFRESH");
    }
    let resolved = &schema["properties"]["resolved"];
    assert!(
        schema["$defs"]["recipe"] == recipe_schema() && *resolved == with_decided(resolved.clone()),
        "write it again: RIVERSEED_REFRESH=1 cargo test --all-features --test all schema"
    );
}

/// The description of a member for the page, then those of its members.
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
fn the_table_of_members_in_the_page_about_files_is_the_schema_s() {
    const HEAD: &str = "| member | what it holds |\n| --- | --- |\n";
    let _files = files();
    let schema = schema();
    let members = schema["properties"].as_object().unwrap();
    let table: String = members.iter().map(|(name, member)| format!("| `{name}` | {} |\n", told(member))).collect();
    let page = fs::read_to_string(PAGE).unwrap();
    let (before, rest) = page.split_once(HEAD).unwrap();
    let (found, after) = rest.split_once("\n\n").unwrap();
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        fs::write(PAGE, format!("{before}{HEAD}{table}\n{after}")).unwrap();
        panic!("the page's table is written again: run without RIVERSEED_REFRESH");
    }
    assert!(
        found == table.trim_end(),
        "write it again: RIVERSEED_REFRESH=1 cargo test --all-features --test all schema"
    );
}
