//! A picture painted while the tree grows is the picture painted at once.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::parts::paint_in_parts;
use crate::common::plain::plain;
use crate::common::property::cases;
use crate::common::random_link;
use crate::common::tier::{first, one_in, tiers};
use proptest::prelude::*;
use riverseed::picture::Picture;
use riverseed::recipe::{Choice, Key, Recipe, Style, link};
use riverseed::session::{Phase, Session};

/// The picture after painting every `ticks` ticks.
fn painted(recipe: &Recipe, ticks: u32) -> Vec<u8> {
    let (mut session, mut picture) = (Session::new(recipe.clone()).unwrap(), picture());
    while session.advance(ticks).unwrap() {
        picture.paint(&session);
    }
    picture.paint(&session);
    picture.pixmap().data().to_vec()
}

fn picture() -> Picture {
    Picture::new(120, 90).unwrap()
}

/// A change from one recipe to the other, by way of the other procedure of growth, and while the first still grows.
fn check_change(link: &str, other: &str) {
    let recipe = |link: &str| {
        let mut recipe = link::read(link).unwrap();
        recipe.set(Key::Growth, "brownian").unwrap();
        recipe
    };
    for (from, to) in [(link::read(link).unwrap(), recipe(other)), (recipe(link), link::read(other).unwrap())] {
        let (mut session, mut picture) = (Session::new(from).unwrap(), picture());
        session.advance(40).unwrap();
        picture.paint(&session);
        session.change(to.clone()).unwrap();
        while session.advance(u32::MAX).unwrap() {}
        picture.paint(&session);
        assert!(picture.pixmap().data() == painted(&to, u32::MAX), "{link} to {other}");
    }
}

proptest! {
    #![proptest_config(first(4, cases(60)))]

    fn painted_bit_by_bit_equals_painted_at_once(link in random_link(800), ticks in 1u32..30) {
        let recipe = link::read(&link).unwrap();
        prop_assert!(painted(&recipe, ticks) == painted(&recipe, u32::MAX), "{link}");
    }

    fn after_each_round_of_drainage_the_picture_is_that_of_painting_at_once(seed in "[a-z]{1,6}", captures in 1u32..6) {
        let link = format!("growth=drainage&land=island&attractors=900&country=usual&seed={seed}&captures={captures}&trim=40");
        let (mut session, mut kept) = (Session::new(link::read(&link).unwrap()).unwrap(), picture());
        let mut trees = 0;
        while session.growth().ending().is_none() {
            session.advance(1).unwrap();
            kept.paint(&session);
            if session.growth().trees() > trees {
                trees = session.growth().trees();
                let mut fresh = picture();
                fresh.paint(&session);
                prop_assert!(kept.pixmap().data() == fresh.pixmap().data(), "{link}: tree {trees}");
            }
        }
        prop_assert_eq!(trees, captures, "{}", link);
    }

    fn changing_there_and_back_gives_the_same_picture(link in random_link(400), trim in 0u32..200) {
        let recipe = link::read(&link).unwrap();
        let mut other = recipe.clone();
        other.set(Key::Trim, &trim.to_string()).unwrap();
        let (mut session, mut picture) = (Session::new(recipe.clone()).unwrap(), picture());
        while session.advance(7).unwrap() {}
        picture.paint(&session);
        session.change(other).unwrap();
        while session.advance(7).unwrap() {}
        picture.paint(&session);
        session.change(recipe.clone()).unwrap();
        while session.advance(7).unwrap() {}
        picture.paint(&session);
        prop_assert!(picture.pixmap().data() == painted(&recipe, u32::MAX), "{link}");
    }

    fn changing_what_shapes_rivers_while_they_are_shaped_gives_the_same_picture(
        link in random_link(300), simplify in 0u32..95, width in 1u32..40, grown in any::<bool>(), steps in 0u32..7,
    ) {
        let recipe = link::read(&link).unwrap();
        let mut other = recipe.clone();
        other.set(Key::Simplify, &simplify.to_string()).unwrap();
        other.set(Key::Width, &width.to_string()).unwrap();
        other.set(Key::Courses, if grown { "grown" } else { "smooth" }).unwrap();
        let (mut session, mut picture) = (Session::new(recipe).unwrap(), picture());
        while session.phase() == Phase::Growing {
            session.advance(1).unwrap();
        }
        session.advance(steps).unwrap();
        session.change(other.clone()).unwrap();
        while session.advance(u32::MAX).unwrap() {}
        picture.paint(&session);
        prop_assert!(picture.pixmap().data() == painted(&other, u32::MAX), "{link}");
    }

    fn changing_to_another_recipe_gives_its_picture(link in random_link(400), other in random_link(400)) {
        check_change(&link, &other);
    }
}

tiers!(
    painted_bit_by_bit_equals_painted_at_once,
    after_each_round_of_drainage_the_picture_is_that_of_painting_at_once,
    changing_there_and_back_gives_the_same_picture,
    changing_what_shapes_rivers_while_they_are_shaped_gives_the_same_picture,
    changing_to_another_recipe_gives_its_picture,
);

#[test]
fn wide_rivers_that_open_while_they_grow_are_those_painted_at_once() {
    for (style, water) in [("ink", [0xdd, 0xe6, 0xe4]), ("atlas", [0xcf, 0xe3, 0xe6])] {
        let link = format!(
            "country=usual&seed=kea&attractors=900&trim=40&land=rectangle&mouths=1&width=40&labels=none&style={style}"
        );
        let recipe = link::read(&link).unwrap();
        let picture = || Picture::new(480, 300).unwrap();
        let (mut session, mut kept, mut opened) = (Session::new(recipe).unwrap(), picture(), 0);
        while session.phase() == Phase::Growing {
            session.advance(9).unwrap();
            kept.paint(&session);
            opened += u32::from(count(kept.pixmap().data().as_chunks().0, water) > 20);
        }
        let mut fresh = picture();
        fresh.paint(&session);
        assert!(kept.pixmap().data() == fresh.pixmap().data(), "{style}");
        assert!(opened > 3, "{style}: in {opened} pictures");
        session.finish().unwrap();
        for picture in [&mut kept, &mut fresh] {
            picture.paint(&session);
        }
        assert!(kept.pixmap().data() == fresh.pixmap().data(), "{style}, finished");
        assert!(count(kept.pixmap().data().as_chunks().0, water) > 500, "{style}");
    }
}

/// Its picture was another once.
#[test]
fn changing_the_procedure_of_growth_alone_gives_its_picture() {
    let link = "country=usual&seed=a&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=0&land=rectangle&outline=&sea=0.100&roughness=0.000&aspect=0.250&mouths=1&sides=n&attractors=100&scatter=random&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink";
    check_change(link, link);
}

/// The finished picture of a land and its rivers, a pixel a unit.
fn map(link: &str) -> (Session, Vec<[u8; 4]>) {
    let mut session = Session::new(link::read(&plain(link)).unwrap()).unwrap();
    let mut picture = Picture::new(1000, 1000).unwrap();
    while session.advance(u32::MAX).unwrap() {}
    picture.paint(&session);
    let pixels = picture.pixmap().data().as_chunks().0.to_vec();
    (session, pixels)
}

fn rivers_end_at_the_coast_and_the_sea_is_the_same_whatever_runs_into_it() {
    for style in one_in(6, Style::WORDS.iter().map(|word| word.name)) {
        let link = format!("aspect=1&land=archipelago&roughness=1&attractors=600&style={style}");
        let ((session, narrow), (_, wide)) = (map(&format!("{link}&width=2")), map(&format!("{link}&width=40")));
        let land = session.land().unwrap();
        let mut inland = 0;
        for (i, (narrow, wide)) in narrow.iter().zip(&wide).enumerate() {
            let height =
                land.coast_distance().height(glam::Vec2::new((i % 1000) as f32 + 0.5, (i / 1000) as f32 + 0.5));
            assert!(height > -3.0 || narrow == wide, "{style}: pixel {i}, {height} inland: {narrow:?}, {wide:?}");
            assert!(narrow[3] == 255 && wide[3] == 255, "{style}: pixel {i} is not opaque");
            inland += u32::from(narrow != wide);
        }
        assert!(inland > 2000 || style == "skeleton", "{style}: {inland} pixels differ");
    }
}

tiers!(rivers_end_at_the_coast_and_the_sea_is_the_same_whatever_runs_into_it);

/// Rivers that cut off loops, on land with a coast and without.
const BENDS: &str = "country=usual&seed=fisk&aspect=1&sea=0.55&growth=colonize&attractors=400&mouths=3&trim=30&flat-share=0.8&neck=4&meander-mix=1&style=past-courses";

#[test]
fn past_courses_painted_round_by_round_are_those_painted_at_once() {
    for land in ["island", "rectangle"] {
        let link = format!("{BENDS}&land={land}&meander-rounds=60");
        let (mut session, mut kept, mut rounds) = (Session::new(link::read(&link).unwrap()).unwrap(), picture(), 0);
        while session.advance(1).unwrap() {
            kept.paint(&session);
            if session.phase() == Phase::Meandering {
                let mut fresh = picture();
                fresh.paint(&session);
                assert!(kept.pixmap().data() == fresh.pixmap().data(), "{land}, round {:?}", session.rounds());
                rounds += 1;
            }
        }
        assert!(rounds > 20 && session.past().unwrap().rounds().iter().any(|past| !past.loops.is_empty()), "{land}");
    }
}

/// The pixels of a map that have exactly a colour.
fn count(pixels: &[[u8; 4]], [r, g, b]: [u8; 3]) -> usize {
    pixels.iter().filter(|pixel| **pixel == [r, g, b, 255]).count()
}

#[test]
fn past_courses_have_a_colour_each_and_without_any_the_map_is_plain() {
    const OLDEST: [u8; 3] = [0xc9, 0xb7, 0x9c];
    const PLAIN: [u8; 3] = [0xea, 0xe0, 0xbd];
    const LATEST: [u8; 3] = [0x8f, 0xb8, 0xb0];
    const RIVER: [u8; 3] = [0xfb, 0xfa, 0xf5];
    const BROOK: [u8; 3] = [0x7d, 0x8f, 0xa0];
    let pixels = |more: &str| map(&format!("{BENDS}&land=rectangle&{more}")).1;
    for (more, bands) in [
        ("great-rivers=3&meander-rounds=30", true),
        ("great-rivers=3&meander-rounds=0", false),
        ("meander=none", false),
    ] {
        let pixels = pixels(more);
        let [oldest, latest, river, brook, plain] =
            [OLDEST, LATEST, RIVER, BROOK, PLAIN].map(|colour| count(&pixels, colour));
        assert_eq!((oldest > 50, latest > 50), (bands, bands), "{more}: {oldest} and {latest} pixels");
        assert_eq!(plain > 3000, bands, "{more}: {plain} pixels of flood plains");
        assert!(river > 3000 && brook > 100, "{more}: {river} and {brook} pixels");
    }
    // Without great rivers those of the highest order stand out.
    assert!(count(&pixels("great-rivers=0&meander-rounds=9"), RIVER) > 1000);
}

/// Each style after another that shows the same relief, on land with a coast and without; and growing again from the
/// start.
fn changing_the_style_of_a_finished_map_gives_the_picture_of_a_fresh_one() {
    for land in one_in(2, ["island", "rectangle"]) {
        let mut fresh = BTreeMap::new();
        let link = |style: &str| format!("country=usual&seed=kea&attractors=900&mouths=3&land={land}&style={style}");
        let (mut session, mut picture) = (Session::new(link::read(&link("atlas")).unwrap()).unwrap(), picture());
        for style in Style::WORDS.iter().chain(Style::WORDS.iter().rev()).map(|word| word.name) {
            let recipe = link::read(&link(style)).unwrap();
            session.change(recipe.clone()).unwrap();
            session.finish().unwrap();
            picture.paint(&session);
            let fresh = fresh.entry(style).or_insert_with(|| painted(&recipe, u32::MAX));
            assert!(picture.pixmap().data() == *fresh, "{land}: {style}");
        }
        let recipe = link::read(&link("night")).unwrap();
        session.change(recipe.clone()).unwrap();
        session.finish().unwrap();
        picture.paint(&session);
        session.restart().unwrap();
        picture.paint(&session);
        let mut fresh = self::picture();
        fresh.paint(&Session::new(recipe).unwrap());
        assert!(picture.pixmap().data() == fresh.pixmap().data(), "{land}, from the start");
    }
}

tiers!(changing_the_style_of_a_finished_map_gives_the_picture_of_a_fresh_one);

/// A change of a finished map's picture from one recipe to the next, and the number of parts after which that picture
/// is abandoned for another.
type Change = (usize, u32, u32, bool, u32);

proptest! {
    #![proptest_config(first(2, cases(12)))]

    /// The picture is that of a fresh one whatever is kept of a relief, of rivers and of ground, and wherever painting
    /// is broken off.
    fn a_picture_painted_in_parts_is_that_of_a_fresh_one(
        changes in prop::collection::vec((0..Style::ALL.len(), 0u32..6, 0u32..3, any::<bool>(), 0u32..40), 2..9), has_coast in any::<bool>(),
    ) {
        let land = if has_coast { "island" } else { "rectangle" };
        let start = link::read(&format!("country=usual&seed=kea&attractors=300&mouths=3&land={land}&meander-rounds=9")).unwrap();
        let recipe = |&(style, shade, rain, is_grown, _): &Change| {
            let mut recipe = start.clone();
            recipe.set(Key::Style, Style::WORDS[style].name).unwrap();
            recipe.set(Key::Shade, ["0.2", "0.45", "1"][shade as usize % 3]).unwrap();
            recipe.set(Key::Span, ["200", "5000"][shade as usize / 3]).unwrap();
            recipe.set(Key::Rain, ["0.5", "0.1", "0.9"][rain as usize]).unwrap();
            recipe.set(Key::RainShadow, ["0", "0.7", "1"][rain as usize]).unwrap();
            recipe.set(Key::Courses, if is_grown { "grown" } else { "smooth" }).unwrap();
            recipe
        };
        // Several bands of rows.
        let picture = || Picture::new(420, 330).unwrap();
        paint_in_parts(start.clone(), changes.iter().map(|change| (recipe(change), change.4)), picture)?;
    }
}

tiers!(a_picture_painted_in_parts_is_that_of_a_fresh_one);
