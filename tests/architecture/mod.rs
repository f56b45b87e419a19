//! Who uses whom is what `docs/layers.toml` says, and no two files use each other: in the library, the crates and Python.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod python;
mod rust;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the repository.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The modules of a folder by the parts of their paths, and what each uses.
type Uses = BTreeMap<Vec<String>, BTreeSet<Vec<String>>>;

/// A function that reads the imports of a folder.
type Reader = fn(&Path) -> Uses;

/// The folders with a section in `docs/layers.toml`, and how their files are read.
const FOLDERS: [(&str, Reader); 6] = [
    ("src", rust::uses),
    ("crates/exchange/src", rust::uses),
    ("crates/cli/src", rust::uses),
    ("crates/wasm/src", rust::uses),
    ("python/src", rust::uses),
    ("python/riverseed", python::uses),
];

/// All files below a folder with an ending.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut entries: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    let below = entries.into_iter().flat_map(|path| if path.is_dir() { files(&path, ending) } else { vec![path] });
    below.filter(|path| path.extension().is_some_and(|end| end == ending)).collect()
}

/// The lines of a folder's section in `docs/layers.toml`, in their order: a layer and the layers that it may use.
fn layers(folder: &str) -> Vec<(String, BTreeSet<String>)> {
    let text = fs::read_to_string(format!("{ROOT}/docs/layers.toml")).unwrap();
    let section = text.split(&format!("\n[\"{folder}\"]\n")).nth(1).unwrap_or_else(|| panic!("no section {folder}"));
    let lines = section.lines().take_while(|line| !line.starts_with('['));
    let lines = lines.filter(|line| !line.starts_with('#') && !line.is_empty());
    let words = |text: &str| text.split('"').skip(1).step_by(2).map(str::to_owned).collect();
    lines.map(|line| line.split_once(" = ").unwrap()).map(|(name, uses)| (name.replace('"', ""), words(uses))).collect()
}

/// The layer of a module: the one with the longest name that its path begins with.
fn layer_of<'a>(names: &[&'a str], folder: &str, module: &[String]) -> &'a str {
    let path = module.join("/") + "/";
    let of_path = names.iter().filter(|name| path.starts_with(&format!("{name}/")));
    of_path.max_by_key(|name| name.len()).unwrap_or_else(|| panic!("docs/layers.toml has no line for {folder}/{path}"))
}

#[test]
fn each_module_uses_the_layers_of_its_line_and_a_line_names_no_other() {
    for (folder, read) in FOLDERS {
        let layers = layers(folder);
        let names: Vec<&str> = layers.iter().map(|(name, _)| name.as_str()).collect();
        let mut used: BTreeMap<&str, BTreeSet<String>> = names.iter().map(|name| (*name, BTreeSet::new())).collect();
        for (module, others) in read(&Path::new(ROOT).join(folder)).iter().filter(|(module, _)| !module.is_empty()) {
            let layer = layer_of(&names, folder, module);
            let others = others.iter().map(|other| layer_of(&names, folder, other)).filter(|other| *other != layer);
            used.entry(layer).or_default().extend(others.map(str::to_owned));
        }
        let differing = layers.iter().filter(|(layer, allowed)| used[layer.as_str()] != *allowed);
        let said: Vec<String> = differing.map(|(layer, _)| format!("{layer} = {:?}", used[layer.as_str()])).collect();
        assert!(said.is_empty(), "docs/layers.toml says otherwise than {folder}:\n{}", said.join("\n"));
    }
}

#[test]
fn layers_stand_below_those_that_they_use() {
    for (folder, _) in FOLDERS {
        let mut above = BTreeSet::new();
        for (layer, uses) in layers(folder) {
            assert!(uses.is_subset(&above), "{folder}/{layer} uses what does not stand above it: {:?}", &uses - &above);
            above.insert(layer);
        }
    }
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    for (folder, read) in FOLDERS {
        let circles = circles(read(&Path::new(ROOT).join(folder)));
        assert!(circles.is_empty(), "in {folder}:\n{}", circles.join("\n"));
    }
}

/// The modules that use themselves by way of others, each with the last of these.
fn circles(mut uses: Uses) -> Vec<String> {
    // A folder's own file hands on what its files make, and they may ask it: that is no circle.
    let is_kin = |a: &[String], b: &[String]| a.starts_with(b) || b.starts_with(a);
    uses.iter_mut().for_each(|(module, used)| used.retain(|other| !is_kin(module, other)));
    let last_in_circle = |start: &Vec<String>| {
        let (mut reached, mut open) = (BTreeSet::new(), vec![start]);
        while let Some(module) = open.pop() {
            if uses[module].contains(start) {
                return Some(format!("{} uses itself by way of {}", start.join("/"), module.join("/")));
            }
            open.extend(uses[module].iter().filter(|next| reached.insert(*next)));
        }
        None
    };
    uses.keys().filter_map(last_in_circle).collect()
}

#[test]
fn circles_are_seen() {
    let uses = |pairs: &[(&str, &str)]| -> Uses {
        let path = |text: &str| text.split('/').map(str::to_owned).collect::<Vec<_>>();
        let mut uses = Uses::new();
        for (module, other) in pairs {
            uses.entry(path(other)).or_default();
            uses.entry(path(module)).or_default().insert(path(other));
        }
        uses
    };
    let none: [String; 0] = [];
    assert_eq!(circles(uses(&[("a", "b"), ("b", "c/d"), ("a", "c/d"), ("c", "c/d"), ("c/d", "c")])), none);
    let (a, b) = ("a uses itself by way of c/d", "b uses itself by way of a");
    assert_eq!(circles(uses(&[("a", "b"), ("b", "c/d"), ("c/d", "a")])), [a, b, "c/d uses itself by way of b"]);
    assert_eq!(circles(uses(&[("c/e", "c/d"), ("c/d", "c/e")])).len(), 2);
}
