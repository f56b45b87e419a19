//! Names are distinct within a map and the same whatever is trimmed or shaped; own names are kept, and none breaks a
//! file.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};

use crate::common::property::{cases, large};
use crate::common::{finished, random_link};
use proptest::prelude::*;
use riverseed::annotate::names::{Names, PlaceKind, PlaceName};
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
const MANY_REACHES: &str = "country=usual&seed=s0&land=island&sea=0.55&attractors=5600&bending=1&bending-variation=0&growth=drainage&great-rivers=8&meander-rounds=60&style=ink";

proptest! {
    #![proptest_config(large(500))]

    #[test]
    fn no_two_things_on_a_map_have_one_name(link in random_link(600)) {
        let session = finished(&link, "style=ink");
        let Names { rivers, reaches, mut places, title, .. } = Names::of(&session.map().unwrap());
        // The main land has the name of the map.
        if let Some(main) = places.iter().position(|place| (place.kind, place.number) == (PlaceKind::Island, 0)) {
            prop_assert_eq!(&places.remove(main).name, &title);
        }
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
    let mark =
        prop_oneof![3 => "[0-9]{1,4}", 2 => "[mslibcnh][0-9]{1,6}", 1 => Just("t".to_string()), 1 => "[a-z]{0,3}"];
    let name =
        prop_oneof![4 => "[A-Za-z .']{0,20}", 2 => "[<>&\"'/=%+#?;{}\\\\-]{0,12}", 1 => "\\PC{0,44}", 1 => ".{0,12}"];
    let entry =
        (mark, prop_oneof![9 => Just("."), 1 => Just("")], name).prop_map(|(mark, stop, name)| mark + stop + &name);
    prop_oneof![
        9 => prop::collection::vec(entry, 0..45).prop_map(|entries| entries.join("_")),
        1 => ".{0,1500}",
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
                prop_assert!(notices.iter().all(|notice| notice.key == "names"), "{:?}", notices);
                prop_assert!(notices[0].message.starts_with(&error.to_string()), "{:?}", notices);
            }
        }
    }
}

#[test]
fn the_longest_names_and_seed_fit_a_link() {
    let wide = "𝕬".repeat(40);
    let names: Vec<String> = (10..37).map(|i| format!("{i}.{wide}")).collect();
    let mut recipe = Recipe::default();
    recipe.set(Key::Names, &names.join("_")).unwrap();
    recipe.set(Key::Seed, &"𝕬".repeat(64)).unwrap();
    recipe.set(Key::Outline, &format!(".{}", "MzMz".repeat(249))).unwrap_or(());
    assert_eq!(link::read(&link::write(&recipe)), Ok(recipe));
}

const SMALL: &str =
    "growth=drainage&land=archipelago&attractors=2000&country=usual&seed=s2&style=ink&meander-rounds=40";

#[test]
fn one_s_own_name_stands_in_the_place_of_another_and_names_its_fork() {
    let plain = Names::of(&finished(SMALL, "").map().unwrap());
    let fork = (0..30).find_map(|seed| {
        let link = format!("{SMALL}&trim=0").replace("country=usual&seed=s2", &format!("country=usual&seed=f{seed}"));
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
    let number = |kind| plain.places.iter().find(|place| place.kind == kind && place.number > 0).unwrap().number;
    let (island, sea) = (number(PlaceKind::Island), number(PlaceKind::Sea));
    let over =
        format!("names={first}.Silver+Water_{second}._t.Home_i{island}.Away_s{sea}.Glass_999999.Nowhere_l77.Dry");
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
    let of_seed = |seed: u32, own: &str| {
        Names::of(&finished(MANY_REACHES, &format!("country=usual&seed=s{seed}&names={own}")).map().unwrap())
    };
    // Another reach may be called The Meanders, after no river.
    let is_named_after_a_river = |name: &str| name.ends_with(" Meanders") && name != "The Meanders";
    let meanders = |names: Names| names.reaches.into_iter().find(|reach| is_named_after_a_river(&reach.name));
    let seed = (0..80).find(|&seed| meanders(of_seed(seed, "")).is_some()).unwrap();
    let names = |own: &str| of_seed(seed, own);
    let reach = meanders(names("")).unwrap();
    assert!(!reach.name.contains("Fork"), "{}", reach.name);
    let unnamed = meanders(names(&format!("{}.", reach.identity))).unwrap();
    assert_eq!(unnamed.name, reach.name, "a river whose name is taken away has a word still");
    assert_eq!(meanders(names(&format!("{}.The Old Man", reach.identity))).unwrap().name, "Old Man Meanders");
}

#[test]
fn no_two_reaches_wind_after_the_same_thing() {
    let (mut maps, mut all) = (0, 0);
    // Of 400 maps the last of these alone could have The Ouroboros and an Ouroboros River.
    for seed in (0..80).chain([261]) {
        let names = Names::of(&finished(MANY_REACHES, &format!("country=usual&seed=s{seed}")).map().unwrap());
        let usual = names.reaches.iter().filter(|reach| !reach.name.ends_with(" Meanders"));
        let winding = |name: &str| name.trim_start_matches("The ").split(' ').next().unwrap_or_default().to_string();
        let words: Vec<String> = usual.map(|reach| winding(&reach.name)).collect();
        assert_eq!(words.iter().collect::<BTreeSet<_>>().len(), words.len(), "s{seed}: {words:?}");
        (maps, all) = (maps + usize::from(words.len() > 2), all + words.len());
    }
    assert!(maps > 5 && all > 60, "{maps} maps, {all} reaches");
}

#[test]
fn a_reach_keeps_its_word_however_long_it_winds() {
    let link = "growth=drainage&land=island&attractors=6000&country=usual&seed=kauri&style=ink&meander=bend";
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
    assert_eq!((&geojson["title"], &json["names"][0]["text"]), (&names.title.clone().into(), &names.title.into()));
    let places = ["sea", "gulf", "lake", "island", "bay", "cape", "strait", "range"].map(of_kind).iter().sum::<usize>();
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
        let inland = session.land().unwrap().coast_distance().height(place.at);
        let is_of_land = matches!(place.kind, PlaceKind::Island | PlaceKind::Cape | PlaceKind::Range);
        // Capes and straits are found on a lattice of eight units.
        let is_found_roughly = matches!(place.kind, PlaceKind::Cape | PlaceKind::Strait) && inland.abs() < 8.0;
        assert!((inland > 0.0) == is_of_land || is_found_roughly, "{id} lies in its midst, {inland} from the coast");
    }
}

#[test]
fn a_seed_that_can_be_a_name_is_the_country_s_and_own_names_of_map_and_land_follow_each_other() {
    let of = |seed: &str, own: &str| {
        let mut recipe = link::read(SMALL).unwrap();
        recipe.set(Key::Seed, seed).unwrap();
        recipe.set(Key::Names, own).unwrap();
        let names = Names::of(&finished(&link::write(&recipe), "").map().unwrap());
        let land = names.places.iter().find(|place| (place.kind, place.number) == (PlaceKind::Island, 0)).unwrap();
        [names.title, land.name.clone(), names.subtitle]
    };
    assert_eq!(of("tay", ""), ["Tay", "Tay", "and its rivers"]);
    assert_eq!(of("new zealand", "")[0], "New Zealand");
    assert_eq!(of("tay", "t.Home"), ["Home", "Home", "from the word tay"]);
    assert_eq!(of("tay", "i0.The Shire"), ["The Shire", "The Shire", "from the word tay"]);
    assert_eq!(of("tay", "i0.The Shire_t.Home"), ["Home", "The Shire", "from the word tay"]);
    assert_eq!(of("tay", "t._i0."), ["", "", "from the word tay"]);
    assert_eq!(of("tay", "i0."), ["Tay", "", "and its rivers"]);
    for word in ["2026", "Haus 7", "Anna & Tom"] {
        assert_eq!(of(word, ""), [word, word, "and its rivers"]);
    }
    // Others than our type have letters for these.
    for word in ["\u{9577}\u{6c5f}", "\u{646}\u{647}\u{631}"] {
        assert_eq!(of(word, ""), [word, word, ""]);
    }
    let [title, land, line] = of("why? why?", "");
    assert!(title == land && title.chars().all(char::is_alphabetic), "{title}");
    assert_eq!(line, "from the words why? why?");
}

#[test]
fn case_counts_for_nothing_but_the_title() {
    let of = |seed: &str| {
        let session = finished(SMALL, &format!("country=usual&seed={seed}"));
        let names = Names::of(&session.map().unwrap());
        let (vertices, rivers) = (session.network().unwrap().vertices.clone(), names.rivers);
        (session.recipe().seed().to_owned(), names.title, vertices.len(), rivers)
    };
    for [seed, typed, titles] in [["kauri", "KAuri", "Kauri KAuri"], ["tōtara", "TŌTARA", "Tōtara TŌTARA"]] {
        let (one, other) = (of(seed), of(typed));
        assert_eq!(
            (one.0.as_str(), other.0.as_str(), format!("{} {}", one.1, other.1).as_str()),
            (seed, typed, titles)
        );
        assert_eq!((one.2, one.3), (other.2, other.3));
    }
}

#[test]
fn nothing_is_called_by_a_foul_word() {
    let session = finished("", "country=usual&seed=anna");
    let names = Names::of(&session.map().unwrap());
    let marked = names.marked(session.network().unwrap());
    let greatest: Vec<&str> = marked.iter().map(|(_, name)| *name).skip(1).take(2).collect();
    assert!(!marked.iter().any(|(_, name)| name.contains("Foul")), "{greatest:?}");
}

#[test]
fn the_title_is_the_first_of_all_names() {
    let session = finished(SMALL, "country=usual&seed=tay");
    let names = Names::of(&session.map().unwrap());
    let marked = names.marked(session.network().unwrap());
    assert_eq!((marked[0].0.to_string().as_str(), marked[0].1), ("t", "Tay"));
    assert!(marked.iter().any(|(mark, name)| mark.to_string() == "i0" && *name == "Tay"));
    let distinct: BTreeSet<String> = marked.iter().map(|(mark, _)| mark.to_string()).collect();
    assert_eq!(distinct.len(), marked.len());
}

/// Places with the parts of coasts and mountains that a map has.
fn places(link: &str, over: &str) -> Vec<PlaceName> {
    Names::of(&finished(link, over).map().unwrap()).places
}

#[test]
fn coasts_have_bays_capes_and_straits_and_mountains_have_ranges() {
    let count = |places: &[PlaceName], kind| places.iter().filter(|place| place.kind == kind).count();
    let most = [
        (PlaceKind::Gulf, 2),
        (PlaceKind::Bay, 6),
        (PlaceKind::Cape, 6),
        (PlaceKind::Strait, 4),
        (PlaceKind::Range, 3),
    ];
    let mut found = [0; 5];
    for land in ["island", "archipelago", "continent", "valley"] {
        for seed in ["tay", "kauri"] {
            let link = format!("land={land}&country=usual&seed={seed}&attractors=3000&style=atlas");
            let session = finished(&link, "");
            let (places, coast) = (Names::of(&session.map().unwrap()).places, session.land().unwrap().clone());
            let height = |at| coast.coast_distance().height(at);
            for (found, (kind, most)) in found.iter_mut().zip(most) {
                let count = count(&places, kind);
                assert!(count <= most, "{count} of {kind:?}: {link}");
                *found += count;
            }
            for place in &places {
                let has_line = matches!(place.kind, PlaceKind::Strait | PlaceKind::Range)
                    || (place.kind, place.number) == (PlaceKind::Island, 0);
                assert_eq!(place.line.len() >= 2, has_line, "{}: {link}", place.name);
                assert!(
                    place.size > 0.0 && place.at.is_finite() && place.line.windows(2).all(|pair| pair[0] != pair[1])
                );
                assert!(place.line.first().zip(place.line.last()).is_none_or(|(first, last)| first.x <= last.x));
                let is_water = matches!(place.kind, PlaceKind::Bay | PlaceKind::Gulf | PlaceKind::Strait);
                assert!(!is_water || height(place.at) < 4.0, "{}: {link}", place.name);
            }
            // A gulf or bay has land on three sides.
            for place in places.iter().filter(|place| matches!(place.kind, PlaceKind::Gulf | PlaceKind::Bay)) {
                let ways = (0..64).map(|i| glam::Vec2::from_angle(i as f32 * std::f32::consts::TAU / 64.0));
                let sees = |way: glam::Vec2| (1..60).any(|i| height(place.at + way * (i as f32 * 4.0)) > 0.0);
                assert!(ways.filter(|way| sees(*way)).count() >= 40, "{}: {link}", place.name);
            }
        }
    }
    assert!(found[0] >= 1 && found[1..].iter().all(|&count| count >= 12), "{found:?}");
}

/// The names of one's own are where they were, or not on the map; none goes to another place.
#[test]
fn own_names_stay_on_their_places_when_sliders_move() {
    let (mut kept, mut all) = (0, 0);
    for (land, seed) in [("island", "tay"), ("archipelago", "kauri"), ("continent", "rimu")] {
        let link = format!("land={land}&country=usual&seed={seed}&attractors=3000&sea=0.6&roughness=0.5&style=atlas");
        let before: Vec<PlaceName> = places(&link, "").into_iter().filter(|place| place.number > 0).take(30).collect();
        let letter = |kind| match kind {
            PlaceKind::Sea => 's',
            PlaceKind::Lake => 'l',
            PlaceKind::Island => 'i',
            PlaceKind::Cape => 'c',
            PlaceKind::Strait => 'n',
            PlaceKind::Range => 'h',
            _ => 'b',
        };
        let own: Vec<String> =
            (0..).zip(&before).map(|(i, place)| format!("{}{}.Own{i}", letter(place.kind), place.number)).collect();
        let own = format!("names={}", own.join("_"));
        for (over, is_same_land) in
            [("width=20", true), ("trim=30", true), ("sea=0.61", false), ("roughness=0.52", false)]
        {
            let after = places(&link, &format!("{own}&{over}"));
            for (i, place) in before.iter().enumerate() {
                let now = after.iter().find(|now| now.name == format!("Own{i}"));
                let is_range = place.kind == PlaceKind::Range;
                assert!(now.is_some() || !is_same_land || is_range, "{} {over} {link}", place.name);
                let away = now.map_or(0.0, |now| now.at.distance(place.at));
                assert!(away <= 60.0 + 0.5 * place.size, "{} moved {away}: {over} {link}", place.name);
                (kept, all) = (kept + usize::from(now.is_some()), all + 1);
            }
        }
    }
    assert!(kept * 100 >= all * 88, "{kept} of {all} stayed");
}

#[test]
fn marks_of_former_ranks_and_of_no_place_do_nothing() {
    let own = "names=s0.A_i3.B_l0.C_b4294967295.D_c0.E_n1.F_h999999999.G";
    let session = finished(SMALL, own);
    let names = Names::of(&session.map().unwrap());
    assert!(names.unused(session.recipe()).len() >= 6);
}
