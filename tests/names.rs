//! Names are distinct within a map and the same whatever is trimmed or shaped; own names are kept, and none breaks a
//! file.
#![cfg(feature = "pack")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};

use crate::common::property::{cases, large};
use crate::common::{finished, random_link};
use proptest::prelude::*;
use riverseed::annotate::names::Names;
use riverseed::recipe::{Key, OwnNames, Recipe, link};
use riverseed::{Session, export};
use serde_json::Value;

/// The names of rivers and their kinds, by the rivers' identities.
fn rivers(session: &Session) -> BTreeMap<u32, (String, String)> {
    Names::of(&session.map().unwrap())
        .rivers
        .into_iter()
        .map(|river| (river.identity, (river.name, river.kind)))
        .collect()
}

/// A map on which several great rivers wind.
const MANY_REACHES: &str = "seed=s0&land=island&sea=0.55&attractors=5600&bending=1&bending-variation=0&growth=drainage&great-rivers=8&style=ink";

proptest! {
    #![proptest_config(large(500))]

    #[test]
    fn no_two_things_on_a_map_have_one_name(link in random_link(600)) {
        let session = finished(&link, "style=ink");
        let Names { rivers, reaches, places, title, .. } = Names::of(&session.map().unwrap());
        prop_assert_eq!(rivers.len(), session.network().unwrap().rivers.len());
        let rivers = rivers.into_iter().map(|river| river.name);
        let all: Vec<String> = rivers
            .chain(reaches.into_iter().map(|reach| reach.name))
            .chain(places.into_iter().map(|place| place.name))
            .chain([title])
            .collect();
        prop_assert!(all.iter().all(|name| !name.is_empty()));
        prop_assert_eq!(all.iter().collect::<BTreeSet<_>>().len(), all.len(), "{:?} {}", all, link);
    }

    #[test]
    fn names_are_the_same_however_rivers_are_trimmed_and_shaped(
        link in random_link(400),
        trim in 0u32..100,
        (simplify, width, rounds) in (0u32..=95, 1u32..=40, 0u32..30),
        growth in prop::sample::select(vec!["drainage", "brownian"]),
    ) {
        let all = |over: &str| rivers(&finished(&link, &format!("growth={growth}&sensitivity=40&style=ink&{over}")));
        let whole = all("courses=grown&trim=0&channel-area=1");
        let over = format!("courses=smooth&trim={trim}&simplify={simplify}&width={width}&meander-rounds={rounds}&bank-variation=0.4");
        // Those that are there at all: `identity.rs` says which are.
        for (identity, name) in all(&over) {
            prop_assert!(whole.get(&identity).is_none_or(|other| *other == name), "{} {} {}", name.0, link, over);
        }
    }
}

/// Any text, much of it like names.
fn own_names() -> impl Strategy<Value = String> {
    let mark = prop_oneof![3 => "[0-9]{1,4}", 2 => "[msli][0-9]{1,2}", 1 => Just("t".to_string()), 1 => "[a-z]{0,3}"];
    let name =
        prop_oneof![4 => "[A-Za-z .']{0,20}", 2 => "[<>&\"'/=%+#?;{}\\\\-]{0,12}", 1 => "\\PC{0,44}", 1 => ".{0,12}"];
    let entry =
        (mark, prop_oneof![9 => Just("."), 1 => Just("")], name).prop_map(|(mark, stop, name)| mark + stop + &name);
    prop_oneof![
        9 => prop::collection::vec(entry, 0..15).prop_map(|entries| entries.join("_")),
        1 => ".{0,500}",
    ]
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn one_s_own_names_survive_the_link(text in own_names()) {
        let link: String = form_urlencoded::Serializer::new(String::new()).append_pair("names", &text).finish();
        let (recipe, notices) = link::read_leniently(&link);
        let kept = Key::Names.parameter().text_of(recipe.value(Key::Names));
        // Whatever was kept is read strictly, again and again, to the same.
        prop_assert_eq!(OwnNames::parse(&kept).unwrap().to_string(), kept.clone());
        prop_assert_eq!(link::read(&link::write(&recipe)).unwrap(), recipe.clone());
        match link::read(&link) {
            Ok(strict) => prop_assert_eq!((strict, notices), (recipe, vec![])),
            Err(error) => {
                prop_assert!(error.to_string().starts_with("names: "), "{}", error);
                prop_assert_eq!(notices.len(), 1);
            }
        }
    }
}

#[test]
fn the_longest_names_and_seed_fit_a_link() {
    let wide = "𝕬".repeat(40);
    let names: Vec<String> = (0..9).map(|i| format!("{i}.{wide}")).collect();
    let mut recipe = Recipe::default();
    recipe.set(Key::Names, &names.join("_")).unwrap();
    recipe.set(Key::Seed, &"𝕬".repeat(64)).unwrap();
    recipe.set(Key::Outline, &format!(".{}", "MzMz".repeat(249))).unwrap_or(());
    assert_eq!(link::read(&link::write(&recipe)), Ok(recipe));
}

const SMALL: &str = "growth=drainage&land=archipelago&attractors=2000&seed=s2&style=ink&meander-rounds=40";

#[test]
fn one_s_own_name_stands_in_the_place_of_another_and_names_its_fork() {
    let plain = Names::of(&finished(SMALL, "").map().unwrap());
    let fork = (0..30).find_map(|seed| {
        let link = format!("{SMALL}&trim=0").replace("seed=s2", &format!("seed=f{seed}"));
        let names = Names::of(&finished(&link, "").map().unwrap());
        let fork = names.rivers.iter().find(|river| river.name.contains("Fork of the"))?;
        let parent = names.rivers.iter().find(|river| fork.name.ends_with(&format!(" {}", river.short)))?;
        Some((link, fork.clone(), parent.clone()))
    });
    let (link, fork, parent) = fork.unwrap();
    let over = format!("names={}.Silver", parent.identity);
    let named = Names::of(&finished(&link, &over).map().unwrap());
    let name = |identity: u32| named.rivers.iter().find(|river| river.identity == identity).unwrap().name.clone();
    assert_eq!(name(parent.identity), "Silver");
    assert_eq!(name(fork.identity), fork.name.replace(&parent.short, "Silver"));
    let (first, second) = (plain.rivers[0].identity, plain.rivers[1].identity);
    let over = format!("names={first}.Silver+Water_{second}._t.Home_i1.Away_s0.Glass_999999.Nowhere_l77.Dry");
    let session = finished(SMALL, &over);
    let named = Names::of(&session.map().unwrap());
    assert_eq!((named.rivers[0].name.as_str(), named.rivers[1].name.as_str()), ("Silver Water", ""));
    assert_eq!(named.rivers[2..], plain.rivers[2..]);
    assert_eq!(named.title, "Home");
    let places: Vec<&str> = named.places.iter().map(|place| place.name.as_str()).collect();
    assert!(places.contains(&"Away") && places.contains(&"Glass"), "{places:?}");
    let unused: Vec<String> = named.unused(session.recipe()).iter().map(ToString::to_string).collect();
    assert_eq!(unused, ["999999", "l77"]);
}

#[test]
fn what_is_named_after_a_name_of_one_s_own_has_its_word() {
    let of_seed =
        |seed: u32, own: &str| Names::of(&finished(MANY_REACHES, &format!("seed=s{seed}&names={own}")).map().unwrap());
    // Another reach may be called The Meanders, after no river.
    let is_named_after_a_river = |name: &str| name.ends_with(" Meanders") && name != "The Meanders";
    let meanders = |names: Names| names.reaches.into_iter().find(|reach| is_named_after_a_river(&reach.name));
    let seed = (0..40).find(|&seed| meanders(of_seed(seed, "")).is_some()).unwrap();
    let names = |own: &str| of_seed(seed, own);
    assert!(names("i0.The Shire").title.contains("Shire") && !names("i0.The Shire").title.contains("The Shire"));
    let reach = meanders(names("")).unwrap();
    assert!(!reach.name.contains("Fork"), "{}", reach.name);
    let unnamed = meanders(names(&format!("{}.", reach.identity))).unwrap();
    assert_eq!(unnamed.name, reach.name, "a river whose name is taken away has a word still");
    assert_eq!(meanders(names(&format!("{}.The Old Man", reach.identity))).unwrap().name, "Old Man Meanders");
}

#[test]
fn a_reach_keeps_its_word_however_long_it_winds() {
    let link = "growth=drainage&land=island&attractors=6000&seed=kauri&style=ink&meander=bend";
    let reaches = |over: &str| -> BTreeMap<u32, String> {
        let names = Names::of(&finished(link, over).map().unwrap());
        names.reaches.into_iter().map(|reach| (reach.identity, reach.name)).collect()
    };
    let (some, more) =
        (reaches("meander-rounds=40&meander-strength=1"), reaches("meander-rounds=80&meander-strength=1"));
    assert!(!some.is_empty() && !more.is_empty());
    for (identity, name) in &some {
        assert!(more.get(identity).is_none_or(|other| other == name), "{name}: {more:?}");
    }
    let (identity, _) = some.first_key_value().unwrap();
    let own = reaches(&format!("meander-rounds=40&meander-strength=1&names=m{identity}.The+Old+Man"));
    assert_eq!(own[identity], "The Old Man");
}

/// The names in both files.
fn files(session: &Session) -> (Value, Value) {
    let (mut geojson, mut json) = (Vec::new(), Vec::new());
    export::geojson::write(&mut geojson, &session.map().unwrap()).unwrap();
    export::json::write(&mut json, &session.map().unwrap(), None).unwrap();
    (serde_json::from_slice(&geojson).unwrap(), serde_json::from_slice(&json).unwrap())
}

#[test]
fn hostile_names_break_no_file() {
    let plain = Names::of(&finished(SMALL, "").map().unwrap());
    let identity = plain.rivers[0].identity;
    for hostile in [
        "</text><script>alert(1)</script>",
        "\"},{\"x\":\"",
        "\\u0000\\",
        "&lt;!--",
        "%00%ff",
        "'); DROP TABLE--",
        "𝕬é\u{300}",
    ] {
        let mut recipe = finished(SMALL, "").recipe().clone();
        recipe.set(Key::Names, &format!("{identity}.{hostile}_t.{hostile}")).unwrap();
        let mut session = Session::new(recipe).unwrap();
        session.finish().unwrap();
        let (geojson, json) = files(&session);
        assert_eq!(geojson["features"][0]["properties"]["name"], hostile);
        assert_eq!((&json["rivers"][0]["name"], &json["names"][0]["text"]), (&hostile.into(), &hostile.into()));
        let svg = export::svg::svg(&session.map().unwrap()).unwrap();
        assert!(roxmltree::Document::parse(&svg).is_ok() && !svg.contains("<script"));
        assert_eq!(link::read(geojson["riverseed"].as_str().unwrap()).as_ref(), Ok(session.recipe()));
    }
    // Ten thousand bytes, and characters that change the direction of text.
    for long in ["x".repeat(10_000), format!("1.{}", "\u{202e}abc".repeat(2500))] {
        let (recipe, notices) = link::read_leniently(&format!("names={long}"));
        assert!(!notices.is_empty());
        let kept = Key::Names.parameter().text_of(recipe.value(Key::Names));
        assert!(OwnNames::parse(&kept).is_ok() && !kept.contains('\u{202e}'));
    }
}

#[test]
fn names_change_nothing_else() {
    let plain = finished(SMALL, "");
    let named = finished(SMALL, "language=7&names=0.Silver_t.Home");
    assert_eq!(plain.network(), named.network());
    assert_ne!(Names::of(&plain.map().unwrap()).rivers, Names::of(&named.map().unwrap()).rivers);
    assert_eq!(riverseed::digest::digest(plain.recipe()).unwrap().len(), 16);
}

#[test]
fn files_have_the_names() {
    let session = finished(SMALL, "");
    let (names, (geojson, json)) = (Names::of(&session.map().unwrap()), files(&session));
    let features = geojson["features"].as_array().unwrap();
    for (i, river) in names.rivers.iter().enumerate() {
        let properties = &features[i]["properties"];
        assert_eq!(
            (&properties["name"], &properties["kind_name"]),
            (&river.name.clone().into(), &river.kind.clone().into())
        );
        let written = &json["rivers"][i];
        assert_eq!((&written["name"], &written["identity"]), (&river.name.clone().into(), &river.identity.into()));
    }
    let of_kind = |kind: &str| features.iter().filter(|feature| feature["properties"]["kind"] == kind).count();
    assert_eq!(of_kind("reach"), names.reaches.len());
    let places = ["sea", "lake", "island"].map(of_kind).iter().sum::<usize>();
    assert_eq!(
        (places, json["names"].as_array().unwrap().len()),
        (names.places.len(), 1 + names.reaches.len() + places)
    );
    for reach in &names.reaches {
        let feature = features.iter().find(|feature| feature["id"] == format!("reach-{}", reach.river)).unwrap();
        assert_eq!(feature["geometry"]["type"], "LineString");
        assert_eq!(feature["properties"]["reach_name"], reach.name);
        assert_eq!(feature["geometry"]["coordinates"].as_array().unwrap().len(), reach.course.len());
    }
    for place in &names.places {
        let id = format!("{}-{}", place.kind.word(), place.number);
        let feature = features.iter().find(|feature| feature["id"] == id).unwrap();
        assert_eq!(
            (&feature["geometry"]["type"], &feature["properties"]["name"]),
            (&"Point".into(), &place.name.clone().into())
        );
        let is_land = session.land().unwrap().coast_distance().height(place.at) > 0.0;
        assert_eq!(is_land, place.kind == riverseed::annotate::names::PlaceKind::Island, "{id} lies in its midst");
    }
}
