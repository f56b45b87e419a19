//! Who uses whom in `src/` is what ARCHITECTURE.md says, and no two files use each other.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

type Modules = BTreeSet<String>;

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
        let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
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
        let is_inner = i > 0 && is_sign(&trees_here[i - 1], ':');
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

/// The rows of ARCHITECTURE's table that are of modules: their names, and what they may use.
fn rules() -> Vec<(Vec<String>, Modules)> {
    let text = fs::read_to_string("ARCHITECTURE.md").unwrap();
    let mut above = Modules::new();
    let mut rules = Vec::new();
    for row in text.lines().filter(|line| line.starts_with("| `src/")) {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").collect();
        let places = cells[0].split(", ").map(|place| place.trim_matches([' ', '`']));
        let names: Vec<String> = places
            .filter_map(|place| place.strip_prefix("src/"))
            .map(|place| place.split(['/', '.']).next().unwrap().to_owned())
            .collect();
        let mut may_use: Modules = cells[2].split([',', ';', ' ', '`']).map(str::to_owned).collect();
        if cells[2].starts_with("all above") {
            may_use.extend(above.iter().cloned());
        }
        above.extend(names.iter().cloned());
        rules.push((names, may_use));
    }
    rules
}

#[test]
fn each_module_uses_what_the_table_allows() {
    let rules = rules();
    let allowed = |module: &str| {
        let rows = rules.iter().filter(|(names, _)| names.iter().any(|name| name == module));
        rows.fold(None, |all: Option<Modules>, (_, may_use)| {
            Some(all.unwrap_or_default().union(may_use).cloned().collect())
        })
    };
    for (module, used) in uses().into_iter().filter(|(module, _)| !module.is_empty()) {
        let allowed =
            allowed(&module[0]).unwrap_or_else(|| panic!("ARCHITECTURE.md has no row for {}", module.join("::")));
        for other in used.iter().filter(|other| other[0] != module[0]) {
            assert!(allowed.contains(&other[0]), "{} may not use {}", module.join("::"), other.join("::"));
        }
    }
}

#[test]
fn no_module_that_a_row_names_is_unused() {
    let uses = uses();
    let tops: Modules = uses.keys().filter_map(|module| module.first().cloned()).collect();
    for (names, may_use) in rules().into_iter().filter(|(_, may_use)| !may_use.contains("above")) {
        let of_row = uses.iter().filter(|(module, _)| module.first().is_some_and(|top| names.contains(top)));
        let used: Modules = of_row.flat_map(|(_, used)| used.iter().map(|other| other[0].clone())).collect();
        let stale: Vec<_> = may_use.iter().filter(|name| tops.contains(*name) && !used.contains(*name)).collect();
        assert!(stale.is_empty(), "{names:?} use no {stale:?}");
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
    assert_eq!(seen("pub(crate) struct A; // crate::land\nconst B: &str = \"crate::land\";"), [""; 0]);
}
