//! README and `docs/` are true: their commands work, their links lead somewhere, and what is generated is current.
//!
//! `make docs`, or `RIVERSEED_REFRESH=1 cargo test --all-features --test all documents`, writes the page of parameters and the figures again.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![cfg(feature = "cli")]

#[path = "../examples/figures.rs"]
#[allow(dead_code, reason = "the tests draw figures one by one")]
mod figures;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The published crate has not all of what documents link to.
fn is_published() -> bool {
    !root().join("www").exists()
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

/// Runs the program in a folder of this test's own.
fn riverseed(folder: &Path, words: &[String]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_riverseed")).current_dir(folder).args(words).output().unwrap()
}

#[test]
fn page_of_parameters_is_the_one_the_program_prints() {
    let printed = String::from_utf8(riverseed(root(), &["table".into()]).stdout).unwrap();
    let path = root().join("docs/parameters.md");
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        fs::write(path, printed).unwrap();
        panic!("docs/parameters.md is written again: run without RIVERSEED_REFRESH");
    }
    assert!(read(path) == printed, "write docs/parameters.md again: make docs");
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

/// The commands in blocks of shell, as words.
fn commands(text: &str) -> Vec<Vec<String>> {
    let blocks = text.split("```sh\n").skip(1).map(|rest| rest.split_once("```").unwrap().0);
    blocks.flat_map(str::lines).filter_map(|line| line.strip_prefix("riverseed ")).map(words).collect()
}

/// The words of a command, of which some stand in double quotes.
fn words(command: &str) -> Vec<String> {
    let is_quoted = |i: usize| i % 2 == 1;
    let pieces = command.split('"').enumerate();
    let of_piece = |(i, piece): (usize, &str)| match is_quoted(i) {
        true => vec![piece.to_owned()],
        false => piece.split_whitespace().map(str::to_owned).collect(),
    };
    pieces.flat_map(of_piece).collect()
}

/// White land on black.
fn draw_land(path: &Path) {
    let mut encoder = png::Encoder::new(fs::File::create(path).unwrap(), 60, 40);
    encoder.set_color(png::ColorType::Grayscale);
    let is_land = |i: usize| (10..50).contains(&(i % 60)) && (10..30).contains(&(i / 60));
    let pixels: Vec<u8> = (0..60 * 40).map(|i| if is_land(i) { 255 } else { 0 }).collect();
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
}

/// In the order in which they stand, since one may read what another wrote.
#[test]
fn commands_of_readme_and_the_page_about_the_command_line_work() {
    for page in ["README.md", "docs/command-line.md", "docs/batch.md"] {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("documents").join(page);
        fs::create_dir_all(&folder).unwrap();
        draw_land(&folder.join("coast.png"));
        fs::create_dir_all(folder.join("out")).unwrap();
        // Ten thousand maps take minutes.
        let commands = commands(&read(page).replace("..10000", "..10"));
        assert!(commands.len() >= 3, "{page}");
        // Takes a minute, and has a test of its own in `command_line.rs`.
        for words in commands.iter().filter(|words| words[0] != "verify") {
            let output = riverseed(&folder, words);
            let complaints = String::from_utf8(output.stderr).unwrap();
            assert!(output.status.success(), "{page}: riverseed {words:?}: {complaints}");
            // What is traced is counted, and so are many maps, a picture as land is more than links hold, and of a file's values all that have no effect are named.
            let may_speak = words[0] == "outline"
                || ["--land", "--recipe", "--seeds"].iter().any(|own| words.contains(&(*own).into()));
            assert!(may_speak || complaints.is_empty(), "{page}: riverseed {words:?}: {complaints}");
        }
    }
}

/// What a document links to: everything in round brackets after square ones, but for whole addresses.
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
    if is_published() {
        return;
    }
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

/// What stands in backquotes as `file::test`.
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
