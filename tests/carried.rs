//! Promises of carried letters: they paint what whoever places letters paints, at every width; they hold for their own map alone; and
//! whatever a page carries is read as letters or refused.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::sync::{Arc, OnceLock};

use crate::common::property::cases;
use proptest::prelude::*;
use riverseed::paint::{Framing, View};
use riverseed::picture::carried::{Carried, Lettering, sealed, stepped};
use riverseed::recipe::link;
use riverseed::recipe::reading::{ReadOptions, read};
use riverseed::{Map, Picture, Session};

const SMALL: &str = "country=usual&seed=kauri&attractors=1500";

fn finished(link: &str) -> Map {
    Session::new(link::read(link).unwrap()).unwrap().finish().unwrap()
}

/// The letters of a map, as they come out of their text.
fn carried(map: &Map) -> Carried {
    Carried::read(&Carried::write(map, &[map.recipe()]).unwrap()).unwrap()
}

fn view(map: &Map, width: u32) -> View {
    View::new(&map.domain(), width, View::height_for(&map.domain(), width)).unwrap()
}

#[test]
fn carried_letters_are_painted_as_placed_ones_at_every_width() {
    for link in [
        SMALL,
        "country=usual&seed=rimu&attractors=1500&labels=many&style=survey&label-size=1.3",
        "country=usual&seed=matai&attractors=1500&style=blueprint&aspect=0.7&language=3",
        "country=usual&seed=totara&attractors=1500&style=ink-wash&cartouche=framed",
        "country=usual&seed=miro&attractors=1500&style=parchment&cartouche=profile&labels=few",
        "country=usual&seed=tawa&attractors=1500&land=continent&names=t.Ängström",
    ] {
        let map = finished(link);
        let letters = carried(&map);
        let mut different = 0;
        let mut before = None;
        for width in (190..1500).step_by(83) {
            for ratio in [1.0, 1.3, 2.0] {
                let view = view(&map, (width as f32 * ratio) as u32);
                let masks = letters.masks(&map, &view, ratio);
                assert!(masks.is_some() || width < 260, "{link}: none at {width}");
                assert!(masks == Lettering::InSteps.masks(&map, &view, ratio), "{link}: others at {width} and {ratio}");
                different += u32::from(masks != before);
                before = masks;
            }
        }
        assert!(different > 20, "{link}: {different}");
    }
}

#[test]
fn a_picture_with_carried_letters_is_that_of_the_engine_to_the_byte() {
    let mut session = Session::new(link::read(SMALL).unwrap()).unwrap();
    let letters = Arc::new(carried(&session.finish().unwrap()));
    let painted = |lettering: Lettering, width: u32| {
        let mut picture = Picture::new(width, (width as f32 / 1.6).round() as u32).unwrap().with_ratio(1.5);
        picture.letter(lettering);
        picture.paint(&session);
        picture.pixmap().data().to_vec()
    };
    for width in [480, 1013, 1500] {
        let carried = painted(Lettering::Carried(letters.clone()), width);
        assert!(carried == painted(Lettering::InSteps, width), "{width}");
        let mut bare = session.try_clone().unwrap();
        bare.change(link::read(&format!("{SMALL}&labels=none")).unwrap()).unwrap();
        let mut picture = Picture::new(width, (width as f32 / 1.6).round() as u32).unwrap();
        picture.paint(&bare);
        assert!(carried != picture.pixmap().data(), "{width}: no letters");
    }
}

#[test]
fn letters_are_no_smaller_than_can_be_read_and_little_larger_than_placed_ones() {
    let map = finished(SMALL);
    let size = map.domain().size;
    for width in (270..1265).step_by(31) {
        let scale = width as f32 / size.x;
        let labels = stepped(&map, &view(&map, width), 1.0).unwrap();
        let least = labels.iter().filter(|label| !label.kind.is_block()).map(|label| label.em * scale);
        let least = least.reduce(f32::min).unwrap();
        assert!((10.9..15.5).contains(&least), "{least} at {width}");
    }
}

#[test]
fn letters_hold_for_their_own_map_alone_and_for_pictures_of_all_of_it() {
    let map = finished(SMALL);
    let letters = carried(&map);
    let whole = view(&map, 700);
    assert!(letters.are_for(map.recipe()) && letters.masks(&map, &whole, 1.0).is_some());
    for other in ["language=4", "labels=many", "names=t.Else", "style=ink", "aspect=1.7", "label-size=1.2"] {
        let other = finished(&format!("{SMALL}&{other}"));
        assert!(!letters.are_for(other.recipe()) && letters.masks(&other, &whole, 1.0).is_none(), "{other:?}");
    }
    let domain = map.domain();
    let part = whole.framed(&domain, Framing::new(0.2, 0.2, 0.5));
    let cut = View::new(&domain, 700, 300).unwrap();
    for view in [part, cut, view(&map, 150)] {
        assert!(letters.masks(&map, &view, 1.0).is_none() && Lettering::InSteps.masks(&map, &view, 1.0).is_none());
    }
}

#[test]
fn letters_of_a_page_hold_in_light_and_in_the_dark() {
    let dark = |dark: bool| read(SMALL, ReadOptions { widget: true, dark }).recipe;
    let mut session = Session::new(dark(false)).unwrap();
    let light = session.finish().unwrap();
    session.change(dark(true)).unwrap();
    let night = session.finish().unwrap();
    let letters = Carried::write(&light, &[light.recipe(), night.recipe()]).unwrap();
    let letters = Carried::read(&letters).unwrap();
    let view = view(&light, 640);
    let masks = letters.masks(&light, &view, 1.0);
    assert!(masks.is_some() && masks == letters.masks(&night, &view, 1.0));
    assert!(!carried(&light).are_for(night.recipe()));
    // A style with other marks is left out.
    let survey = link::read(&format!("{SMALL}&style=survey")).unwrap();
    let letters = Carried::write(&light, &[light.recipe(), &survey]).unwrap();
    assert!(!Carried::read(&letters).unwrap().are_for(&survey));
    let many = link::read(&format!("{SMALL}&labels=many")).unwrap();
    assert!(Carried::write(&light, &[light.recipe(), &many]).is_none(), "another map");
}

#[test]
fn maps_without_names_and_with_woods_have_none_to_carry() {
    for link in ["labels=none", "woods=0.5", "hills=0.4&style=parchment"] {
        let map = finished(&format!("{SMALL}&{link}"));
        assert_eq!(Carried::write(&map, &[map.recipe()]), None, "{link}");
    }
}

/// Letters of a small map, less their sum.
fn text() -> &'static (Map, String) {
    static TEXT: OnceLock<(Map, String)> = OnceLock::new();
    TEXT.get_or_init(|| {
        let map = finished(SMALL);
        let text = Carried::write(&map, &[map.recipe()]).unwrap();
        let body = (1..9).map(|sum| &text[sum..]).find(|body| sealed(body) == text).unwrap();
        (map, body.into())
    })
}

#[test]
fn damaged_letters_are_refused() {
    let whole = sealed(&text().1);
    assert!(Carried::read(&whole).is_some());
    for at in (0..whole.len()).step_by(97) {
        let other = if &whole[at..=at] == "A" { "B" } else { "A" };
        assert!(Carried::read(&format!("{}{other}{}", &whole[..at], &whole[at + 1..])).is_none(), "{at}");
        assert!(Carried::read(&whole[..at]).is_none() && Carried::read(&whole[at + 1..]).is_none(), "{at}");
    }
    assert!(Carried::read(&format!("{whole}A")).is_none() && Carried::read(&format!("{whole} ")).is_none());
    assert!(Carried::read(&"A".repeat(Carried::LONGEST + 1)).is_none());
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn whatever_is_carried_is_read_or_refused(changes in proptest::collection::vec((any::<prop::sample::Index>(), "[-_A-Za-z0-9]{0,4}"), 1..6)) {
        let (map, body) = text();
        let mut body = body.clone();
        for (at, other) in changes {
            let at = at.index(body.len());
            body.replace_range(at..(at + other.len()).min(body.len()), &other);
        }
        if let Some(letters) = Carried::read(&sealed(&body)) {
            letters.masks(map, &view(map, 300), 1.0);
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,60}", digits in "[-_A-Za-z0-9]{0,200}") {
        prop_assert!(Carried::read(&text).is_none());
        Carried::read(&sealed(&format!("B{digits}")));
    }
}
