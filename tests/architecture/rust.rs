//! The modules of a crate and what each uses, read from its files.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

use super::{Uses, files};

/// The parts of a module's path: none for the root, `land`, `grid` for `land/grid.rs`.
fn module_of(file: &Path, folder: &Path) -> Vec<String> {
    let path = file.strip_prefix(folder).unwrap().with_extension("");
    let parts = path.iter().map(|part| part.to_str().unwrap().to_owned());
    parts.filter(|part| part != "mod" && part != "lib" && part != "main").collect()
}

/// The code of a file, without its tests.
fn code(file: &PathBuf) -> String {
    fs::read_to_string(file).unwrap().split("\nmod tests {").next().unwrap().to_owned()
}

/// Finds the modules of a crate in its folder and what each uses outside tests.
pub fn uses(folder: &Path) -> Uses {
    let files: Vec<_> = files(folder, "rs").into_iter().filter(|path| !path.ends_with("tests.rs")).collect();
    let modules: Vec<_> = files.iter().map(|file| (module_of(file, folder), code(file))).collect();
    let names: BTreeSet<Vec<String>> = modules.iter().map(|(module, _)| module.clone()).collect();
    let exports: Exports = modules.iter().flat_map(|(module, code)| exports(code, module)).collect();
    let used_by = |module: &[String], code: &str| {
        let paths = paths(code, module).into_iter().map(|path| declared(path, &exports));
        paths.filter_map(|path| deepest(&names, path)).collect()
    };
    modules.iter().map(|(module, code)| (module.clone(), used_by(module, code))).collect()
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

/// Names by which modules hand on what others declare, as whole paths.
type Exports = BTreeMap<Vec<String>, Vec<String>>;

/// The names that a module hands on from others, and where they are from.
fn exports(code: &str, module: &[String]) -> Exports {
    let code = trees(code.parse().unwrap());
    let mut found = Vec::new();
    for (i, _) in code.iter().enumerate().filter(|(_, tree)| tree.to_string() == "use") {
        follow(&code[i + 1..], module.to_vec(), &mut found);
    }
    let named = |path: Vec<String>| Some(([module, &[path.last()?.clone()]].concat(), path));
    found.into_iter().filter_map(named).collect()
}

/// A path with a name that is handed on taken to where it is declared.
fn declared(mut path: Vec<String>, exports: &Exports) -> Vec<String> {
    // More than modules hand on from each other, should two name each other.
    for _ in 0..8 {
        let handed = (1..=path.len()).find_map(|count| Some((count, exports.get(&path[..count])?)));
        let Some((count, from)) = handed.filter(|(count, from)| **from != path[..*count]) else { break };
        path = [from, &path[count..]].concat();
    }
    path
}

/// The module that a path leads into.
fn deepest(modules: &BTreeSet<Vec<String>>, mut path: Vec<String>) -> Option<Vec<String>> {
    while !path.is_empty() && !modules.contains(&path) {
        path.pop();
    }
    (!path.is_empty()).then_some(path)
}

#[test]
fn paths_are_seen_however_they_are_written() {
    let root = exports("pub use glam;\npub use session::{Phase, Session};\npub mod session;", &[]);
    let exports = root.into_iter().chain(exports("pub use self::cell::Cell;", &["land".to_owned()])).collect();
    let seen = |code: &str| -> Vec<String> {
        let paths = paths(code, &["export".to_owned(), "svg".to_owned()]).into_iter();
        paths.filter(|path| !path.is_empty()).map(|path| declared(path, &exports).join("::")).collect()
    };
    let nested = "use crate::{land::{Cell, trace::{self, Traced}}, paint::View};\nuse super::super::tree::*;";
    assert_eq!(seen(nested), ["land::cell::Cell", "land::trace", "land::trace::Traced", "paint::View", "tree"]);
    assert_eq!(seen("fn f(session: &crate::Session) {}"), ["session::Session"]);
    assert_eq!(seen("use crate::{Phase, Session as S};"), ["session::Phase", "session::Session"]);
    assert_eq!(
        seen("fn f() { matches!(super::kind(), crate::land::Cell::Land) }"),
        ["export::kind", "land::cell::Cell::Land"]
    );
    assert_eq!(seen("fn f() { A { b: super::c::d(), e: crate::land::F } }"), ["export::c::d", "land::F"]);
    assert_eq!(seen("pub(crate) struct A; // crate::land\nconst B: &str = \"crate::land\";"), [""; 0]);
}
