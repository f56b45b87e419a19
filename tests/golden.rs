//! Golden pictures, compared pixel for pixel. Each is also an example of a link and what it draws.
//!
//! `RIVERSEED_REFRESH=1 cargo test --all-features --test all golden` draws them again and then fails. After a mismatch,
//! `target/golden` holds expected, difference and actual side by side.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use riverseed::domain::Domain;
use riverseed::export::png::{LINK_KEYWORD, write};
use riverseed::paint::View;
use riverseed::picture::Picture;
use riverseed::recipe::{Recipe, link};
use riverseed::session::Session;
use tiny_skia::Pixmap;

const WIDTH: u32 = 240;

/// A line for each picture: its name, and its whole link but for what is as by default.
const PICTURES: &str = include_str!("golden.txt");

/// Names and links.
fn pictures() -> impl Iterator<Item = (&'static str, &'static str)> {
    PICTURES.lines().map(|line| line.split_once(' ').unwrap_or((line, "")))
}

fn picture(recipe: Recipe, width: u32) -> Pixmap {
    let height = View::height_for(&Domain::of(&recipe), width);
    let mut session = Session::new(recipe).unwrap();
    while session.advance(u32::MAX).unwrap() {}
    assert!(session.summary().shortfall().is_none(), "{:?} grows next to nothing", session.recipe());
    let mut picture = Picture::new(width, height).unwrap();
    picture.paint(&session);
    picture.pixmap().clone()
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn path(name: &str) -> PathBuf {
    root().join("tests/golden").join(name).with_extension("png")
}

/// The pixels of a golden picture, three bytes each, and its link.
fn read(path: &Path) -> (Vec<u8>, String) {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).unwrap())).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    let chunk = reader.info().uncompressed_latin1_text.iter().find(|chunk| chunk.keyword == LINK_KEYWORD);
    (pixels, chunk.map(|chunk| chunk.text.clone()).unwrap_or_default())
}

fn rgb(picture: &Pixmap) -> Vec<u8> {
    picture.data().chunks(4).flat_map(|rgba| rgba[..3].to_vec()).collect()
}

/// Writes expected | difference | actual.
fn write_difference(name: &str, expected: &[u8], actual: &Pixmap) {
    let (width, height) = (actual.width(), actual.height());
    let mut sheet = Pixmap::new(width * 3, height).unwrap();
    let rgb = actual.data().chunks(4).zip(expected.chunks(3));
    for (i, (actual, expected)) in rgb.enumerate() {
        let difference: Vec<u8> = actual.iter().zip(expected).map(|(a, e)| a.abs_diff(*e)).collect();
        for (column, colour) in [expected, &difference, &actual[..3]].iter().enumerate() {
            let (x, y) = (i as u32 % width + column as u32 * width, i as u32 / width);
            let at = ((y * width * 3 + x) * 4) as usize;
            sheet.data_mut()[at..at + 4].copy_from_slice(&[colour[0], colour[1], colour[2], 255]);
        }
    }
    let folder = root().join("target/golden");
    fs::create_dir_all(&folder).unwrap();
    write(File::create(folder.join(name).with_extension("png")).unwrap(), &sheet, "").unwrap();
}

#[test]
fn every_picture_is_its_golden_one() {
    let refresh = std::env::var_os("RIVERSEED_REFRESH").is_some();
    let mut changed = Vec::new();
    for (name, link) in pictures() {
        let recipe = link::read(link).unwrap();
        let actual = picture(recipe.clone(), WIDTH);
        if refresh {
            write(File::create(path(name)).unwrap(), &actual, &link::write(&recipe)).unwrap();
            continue;
        }
        let (expected, carried) = read(&path(name));
        assert_eq!(link::read(&carried).unwrap(), recipe, "{name} carries another link");
        if rgb(&actual) != expected {
            write_difference(name, &expected, &actual);
            changed.push(name);
        }
    }
    assert!(!refresh, "the pictures are drawn again: look at them, then run without RIVERSEED_REFRESH");
    assert!(changed.is_empty(), "these have changed, see target/golden: {changed:?}");
}

#[test]
fn every_golden_picture_is_still_drawn() {
    let folder = path("default").parent().unwrap().to_owned();
    for entry in fs::read_dir(folder).unwrap() {
        let found = entry.unwrap().path();
        let is_drawn = pictures().any(|(name, _)| path(name) == found) || found == path("card");
        assert!(is_drawn, "{} belongs to no recipe", found.display());
    }
}

#[test]
fn a_card_is_its_golden_one() {
    const LINK: &str =
        "country=usual&seed=Ardenwold&land=island&style=ink&labels=none&attractors=400&meander=none&cartouche=none";
    let mut session = Session::new(link::read(LINK).unwrap()).unwrap();
    let map = session.finish().unwrap();
    let mut picture = Picture::new(1200, 630).unwrap();
    // The page draws the same: www/tests/unit/card.test.ts.
    picture.head(&session, &map);
    picture.paint(&session);
    let path = path("card");
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        write(File::create(&path).unwrap(), picture.pixmap(), LINK).unwrap();
        panic!("the card is drawn again: look at it, then run without RIVERSEED_REFRESH");
    }
    assert!(rgb(picture.pixmap()) == read(&path).0, "the card has changed");
}

/// Returns the links and the pictures of a table's columns: the first row and the third.
fn columns(table: &str) -> Vec<(String, String)> {
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.trim_matches('|').split('|').collect()).collect();
    let link = |cell: &str| cell.trim().trim_matches('`').to_owned();
    let picture = |cell: &str| cell.split_once("](").unwrap().1.trim().trim_end_matches(')').to_owned();
    rows[0].iter().zip(&rows[2]).map(|(head, cell)| (link(head), picture(cell))).collect()
}

#[test]
fn readme_s_pictures_are_what_their_links_draw() {
    const WIDTH: u32 = 400;
    let readme = include_str!("../README.md");
    let table: Vec<&str> = readme.lines().skip_while(|line| !line.starts_with('|')).take(3).collect();
    let columns = columns(&table.join("\n"));
    assert_eq!(columns.len(), 4);
    let refresh = std::env::var_os("RIVERSEED_REFRESH").is_some();
    for (text, path) in columns {
        let (recipe, path) = (link::read(&text).unwrap(), root().join(path));
        let picture = picture(recipe.clone(), WIDTH);
        if refresh {
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            write(File::create(&path).unwrap(), &picture, &recipe.to_string()).unwrap();
        }
        assert!(rgb(&picture) == read(&path).0, "README names the link above its picture: {text}");
    }
    assert!(!refresh, "README's pictures are drawn again: look at them, then run without RIVERSEED_REFRESH");
}

#[test]
fn the_page_s_picture_for_posts_is_what_its_link_draws() {
    let path = root().join("www/public/river.png");
    let (expected, carried) = read(&path);
    let picture = picture(link::read(&carried).unwrap(), 1000);
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        write(File::create(&path).unwrap(), &picture, &carried).unwrap();
        panic!("the picture is drawn again: look at it, then run without RIVERSEED_REFRESH");
    }
    assert!(rgb(&picture) == expected, "the picture carries another link");
}
