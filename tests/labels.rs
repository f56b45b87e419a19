//! Promises of labels: they equal those of the twin, which goes through all rivers for every sample; they keep apart
//! from each other and from their rivers; they are upright, and hardly bent.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::literal_ground::Literal;
use crate::common::property::{cases, large};
use crate::common::random_link;
use crate::common::svg_ids::without_number;
use crate::common::tier::{first, tiers};
use geo::{Distance, Euclidean, Intersects};
use proptest::prelude::*;
use riverseed::annotate::labels;
use riverseed::annotate::names::{Names, PlaceKind, PlaceName};
use riverseed::annotate::place::{Box, Input, Kind, Label, Piece, Placed, Raster, place};
use riverseed::glam::Vec2;
use riverseed::land::{CELL_SIZE, Region, Run};
use riverseed::recipe::{Key, link};
use riverseed::{Map, Picture, Session};

/// Finishes the rivers of a link.
fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(link).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// The labels of a picture of the whole map, `width` pixels wide, and the input that they are placed by.
fn placed(map: &Map, width: f32) -> (Vec<Label>, Input<'_>) {
    let size = map.domain().size;
    let input = labels::input(map, [Vec2::ZERO, size], width / size.x).unwrap();
    (place(&input, &Raster::new(&input)), input)
}

fn boxes(label: &Label) -> Vec<Box> {
    label.letters.iter().map(|letter| letter.around(label.em)).collect()
}

fn polygon(around: &Box) -> geo::Polygon<f64> {
    let corners = around.corners().map(|at| geo::coord! { x: f64::from(at.x), y: f64::from(at.y) });
    geo::Polygon::new(geo::LineString::from(corners.to_vec()), vec![])
}

/// The angle of a direction in degrees, downward.
fn degrees(along: Vec2) -> f64 {
    libm::atan2(f64::from(along.y), f64::from(along.x)).to_degrees()
}

fn check(session: &Session, width: f32) -> Result<usize, TestCaseError> {
    let map = session.map().unwrap();
    let (labels, input) = placed(&map, width);
    let pieces = Pieces::of(&input);
    for label in labels.iter().filter(|label| label.kind != Kind::Grid) {
        check_shape(label)?;
        match label.river {
            Some(river) => check_place(label, river, &input, &pieces)?,
            None if label.kind.is_of_cartouche() => check_cartouche(label, &labels, &input)?,
            None if label.kind.is_mark() || label.kind.is_block() => {} // what those promise is in marks.rs
            None => check_area(label, &input)?,
        }
    }
    let polygons: Vec<Vec<_>> = labels.iter().map(|label| boxes(label).iter().map(polygon).collect()).collect();
    for (i, label) in labels.iter().enumerate() {
        for (other, there) in labels[..i].iter().zip(&polygons) {
            prop_assert!(label.text != other.text || label.river == other.river, "{} twice", label.text);
            let meet = polygons[i].iter().any(|a| there.iter().any(|b| a.intersects(b)));
            prop_assert!(!meet, "{} meets {}", label.text, other.text);
        }
    }
    Ok(labels.len())
}

/// Hardly bent, and upright.
fn check_shape(label: &Label) -> Result<(), TestCaseError> {
    for pair in label.letters.windows(2) {
        let turn = degrees(pair[1].along) - degrees(pair[0].along);
        let turn = (turn + 540.0).rem_euclid(360.0) - 180.0;
        prop_assert!(turn.abs() < 16.01, "{} turns by {turn} degrees", label.text);
    }
    let [first, last]: [&Placed; 2] = [label.letters.first().unwrap(), label.letters.last().unwrap()];
    let end = last.place(Vec2::new(last.glyph.advance, 0.0), label.em);
    let direction = degrees(end - first.at);
    prop_assert!((-100.5..80.5).contains(&direction), "{} runs at {direction} degrees", label.text);
    Ok(())
}

/// In the frame, off other labels, and at sea where a corner of the map is.
fn check_cartouche(label: &Label, labels: &[Label], input: &Input<'_>) -> Result<(), TestCaseError> {
    let [least, most] = input.frame;
    let is_in = |at: Vec2| at.cmpge(least).all() && at.cmple(most).all();
    let corners = boxes(label).into_iter().flat_map(|around| around.corners());
    let ends = label.strokes.iter().flat_map(|stroke| stroke.ends);
    prop_assert!(corners.chain(ends.clone()).all(is_in), "{} leaves the map", label.text);
    let Some((from, to)) = ends.map(|at| (at, at)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))) else { return Ok(()) };
    for other in labels.iter().filter(|other| !other.kind.is_of_cartouche()) {
        let mut corners = boxes(other).into_iter().flat_map(|around| around.corners());
        let is_around = |at: Vec2| at.cmpgt(from).all() && at.cmplt(to).all();
        prop_assert!(!corners.any(is_around), "{} stands in the cartouche", other.text);
    }
    let depth = |at: Vec2| input.map.sea.map_or(-1.0, |sea| -sea.height(at));
    let is_sea = |from: Vec2, least: f32| {
        let mut points = (0..=40).flat_map(|x| (0..=20).map(move |y| Vec2::new(x as f32 / 40.0, y as f32 / 20.0)));
        points.all(|share| depth(from + share * (to - from)) >= least)
    };
    prop_assert_eq!(label.cleared.is_empty(), is_sea(from, 0.0), "{}", &label.text);
    let margin = (from - least).min(most - to).min_element();
    let (first, last) = (least + margin, most - margin - (to - from));
    let middle = 0.5 * (first.x + last.x);
    let mut others = [first.x, middle, last.x].into_iter().flat_map(|x| [first.y, last.y].map(|y| Vec2::new(x, y)));
    prop_assert!(label.cleared.is_empty() || !others.any(|at| is_sea(at, label.em)), "there is a place at sea");
    Ok(())
}

/// The seas, lakes and islands but the main land, with their regions.
fn areas<'a>(input: &'a Input<'_>) -> impl Iterator<Item = (&'a PlaceName, &'a Region)> {
    let is_area = |place: &PlaceName| match place.kind {
        PlaceKind::Island => place.number > 0,
        kind => matches!(kind, PlaceKind::Sea | PlaceKind::Lake),
    };
    input.map.names.places.iter().zip(input.map.regions.iter()).filter(move |(place, _)| is_area(place))
}

/// Returns `true` if a place has this name, in full or without its article.
fn is_named(place: &PlaceName, text: &str) -> bool {
    place.name == text || place.name.strip_prefix("The ") == Some(text)
}

/// Level and on dry land, beside its lake.
fn check_tarn(label: &Label, input: &Input<'_>) -> Result<(), TestCaseError> {
    let (_, region) = areas(input).find(|(place, _)| is_named(place, &label.text)).unwrap();
    let coast = input.map.coast().unwrap();
    let corners = || boxes(label).into_iter().flat_map(|around| around.corners());
    prop_assert!(label.letters.iter().all(|letter| degrees(letter.along).abs() < 0.1), "{} climbs", label.text);
    prop_assert!(corners().all(|corner| coast.height(corner) > 0.0), "{} stands in water", label.text);
    let nearest = corners().map(|corner| away(region, corner)).fold(f32::MAX, f32::min);
    prop_assert!(nearest <= 2.5 * label.em, "{} is {nearest} from its lake, {} an em", label.text, label.em);
    Ok(())
}

/// The distance of a point from a region, in units.
fn away(region: &Region, at: Vec2) -> f32 {
    let corner = |x: u32, y: u32| Vec2::new(x as f32, y as f32) * CELL_SIZE;
    let off = |run: &Run| at.clamp(corner(run.start, run.row), corner(run.end, run.row + 1)).distance(at);
    region.runs.iter().map(off).fold(f32::MAX, f32::min)
}

/// In its own water, climbing by 20 degrees at most; or on its island, or level on the water beside it.
fn check_area(label: &Label, input: &Input<'_>) -> Result<(), TestCaseError> {
    if label.kind == Kind::Tarn {
        return check_tarn(label, input);
    }
    if matches!(label.kind, Kind::Region | Kind::Inlet | Kind::Cape) {
        return check_landmark(label, input);
    }
    let (place, region) = areas(input).find(|(place, _)| is_named(place, &label.text)).unwrap();
    let (is_island, is_in) = (place.kind == PlaceKind::Island, label.kind != Kind::Offshore);
    prop_assert_eq!(is_island, label.kind != Kind::Water);
    for letter in &label.letters {
        let angle = degrees(letter.along);
        prop_assert!(angle.abs() < if is_island { 0.1 } else { 20.01 }, "{} climbs by {angle} degrees", label.text);
    }
    for around in boxes(label) {
        prop_assert_eq!(region.holds(around.middle), is_in, "{}", label.text);
        for corner in around.corners() {
            prop_assert!(corner.cmpge(input.frame[0]).all() && corner.cmple(input.frame[1]).all(), "{}", label.text);
            let inland = input.map.coast().unwrap().height(corner);
            let room = if label.kind == Kind::Island { inland } else { -inland };
            let least = if label.kind == Kind::Water { 0.7 } else { 0.15 };
            prop_assert!(room > least * label.em, "{} is {room} from the coast", label.text);
        }
    }
    if label.kind == Kind::Offshore {
        check_belonging(label, region, input)?;
    }
    Ok(())
}

/// Regions on their land, bays and straits in their water, capes on the water near their tip; all upright and in the frame.
fn check_landmark(label: &Label, input: &Input<'_>) -> Result<(), TestCaseError> {
    let landmark = input.map.names.places.iter().find(|place| is_named(place, &label.text)).unwrap();
    let (is_region, coast) = (label.kind == Kind::Region, input.map.coast().unwrap());
    let mut nearest = f32::MAX;
    for corner in boxes(label).into_iter().flat_map(|around| around.corners()) {
        prop_assert!(corner.cmpge(input.frame[0]).all() && corner.cmple(input.frame[1]).all(), "{}", label.text);
        let room = if is_region { coast.height(corner) } else { -coast.height(corner) };
        prop_assert!(room > 0.15 * label.em, "{:?} {} is {room} from the coast", landmark.kind, label.text);
        let line = landmark.line.iter().chain([&landmark.at]);
        nearest = line.map(|at| at.distance(corner)).fold(nearest, f32::min);
    }
    let most = landmark.size.max(5.0 * label.em);
    prop_assert!(nearest <= most, "{:?} {} is {nearest} from what it names", landmark.kind, label.text);
    Ok(())
}

/// Nearer to its island than to any other, on average.
fn check_belonging(label: &Label, own: &Region, input: &Input<'_>) -> Result<(), TestCaseError> {
    let away = |region: &Region| -> f32 {
        boxes(label).iter().map(|around| away(region, around.middle)).sum::<f32>() / label.letters.len() as f32
    };
    for (other, region) in areas(input).filter(|(place, region)| place.kind == PlaceKind::Island && *region != own) {
        prop_assert!(away(own) < 1.35 * away(region) + 0.4 * label.em, "{} seems to name {:?}", label.text, other.name);
    }
    Ok(())
}

/// The pieces of each river.
struct Pieces(BTreeMap<u32, Vec<Piece>>);

impl Pieces {
    fn of(input: &Input<'_>) -> Self {
        let mut pieces: BTreeMap<u32, Vec<Piece>> = BTreeMap::new();
        Piece::all(input).into_iter().for_each(|piece| pieces.entry(piece.river).or_default().push(piece));
        Self(pieces)
    }

    fn of_river(&self, river: u32) -> impl Iterator<Item = &Piece> {
        self.0.get(&river).into_iter().flatten()
    }
}

/// On land, off its river, and nearer to that than to any other that could be taken for it.
fn check_place(label: &Label, river: u32, input: &Input<'_>, pieces: &Pieces) -> Result<(), TestCaseError> {
    let ends = |piece: &Piece| {
        let [from, to] = piece.ends.map(|place| geo::coord! { x: f64::from(place.at.x), y: f64::from(place.at.y) });
        geo::Line::new(from, to)
    };
    for around in boxes(label) {
        for corner in around.corners() {
            prop_assert!(
                input.map.coast().is_none_or(|coast| coast.height(corner) > 0.0),
                "{} is in the sea",
                label.text
            );
            prop_assert!(corner.cmpge(input.frame[0]).all() && corner.cmple(input.frame[1]).all(), "{}", label.text);
        }
        let own = pieces.of_river(river).filter(|_| label.kind == Kind::River);
        for piece in own {
            let narrower = f64::from(piece.ends[0].half.min(piece.ends[1].half));
            let distance = Euclidean.distance(&polygon(&around), &ends(piece));
            prop_assert!(distance >= narrower * 0.999, "{} lies on its river", label.text);
        }
    }
    let middles =
        || label.letters.iter().map(|letter| letter.place(Vec2::new(letter.glyph.advance * 0.5, -0.2), label.em));
    let away = |river: u32, least: f32| -> f32 {
        let of_river = || pieces.of_river(river).filter(|piece| piece.is_as_wide_as(least));
        middles().map(|at| of_river().map(|piece| piece.distance(at)).fold(4.0 * label.em, f32::min)).sum()
    };
    let widest = input.map.courses[river as usize].iter().map(|place| 2.0 * place.half).fold(0.0, f32::max);
    let own = away(river, 0.0);
    for rival in (0..input.map.courses.len() as u32).filter(|&rival| rival != river) {
        prop_assert!(own < away(rival, 0.4 * widest), "{} seems to belong to river {rival}", label.text);
    }
    Ok(())
}

proptest! {
    #![proptest_config(first(1, large(100)))]

    fn labels_are_upright_ashore_and_apart(link in random_link(2000), size in 0.5f64..1.6, width in 300.0f32..2000.0) {
        check(&finished(&format!("{link}&labels=many&label-size={size:.2}")), width)?;
    }

    fn labels_are_those_of_the_twin(link in random_link(300), size in 0.5f64..1.3) {
        let session = finished(&format!("{link}&labels=many&label-size={size:.2}"));
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1400.0);
        prop_assert_eq!(labels, place(&input, &Literal::new(Piece::all(&input))));
    }
}

tiers!(labels_are_upright_ashore_and_apart, labels_are_those_of_the_twin);

proptest! {
    #![proptest_config(first(2, cases(6)))]

    fn changing_labels_gives_the_picture_of_a_fresh_one(link in random_link(500), size in 0.5f64..2.0) {
        let painted = |session: &Session| {
            let mut picture = Picture::new(240, 200).unwrap();
            picture.paint(session);
            picture.pixmap().data().to_vec()
        };
        let mut session = finished(&format!("{link}&labels=none"));
        let mut picture = Picture::new(240, 200).unwrap();
        picture.paint(&session);
        let bare = picture.pixmap().data().to_vec();
        for labels in ["many", "few", "none"] {
            let other = format!("{link}&labels={labels}&label-size={size:.2}");
            session.change(link::read(&other).unwrap()).unwrap();
            session.finish().unwrap();
            picture.paint(&session);
            prop_assert!(picture.pixmap().data() == painted(&finished(&other)), "{}", labels);
        }
        prop_assert!(picture.pixmap().data() == bare);
    }
}

tiers!(changing_labels_gives_the_picture_of_a_fresh_one);

#[test]
fn islands_and_lakes_have_names_too() {
    let counts = |link: &str| {
        let session = finished(link);
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1400.0);
        check(&session, 1400.0).unwrap();
        let islands = areas(&input).filter(|(place, _)| place.kind == PlaceKind::Island).count();
        let count = |kind: Kind| labels.iter().filter(|label| label.kind == kind).count();
        (islands, [Kind::Island, Kind::Offshore, Kind::Water].map(count))
    };
    let mut all = [0; 4];
    for seed in ["kea", "moa", "tui", "skye", "lofoten", "kauri"] {
        let (islands, [inside, beside, water]) = counts(&format!(
            "country=usual&seed={seed}&land=archipelago&sea=0.75&roughness=1&attractors=4000&labels=many"
        ));
        println!("{seed}: {islands} islands, {inside} named on them, {beside} beside them, {water} waters");
        all = [all[0] + islands, all[1] + inside, all[2] + beside, all[3] + water];
    }
    let [islands, inside, beside, water] = all;
    assert!(inside >= 3 && beside > 12 && 10 * (inside + beside) >= 8 * islands && water >= 6, "{all:?}");
    // A land drawn by hand, with two lakes and an island in one of them.
    let (islands, [inside, beside, water]) =
        counts(&format!("land=drawn&roughness=0.6&attractors=2000&labels=some&outline={LAKES}"));
    assert_eq!((islands, inside + beside, water), (1, 1, 3));
}

const LAKES: &str = ".9bgA7Mqx0zz6rQ6AgA8JUv6ALMz6EzqxCkgAEzVOLMMFUvF_f_D2rQF_0zMF7MVO.bhczZFhUTMjMNUhUK4czNUYRTMWZZFYR.zMmZw8qerhsKmFqej1mZmFiUrhgow8iU.VHczTyeoRpd7RpbrTya-";

/// The greatest river has its name on maps where there is a place for it.
#[test]
fn the_greatest_river_has_its_name_however_few_have_and_however_many_others_wind() {
    for seed in [8, 38, 51, 58] {
        let link =
            "land=continent&attractors=2000&great-rivers=8&flat-share=0.6&meander-rounds=40&labels=few&label-size=1.5";
        let session = finished(&format!("{link}&country=usual&seed={seed}"));
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1400.0);
        let greatest = (0..input.map.discharges.len()).max_by_key(|&river| input.map.discharges[river]).unwrap();
        let has_name = |label: &Label| label.river == Some(greatest as u32) && label.kind == Kind::River;
        assert!(labels.iter().any(has_name), "{seed}");
    }
}

#[test]
fn no_letter_of_a_sea_climbs_by_more_than_20_degrees() {
    for (seed, land) in (0..24).flat_map(|seed| ["island", "continent"].map(|land| (seed, land))) {
        let session = finished(&format!("country=usual&seed={seed}&land={land}&attractors=500&labels=few"));
        let map = session.map().unwrap();
        let (labels, _) = placed(&map, 1400.0);
        let waters = labels.iter().filter(|label| label.kind == Kind::Water);
        let angles = waters.flat_map(|label| &label.letters).map(|letter| degrees(letter.along).abs());
        let steepest = angles.fold(0.0, f64::max);
        assert!(steepest <= 20.01, "{seed}, {land}: {steepest}");
    }
}

/// Where rivers lie close together, and labels would often be nearer to another.
#[test]
fn labels_belong_to_their_rivers_on_a_dense_map_too() {
    let session =
        finished("land=rectangle&growth=brownian&sensitivity=12&country=usual&seed=kea&labels=many&label-size=0.7");
    let count = check(&session, 1400.0).unwrap();
    assert!(count > 20, "{count}");
}

#[test]
fn no_two_rivers_have_one_label_in_short_either() {
    let session =
        finished("country=usual&seed=skye&land=continent&growth=drainage&meander-rounds=60&great-rivers=3&labels=many");
    let map = session.map().unwrap();
    let (labels, _) = placed(&map, 1200.0);
    let rivers: BTreeMap<_, _> = labels.iter().map(|label| (&label.text, label.river)).collect();
    assert!(labels.iter().all(|label| rivers[&label.text] == label.river) && labels.len() > 40);
}

#[test]
fn most_great_rivers_have_their_name() {
    let maps = ["island", "continent", "archipelago", "valley", "rectangle"].into_iter().flat_map(|land| {
        ["drainage", "colonize"].map(|growth| {
            format!("land={land}&sea=0.55&growth={growth}&attractors=6000&labels=some&country=usual&seed=kea")
        })
    });
    let labelled = |link: String| {
        let session = finished(&link);
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1400.0);
        let mut greatest: Vec<u32> = (0..input.map.courses.len() as u32).collect();
        greatest.sort_by_key(|&river| std::cmp::Reverse(input.map.discharges[river as usize]));
        let count =
            greatest[..10].iter().filter(|&&river| labels.iter().any(|label| label.river == Some(river))).count();
        println!("{link}: {count} of 10, {} labels", labels.len());
        count
    };
    let counts: Vec<usize> = maps.map(labelled).collect();
    assert!(counts.iter().sum::<usize>() >= 90, "{counts:?} of ten each");
}

#[test]
fn a_map_without_labels_asks_for_none_and_one_with_them_has_as_many_as_it_asks_for() {
    let count = |labels: &str| {
        let session = finished(&format!("land=island&attractors=4000&country=usual&seed=kauri&labels={labels}"));
        let size = session.domain().size;
        labels::input(&session.map().unwrap(), [Vec2::ZERO, size], 1.0)
            .map_or(0, |input| place(&input, &Raster::new(&input)).len())
    };
    let counts = ["none", "few", "some", "many"].map(count);
    assert!(counts[0] == 0 && counts[1] > 3 && counts.is_sorted_by(|a, b| a < b), "{counts:?}");
    // A recipe that is still growing has none.
    let session = Session::new(link::read("land=island&labels=many").unwrap()).unwrap();
    assert_eq!(session.map(), None);
}

#[test]
fn svg_has_each_label_as_a_group_with_its_text_and_a_mask_for_rivers() {
    let session =
        finished("land=island&attractors=4000&country=usual&seed=kauri&style=atlas&labels=some&names=t.%3Cb%3E");
    let size = session.domain().size;
    let map = session.map().unwrap();
    let input = labels::input(&map, [Vec2::ZERO, size], 1.0).unwrap();
    let text = without_number(&riverseed::export::svg::svg(&session.map().unwrap()).unwrap());
    let document = roxmltree::Document::parse(&text).unwrap();
    let by_id = |id: &str| document.descendants().find(|node| node.attribute("id") == Some(id));
    let titles: Vec<&str> =
        by_id("labels").unwrap().children().filter_map(|label| label.first_child()?.text()).collect();
    let all = place(&input, &Raster::new(&input));
    let on_land = all.iter().filter(|label| !label.kind.is_afloat()).count();
    let names = all.into_iter().filter(|label| !label.kind.is_of_cartouche());
    assert_eq!(titles, names.map(|label| label.text).collect::<Vec<_>>());
    assert_eq!(by_id("rivers").unwrap().attribute("mask"), Some("url(#halo)"));
    let steps: Vec<usize> = by_id("halo")
        .unwrap()
        .descendants()
        .filter_map(|path| Some(path.attribute("d")?.matches('M').count()))
        .collect();
    // The map, and a ring around each name on land at least; nearest to letters, one around each letter.
    assert!(steps.len() == 3 && steps[0] > on_land && steps[2] > 2 * on_land, "{steps:?} for {on_land}");
    let titled = finished(
        "land=island&attractors=500&style=atlas&labels=none&country=usual&seed=%3Ckea%3E&names=t.A%26B&cartouche=framed",
    );
    let text = riverseed::export::svg::svg(&titled.map().unwrap()).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let cartouche = document.descendants().find(|node| node.attribute("id") == Some("cartouche")).unwrap();
    assert_eq!(cartouche.attribute("aria-label"), Some("A&B, from the word <kea>, 0, 10, 20 km"));
    assert_eq!(cartouche.descendants().filter(|node| node.has_tag_name("title")).count(), 5);
    assert!(!text.contains("id=\"labels\""));
    // As text on paths, a line each, all letters included.
    let session = finished(
        "land=island&attractors=4000&country=usual&seed=kauri&style=atlas&labels=some&cartouche=plain&names=t.A+B",
    );
    let texts: Vec<String> =
        placed(&session.map().unwrap(), session.domain().size.x).0.into_iter().map(|label| label.text).collect();
    let text = riverseed::export::svg::svg_with_text(&session.map().unwrap()).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let paths = document.descendants().filter(|node| node.has_tag_name("textPath"));
    let on_path = |path: roxmltree::Node<'_, '_>| {
        let id = path.attribute("href").unwrap().strip_prefix('#').unwrap().to_owned();
        let baselines = document.descendants().filter(|node| node.attribute("id") == Some(id.as_str()));
        assert_eq!(baselines.filter(|node| node.attribute("d").is_some()).count(), 1, "{id}");
        assert!(path.attribute("textLength").unwrap().parse::<f32>().unwrap() > 5.0);
        path.text().unwrap().to_owned()
    };
    assert_eq!(paths.map(on_path).collect::<Vec<_>>(), texts);
    let bare = finished("land=island&attractors=4000&country=usual&seed=kauri&style=atlas&labels=none");
    let bare = riverseed::export::svg::svg(&bare.map().unwrap()).unwrap();
    assert!(!bare.contains("id=\"labels\"") && !bare.contains("mask"));
}

/// Realistic seeds: wide, long, from right to left, in letters that the type lacks, and with other characters than
/// letters.
fn any_seed() -> impl Strategy<Value = String> {
    prop_oneof![
        Just("W".repeat(64)),
        Just("\u{5e9}\u{5dc}\u{5d5}\u{5dd} kea".into()),
        Just("\u{6771}\u{4eac}".into()),
        "[A-Za-z ]{1,64}",
        "\\PC{1,64}"
    ]
}

proptest! {
    #![proptest_config(large(100))]

    #[test]
    fn a_cartouche_stands_at_sea_if_there_is_a_place_and_off_all_labels(
        link in random_link(1000), seed in any_seed(), aspect in 0.3f64..4.0, size in 0.5f64..2.0, width in 200.0f32..2000.0,
    ) {
        let mut recipe = link::read(&format!("{link}&labels=some&cartouche=framed&label-size={size:.2}")).unwrap();
        recipe.set(Key::Aspect, &format!("{aspect:.2}")).unwrap();
        prop_assume!(recipe.set(Key::Seed, &seed).is_ok());
        let mut session = Session::new(recipe).unwrap();
        session.finish().unwrap();
        check(&session, width)?;
    }
}

#[test]
fn a_cartouche_is_at_sea_on_islands_and_coasts() {
    for land in ["island", "continent", "archipelago", "valley"] {
        for (seed, width) in (0..4).zip([1400.0, 700.0, 1000.0, 500.0]) {
            let link = format!("land={land}&attractors=500&country=usual&seed={seed}&labels=few&cartouche=framed");
            check(&finished(&link), width).unwrap();
        }
    }
}

#[test]
fn a_seed_that_is_too_long_or_in_other_letters_is_left_out_of_the_cartouche() {
    let texts = |seed: &str| -> Vec<String> {
        let link =
            format!("land=island&attractors=500&labels=none&cartouche=framed&names=t.Home&country=usual&seed={seed}");
        let session = finished(&link);
        let labels = placed(&session.map().unwrap(), 1200.0).0.into_iter();
        let of_title = labels.filter(|label| matches!(label.kind, Kind::Title | Kind::Seed));
        of_title.map(|label| label.text).collect()
    };
    assert_eq!(texts("kea"), ["Home", "from the word kea"]);
    assert_eq!(texts("a long seed of some letters"), ["Home", "from the words a long seed of some letters"]);
    for seed in [&"W".repeat(64), "\u{5e9}\u{5dc}\u{5d5}\u{5dd}", "\u{6771}\u{4eac}"] {
        assert_eq!(texts(seed), ["Home"]);
    }
    // Without a title there is no cartouche.
    let session = finished("land=island&attractors=500&labels=none&cartouche=plain&names=t.");
    assert!(placed(&session.map().unwrap(), 1200.0).0.is_empty());
}

#[test]
fn a_name_that_is_taken_away_is_on_no_map_and_one_s_own_is() {
    let session = finished("land=island&attractors=4000&country=usual&seed=kauri&labels=some");
    let map = session.map().unwrap();
    let (labels, _) = placed(&map, 1400.0);
    let river = labels[0].river.unwrap();
    let identity = Names::identities(&map)[river as usize];
    let texts = |own: &str| -> Vec<String> {
        let session = finished(&format!(
            "land=island&attractors=4000&country=usual&seed=kauri&labels=some&names={identity}.{own}"
        ));
        let map = session.map().unwrap();
        let (labels, _) = placed(&map, 1400.0);
        labels
            .into_iter()
            .filter(|label| label.river == Some(river) && label.kind == Kind::River)
            .map(|label| label.text)
            .collect()
    };
    assert!(texts("").is_empty());
    assert!(texts("Ant").contains(&"Ant".to_owned()));
}
