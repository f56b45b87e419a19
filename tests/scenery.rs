//! Promises of woods and hills: they keep off the water, measured exactly from the true banks, and off letters and the
//! coast; trees stay where they are whatever moves around them; and the picture is the same however it is painted.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::parts::paint_in_parts;
use crate::common::property::{cases, large};
use crate::common::svg_ids::without_number;
use crate::common::tier::{first, tiers};
use crate::common::{random_link, styles};
use geo::{Distance, Euclidean};
use proptest::prelude::*;
use riverseed::annotate::place::{
    Box, FOOT_FROM_BANKS, FROM_BANKS, FROM_COAST, FROM_LETTERS, Feature, PenStroke, Raster, Scenery, SceneryInput,
    Standing, place,
};
use riverseed::annotate::{labels, scenery};
use riverseed::glam::Vec2;
use riverseed::network::Place;
use riverseed::recipe::link;
use riverseed::{Key, Map, Picture, Session, Style};

/// Finishes the rivers of a link.
fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(link).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// Finishes the rivers of a link with other values of some parameters.
fn finished_with(link: &str, more: &[(Key, &str)]) -> Session {
    let mut recipe = link::read(link).unwrap();
    more.iter().for_each(|(key, text)| recipe.set(*key, text).unwrap());
    let mut session = Session::new(recipe).unwrap();
    session.finish().unwrap();
    session
}

/// The scenery of a map on a picture `width` pixels wide, and the input that it is placed by.
fn placed(map: &Map, width: f32) -> (Vec<Standing>, SceneryInput<'_>) {
    let size = map.domain().size;
    let labels = labels::input(map, [Vec2::ZERO, size], width / size.x)
        .map_or_else(Vec::new, |input| place(&input, &Raster::new(&input)));
    let input = scenery::input(map, &labels).unwrap();
    (Scenery::whole(&input), input)
}

fn coord(at: Vec2) -> geo::Coord<f64> {
    geo::coord! { x: f64::from(at.x), y: f64::from(at.y) }
}

/// A stroke of a glyph on the map, as many straight pieces.
fn line(stroke: &PenStroke, one: &Standing) -> geo::LineString<f64> {
    const PIECES: u32 = 12;
    let (mut from, mut points) = (stroke.start, vec![stroke.start]);
    for &[control, end] in &stroke.curves {
        let at = |t: f32| from * ((1.0 - t) * (1.0 - t)) + control * (2.0 * t * (1.0 - t)) + end * (t * t);
        points.extend((1..=PIECES).map(|i| at(i as f32 / PIECES as f32)));
        from = end;
    }
    points.into_iter().map(|at| coord(one.foot + at * one.size)).collect()
}

/// A glyph's silhouette, and all of its strokes.
fn shapes(one: &Standing) -> (geo::Polygon<f64>, Vec<geo::LineString<f64>>) {
    let shape = one.shape();
    let strokes = shape.outline.iter().chain(&shape.shade).chain(&shape.wash);
    let strokes = strokes.map(|stroke| line(stroke, one)).collect();
    (geo::Polygon::new(line(&shape.silhouette, one), vec![]), strokes)
}

/// How far a glyph reaches from its foot, and more than such distances are off.
fn reach(one: &Standing, silhouette: &geo::Polygon<f64>, strokes: &[geo::LineString<f64>]) -> f32 {
    let ends = strokes.iter().chain([silhouette.exterior()]).flat_map(|line| line.coords());
    let away = ends.map(|end| Vec2::new(end.x as f32, end.y as f32).distance(one.foot));
    away.fold(0.0, f32::max) + 0.01
}

/// The distance of a glyph from the banks of some lines, measured by discs along them.
fn clearance(one: &Standing, lines: &[impl AsRef<[Place]>]) -> f64 {
    let (silhouette, strokes) = shapes(one);
    let reach = reach(one, &silhouette, &strokes);
    // The nearest first, by what even the farthest end of the glyph keeps from them.
    let apart_at_least = |disc: &Place| f64::from(disc.at.distance(one.foot) - reach - disc.half);
    let discs = discs_near(one.foot, 1.5 * one.size + 12.0, lines);
    let mut discs: Vec<(f64, Place)> = discs.into_iter().map(|disc| (apart_at_least(&disc), disc)).collect();
    discs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut nearest = f64::MAX;
    for (least, disc) in discs {
        if least >= nearest {
            break;
        }
        let middle = geo::Point(coord(disc.at));
        let apart = strokes.iter().map(|stroke| Euclidean.distance(&middle, stroke));
        let apart = apart.fold(Euclidean.distance(&middle, &silhouette), f64::min);
        nearest = nearest.min(apart - f64::from(disc.half));
    }
    nearest
}

/// The discs along some lines near a place, so dense that hardly anything is left out.
fn discs_near(at: Vec2, reach: f32, lines: &[impl AsRef<[Place]>]) -> Vec<Place> {
    const DISCS: u32 = 16;
    let is_near = |pair: &&[Place]| {
        let [least, most] = [pair[0].at.min(pair[1].at), pair[0].at.max(pair[1].at)];
        (least - at).max(at - most).max_element() < reach + pair[0].half.max(pair[1].half)
    };
    let discs = |pair: &[Place]| {
        let (from, to) = (pair[0], pair[1]);
        (0..=DISCS).map(move |i| {
            let t = i as f32 / DISCS as f32;
            Place { at: from.at.lerp(to.at, t), half: from.half + (to.half - from.half) * t }
        })
    };
    lines.iter().flat_map(|line| line.as_ref().windows(2)).filter(is_near).flat_map(discs).collect()
}

/// The centerlines of all rivers.
fn courses<'a>(input: &'a SceneryInput<'_>) -> impl Iterator<Item = Vec<Place>> + 'a {
    input.network.rivers.iter().map(|river| input.network.middle(river))
}

fn water(input: &SceneryInput<'_>) -> Vec<Vec<Place>> {
    courses(input).chain(input.lakes.iter().cloned()).collect()
}

fn polygon(around: &Box) -> geo::Polygon<f64> {
    geo::Polygon::new(geo::LineString::from(around.corners().map(coord).to_vec()), vec![])
}

/// More than rounding to 32 bits and the gaps between discs are off.
const SLACK: f64 = 0.01;

fn check(session: &Session, width: f32) -> Result<usize, TestCaseError> {
    let map = session.map().unwrap();
    let (all, input) = placed(&map, width);
    let water = water(&input);
    for one in &all {
        let clear = clearance(one, &water);
        prop_assert!(clear >= f64::from(FROM_BANKS) - SLACK, "{one:?} is {clear} from a bank");
        let foot = discs_near(one.foot, 20.0, &water).into_iter().map(|disc| one.foot.distance(disc.at) - disc.half);
        let foot = foot.fold(f32::MAX, f32::min);
        prop_assert!(!one.is_plant() || foot >= FOOT_FROM_BANKS - 0.01, "{one:?} has its foot {foot} from a bank");
        check_coast_and_letters(one, &input)?;
    }
    prop_assert!(all.windows(2).all(|pair| pair[0].foot.y <= pair[1].foot.y), "the nearest come last");
    Ok(all.len())
}

fn check_coast_and_letters(one: &Standing, input: &SceneryInput<'_>) -> Result<(), TestCaseError> {
    let (silhouette, strokes) = shapes(one);
    if let Some(coast) = input.coast() {
        for at in strokes.iter().flat_map(|stroke| stroke.coords()) {
            let inland = coast.height(Vec2::new(at.x as f32, at.y as f32));
            // Beside notches heights are not quite distances.
            prop_assert!(inland > FROM_COAST - 1.0, "{one:?} is {inland} inland");
        }
    }
    let farthest = reach(one, &silhouette, &strokes) + FROM_LETTERS;
    let is_near = |letter: &&Box| {
        let middle = letter.middle;
        let size = letter.corners().map(|corner| corner.distance(middle)).into_iter().fold(0.0, f32::max);
        middle.distance(one.foot) < farthest + size
    };
    for letter in input.letters.iter().filter(is_near).map(polygon) {
        let apart = strokes.iter().map(|stroke| Euclidean.distance(&letter, stroke));
        let apart = apart.fold(Euclidean.distance(&letter, &silhouette), f64::min);
        prop_assert!(apart >= f64::from(FROM_LETTERS) - SLACK, "{one:?} is {apart} from a letter");
    }
    Ok(())
}

proptest! {
    #![proptest_config(first(3, large(500)))]

    fn nothing_stands_in_water_on_letters_or_nearer_to_a_bank_than_said(
        link in random_link(1500), rounds in 0u32..200, style in prop::sample::select(styles(Style::has_hills)),
    ) {
        let rounds = rounds.to_string();
        let more = [(Key::MeanderRounds, &*rounds), (Key::GreatRivers, "5"), (Key::Style, style), (Key::Labels, "some")];
        let session = finished_with(&format!("{link}&woods=1&hills=1"), &more);
        check(&session, 1400.0)?;
    }
}

tiers!(nothing_stands_in_water_on_letters_or_nearer_to_a_bank_than_said);

proptest! {
    #![proptest_config(first(1, large(50)))]

    fn trees_stay_where_they_are_when_rivers_move(link in random_link(800), one in 0u32..50, other in 50u32..=100) {
        let session = |strength: u32| {
            let strength = (f64::from(strength) / 100.0).to_string();
            finished_with(
                &format!("{link}&woods=1"),
                // Lakes may lie elsewhere, too.
                &[(Key::MeanderStrength, &strength), (Key::Style, "ink"), (Key::Labels, "none"), (Key::Lakes, "0")],
            )
        };
        let sessions = [session(one), session(other)];
        let maps = [&sessions[0], &sessions[1]].map(|session| session.map().unwrap());
        let [before, after] = maps.each_ref().map(|map| placed(map, 1400.0));
        for (here, there) in [(&before, &after), (&after, &before)] {
            // Marshes and rows of trees go where their river goes.
            let is_tree = |one: &&Standing| !matches!(one.feature(), Feature::Marsh | Feature::Willow);
            let trees: BTreeMap<u32, &Standing> = there.0.iter().filter(is_tree).map(|tree| (tree.number, tree)).collect();
            for tree in here.0.iter().filter(is_tree) {
                match trees.get(&tree.number) {
                    Some(same) => prop_assert_eq!(tree, *same),
                    // A disc that holds a part of a tree is larger than that by less than this.
                    None => {
                        let clear = clearance(tree, &water(&there.1));
                        prop_assert!(clear < f64::from(FROM_BANKS) + 2.5, "{tree:?} is gone, {clear} from a bank");
                    }
                }
            }
        }
    }

    fn more_woods_are_the_same_trees_and_more(link in random_link(300), few in 0u32..90) {
        let trees = |woods: u32| {
            let session = finished_with(&link, &[(Key::Woods, &(f64::from(woods) / 100.0).to_string()), (Key::Style, "atlas")]);
            let all = if woods == 0 { Vec::new() } else { placed(&session.map().unwrap(), 1400.0).0 };
            all.into_iter().map(|tree| (tree.number, tree)).collect::<BTreeMap<_, _>>().into_values().collect::<Vec<_>>()
        };
        let [few, more] = [few, few + 10].map(trees);
        // Here and there one of ten thousand makes room for another.
        let gone = few.iter().filter(|tree| more.binary_search_by_key(&tree.number, |tree| tree.number).is_err()).count();
        prop_assert!(1000 * gone <= few.len(), "{gone} of {} are gone of {}", few.len(), more.len());
    }
}

/// A mountainous island with woods.
const WOODED: &str = "seed=kea&attractors=3000&land=island&labels=none&woods=0.5&style=atlas";

#[test]
fn trees_stand_lower_the_colder_it_is() {
    let highest = |warmth: &str| {
        let session = finished(&format!("{WOODED}&warmth={warmth}"));
        let map = session.map().unwrap();
        let (all, input) = placed(&map, 1400.0);
        let mut heights: Vec<f32> = all.iter().map(|one| input.heights.unwrap().share(one.foot)).collect();
        heights.sort_by(f32::total_cmp);
        heights[heights.len() * 95 / 100]
    };
    let [cold, temperate, warm] = ["0", "0.5", "1"].map(highest);
    assert!(cold + 0.1 < temperate && temperate + 0.1 < warm, "{cold}, {temperate}, {warm}");
}

#[test]
fn more_trees_stand_before_ranges_and_fewer_behind() {
    let even = finished(WOODED).map().unwrap();
    let rained = finished(&format!("{WOODED}&rain-shadow=1&wind=270")).map().unwrap();
    let (before, (now, input)) = (placed(&even, 1400.0).0, placed(&rained, 1400.0));
    // How many stand where there is so much more rain; with a factor of -1, where there is so much less.
    let count = |all: &[Standing], factor: f32| {
        all.iter().filter(|one| input.weather.more_rain(one.foot) * factor > 0.05).count()
    };
    assert!(count(&now, 1.0) > count(&before, 1.0), "{} and {}", count(&now, 1.0), count(&before, 1.0));
    assert!(count(&now, -1.0) < count(&before, -1.0), "{} and {}", count(&now, -1.0), count(&before, -1.0));
}

tiers!(trees_stay_where_they_are_when_rivers_move, more_woods_are_the_same_trees_and_more);

/// A change of a finished map: woods and hills in tenths, the style, and the number of parts after which its picture is
/// abandoned for another.
type Change = (u32, u32, &'static str, u32);

proptest! {
    #![proptest_config(first(2, cases(10)))]

    fn a_picture_painted_in_parts_is_that_of_a_fresh_one(
        link in random_link(300), labels in any::<bool>(), changes in prop::collection::vec(
            (0u32..=10, 0u32..=10, prop::sample::select(vec!["ink", "dark", "basins", "survey", "skeleton"]), 0u32..30), 2..6),
    ) {
        let recipe = |&(woods, hills, style, _): &Change| {
            let [woods, hills] = [woods, hills].map(|tenths| (f64::from(tenths) / 10.0).to_string());
            let labels = if labels { "some" } else { "none" };
            let mut recipe = link::read(&link).unwrap();
            for (key, text) in [(Key::Woods, &*woods), (Key::Hills, &hills), (Key::Style, style), (Key::Labels, labels)] {
                recipe.set(key, text).unwrap();
            }
            recipe
        };
        let picture = || Picture::new(360, 300).unwrap();
        let bare = recipe(&(0, 0, "ink", 0));
        let mut untouched = picture();
        let mut session = Session::new(bare.clone()).unwrap();
        session.finish().unwrap();
        untouched.paint(&session);
        let steps = [(bare.clone(), u32::MAX)].into_iter().chain(changes.iter().map(|change| (recipe(change), change.3)));
        let (mut session, mut kept) = paint_in_parts(bare.clone(), steps, picture)?;
        session.change(bare).unwrap();
        session.finish().unwrap();
        kept.paint(&session);
        prop_assert!(kept.pixmap().data() == untouched.pixmap().data());
    }
}

tiers!(a_picture_painted_in_parts_is_that_of_a_fresh_one);

const MAP: &str = "land=island&sea=0.55&attractors=3000&country=usual&seed=kauri";

#[test]
fn woods_and_hills_are_on_the_map_as_much_as_is_asked_for() {
    let count = |more: &str| {
        let session = finished(&format!("{MAP}&{more}"));
        let map = session.map().unwrap();
        let all = scenery::input(&map, &[]).map_or_else(Vec::new, |input| Scenery::whole(&input));
        let trees = all.iter().filter(|one| one.is_plant()).count();
        (trees, all.len() - trees)
    };
    let trees = ["woods=0", "woods=0.2", "woods=0.5", "woods=1"].map(|woods| count(woods).0);
    assert!(trees[0] == 0 && trees[1] > 100 && trees[3] > 2300 && trees.is_sorted_by(|a, b| a < b), "{trees:?}");
    let hills = ["hills=0", "hills=0.3", "hills=1"].map(|hills| count(&format!("{hills}&style=ink")).1);
    assert!(hills[0] == 0 && hills[1] > 30 && hills[2] > 120 && hills.is_sorted_by(|a, b| a < b), "{hills:?}");
    assert_eq!(count("woods=0.5&hills=1&style=skeleton"), (0, 0));
    assert!(count("woods=0.5&hills=1&style=survey").1 == 0 && count("woods=0.5&hills=1&style=survey").0 > 100);
    let growing = Session::new(link::read(&format!("{MAP}&woods=1")).unwrap()).unwrap();
    assert_eq!(growing.map(), None);
}

#[test]
fn hills_are_higher_where_the_land_is() {
    let session = finished(&format!("{MAP}&style=basins&hills=1"));
    let map = session.map().unwrap();
    let (hills, input) = placed(&map, 1400.0);
    let height = |one: &Standing| session.relief().unwrap().at(one.foot);
    let mean = |feature: Feature| {
        let heights: Vec<f32> = hills.iter().filter(|one| one.feature() == feature).map(height).collect();
        assert!(heights.len() > 10, "{} of {feature:?}", heights.len());
        heights.iter().sum::<f32>() / heights.len() as f32
    };
    let highest = input.heights.unwrap().highest;
    let [hill, mountain] = [Feature::Hill, Feature::Mountain].map(mean);
    assert!(hill > 0.2 * highest && mountain > 0.6 * highest, "{hill} and {mountain} of {highest}");
}

/// The scenery of a map in a style with its relief, and its heights as shares of the highest.
fn with_heights(link: &str, check: impl Fn(&[Standing], &SceneryInput<'_>, &dyn Fn(Vec2) -> f32)) {
    let session = finished(link);
    let map = session.map().unwrap();
    let (all, input) = placed(&map, 1400.0);
    let heights = input.heights.unwrap();
    check(&all, &input, &|at| heights.share(at));
}

fn of(all: &[Standing], feature: Feature) -> Vec<&Standing> {
    all.iter().filter(|one| one.feature() == feature).collect()
}

#[test]
fn mountains_stand_on_high_ground_alone_and_the_largest_highest() {
    for style in styles(|style| style.has_relief() && style.has_hills()) {
        with_heights(&format!("{MAP}&hills=1&style={style}"), |all, _, height| {
            let mountains = of(all, Feature::Mountain);
            assert!(mountains.len() > 30, "{} in {style}", mountains.len());
            // The middle of its height is on the place that it was chosen for.
            let middle = |one: &Standing| height(one.foot - Vec2::new(0.0, 0.5 * one.size));
            assert!(mountains.iter().all(|one| middle(one) >= 0.45), "{style}");
            let mean = |all: &[&Standing]| all.iter().map(|one| middle(one)).sum::<f32>() / all.len() as f32;
            let (tall, low): (Vec<&Standing>, Vec<&Standing>) = mountains.iter().partition(|one| one.shape >= 44);
            assert!(mean(&tall) > mean(&low) + 0.1, "{} and {}", mean(&tall), mean(&low));
        });
    }
}

#[test]
fn conifers_are_high_and_broad_leaves_low() {
    with_heights(&format!("{MAP}&woods=1&style=atlas"), |all, _, height| {
        let mean = |feature: Feature| {
            let trees = of(all, feature);
            assert!(trees.len() > 100, "{} of {feature:?}", trees.len());
            trees.iter().map(|one| height(one.foot)).sum::<f32>() / trees.len() as f32
        };
        let [low, high] = [Feature::Canopy, Feature::Conifer].map(mean);
        assert!(high > 1.6 * low, "{low} and {high}");
    });
}

#[test]
fn marshes_lie_on_level_low_ground_near_great_rivers_and_rows_along_them() {
    with_heights(
        "land=valley&attractors=3000&country=usual&seed=matai&woods=0.7&style=parchment",
        |all, input, height| {
            // Three units wide at least.
            let courses: Vec<Vec<Place>> = courses(input).collect();
            let great: Vec<&[Place]> = courses.iter().flat_map(|course| course.windows(2)).collect();
            let great: Vec<&[Place]> =
                great.into_iter().filter(|piece| piece.iter().any(|place| place.half >= 1.5)).collect();
            let away = |one: &Standing| {
                let discs = discs_near(one.foot, 40.0, &great).into_iter();
                discs.map(|disc| disc.at.distance(one.foot) - disc.half).fold(f32::MAX, f32::min)
            };
            let (marshes, rows) = (of(all, Feature::Marsh), of(all, Feature::Willow));
            assert!(marshes.len() > 40 && rows.len() > 60, "{} marshes, {} trees in rows", marshes.len(), rows.len());
            for marsh in marshes {
                let here = height(marsh.foot);
                let level = |way: Vec2| (height(marsh.foot + way * 8.0) - here).abs() <= 0.05;
                assert!(
                    here <= 0.09 && [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y].into_iter().all(level),
                    "{marsh:?}"
                );
                assert!(away(marsh) < 30.1, "{marsh:?}");
            }
            for tree in rows {
                assert!(away(tree) < 8.6, "{tree:?}");
            }
        },
    );
}

#[test]
fn light_gives_way_to_hills_where_both_show_the_relief() {
    let shade = |link: &str| link::read(link).unwrap().shade();
    assert_eq!(shade("style=parchment"), shade("style=parchment&woods=1"));
    assert!(shade("style=parchment&hills=1") < 0.2 * shade("style=parchment"));
    assert_eq!(shade("style=atlas&hills=1"), shade("style=atlas"));
}

#[test]
fn scenery_does_not_depend_on_how_large_a_picture_is() {
    let session = finished(&format!("{MAP}&style=ink&labels=none&woods=0.6&hills=0.6"));
    assert_eq!(placed(&session.map().unwrap(), 300.0).0, placed(&session.map().unwrap(), 2000.0).0);
}

#[test]
fn svg_has_a_use_for_each_tree_and_hill_that_stands_apart_and_paths_for_what_is_left_of_others() {
    let svg = |more: &str| {
        without_number(&riverseed::export::svg::svg(&finished(&format!("{MAP}&{more}")).map().unwrap()).unwrap())
    };
    let session = finished(&format!("{MAP}&style=ink&woods=0.6&hills=0.6&labels=some"));
    let map = session.map().unwrap();
    let (all, _) = placed(&map, session.domain().size.x);
    let text = without_number(&riverseed::export::svg::svg(&session.map().unwrap()).unwrap());
    let document = roxmltree::Document::parse(&text).unwrap();
    let symbols: Vec<&str> = document
        .descendants()
        .filter(|node| node.has_tag_name("symbol"))
        .filter_map(|node| node.attribute("id"))
        .collect();
    for (class, kind, is_wood) in [("woods", "tree", true), ("hills", "hill", false)] {
        let group = document.descendants().find(|node| node.attribute("class") == Some(class)).unwrap();
        let uses: Vec<(&str, &str)> =
            group.children().filter_map(|node| Some((node.attribute("href")?, node.attribute("transform")?))).collect();
        assert!(uses.iter().all(|(href, _)| symbols.contains(&&href[1..])), "{class}");
        // As many as stand apart are there at least, and each of those.
        let apart: Vec<&Standing> =
            all.iter().filter(|one| one.is_plant() == is_wood && stands_apart(one, &all)).collect();
        assert!(apart.len() > 10 && uses.len() >= apart.len(), "{class}: {} of {}", uses.len(), apart.len());
        for one in apart {
            let href = format!("#{kind}-{}", one.shape);
            let [x, y] = one.foot.to_array().map(|x| f64::from((x * 100.0 + 0.5).floor()) / 100.0);
            let begin = format!("translate({x} {y})scale(");
            assert!(uses.iter().any(|(to, transform)| *to == href && transform.starts_with(&begin)), "{one:?}");
        }
        let count = all.iter().filter(|one| one.is_plant() == is_wood).count();
        let paths = group.descendants().filter(|node| node.has_tag_name("path")).count();
        assert!(uses.len() < count && (1..100).contains(&paths), "{class}: {} of {count}, {paths} paths", uses.len());
    }
    let survey = svg("woods=0.5&style=survey");
    assert!(survey.contains("class=\"bodies\"") && survey.contains("class=\"washes\"") && !survey.contains("hill"));
    assert!(!svg("style=ink&hills=0.5").contains("\"woods\""));
    assert!(!svg("woods=0.5&hills=0.5&style=ink&labels=none").contains("<mask"), "woods and hills need none");
    let bare = svg("labels=none");
    assert!(!bare.contains("<use href=\"#tree") && !bare.contains("<use href=\"#hill") && !bare.contains("scenery"));
}

/// Whether a tree or a hill is so far from all others that none hides any of it.
fn stands_apart(one: &Standing, all: &[Standing]) -> bool {
    let reach = |one: &Standing| {
        let (silhouette, strokes) = shapes(one);
        reach(one, &silhouette, &strokes)
    };
    let own = reach(one);
    // No glyph reaches farther than two of its sizes.
    let near = all.iter().filter(|other| one.foot.distance(other.foot) < own + 2.0 * other.size);
    near.filter(|other| other != &one).all(|other| one.foot.distance(other.foot) > own + reach(other))
}
