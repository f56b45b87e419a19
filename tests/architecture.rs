//! Who uses whom in `src/` is what `docs/layers.toml` says, and no two files use each other.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

/// All files below a folder that end in `.rs`.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    entries.into_iter().flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

/// The parts of a module's path: none for the root, `land`, `grid` for `src/land/grid.rs`.
fn module_of(file: &Path) -> Vec<String> {
    let path = file.strip_prefix("src").unwrap().with_extension("");
    let parts = path.iter().map(|part| part.to_str().unwrap().to_owned());
    parts.filter(|part| part != "mod" && part != "lib").collect()
}

/// The modules of the crate and what each uses outside tests, by their whole paths.
fn uses() -> BTreeMap<Vec<String>, BTreeSet<Vec<String>>> {
    let is_of_the_library = |path: &PathBuf| !path.ends_with("tests.rs");
    let files = files(Path::new("src")).into_iter().filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let files: Vec<_> = files.filter(is_of_the_library).collect();
    let modules: BTreeSet<Vec<String>> = files.iter().map(|file| module_of(file)).collect();
    let exports = exports(&fs::read_to_string("src/lib.rs").unwrap());
    let used_by = |file: &PathBuf| {
        let text = fs::read_to_string(file).unwrap();
        let code = text.split("\nmod tests {").next().unwrap();
        let paths = paths(code, &module_of(file)).into_iter().map(|path| declared(path, &exports));
        paths.filter_map(|path| deepest(&modules, path)).collect()
    };
    files.iter().map(|file| (module_of(file), used_by(file))).collect()
}

fn trees(stream: TokenStream) -> Vec<TokenTree> {
    stream.into_iter().collect()
}

fn is_sign(tree: &TokenTree, sign: char) -> bool {
    matches!(tree, TokenTree::Punct(punct) if punct.as_char() == sign)
}

/// What stands behind a double colon.
fn behind_colons(trees: &[TokenTree]) -> Option<&[TokenTree]> {
    trees.split_at_checked(2).filter(|(colons, _)| colons.iter().all(|tree| is_sign(tree, ':'))).map(|(_, rest)| rest)
}

/// All that a module names by a path of the crate's, in `use` and elsewhere, lists in braces taken apart.
fn paths(code: &str, module: &[String]) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    search(&trees(code.parse().unwrap()), module, &mut found);
    found
}

fn search(trees_here: &[TokenTree], module: &[String], found: &mut Vec<Vec<String>>) {
    for (i, tree) in trees_here.iter().enumerate() {
        // A single colon stands before a type or the value of a field, which begins a path.
        let is_inner = i > 1 && trees_here[i - 2..i].iter().all(|tree| is_sign(tree, ':'));
        match tree {
            TokenTree::Group(group) => search(&trees(group.stream()), module, found),
            TokenTree::Ident(name) if !is_inner && (name == "crate" || name == "super") => {
                follow(&trees_here[i..], module.to_vec(), found);
            }
            _ => {}
        }
    }
}

/// Follows one path into all branches of its lists.
fn follow(path: &[TokenTree], mut base: Vec<String>, found: &mut Vec<Vec<String>>) {
    match path {
        [TokenTree::Group(list), ..] => {
            let items = trees(list.stream());
            items.split(|tree| is_sign(tree, ',')).for_each(|item| follow(item, base.clone(), found));
        }
        [TokenTree::Ident(name), rest @ ..] => {
            match name.to_string().as_str() {
                "crate" => base.clear(),
                "super" => drop(base.pop()),
                "self" => {}
                name => base.push(name.to_owned()),
            }
            match behind_colons(rest) {
                Some(further) => follow(further, base, found),
                None => found.push(base),
            }
        }
        _ => found.push(base),
    }
}

/// The names that the root of the crate exports from its modules, and where they are declared.
fn exports(root: &str) -> BTreeMap<String, Vec<String>> {
    let root = trees(root.parse().unwrap());
    let mut found = Vec::new();
    for (i, _) in root.iter().enumerate().filter(|(_, tree)| tree.to_string() == "use") {
        follow(&root[i + 1..], Vec::new(), &mut found);
    }
    found.into_iter().filter_map(|path| Some((path.last()?.clone(), path))).collect()
}

/// A path with a name of the root taken to where it is declared.
fn declared(path: Vec<String>, exports: &BTreeMap<String, Vec<String>>) -> Vec<String> {
    match path.split_first().and_then(|(name, rest)| Some((exports.get(name)?, rest))) {
        Some((export, rest)) => [export, rest].concat(),
        None => path,
    }
}

/// The module that a path leads into.
fn deepest(modules: &BTreeSet<Vec<String>>, mut path: Vec<String>) -> Option<Vec<String>> {
    while !path.is_empty() && !modules.contains(&path) {
        path.pop();
    }
    (!path.is_empty()).then_some(path)
}

/// The lines of `[src]` in `docs/layers.toml`, in their order: a layer and the layers that it may use.
fn layers() -> Vec<(String, BTreeSet<String>)> {
    let text = fs::read_to_string("docs/layers.toml").unwrap();
    let lines = text.split("[src]\n").nth(1).unwrap().lines().take_while(|line| !line.starts_with('['));
    let lines = lines.filter(|line| !line.starts_with('#') && !line.is_empty());
    let words = |text: &str| text.split('"').skip(1).step_by(2).map(str::to_owned).collect();
    lines.map(|line| line.split_once(" = ").unwrap()).map(|(name, uses)| (name.replace('"', ""), words(uses))).collect()
}

/// The layer of a module: the one with the longest name that its path begins with.
fn layer_of<'a>(names: &[&'a str], module: &[String]) -> &'a str {
    let path = module.join("/") + "/";
    let of_path = names.iter().filter(|name| path.starts_with(&format!("{name}/")));
    of_path.max_by_key(|name| name.len()).unwrap_or_else(|| panic!("docs/layers.toml has no line for src/{path}"))
}

#[test]
fn each_module_uses_the_layers_of_its_line_and_a_line_names_no_other() {
    let layers = layers();
    let names: Vec<&str> = layers.iter().map(|(name, _)| name.as_str()).collect();
    let mut used: BTreeMap<&str, BTreeSet<String>> = names.iter().map(|name| (*name, BTreeSet::new())).collect();
    for (module, others) in uses().iter().filter(|(module, _)| !module.is_empty()) {
        let layer = layer_of(&names, module);
        let others = others.iter().map(|other| layer_of(&names, other)).filter(|other| *other != layer);
        used.entry(layer).or_default().extend(others.map(str::to_owned));
    }
    let differing = layers.iter().filter(|(layer, allowed)| used[layer.as_str()] != *allowed);
    let said: Vec<String> = differing.map(|(layer, _)| format!("{layer} uses {:?}", used[layer.as_str()])).collect();
    assert!(said.is_empty(), "docs/layers.toml says otherwise:\n{}", said.join("\n"));
}

#[test]
fn layers_stand_below_those_that_they_use() {
    let mut above = BTreeSet::new();
    for (layer, uses) in layers() {
        assert!(uses.is_subset(&above), "{layer} uses layers that do not stand above it: {:?}", &uses - &above);
        above.insert(layer);
    }
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    // A folder's own file hands on what its files make, and they may ask it: that is no circle.
    let is_kin = |a: &[String], b: &[String]| a.starts_with(b) || b.starts_with(a);
    let uses: BTreeMap<_, BTreeSet<_>> = uses()
        .into_iter()
        .map(|(module, used)| (module.clone(), used.into_iter().filter(|other| !is_kin(&module, other)).collect()))
        .collect();
    for start in uses.keys() {
        let (mut reached, mut open) = (BTreeSet::new(), vec![start]);
        while let Some(module) = open.pop() {
            for next in uses[module].iter().filter(|next| reached.insert(*next)) {
                assert!(next != start, "{} uses itself by way of {}", start.join("::"), module.join("::"));
                open.push(next);
            }
        }
    }
}

#[test]
fn paths_are_seen_however_they_are_written() {
    let exports = exports("pub use glam;\npub use session::{Phase, Session};\npub mod session;");
    let seen = |code: &str| -> Vec<String> {
        let paths = paths(code, &["export".to_owned(), "svg".to_owned()]).into_iter();
        paths.filter(|path| !path.is_empty()).map(|path| declared(path, &exports).join("::")).collect()
    };
    let nested = "use crate::{land::{Cell, trace::{self, Traced}}, paint::View};\nuse super::super::tree::*;";
    assert_eq!(seen(nested), ["land::Cell", "land::trace", "land::trace::Traced", "paint::View", "tree"]);
    assert_eq!(seen("fn f(session: &crate::Session) {}"), ["session::Session"]);
    assert_eq!(seen("use crate::{Phase, Session as S};"), ["session::Phase", "session::Session"]);
    assert_eq!(
        seen("fn f() { matches!(super::kind(), crate::land::Cell::Land) }"),
        ["export::kind", "land::Cell::Land"]
    );
    assert_eq!(seen("fn f() { A { b: super::c::d(), e: crate::land::F } }"), ["export::c::d", "land::F"]);
    assert_eq!(seen("pub(crate) struct A; // crate::land\nconst B: &str = \"crate::land\";"), [""; 0]);
}
