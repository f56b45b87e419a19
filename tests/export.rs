//! Exported files open in readers written by others.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};

use crate::common::plain::plain;
use crate::common::property::cases;
use crate::common::random_link;
use crate::common::svg_ids::end_of_ids;
use crate::common::tier::{first, one_in, pairs, tiers};
use geo::{Area, LineString, Polygon, Validation};
use geojson::feature::Id;
use geojson::{FeatureCollection, GeometryValue};
use proptest::prelude::*;
use resvg::{tiny_skia, usvg};
use riverseed::export::{geojson as to_geojson, json as to_json, svg};
use riverseed::network::NONE;
use riverseed::picture::Picture;
use riverseed::recipe::{Choice, Style, link};
use riverseed::session::Session;

fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(&plain(link)).unwrap()).unwrap();
    while session.advance(64).unwrap() {}
    session
}

fn collection(session: &Session) -> FeatureCollection {
    let mut text = Vec::new();
    to_geojson::write(&mut text, &session.map().unwrap()).unwrap();
    String::from_utf8(text).unwrap().parse::<geojson::GeoJson>().unwrap().try_into().unwrap()
}

fn network(session: &Session) -> serde_json::Value {
    let mut text = Vec::new();
    to_json::write(&mut text, &session.map().unwrap(), None).unwrap();
    serde_json::from_slice(&text).unwrap()
}

/// Checks an SVG: well-formed, ids its own, a path a river, all numbers numbers.
fn check_svg(session: &Session) {
    let text = svg::svg(&session.map().unwrap()).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
    let rivers = ids.iter().filter(|id| id.strip_prefix("river-").is_some_and(|id| id.parse::<u32>().is_ok())).count();
    assert_eq!(rivers, session.network().unwrap().rivers.len());
    for data in document.descendants().filter_map(|node| node.attribute("d")) {
        assert!(data.bytes().all(|c| b"MHVqtTlaz0123456789.- ".contains(&c)), "{data}");
        // Lines that were cut off by a number that is none would end at 0 0, or at the end of all numbers.
        assert!(!data.contains("21474836"), "{data}");
    }
    let tree = usvg::Tree::from_str(&text, &usvg::Options::default()).unwrap();
    let size = session.domain().size;
    assert!((tree.size().width() - size.x).abs() < 0.01 && (tree.size().height() - size.y).abs() < 0.01);
}

/// Checks a GeoJSON: water, and what it flows through.
fn check_geojson(session: &Session) {
    let ground = check_water(session, collection(session).features);
    check_ground(session, &ground);
}

/// Checks that rivers are connected and lakes are closed. Returns what comes after them.
fn check_water(session: &Session, features: Vec<geojson::Feature>) -> Vec<geojson::Feature> {
    let id = |feature: &geojson::Feature, key: &str| feature.property(key).and_then(serde_json::Value::as_u64);
    let line = |feature: &geojson::Feature| match &feature.geometry.as_ref().unwrap().value {
        GeometryValue::LineString { coordinates } => coordinates.clone(),
        other => panic!("{other:?}"),
    };
    let (features, others) = features.split_at(session.network().unwrap().rivers.len());
    let is_lake = |feature: &&geojson::Feature| feature.property("kind").is_some_and(|kind| kind == "oxbow");
    let (lakes, ground) = others.split_at(others.iter().take_while(is_lake).count());
    check_lakes(session, lakes);
    let lines: Vec<_> = features.iter().map(line).collect();
    for (number, feature) in features.iter().enumerate() {
        let line = &lines[number];
        assert!(line.iter().flat_map(|at| at.as_slice()).all(|x| x.is_finite()));
        assert_eq!(feature.id, Some(Id::String(format!("river-{number}"))));
        assert_eq!(id(feature, "number"), Some(number as u64));
        assert!(line.len() > 1 && line.windows(2).all(|pair| pair[0][2] >= pair[1][2]), "a river rises");
        match id(feature, "parent") {
            Some(parent) => {
                assert!(lines[parent as usize].contains(line.last().unwrap()));
                assert_eq!(id(feature, "mouth"), id(&features[parent as usize], "mouth"));
            }
            None => assert!(id(feature, "mouth") == Some(number as u64) && line.last().unwrap()[2] == 0.0),
        }
    }
    // `names.rs` looks at what only has a name.
    let named = ["reach", "sea", "gulf", "lake", "island", "bay", "cape", "strait", "range"];
    let is_ground = |feature: &&geojson::Feature| !named.iter().any(|kind| feature.property("kind").unwrap() == kind);
    ground.iter().filter(is_ground).cloned().collect()
}

/// Checks the lakes of a GeoJSON: each that there is to see is there, and each is a valid polygon, its ring
/// counterclockwise (RFC 7946).
fn check_lakes(session: &Session, lakes: &[geojson::Feature]) {
    let oxbows = session.network().unwrap().oxbows.iter().enumerate();
    let seen: Vec<u64> =
        oxbows.filter(|(_, oxbow)| oxbow.middle().len() > 2).map(|(number, _)| number as u64).collect();
    let number = |lake: &geojson::Feature| lake.property("number").and_then(serde_json::Value::as_u64).unwrap();
    assert_eq!(lakes.iter().map(number).collect::<Vec<_>>(), seen, "lakes are lost");
    for lake in lakes {
        assert_eq!(lake.id, Some(Id::String(format!("oxbow-{}", number(lake)))));
        let polygon = polygon(lake);
        assert!(polygon.is_valid(), "{:?}: {:?}", lake.id, polygon.validation_errors());
    }
}

/// Checks basins, land, lakes and ridges: valid polygons, each basin with a mouth of its own, and all of them within the
/// land's area.
fn check_ground(session: &Session, ground: &[geojson::Feature]) {
    let kind = |feature: &geojson::Feature| feature.property("kind").unwrap().as_str().unwrap().to_owned();
    let kinds: Vec<String> = ground.iter().map(kind).collect();
    assert!(kinds.is_sorted_by_key(|kind| {
        ["basin", "land", "water", "delta", "distributary", "ridge"].iter().position(|own| own == kind).unwrap()
    }));
    // The units of a degree.
    let units = 111_320.0 / session.map().unwrap().scale().metres_a_unit;
    let rings = |feature: &geojson::Feature| match feature.geometry.clone().unwrap().value {
        GeometryValue::Polygon { coordinates } => vec![coordinates],
        GeometryValue::MultiPolygon { coordinates } => coordinates,
        _ => vec![],
    };
    let line =
        |ring: &Vec<geojson::Position>| ring.iter().map(|at| (at[0] * units, at[1] * units)).collect::<LineString>();
    let metres = session.map().unwrap().scale().metres_a_unit;
    let (mut areas, mut mouths) = ([0.0, 0.0], BTreeSet::new());
    for (feature, kind) in ground.iter().zip(&kinds) {
        let number = |name: &str| feature.property(name).and_then(serde_json::Value::as_u64).unwrap();
        assert_eq!(feature.id, Some(Id::String(format!("{kind}-{}", number("number")))));
        let mut area = 0.0;
        for polygon in rings(feature) {
            let polygon = Polygon::new(line(&polygon[0]), polygon[1..].iter().map(line).collect());
            assert!(polygon.is_valid(), "{:?}: {:?}", feature.id, polygon.validation_errors());
            assert!(polygon.signed_area() > 0.0, "clockwise");
            area += polygon.unsigned_area();
        }
        if kind == "basin" {
            assert!(mouths.insert(number("mouth")));
            assert!(session.network().unwrap().rivers[number("mouth") as usize].junction == NONE);
            // Corners of cells are cut.
            let cells = feature.property("area_m2").and_then(serde_json::Value::as_f64).unwrap() / (metres * metres);
            assert!((area - cells).abs() <= 0.5 * cells, "{area} of {cells}");
        }
        match kind.as_str() {
            "basin" => areas[0] += area,
            "land" => areas[1] += area,
            _ => {}
        }
    }
    assert!(areas[0] <= areas[1] * 1.02 + 500.0, "basins of {} on land of {}", areas[0], areas[1]);
    assert_eq!(
        kinds.iter().filter(|kind| *kind == "ridge").count(),
        session.land().map_or(0, |land| land.ridges().len())
    );
}

/// The polygon of a lake, with the positions as they are written.
fn polygon(lake: &geojson::Feature) -> Polygon {
    let GeometryValue::Polygon { coordinates } = &lake.geometry.as_ref().unwrap().value else {
        panic!("{:?} is no polygon", lake.id);
    };
    let [ring] = &coordinates[..] else { panic!("{:?} has holes", lake.id) };
    assert!(ring.len() > 3 && ring.first() == ring.last());
    Polygon::new(ring.iter().map(|at| (at[0], at[1])).collect::<LineString>(), vec![])
}

/// Checks the JSON form: a tributary's last point is one of its parent's.
fn check_json(session: &Session) {
    let network = network(session);
    let rivers = network["rivers"].as_array().unwrap();
    assert_eq!(rivers.len(), session.network().unwrap().rivers.len());
    for river in rivers {
        let points = river["points"].as_array().unwrap();
        assert!(points.iter().all(|point| point.as_array().unwrap().iter().all(serde_json::Value::is_f64)));
        if let Some(parent) = river["parent"].as_u64() {
            assert!(rivers[parent as usize]["points"].as_array().unwrap().contains(points.last().unwrap()));
        }
    }
    assert_eq!(network["oxbows"].as_array().unwrap().len(), session.network().unwrap().oxbows.len());
}

fn check_files(link: &str) {
    let session = finished(link);
    check_svg(&session);
    check_geojson(&session);
    check_json(&session);
}

proptest! {
    #![proptest_config(first(4, cases(40)))]

    fn any_network_can_be_read(link in random_link(700)) {
        check_files(&link);
    }
}

tiers!(any_network_can_be_read);

/// Wide rivers in narrow bends, cut off again and again: lakes that cross themselves, and that silt has all but closed,
/// at every age. As they grow old and vanish, many are seen in many rounds.
fn lakes_are_valid_polygons_and_none_is_lost() {
    let recipes = [
        "seed=s6&edition=1&growth=colonize&valleys=0&land=island&sea=0.3&roughness=0.5&sensitivity=24&attractors=800&trim=400&simplify=95&width=40&bank-variation=0&meander-strength=1&meander-elsewhere=0&great-rivers=16&flat-share=1&neck=3&oxbows=1",
        "seed=s7&edition=1&growth=colonize&valleys=0&land=island&sea=0.3&roughness=0.5&sensitivity=24&attractors=800&trim=400&simplify=95&width=40&bank-variation=0&meander-strength=1&meander-elsewhere=0&great-rivers=16&flat-share=1&neck=3&oxbows=1",
        "seed=p2&edition=1&growth=colonize&valleys=0&sea=0.3&attractors=658&trim=153&simplify=42&width=21&bank-variation=0.20&meander-strength=1&meander-elsewhere=0&great-rivers=12&flat-share=1&neck=1&clearance=0&taper=3&oxbows=1",
        "seed=p3&edition=1&growth=colonize&valleys=0&sea=0.3&attractors=658&trim=153&simplify=42&width=21&bank-variation=0.20&meander-strength=1&meander-elsewhere=0&great-rivers=12&flat-share=1&neck=3&clearance=0&taper=3&oxbows=1",
    ];
    let (mut sessions, mut lakes, mut maps) = (BTreeMap::new(), 0, 0);
    for (recipe, rounds) in one_in(60, pairs(recipes, (8..=400).step_by(8))) {
        let session = sessions.entry(recipe).or_insert_with(|| finished(&format!("{recipe}&meander-rounds=0")));
        let change = link::pairs(&format!("meander-rounds={rounds}")).unwrap();
        session.change(link::apply(session.recipe().clone(), &change).unwrap()).unwrap();
        lakes += session.finish().unwrap().network().oxbows.len();
        maps += 1;
        check_water(session, collection(session).features);
    }
    // Young rivers have none.
    assert!(lakes > 2 * (maps - 4), "{lakes} lakes on {maps} maps");
}

tiers!(lakes_are_valid_polygons_and_none_is_lost);

/// A lake of it was no valid polygon once.
#[test]
fn network_whose_lake_crossed_itself_can_be_read() {
    check_files(
        "country=usual&seed=o&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=0&shores=nesw&land=rectangle&outline=&sea=0.100&roughness=0.000&aspect=0.250&mouths=30&sides=nes&attractors=687&scatter=grid&reach=7.528&kill=1.278&step=0.200&momentum=0.843&curl=0.000&stretch=1&trim=0&width=21.95&style=ink&simplify=9&bank-variation=0.000&meander=flow&meander-rounds=217&meander-strength=0.615&meander-mix=0.000&meander-elsewhere=0.391&great-rivers=0&flat-share=0.000&neck=2.22&clearance=0.25&taper=6.08",
    );
}

/// Its files could not be read once.
#[test]
fn network_of_few_attractors_in_a_tower_can_be_read() {
    check_files(
        "country=usual&seed=a&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=0&land=rectangle&outline=&sea=0.100&roughness=0.000&aspect=0.250&mouths=1&sides=n&attractors=100&scatter=random&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&simplify=0&bank-variation=0.000&meander=bend&meander-rounds=0&meander-strength=0.000&meander-mix=0.000&meander-elsewhere=0.000&great-rivers=0&flat-share=0.000&neck=1.00&clearance=0.00&taper=1.00",
    );
}

#[test]
fn hostile_seeds_are_text_and_nothing_else() {
    let seed = r#"<script>alert("&'")</script>]]>-->"#;
    let query: String = seed.bytes().map(|byte| format!("%{byte:02x}")).collect();
    let session = finished(&format!("country=usual&seed={query}&attractors=100"));
    check_svg(&session);
    let text = svg::svg(&session.map().unwrap()).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let text_of = |name| document.descendants().find(|node| node.has_tag_name(name)).unwrap().text().unwrap();
    let title = ("http://www.w3.org/2000/svg", "title");
    assert_eq!(text_of(title), seed);
    assert_eq!(link::read(text_of((title.0, "metadata"))).as_ref(), Ok(session.recipe()));
    assert!(!text.contains("<script"));
    let members = collection(&session).foreign_members.unwrap();
    assert_eq!(link::read(members["riverseed"].as_str().unwrap()).as_ref(), Ok(session.recipe()));
}

/// Returns the ids that an SVG file refers to, in order.
fn referred_to(svg: &str) -> Vec<&str> {
    let named = |mark: &'static str, end: char| svg.split(mark).skip(1).filter_map(move |rest| rest.split(end).next());
    named("url(#", ')').chain(named("href=\"#", '"')).collect()
}

#[test]
fn a_drawing_has_the_colours_of_its_climate() {
    let drawn = |more: &str| {
        let session = finished(&format!(
            "country=usual&attractors=900&growth=drainage&style=atlas&land=island&labels=none{more}"
        ));
        svg::svg(&session.map().unwrap()).unwrap()
    };
    let levels = |text: &str| text.matches("<clipPath id=\"rain-").count();
    let [usual, lava, shaded] = ["", "&ground=lava", "&rain-shadow=1"].map(drawn);
    // The sea, and the rivers on top.
    assert!(usual.contains("#8fb6c6") && usual.contains("#2a6f9e") && levels(&usual) == 0);
    assert!(lava.contains("#6fa0b4") && lava.contains("#0f4c78") && !lava.contains("#8fb6c6"));
    // What is level with the map's rain has the map's colours, and more of them lie beside.
    assert!(shaded.contains("#8fb6c6") && levels(&shaded) >= 4, "{}", levels(&shaded));
}

#[test]
fn maps_in_one_page_refer_each_to_its_own_parts() {
    let links = [
        "style=atlas&labels=many&land=island&seed=a",
        "style=atlas&labels=many&land=island&seed=b",
        "style=parchment&woods=0.6&hills=0.6&labels=some&land=island&seed=a",
        "style=survey&woods=0.6&labels=some&land=continent&seed=a",
        "style=ink-wash&labels=some&land=island&seed=a",
        "style=past-courses&land=island&seed=a",
        "style=orbit&rain-shadow=1&land=island&seed=a",
    ];
    let mut before = BTreeSet::new();
    for link in links {
        let map = finished(&format!("attractors=1500&growth=drainage&{link}")).map().unwrap();
        for svg in [svg::svg(&map).unwrap(), svg::svg_with_text(&map).unwrap()] {
            let document = roxmltree::Document::parse(&svg).unwrap();
            let ids: BTreeSet<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
            let (referred, end) = (referred_to(&svg), end_of_ids(&svg));
            assert!(referred.len() > 5, "{link}: {}", referred.len());
            for id in referred {
                assert!(ids.contains(id) && id.contains(&end), "{link}: {id}");
            }
        }
        assert!(before.insert(end_of_ids(&svg::svg(&map).unwrap())), "{link}");
    }
}

#[test]
fn map_without_rivers_is_a_file_too() {
    let shut_off = "land=drawn&roughness=0&aspect=1&attractors=100&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1..M4M4zHM4zHzHM4zHM4M4";
    let session = finished(shut_off);
    assert_eq!(session.network().unwrap().rivers.len(), 0);
    check_svg(&session);
    check_geojson(&session);
    check_json(&session);
    let is_land = |feature: &geojson::Feature| feature.property("kind").is_some_and(|kind| kind == "land");
    assert!(collection(&session).features.iter().any(is_land));
}

#[test]
fn there_is_no_map_to_be_written_until_all_of_it_is_there() {
    let mut session = Session::new(link::read("attractors=100&style=atlas").unwrap()).unwrap();
    loop {
        let is_finished = session.is_finished();
        assert_eq!(session.map().is_some(), is_finished, "{:?}", session.phase());
        if is_finished {
            break;
        }
        session.advance(1).unwrap();
    }
    assert!(session.map().unwrap().shown_relief().is_some());
}

const SIDE: u32 = 1000;

/// The SVG as a picture, a pixel a unit.
fn drawn(session: &Session) -> tiny_skia::Pixmap {
    rendered(&svg::svg(&session.map().unwrap()).unwrap())
}

fn rendered(svg: &str) -> tiny_skia::Pixmap {
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).unwrap();
    let mut pixmap = tiny_skia::Pixmap::new(SIDE, SIDE).unwrap();
    resvg::render(&tree, tiny_skia::Transform::identity(), &mut pixmap.as_mut());
    pixmap
}

/// Whether two colours are told apart at a glance.
fn differ((a, b): (&[u8], &[u8])) -> bool {
    a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 60)
}

/// Draws maps with names, woods and hills as readers do that take masks by brightness, as SVG says, and as those that take them by opacity.
fn masks_are_the_same_by_brightness_and_by_opacity() {
    // In 1000ths of all pixels.
    const MOST: usize = 1;
    let styles = one_in(6, Style::ALL.iter().filter(|style| style.word().name != "skeleton"));
    let wrong = styles.filter_map(|style| {
        let style = style.word().name;
        let link = "country=usual&seed=tui&aspect=1&land=island&attractors=2500&labels=many&cartouche=framed&woods=0.6&hills=0.6";
        let text = svg::svg(&finished(&format!("{link}&style={style}")).map().unwrap()).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let masks: Vec<_> = document.descendants().filter(|node| node.has_tag_name("mask")).collect();
        let painted = masks.iter().flat_map(|mask| mask.descendants()).flat_map(|node| node.attributes());
        let is_paint = |name: &str| ["fill", "stroke", "color", "filter", "style"].contains(&name);
        let not_white = painted.filter(|one| is_paint(one.name()) && one.value() != "#fff").count();
        let by_opacity = rendered(&text.replace("<mask ", "<mask mask-type=\"alpha\" "));
        let by_brightness = rendered(&text);
        let pairs = by_brightness.data().chunks_exact(4).zip(by_opacity.data().chunks_exact(4));
        let differing = pairs.filter(|&pair| differ(pair)).count();
        let is_right = masks.len() == 1 && not_white == 0 && differing * 1000 <= MOST * (SIDE * SIDE) as usize;
        (!is_right).then(|| format!("{style}: {} masks, {not_white} not white, {differing} pixels differ", masks.len()))
    });
    assert_eq!(wrong.collect::<Vec<_>>(), [""; 0]);
}

tiers!(masks_are_the_same_by_brightness_and_by_opacity);

#[test]
fn rivers_of_an_svg_end_at_the_coast() {
    for style in ["ink", "past-courses"] {
        let link = format!("aspect=1&land=archipelago&roughness=1&attractors=600&style={style}&width=");
        ends_at_the_coast(["2", "40"].map(|width| finished(&format!("{link}{width}"))));
    }
}

fn ends_at_the_coast([narrow, wide]: [Session; 2]) {
    let (narrow_map, wide_map) = (drawn(&narrow), drawn(&wide));
    let land = narrow.land().unwrap();
    for (i, (narrow, wide)) in narrow_map.pixels().iter().zip(wide_map.pixels()).enumerate() {
        let height = land
            .coast_distance()
            .height(glam::Vec2::new((i as u32 % SIDE) as f32 + 0.5, (i as u32 / SIDE) as f32 + 0.5));
        assert!(height > -3.5 || narrow == wide, "pixel {i}, {height} inland: {narrow:?}, {wide:?}");
    }
}

fn svg_looks_like_the_picture() {
    // The share of pixels in percent that may differ: in an SVG, Survey's contours neither end beside rivers nor grow
    // paler on steep slopes, Night's rivers do not glow, and no mist lies along those of Ink wash.
    let links = [
        ("seed=kauri&aspect=1&attractors=2000", 1),
        ("seed=rimu&aspect=1&attractors=2000&land=island&style=atlas&mouths=9&meander-rounds=200&width=30", 1),
        ("seed=totara&aspect=1&land=valley&growth=brownian&sensitivity=24", 1),
        (
            "seed=fisk&aspect=1&land=rectangle&attractors=700&mouths=2&flat-share=0.8&meander-rounds=50&neck=3&style=past-courses",
            1,
        ),
        ("seed=moa&aspect=1&land=continent&attractors=2000&flat-share=0.5&meander-rounds=30&style=past-courses", 1),
        ("seed=tui&aspect=1&land=island&attractors=3000&trim=30&style=ink-wash", 5),
        ("seed=tui&aspect=1&land=archipelago&attractors=3000&trim=30&style=orbit", 1),
        ("seed=tui&aspect=1&land=rectangle&attractors=3000&trim=30&style=blueprint", 1),
        ("seed=tui&aspect=1&land=island&attractors=3000&trim=30&style=basins", 1),
        ("seed=tui&aspect=1&land=valley&attractors=3000&trim=30&style=survey", 2),
        ("seed=tui&aspect=1&land=island&attractors=3000&trim=30&style=parchment", 1),
        ("seed=tui&aspect=1&land=archipelago&attractors=3000&trim=30&style=night", 2),
    ];
    let wrong = one_in(6, links).filter_map(|(link, most)| {
        let session = finished(link);
        let (map, picture) = (drawn(&session), painted(&session));
        let differing = map.data().chunks_exact(4).zip(picture.chunks_exact(4)).filter(|&pair| differ(pair)).count();
        (differing * 100 >= most * (SIDE * SIDE) as usize).then(|| format!("{link}: {differing} pixels differ"))
    });
    assert_eq!(wrong.collect::<Vec<_>>(), [""; 0]);
}

tiers!(svg_looks_like_the_picture);

/// The picture, a pixel a unit.
fn painted(session: &Session) -> Vec<u8> {
    let mut picture = Picture::new(SIDE, SIDE).unwrap();
    picture.paint(session);
    picture.pixmap().data().to_vec()
}

/// Compares the part of light and shadow in each colour between an SVG and the picture: the difference to the same map
/// without them. Whatever an SVG leaves out is in neither.
fn svg_has_the_light_and_shadow_of_the_picture() {
    let styles = one_in(8, Style::ALL.iter().filter(|style| style.has_relief()));
    let wrong = styles.filter_map(|style| {
        // In hundredths of all of it. Orbit's forests hide light in the picture; Blueprint has so little that rounding
        // shows.
        let most = match style {
            Style::Orbit => 60,
            Style::Blueprint => 50,
            _ => 45,
        };
        let style = style.word().name;
        let link = format!("country=usual&seed=tui&aspect=1&land=island&attractors=3000&trim=30&style={style}");
        let [lit, flat] = ["", "&shade=0"].map(|shade| finished(&format!("{link}{shade}")));
        let change = |lit: &[u8], flat: &[u8]| -> Vec<i32> {
            lit.iter().zip(flat).map(|(&lit, &flat)| i32::from(lit) - i32::from(flat)).collect()
        };
        let in_picture = change(&painted(&lit), &painted(&flat));
        let in_map = change(drawn(&lit).data(), drawn(&flat).data());
        let total: u64 = in_picture.iter().map(|change| u64::from(change.unsigned_abs())).sum();
        let off: u64 = in_picture.iter().zip(&in_map).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        (off * 100 >= total * most).then(|| format!("{style}: off by {off} of {total}"))
    });
    assert_eq!(wrong.collect::<Vec<_>>(), [""; 0]);
}

tiers!(svg_has_the_light_and_shadow_of_the_picture);

#[test]
fn land_that_runs_off_the_map_has_a_neatline_in_svg() {
    for (link, has_line) in [
        ("land=rectangle&style=atlas", true),
        ("land=continent&style=parchment", true),
        ("land=island&style=atlas", false),
        ("land=rectangle&style=ink", false),
        ("land=rectangle&style=orbit", false),
    ] {
        let session = finished(&format!("{link}&attractors=500&trim=0"));
        let svg = svg::svg(&session.map().unwrap()).unwrap();
        assert_eq!(svg.contains("<g id=\"neatline\""), has_line, "{link}");
    }
}
