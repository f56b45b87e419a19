//! README and `docs/` are true: their commands work, their links lead somewhere, and what is generated is current.
//!
//! `make docs`, or `RIVERSEED_REFRESH=1 cargo test --all-features --test all documents`, draws the figures again.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "../examples/figures.rs"]
#[allow(dead_code, reason = "the tests draw figures one by one")]
mod figures;

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// README and the like, and all of `docs/`.
fn documents() -> Vec<PathBuf> {
    let is_document = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "md");
    let inside = |folder: &Path| fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<_> = inside(root()).chain(inside(&root().join("docs"))).filter(is_document).collect();
    found.sort();
    found
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(root().join(path)).unwrap()
}

#[test]
fn figures_are_those_that_their_example_draws() {
    let folder = root().join("docs/figures");
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        figures::write(&folder).unwrap();
        panic!("docs/figures is written again: run without RIVERSEED_REFRESH");
    }
    let page = read("docs/algorithms.md");
    for (name, draw) in figures::FIGURES {
        let is_current = fs::read_to_string(folder.join(name)).unwrap() == draw().unwrap();
        assert!(is_current, "draw docs/figures/{name} again: make docs");
        assert!(page.contains(&format!("](figures/{name})")), "docs/algorithms.md does not show {name}");
    }
}

/// The targets of a document's links, except whole addresses.
fn links(text: &str) -> Vec<&str> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target);
    targets.filter(|target| !target.contains("://") && !target.contains('…')).collect()
}

/// The anchors that readers of Markdown give to headings.
fn anchors(text: &str) -> Vec<String> {
    let headings = text.lines().filter(|line| line.starts_with('#')).map(|line| line.trim_start_matches('#').trim());
    let anchor = |heading: &str| -> String {
        let kept = heading.to_lowercase().replace(' ', "-");
        kept.chars().filter(|c| c.is_alphanumeric() || matches!(c, '-' | '_')).collect()
    };
    headings.map(anchor).collect()
}

#[test]
fn every_link_between_documents_leads_somewhere() {
    for document in documents() {
        let text = read(&document);
        for link in links(&text) {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { document.clone() } else { document.parent().unwrap().join(file) };
            assert!(target.exists(), "{}: no such file: {link}", document.display());
            let has_anchor = anchor.is_empty() || anchors(&read(&target)).iter().any(|found| found == anchor);
            assert!(has_anchor, "{}: no such heading: {link}", document.display());
        }
    }
}

/// The tests that a document names in backquotes, as `file::test`.
fn named_tests(text: &str) -> Vec<(&str, &str)> {
    let is_name = |name: &str| !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || c == '_');
    let quoted = text.split('`').skip(1).step_by(2).filter_map(|quoted| quoted.split_once("::"));
    quoted.filter(|(file, test)| is_name(file) && is_name(test)).collect()
}

#[test]
fn tests_that_prove_what_algorithms_promise_are_there() {
    let page = read("docs/algorithms.md");
    let tests = named_tests(&page);
    assert!(tests.len() > 15);
    for (file, test) in tests {
        assert!(read(format!("tests/{file}.rs")).contains(&format!("fn {test}(")), "no such test: {file}::{test}");
    }
}

#[test]
fn every_page_is_linked_from_readme() {
    let readme = read("README.md");
    let linked = links(&readme);
    for page in documents().iter().filter_map(|path| path.strip_prefix(root().join("docs")).ok()) {
        let name = format!("docs/{}", page.display());
        assert!(linked.contains(&name.as_str()), "README does not link to {name}");
    }
}

#[test]
fn fuzzing_begins_with_every_key() {
    let each =
        |form: fn(&str) -> String| riverseed::recipe::table::TABLE.iter().map(|row| form(row.name)).collect::<Vec<_>>();
    let link = each(|name| format!("{name}=1")).join("&");
    let json = format!("{{{}}}", each(|name| format!("\"{name}\":1")).join(","));
    for (target, seed) in [("link", link), ("json", json)] {
        let path = root().join(format!("fuzz/seeds/{target}/every-key"));
        if std::env::var_os("RIVERSEED_REFRESH").is_some() {
            fs::write(&path, &seed).unwrap();
        }
        assert!(fs::read_to_string(&path).unwrap() == seed, "{}: make docs", path.display());
    }
}
