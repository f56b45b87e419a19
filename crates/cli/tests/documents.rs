//! The commands in README and `docs/` work, and the page of parameters is current.
//!
//! `make docs` writes that page.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use riverseed_exchange::gis::layers::{Column, KEY, LAYERS, Layer};

/// Returns the folder of the checkout.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(root().join(path)).unwrap()
}

/// Runs the program in a folder.
fn riverseed(folder: &Path, words: &[String]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_riverseed")).current_dir(folder).args(words).output().unwrap()
}

/// Compares a file with the output of a command, or writes it.
fn assert_printed(file: &str, command: &[&str]) {
    let command: Vec<String> = command.iter().map(|&word| word.into()).collect();
    let printed = String::from_utf8(riverseed(&root(), &command).stdout).unwrap();
    let path = root().join(file);
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        fs::write(path, printed).unwrap();
        panic!("{file} is written again: run without RIVERSEED_REFRESH");
    }
    assert!(read(path) == printed, "write {file} again: make docs");
}

#[test]
fn page_of_parameters_is_the_one_the_program_prints() {
    assert_printed("docs/parameters.md", &["table"]);
}

/// The page and the npm package read parameters from this file.
#[test]
fn data_of_parameters_are_those_the_program_prints() {
    assert_printed("www/src/engine/parameters.json", &["table", "--json"]);
}

/// Finds the lines in blocks of shell.
fn shell(text: &str) -> impl Iterator<Item = &str> {
    let blocks = text.split("```sh\n").skip(1).map(|rest| rest.split_once("```").unwrap().0);
    blocks.flat_map(str::lines)
}

/// Writes the table of layers: those of a GeoPackage, and the kinds of features that GeoJSON has.
fn table_of_layers() -> String {
    let shape = |layer: &Layer| {
        let name = layer.geometry.to_lowercase().replace("multi", "multi-").replace("linestring", "line");
        if layer.has_heights { format!("{name} with heights") } else { name }
    };
    let column = |column: &Column| format!("`{}`, {}", column.name, column.help);
    let row = |layer: &Layer| {
        let kinds: Vec<String> = layer.kinds.iter().map(|kind| format!("`{kind}`")).collect();
        let columns: Vec<String> = layer.columns.iter().filter(|own| own.name != KEY.name).map(column).collect();
        let description = layer.description.trim_end_matches('.');
        format!(
            "| `{}` | {} | {} | {description} | {} |\n",
            layer.name,
            kinds.join(", "),
            shape(layer),
            columns.join("; ")
        )
    };
    let head = "| layer | `kind` | shape | what it holds | columns |\n| --- | --- | --- | --- | --- |\n";
    head.to_owned() + &LAYERS.iter().map(row).collect::<String>()
}

/// Both pages have the table, between two comments.
#[test]
fn tables_of_layers_are_those_that_the_program_writes() {
    const BEGIN: &str = "<!-- table: layers -->\n";
    const END: &str = "<!-- end -->";
    for file in ["docs/gis.md", "docs/files.md"] {
        let page = read(file);
        let (before, rest) = page.split_once(BEGIN).unwrap();
        let (table, after) = rest.split_once(END).unwrap();
        if std::env::var_os("RIVERSEED_REFRESH").is_some() {
            fs::write(root().join(file), format!("{before}{BEGIN}{}{END}{after}", table_of_layers())).unwrap();
        } else {
            assert!(table == table_of_layers(), "write {file} again: make docs");
        }
    }
    assert!(std::env::var_os("RIVERSEED_REFRESH").is_none(), "written again: run without RIVERSEED_REFRESH");
}

/// Finds the commands in blocks of shell, as words.
fn commands(text: &str) -> Vec<Vec<String>> {
    shell(text).filter_map(|line| line.strip_prefix("riverseed ")).map(words).collect()
}

/// What other programs do is tested where they are at hand.
#[test]
fn lines_of_shell_in_readme_and_the_guides_are_commands_or_installations() {
    const OTHERS: [&str; 4] = ["cargo add riverseed ", "npm install ", "pip install ./python", "mkdir -p out"];
    for page in guides().into_iter().chain(["README.md".into()]) {
        for line in shell(&read(&page)) {
            assert!(["riverseed "].iter().chain(&OTHERS).any(|start| line.starts_with(start)), "{page}: {line}");
        }
    }
}

/// Returns the guides.
fn guides() -> Vec<String> {
    let guides = fs::read_dir(root().join("docs/for")).unwrap().map(|guide| guide.unwrap().file_name());
    let mut guides: Vec<String> = guides.map(|name| format!("docs/for/{}", name.to_str().unwrap())).collect();
    guides.sort();
    assert!(guides.len() >= 8, "{guides:?}");
    guides
}

/// Splits the words of a command, some of them in double quotes.
fn words(command: &str) -> Vec<String> {
    let is_quoted = |i: usize| i % 2 == 1;
    let pieces = command.split('"').enumerate();
    let of_piece = |(i, piece): (usize, &str)| match is_quoted(i) {
        true => vec![piece.to_owned()],
        false => piece.split_whitespace().map(str::to_owned).collect(),
    };
    pieces.flat_map(of_piece).collect()
}

/// Draws white land on black.
fn draw_land(path: &Path) {
    let mut encoder = png::Encoder::new(fs::File::create(path).unwrap(), 60, 40);
    encoder.set_color(png::ColorType::Grayscale);
    let is_land = |i: usize| (10..50).contains(&(i % 60)) && (10..30).contains(&(i / 60));
    let pixels: Vec<u8> = (0..60 * 40).map(|i| if is_land(i) { 255 } else { 0 }).collect();
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
}

/// The commands run in the order of the page, since one may read the output of another.
#[test]
fn commands_of_readme_the_guides_and_the_pages_about_the_command_line_work() {
    let pages = ["README.md", "docs/command-line.md", "docs/batch.md", "docs/gis.md", "docs/engines.md"];
    for page in pages.map(String::from).into_iter().chain(guides()) {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("documents").join(&page);
        // What an earlier run left may be of an earlier program.
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        draw_land(&folder.join("coast.png"));
        fs::create_dir_all(folder.join("out")).unwrap();
        // Ten thousand maps take minutes.
        let commands = commands(&read(&page).replace("..10000", "..10").replace("..100 ", "..10 "));
        assert!(page.starts_with("docs/for/") || commands.len() >= 3, "{page}");
        // This takes a minute, and `command_line.rs` has a test for it.
        for words in commands.iter().filter(|words| words[0] != "verify") {
            let output = riverseed(&folder, words);
            let complaints = String::from_utf8(output.stderr).unwrap();
            assert!(output.status.success(), "{page}: riverseed {words:?}: {complaints}");
            // Some commands may print notes: traces and batches report counts, a picture as land is more than links
            // hold, and values of a file without effect are named.
            let may_speak = words[0] == "outline"
                || ["--land", "--recipe", "--seeds"].iter().any(|own| words.contains(&(*own).into()));
            assert!(may_speak || complaints.is_empty(), "{page}: riverseed {words:?}: {complaints}");
        }
    }
}
