//! Golden pictures, compared pixel for pixel. Each is also an example of a link and what it draws.
//!
//! `RIVERSEED_REFRESH=1 cargo test --all-features --test golden` draws them again and then fails. After a mismatch,
//! `target/golden` holds expected, difference and actual side by side.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![cfg(feature = "png")]

mod common;

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use common::plain::plain;
use riverseed::domain::Domain;
use riverseed::export::png::{LINK_KEYWORD, write};
use riverseed::paint::View;
use riverseed::picture::Picture;
use riverseed::recipe::{Recipe, link};
use riverseed::session::Session;
use tiny_skia::Pixmap;

const WIDTH: u32 = 240;

/// Names and links. In all but the first, keys that a link leaves out have the values of the plain rectangle.
const PICTURES: &[(&str, &str)] = &[
    ("default", ""),
    ("drainage", "growth=drainage&attractors=2000&trim=30&channel-area=4&mouths=0"),
    ("drainage-island", "growth=drainage&land=island&attractors=4000&trim=30&channel-area=4&mouths=0&style=atlas"),
    (
        "drainage-wild",
        "growth=drainage&land=continent&attractors=4000&trim=30&channel-area=4&mouths=0&valleys=0.6&style=atlas",
    ),
    ("valleys-island", "valleys=0.2&curl=0.7&land=island&attractors=4000&trim=24&mouths=0&style=atlas"),
    ("valleys-wild", "valleys=1&land=continent&attractors=4000&trim=24&mouths=0&style=atlas"),
    ("night", "growth=drainage&land=archipelago&attractors=6000&trim=24&channel-area=4&mouths=0&style=night"),
    ("survey", "growth=drainage&land=island&seed=kea&attractors=5000&trim=24&channel-area=4&mouths=0&style=survey"),
    ("survey-plain", "growth=brownian&sensitivity=24&trim=50&mouths=3&style=survey"),
    (
        "basins",
        "growth=drainage&land=archipelago&seed=kea&attractors=5000&trim=24&channel-area=4&mouths=0&style=basins",
    ),
    ("basins-valley", "land=valley&attractors=2000&trim=24&mouths=4&style=basins"),
    (
        "parchment",
        "growth=drainage&land=island&seed=moa&attractors=5000&trim=24&channel-area=4&mouths=0&style=parchment",
    ),
    ("parchment-plain", "growth=colonize&attractors=1500&trim=39&mouths=4&style=parchment"),
    (
        "past-courses",
        "seed=memphis&aspect=2&sides=e&mouths=1&attractors=200&trim=60&width=26&flat-share=0.8&neck=3&meander-mix=0.8&meander-rounds=50&great-rivers=2&style=past-courses",
    ),
    (
        "past-courses-coast",
        "growth=drainage&land=continent&seed=moa&attractors=1500&trim=60&mouths=0&great-rivers=4&flat-share=0.6&meander-rounds=60&style=past-courses",
    ),
    ("ink-wash", "growth=drainage&land=island&seed=tui&attractors=5000&trim=24&channel-area=4&mouths=0&style=ink-wash"),
    ("ink-wash-valley", "land=valley&attractors=2000&trim=24&mouths=4&style=ink-wash"),
    ("orbit", "growth=drainage&land=archipelago&seed=tui&attractors=5000&trim=24&channel-area=4&mouths=0&style=orbit"),
    ("orbit-plain", "growth=drainage&attractors=3000&trim=30&mouths=0&style=orbit"),
    (
        "blueprint",
        "growth=drainage&land=continent&seed=tui&attractors=5000&trim=24&channel-area=4&mouths=0&style=blueprint",
    ),
    ("blueprint-plain", "growth=colonize&attractors=1500&trim=39&mouths=4&style=blueprint"),
    ("atlas-plain", "growth=drainage&attractors=3000&trim=30&mouths=0&style=atlas&mountains=3&plains=60&shade=0.8"),
    (
        "labels-atlas",
        "growth=drainage&land=island&seed=kauri&attractors=4000&trim=24&channel-area=4&mouths=0&style=atlas&labels=many&label-size=0.5",
    ),
    (
        "labels-ink",
        "growth=colonize&valleys=0.2&land=continent&attractors=2000&mouths=0&style=ink&labels=some&label-size=0.7",
    ),
    ("labels-dark", "growth=brownian&sensitivity=32&trim=50&land=archipelago&style=dark&labels=few"),
    (
        "labels-survey",
        "growth=drainage&land=archipelago&seed=moa&attractors=3000&trim=24&channel-area=4&mouths=0&style=survey&labels=some&label-size=0.5",
    ),
    (
        "labels-blueprint",
        "growth=colonize&valleys=0.2&land=continent&seed=kea&attractors=1500&mouths=0&style=blueprint&labels=few&label-size=0.5",
    ),
    (
        "labels-ink-wash",
        "growth=drainage&land=island&seed=kauri&attractors=3000&trim=24&channel-area=4&mouths=0&style=ink-wash&labels=few&label-size=0.6",
    ),
    (
        "cartouche",
        "growth=drainage&land=continent&seed=moa&attractors=3000&trim=24&channel-area=4&mouths=0&style=parchment&cartouche=framed&label-size=0.6",
    ),
    ("cartouche-plain", "land=rectangle&attractors=1000&style=ink&cartouche=plain&label-size=0.7"),
    (
        "scenery-ink",
        "growth=drainage&land=island&seed=kauri&attractors=3000&trim=30&channel-area=4&mouths=0&style=ink&labels=few&label-size=0.7&woods=0.5&hills=0.8",
    ),
    (
        "scenery-parchment",
        "growth=drainage&land=valley&seed=moa&attractors=3000&trim=30&channel-area=4&mouths=0&style=parchment&woods=0.6",
    ),
    (
        "scenery-basins",
        "growth=colonize&land=continent&seed=kea&attractors=1500&trim=39&mouths=0&style=basins&woods=0.4&hills=1",
    ),
    ("original", "preset=original&attractors=1500"),
    ("momentum", "preset=momentum&attractors=1500"),
    ("curl", "preset=curl&attractors=1500"),
    ("trimmed-original", "preset=trimmed-original&attractors=1500&trim=59"),
    ("trimmed-momentum", "preset=trimmed-momentum&attractors=1500&trim=59"),
    ("trimmed-curl", "preset=trimmed-curl&attractors=1500&trim=59"),
    ("skeleton", "style=skeleton&attractors=1500&trim=39"),
    ("skeleton-curl", "style=skeleton&preset=trimmed-curl&attractors=1500&trim=59"),
    ("one-mouth", "mouths=1&attractors=1000&width=24&trim=48"),
    ("all-sides", "mouths=9&sides=nesw&attractors=2000&trim=34"),
    ("east-and-west", "mouths=6&sides=ew&attractors=2000&trim=34"),
    ("banner", "aspect=4&attractors=1500&seed=banner&trim=39"),
    ("tower", "aspect=0.5&attractors=800&seed=tower&trim=54"),
    ("grid", "scatter=grid&reach=4&attractors=1500&trim=39"),
    ("straight", "reach=12&attractors=1500&trim=39"),
    ("coarse", "attractors=100&seed=few&trim=152"),
    ("fine", "attractors=20000&width=8&kill=0.8&trim=11"),
    ("wild", "curl=1.6&momentum=0.3&stretch=3&attractors=1200&trim=44"),
    ("spirals", "curl=2&stretch=64&attractors=1200&step=0.3&trim=35"),
    ("macron", "seed=w%C4%81nanga&attractors=1000&trim=48"),
    ("straight-courses", "simplify=95&meander=none&attractors=1500&trim=39"),
    ("meanders", "great-rivers=9&meander-elsewhere=0.6&meander-rounds=90&attractors=1500&trim=39"),
    ("flow", "meander=flow&great-rivers=9&meander-rounds=60&attractors=1500&trim=39"),
    ("skeleton-meanders", "style=skeleton&great-rivers=9&attractors=1500&trim=39"),
    ("uneven", "bank-variation=0.5&width=40&mouths=1&attractors=800&great-rivers=0&trim=54"),
    ("brownian-flow", "growth=brownian&sensitivity=40&trim=59&meander=flow&great-rivers=4&style=atlas&land=continent"),
    ("island", "land=island&mouths=6&attractors=2000&trim=24"),
    ("dark", "style=dark&land=island&seed=kauri&attractors=2000&trim=24"),
    ("continent", "land=continent&style=atlas&attractors=2000&trim=24"),
    ("archipelago", "land=archipelago&mouths=9&attractors=2000&style=atlas&trim=24"),
    ("valley", "land=valley&attractors=2000&trim=24"),
    ("basin", "land=basin&mouths=7&attractors=2000&style=skeleton&trim=23"),
    (
        "drawn",
        "land=drawn&roughness=0.3&mouths=4&attractors=2000&style=atlas&outline=.3CgA5Tmy30twyhyhrhz8lJzMgAyja2zMUez8NeyhILtwGsmyI9gAMza2P7WuR8R8UeMDZNGsf_EfmyGsrhMDuDR8wEWuzMa2.jMZmoUa4mZgA.AAzMHr2ZJm__AA__..TMgAcznr",
    ),
    (
        "closed-ridges",
        "land=drawn&roughness=0.3&mouths=4&attractors=2000&style=atlas&outline=.-SgA8kqZ1qyLtA2ikf5gbI7mQ26OItziFbpqF-gAHqXJKhN-Q2FxauCDk6EKtAJdz1PW6VWa..f_k5dcqUY5r9U5qXRwnrO_jrOFdqQoYPVLWmZMYMcVa3fGe4f_k5..v_Zmu8dTsSfRpRelnTbknTXopRUnsST7u8V5v_Zm..jMnrnrqPsyoUx6mZ&trim=24",
    ),
    ("brownian", "growth=brownian&sensitivity=24&trim=50"),
    ("brownian-island", "growth=brownian&sensitivity=32&trim=50&land=island&style=atlas"),
    ("brownian-archipelago", "growth=brownian&sensitivity=32&trim=50&land=archipelago"),
    ("brownian-valley", "growth=brownian&sensitivity=40&trim=59&land=valley&style=atlas"),
];

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
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Returns `true` for the published crate, which has no page and, to stay small, no pictures.
fn is_published() -> bool {
    !root().join("www").exists()
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
    if is_published() {
        return;
    }
    let refresh = std::env::var_os("RIVERSEED_REFRESH").is_some();
    let mut changed = Vec::new();
    for (name, text) in PICTURES {
        let link = if *name == "default" { (*text).to_owned() } else { plain(text) };
        let recipe = link::read(&link).unwrap();
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
    if is_published() {
        return;
    }
    let folder = path("default").parent().unwrap().to_owned();
    for entry in fs::read_dir(folder).unwrap() {
        let found = entry.unwrap().path();
        assert!(PICTURES.iter().any(|(name, _)| path(name) == found), "{} belongs to no recipe", found.display());
    }
}

#[test]
fn readme_s_picture_is_what_its_link_draws() {
    if is_published() {
        return;
    }
    let path = root().join("www/public/river.png");
    let (expected, carried) = read(&path);
    if std::env::var_os("RIVERSEED_REFRESH").is_some() {
        let picture = picture(link::read(&carried).unwrap(), 1000);
        write(File::create(&path).unwrap(), &picture, &carried).unwrap();
        panic!("the README's picture is drawn again: look at it, then run without RIVERSEED_REFRESH");
    }
    let (_, command) = include_str!("../README.md").split_once("`riverseed render \"").unwrap();
    let recipe = link::read(command.split_once('"').unwrap().0).unwrap();
    assert_eq!(link::read(&carried).unwrap(), recipe, "the README's picture carries another link");
    assert!(rgb(&picture(recipe, 1000)) == expected, "draw it again: the command stands below it in the README");
}
