//! Promises of the marks on labelled maps besides names. Heights are those of the relief, on summits and saddles;
//! letters are those of the grid's columns; the legend counts rivers; the seal has the seed's initials; and none of
//! them is in the way of anything.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::literal_ground::Literal;
use crate::common::parts::paint_in_parts;
use crate::common::property::{cases, large};
use crate::common::random_link;
use crate::common::svg_ids::without_number;
use crate::common::tier::{first, one_in, tiers};
use proptest::prelude::*;
use riverseed::annotate::labels;
use riverseed::annotate::place::{Input, Kind, Label, Piece, Raster, Stroke, place};
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::glam::Vec2;
use riverseed::recipe::{Key, Recipe, Style, link};
use riverseed::{Map, Picture, Session};

fn recipe(link: &str, more: &[(Key, &str)]) -> Recipe {
    let mut recipe = link::read(link).unwrap();
    more.iter().for_each(|(key, text)| recipe.set(*key, text).unwrap());
    recipe
}

fn finished(recipe: Recipe) -> Session {
    let mut session = Session::new(recipe).unwrap();
    session.finish().unwrap();
    session
}

fn finished_link(link: &str) -> Session {
    finished(recipe(link, &[]))
}

/// The labels of a picture of the whole map, `width` pixels wide, and the input that they are placed by.
fn placed(map: &Map, width: f32) -> (Vec<Label>, Input<'_>) {
    let size = map.domain().size;
    let input = labels::input(map, [Vec2::ZERO, size], width / size.x).unwrap();
    (place(&input, &Raster::new(&input)), input)
}

fn of(labels: &[Label], kind: Kind) -> impl Iterator<Item = &Label> {
    labels.iter().filter(move |label| label.kind == kind)
}

/// Points of a label, up to an eighth of its em apart: of its letters' boxes, and of its strokes with their width.
fn points(label: &Label) -> Vec<Vec2> {
    const STEPS: u32 = 8;
    let shares = || (0..=STEPS).map(|i| i as f32 / STEPS as f32);
    let boxes = label.letters.iter().flat_map(|letter| {
        let around = letter.around(label.em);
        shares().flat_map(move |x| {
            shares().map(move |y| around.middle + around.along * (2.0 * x - 1.0) + around.down * (2.0 * y - 1.0))
        })
    });
    let ring = [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y, Vec2::ZERO];
    let strokes = label.strokes.iter().flat_map(|&Stroke { ends, half }| {
        shares().flat_map(move |share| ring.map(|way| ends[0].lerp(ends[1], share) + way * half))
    });
    boxes.chain(strokes).collect()
}

/// The distance of a point from the nearest bank of a river.
fn from_bank(pieces: &[Piece], at: Vec2) -> f32 {
    pieces.iter().filter(|piece| piece.is_river()).map(|piece| piece.distance(at)).fold(f32::MAX, f32::min)
}

/// Heights as they are exported, in metres, cell by cell.
struct Exported {
    metres: Vec<f64>,
    step: f64,
    columns: usize,
    cell: f32,
}

impl Exported {
    fn new(session: &Session) -> Self {
        let rasters = Rasters::new(&session.map().unwrap()).unwrap();
        let Values::Words(words) = rasters.values(Layer::Heights) else { unreachable!("heights are words") };
        let metres = words.into_iter().map(|word| rasters.scale.metres(word)).collect();
        Self { metres, step: rasters.scale.metres_a_step, columns: rasters.columns, cell: rasters.cell_size }
    }

    /// The height a number of columns and rows away from a place; `None` beyond the map.
    fn at(&self, place: Vec2, [right, down]: [i32; 2]) -> Option<f64> {
        let [column, row] = [(place.x, right), (place.y, down)].map(|(x, by)| (x / self.cell) as i32 + by);
        let rows = (self.metres.len() / self.columns) as i32;
        let is_on_map = (0..self.columns as i32).contains(&column) && (0..rows).contains(&row);
        is_on_map.then(|| self.metres[row as usize * self.columns + column as usize])
    }

    /// Returns `true` if nothing within 8 units is higher by more than a step.
    fn is_summit(&self, place: Vec2) -> bool {
        let own = self.at(place, [0, 0]).unwrap();
        let around = (-4..=4).flat_map(|x| (-4..=4).map(move |y| [x, y])).filter(|[x, y]| x * x + y * y <= 16);
        around.filter_map(|by| self.at(place, by)).all(|other| other <= own + self.step)
    }

    /// Returns `true` if land rises on two sides and falls on the two between them.
    fn is_saddle(&self, place: Vec2) -> bool {
        let own = self.at(place, [0, 0]).unwrap();
        let ring = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];
        // Heights in files are rounded to steps: two that are alike there may be either way.
        let is_one = |is_higher: &dyn Fn(f64) -> bool| {
            let is_higher = ring.map(|[x, y]| self.at(place, [4 * x, 4 * y]).is_some_and(is_higher));
            (0..8).filter(|&i| is_higher[i] != is_higher[(i + 1) % 8]).count() == 4
        };
        is_one(&|other| other > own) || is_one(&|other| other >= own)
    }
}

/// Checks heights. Returns the numbers of summits and of saddles on a map.
fn check_heights(session: &Session, width: f32) -> Result<[usize; 2], TestCaseError> {
    let map = session.map().unwrap();
    let (labels, input) = placed(&map, width);
    let (exported, pieces) = (Exported::new(session), Piece::all(&input));
    let apart = input.map.marks.elevations.unwrap().apart;
    let mut spots: Vec<Vec2> = Vec::new();
    let mut counts = [0; 2];
    for label in of(&labels, Kind::SpotHeight) {
        let spot = label.strokes.last().unwrap().ends[0];
        let metres = exported.at(spot, [0, 0]).unwrap();
        let off = (label.text.parse::<f64>().unwrap() - metres).abs();
        prop_assert!(off <= 0.501 + 0.5 * exported.step, "{} m, and {metres} in files", label.text);
        let is_summit = exported.is_summit(spot);
        prop_assert!(is_summit || exported.is_saddle(spot), "{} m at {spot} is neither summit nor saddle", label.text);
        counts[usize::from(!is_summit)] += 1;
        prop_assert!(spots.iter().all(|other| other.distance(spot) >= apart), "{} m is near another", label.text);
        spots.push(spot);
        for at in points(label) {
            let clear = from_bank(&pieces, at);
            prop_assert!(clear >= 0.15 * label.em, "{} m is {clear} from a bank", label.text);
            prop_assert!(
                input.map.coast().is_none_or(|coast| coast.height(at) > 0.0),
                "{} m is in the sea",
                label.text
            );
            prop_assert!(at.cmpge(input.frame[0]).all() && at.cmple(input.frame[1]).all());
        }
    }
    check_apart(&labels)?;
    Ok(counts)
}

/// No mark touches a letter of anything else.
fn check_apart(labels: &[Label]) -> Result<(), TestCaseError> {
    for mark in labels.iter().filter(|label| label.kind.is_mark() || label.kind == Kind::Legend) {
        // Of the grid its crossings: the line around the map is as long as that.
        let strokes = mark.strokes.iter().filter(|stroke| stroke.ends[0].distance(stroke.ends[1]) < 3.0 * mark.em);
        let alone = Label { strokes: strokes.copied().collect(), ..mark.clone() };
        let is_block = |label: &Label| label.kind == Kind::Legend;
        let others = labels.iter().filter(|other| !(std::ptr::eq(*other, mark) || is_block(mark) && is_block(other)));
        for other in others {
            for letter in other.letters.iter().map(|letter| letter.around(other.em)) {
                let meets = points(&alone).into_iter().any(|at| letter.gap([at, at]) <= 0.0);
                prop_assert!(!meets, "{:?} {} touches {:?} {}", mark.kind, mark.text, other.kind, other.text);
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(first(1, large(60)))]

    fn heights_are_those_of_files_on_summits_and_saddles_and_in_nothing_s_way(
        link in random_link(2000), size in 0.5f64..1.4, width in 400.0f32..2000.0,
    ) {
        let more = [(Key::Style, "survey"), (Key::Labels, "many"), (Key::LabelSize, &format!("{size:.2}"))];
        check_heights(&finished(recipe(&link, &more)), width)?;
    }

    fn marks_are_those_of_the_twin(link in random_link(300), size in 0.5f64..1.3, style in 0usize..3) {
        let style = ["survey", "blueprint", "ink-wash"][style];
        let more = [(Key::Style, style), (Key::Labels, "few"), (Key::LabelSize, &format!("{size:.2}"))];
        let session = finished(recipe(&link, &more));
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1400.0);
        prop_assert_eq!(labels, place(&input, &Literal::new(Piece::all(&input))));
    }
}

tiers!(heights_are_those_of_files_on_summits_and_saddles_and_in_nothing_s_way, marks_are_those_of_the_twin);

fn maps_with_mountains_tell_the_heights_of_summits_and_of_saddles() {
    let maps = [("island", "drainage"), ("archipelago", "colonize"), ("continent", "drainage")];
    for (land, growth) in one_in(3, maps) {
        let link = format!("land={land}&growth={growth}&country=usual&seed=kauri&attractors=4000&style=survey");
        let mut session = finished_link(&link);
        let counts = ["few", "some", "many"].map(|labels| {
            session.change(recipe(&link, &[(Key::Labels, labels)])).unwrap();
            let [summits, saddles] = check_heights(&session, 1440.0).unwrap();
            println!("{land}, {growth}, {labels}: {summits} summits, {saddles} saddles");
            summits + saddles
        });
        assert!(counts[0] >= 6 && counts.is_sorted() && counts[2] <= 150, "{land}: {counts:?}");
    }
}

tiers!(maps_with_mountains_tell_the_heights_of_summits_and_of_saddles);

/// Wherever nothing is in its way.
#[test]
fn the_highest_place_is_told_and_has_a_triangle() {
    // On some maps a river or a name is.
    let is_told = |seed: &str| {
        let link = format!("land=island&sea=0.55&attractors=5600&country=usual&seed={seed}&style=survey&labels=some");
        let (labels, _) = placed(&finished_link(&link).map().unwrap(), 1440.0);
        let highest = of(&labels, Kind::SpotHeight).max_by_key(|label| label.text.parse::<u32>().unwrap()).unwrap();
        highest.strokes.len() == 4 && of(&labels, Kind::SpotHeight).any(|label| label.strokes.len() == 1)
    };
    assert!(["kauri", "rimu", "kea", "tui"].into_iter().any(is_told));
}

/// In each picture, the whole and a part of the map.
#[test]
fn grid_letters_and_lines_are_those_of_the_grid() {
    let session = finished_link("land=archipelago&country=usual&seed=moa&attractors=3000&style=survey&labels=some");
    let size = session.domain().size;
    for sheet in [[Vec2::ZERO, size], [Vec2::new(190.0, 100.0), Vec2::new(1010.0, 640.0)]] {
        let map = session.map().unwrap();
        let input = labels::input(&map, sheet, 1.2).unwrap();
        let labels = place(&input, &Raster::new(&input));
        let (grid, [least, most]) = (input.map.marks.grid.unwrap(), input.view);
        assert!(grid.sheet == sheet && (least - sheet[0]).min_element() > grid.em);
        let mut sides: BTreeMap<String, usize> = BTreeMap::new();
        for label in of(&labels, Kind::GridLetter) {
            let middles = label.letters.iter().map(|letter| letter.around(label.em).middle);
            let middle = middles.sum::<Vec2>() / label.letters.len() as f32;
            let [across, down] = [middle.x, middle.y].map(|at| (at / grid.every) as u32);
            let expected = if label.text.parse::<u32>().is_ok() {
                (down + 1).to_string()
            } else {
                char::from(b'A' + across as u8).to_string()
            };
            assert_eq!(label.text, expected, "at {middle}");
            // In the margin, beside what is seen of its column or row.
            assert!(middle.cmplt(least).any() || middle.cmpgt(most).any(), "{middle}");
            *sides.entry(label.text.clone()).or_default() += 1;
        }
        assert!(sides.values().all(|count| *count == 2) && sides.len() >= 10, "{sides:?}");
        // Every line begins or crosses at the grid, but for those around the map.
        let lines = of(&labels, Kind::Grid).next().unwrap();
        let is_line = |at: f32| (at / grid.every - (at / grid.every).round()).abs() < 1e-3;
        let ends = lines.strokes.iter().filter(|stroke| stroke.ends[0].distance(stroke.ends[1]) < 3.0 * grid.em);
        for stroke in ends.clone() {
            let middle = (stroke.ends[0] + stroke.ends[1]) * 0.5;
            assert!(is_line(middle.x) || is_line(middle.y), "{stroke:?}");
        }
        assert!(ends.count() > 30 && lines.strokes.len() > 34);
        // All else keeps off the margin.
        for label in labels.iter().filter(|label| !matches!(label.kind, Kind::Grid | Kind::GridLetter)) {
            assert!(
                points(label).into_iter().all(|at| at.cmpge(least).all() && at.cmple(most).all()),
                "{}",
                label.text
            );
        }
        check_apart(&labels).unwrap();
    }
    // So small a picture has no room for it.
    assert!(placed(&session.map().unwrap(), 200.0).1.map.marks.grid.is_none());
}

#[test]
fn a_legend_says_title_seed_scale_and_counts_at_sea_and_off_the_cartouche() {
    for (land, cartouche) in
        [("island", "none"), ("continent", "framed"), ("archipelago", "plain"), ("rectangle", "none")]
    {
        let link = format!(
            "land={land}&sea=0.7&drowning=0&country=usual&seed=moa&attractors=2000&style=blueprint&labels=some&cartouche={cartouche}"
        );
        let session = finished_link(&link);
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1440.0);
        let texts: Vec<&str> = of(&labels, Kind::Legend).map(|label| label.text.as_str()).collect();
        let names = riverseed::annotate::names::Names::of(&session.map().unwrap());
        assert_eq!(names.title, "Moa");
        let heading = if cartouche == "none" { vec![names.title.as_str(), names.subtitle.as_str()] } else { vec![] };
        assert!(texts.starts_with(&heading) && texts[heading.len()] == "10 km", "{texts:?}");
        let rivers = &session.network().unwrap().rivers;
        let highest = rivers.iter().map(|river| river.order).max().unwrap();
        for (line, order) in texts[heading.len() + 1..].iter().zip((1..=highest).rev()) {
            let count = rivers.iter().filter(|river| river.order == order).count();
            let plural = if count == 1 { "" } else { "s" };
            assert_eq!(*line, format!("{count} river{plural} of order {order}"));
        }
        assert!(texts.len() >= heading.len() + 3, "{texts:?}");
        let strokes = &of(&labels, Kind::Legend).next().unwrap().strokes;
        let length = |stroke: &Stroke| stroke.ends[0].distance(stroke.ends[1]);
        assert!(strokes.iter().any(|stroke| (length(stroke) - map.scale().units(10.0)).abs() < 1e-3));
        let is_sea = |at: Vec2| input.map.coast().is_some_and(|coast| coast.height(at) < 0.0);
        let is_at_sea = of(&labels, Kind::Legend).flat_map(points).all(is_sea);
        assert_eq!(is_at_sea, land != "rectangle", "{land}");
        check_apart(&labels).unwrap();
        let [least, most] = input.frame;
        assert!(of(&labels, Kind::Legend).flat_map(points).all(|at| at.cmpge(least).all() && at.cmple(most).all()));
    }
}

#[test]
fn a_seal_has_the_seed_s_initials_or_the_map_s() {
    let seal = |seed: &str, names: &str| {
        let more = [(Key::Seed, seed), (Key::Names, names)];
        let session = finished(recipe("land=island&attractors=500&style=ink-wash&labels=few", &more));
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1440.0);
        check_apart(&labels).unwrap();
        let seals: Vec<&Label> = of(&labels, Kind::Seal).collect();
        assert_eq!(seals.len(), 1, "{seed}");
        let corners = points(seals[0]);
        let side = corners.iter().map(|at| at.x).fold(f32::MIN, f32::max)
            - corners.iter().map(|at| at.x).fold(f32::MAX, f32::min);
        let height = input.frame[1].y - input.frame[0].y;
        assert!((0.034..0.046).contains(&(side / height)), "{seed}: {side} of {height}");
        assert!(corners.iter().all(|at| input.map.coast().unwrap().height(*at) < 0.0), "{seed} is on land");
        assert!(!seals[0].letters.is_empty());
        seals[0].text.clone()
    };
    assert_eq!(seal("kauri", ""), "K");
    assert_eq!(seal("two words more", ""), "TW");
    assert_eq!(seal("\u{e9}t\u{e9}", ""), "\u{c9}");
    assert_eq!(seal("\u{1f30a} 7", ""), "7");
    // No letter that the type has: the map's name has one, and if that, too, has none, there is one for rivers.
    for seed in ["\u{1f30a}", "\u{5e9}\u{5dc}\u{5d5}\u{5dd}", "\u{6771}\u{4eac}", "...", ""] {
        let of_name = seal(seed, "");
        assert!(
            of_name.chars().count() == 1 && of_name.is_ascii() || of_name.chars().all(char::is_uppercase),
            "{of_name}"
        );
        assert_eq!(seal(seed, "t.Home of mine"), "H");
        assert_eq!(seal(seed, "t.\u{6771}"), "R");
    }
}

proptest! {
    #![proptest_config(large(60))]

    #[test]
    fn legend_and_seal_stand_in_nothing_s_way(
        link in random_link(800), size in 0.5f64..2.0, width in 200.0f32..2000.0, style in prop_oneof![Just("blueprint"), Just("ink-wash")],
        cartouche in prop_oneof![Just("none"), Just("plain"), Just("framed")],
    ) {
        let more = [(Key::Style, style), (Key::Labels, "some"), (Key::Cartouche, cartouche), (Key::LabelSize, &format!("{size:.2}"))];
        let session = finished(recipe(&link, &more));
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, width);
        check_apart(&labels)?;
        let pieces = Piece::all(&input);
        for seal in of(&labels, Kind::Seal) {
            for at in points(seal) {
                let is_in_frame = at.cmpge(input.frame[0]).all() && at.cmple(input.frame[1]).all();
                prop_assert!(is_in_frame, "the seal is at {at}, off {:?}", input.frame);
                let is_sea = input.map.coast().is_some_and(|coast| coast.height(at) < 0.0);
                prop_assert!(is_sea || from_bank(&pieces, at) > 0.0, "the seal is on a river");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(6))]

    #[test]
    fn marks_painted_in_parts_are_those_painted_at_once(link in random_link(400), parts in prop::collection::vec(0u32..8, 4)) {
        let recipe = |style: &str, labels: &str| recipe(&link, &[(Key::Style, style), (Key::Labels, labels)]);
        let styles = [("survey", "few"), ("ink-wash", "few"), ("atlas", "few"), ("blueprint", "some")];
        let changes = styles.map(|(style, labels)| recipe(style, labels)).into_iter().zip(parts);
        paint_in_parts(recipe("ink", "none"), changes, || Picture::new(500, 320).unwrap())?;
    }
}

#[test]
fn maps_without_labels_have_no_marks_and_other_styles_none_either() {
    let (mut with, mut all) = (0, 0);
    for style in <Style as riverseed::recipe::Choice>::WORDS {
        let link = format!("land=island&country=usual&seed=kauri&attractors=1000&labels=none&style={}", style.name);
        let mut session = finished_link(&link);
        let size = session.domain().size;
        assert!(labels::input(&session.map().unwrap(), [Vec2::ZERO, size], 1.0).is_none(), "{}", style.name);
        session.change(recipe(&link, &[(Key::Cartouche, "plain")])).unwrap();
        assert!(
            placed(&session.map().unwrap(), 1200.0).0.iter().all(|label| label.kind.is_of_cartouche()),
            "{}",
            style.name
        );
        session.change(recipe(&link, &[(Key::Labels, "some")])).unwrap();
        let is_mark = |label: &Label| label.kind.is_mark() || label.kind == Kind::Legend;
        with += usize::from(placed(&session.map().unwrap(), 1200.0).0.iter().any(is_mark));
        all += 1;
    }
    assert_eq!((with, all), (3, 12));
}

#[test]
fn svg_has_marks_a_legend_and_a_seal() {
    let svg = |style: &str| {
        let session =
            finished_link(&format!("land=island&country=usual&seed=kauri&attractors=3000&labels=some&style={style}"));
        let map = session.map().unwrap();
        let (labels, _) = placed(&map, session.domain().size.x);
        let texts = [
            riverseed::export::svg::svg(&session.map().unwrap()),
            riverseed::export::svg::svg_with_text(&session.map().unwrap()),
        ];
        (labels, texts.map(|text| without_number(&text.unwrap())))
    };
    let (labels, texts) = svg("survey");
    for text in texts {
        let document = roxmltree::Document::parse(&text).unwrap();
        let marks = document.descendants().find(|node| node.attribute("id") == Some("marks")).unwrap();
        let titles: Vec<&str> =
            marks.descendants().filter(|node| node.has_tag_name("title")).filter_map(|title| title.text()).collect();
        let expected = labels.iter().filter(|label| label.kind.is_mark() && !label.letters.is_empty());
        assert_eq!(titles, expected.map(|label| label.text.as_str()).collect::<Vec<_>>());
        assert_eq!(marks.attribute("fill"), Some("#4a3322"));
    }
    let (labels, [text, _]) = svg("blueprint");
    let document = roxmltree::Document::parse(&text).unwrap();
    let legend = document.descendants().find(|node| node.attribute("id") == Some("legend")).unwrap();
    let lines: Vec<&str> = of(&labels, Kind::Legend).map(|label| label.text.as_str()).collect();
    assert_eq!(legend.attribute("aria-label"), Some(lines.join(", ").as_str()));
    let (_, [text, _]) = svg("ink-wash");
    let document = roxmltree::Document::parse(&text).unwrap();
    let seal = document.descendants().find(|node| node.attribute("id") == Some("seal")).unwrap();
    let paths: Vec<_> = seal.descendants().filter(|node| node.has_tag_name("path")).collect();
    // Around its letters, and along its edge.
    assert_eq!([paths[0].attribute("fill"), paths[1].attribute("stroke")], [Some("#a8322a"); 2]);
    assert_eq!((paths.len(), paths[0].attribute("fill-rule")), (2, Some("evenodd")));
    assert!(!text.contains("id=\"marks\"") && !text.contains("id=\"legend\""));
}

/// Letters are left out of a seal: where they are, the paper shows.
#[test]
fn a_seal_is_red_with_letters_left_out() {
    let session = finished_link("land=island&country=usual&seed=kauri&attractors=500&style=ink-wash&labels=few");
    let mut picture = Picture::new(1440, 900).unwrap();
    picture.paint(&session);
    let map = session.map().unwrap();
    let (labels, _) = placed(&map, 1440.0);
    let seal = of(&labels, Kind::Seal).next().unwrap();
    let view = *picture.view();
    let pixel = |at: Vec2| {
        let at = view.pixel(at);
        picture
            .pixmap()
            .pixel(at.x as u32, at.y as u32)
            .map(|pixel| [pixel.red(), pixel.green(), pixel.blue()])
            .unwrap()
    };
    let around = points(seal).into_iter().map(pixel).collect::<Vec<_>>();
    let red = around.iter().filter(|colour| **colour == [0xa8, 0x32, 0x2a]).count();
    let pale = around.iter().filter(|[red, green, _]| red.abs_diff(*green) < 12 && *red > 200).count();
    assert!(red * 3 > around.len() && pale * 40 > around.len(), "{red} red, {pale} pale of {}", around.len());
}
