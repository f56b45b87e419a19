//! Promises of the title and of what stands with it: the sea's freest place, the same in pictures of all sizes; scales that measure; plates
//! that tell what the network does.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use riverseed::annotate::labels;
use riverseed::annotate::names::Names;
use riverseed::annotate::place::{Input, Kind, Label, Plate, Raster, Stroke, place};
use riverseed::glam::Vec2;
use riverseed::recipe::{Key, Style, link};
use riverseed::scale::figures;
use riverseed::{Map, Session};

fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(link).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// The labels of a picture of the whole map, `width` pixels wide, and the input that they are placed by; none if it has no annotation.
fn placed(map: &Map, width: f32) -> (Vec<Label>, Option<Input<'_>>) {
    let size = map.domain().size;
    let input = labels::input(map, [Vec2::ZERO, size], width / size.x);
    (input.as_ref().map_or_else(Vec::new, |input| place(input, &Raster::new(input))), input)
}

/// The box around a label's letters.
fn around(label: &Label) -> [Vec2; 2] {
    let corners = label.letters.iter().flat_map(|letter| letter.around(label.em).corners());
    corners.fold([Vec2::MAX, Vec2::MIN], |[least, most], at| [least.min(at), most.max(at)])
}

fn title(labels: &[Label]) -> Option<&Label> {
    labels.iter().find(|label| label.kind == Kind::Title)
}

const LANDS: [&str; 5] = ["island", "archipelago", "continent", "valley", "rectangle"];

#[test]
fn a_title_has_one_place_at_all_sizes_and_one_size_where_that_can_be_read() {
    for land in LANDS {
        for seed in ["tay", "elbe", "mara", "two"] {
            let session = finished(&format!("land={land}&attractors=900&country=usual&seed={seed}&labels=few"));
            let map = session.map().unwrap();
            let middle = map.domain().size * 0.5;
            let mut places: Vec<[i32; 2]> = Vec::new();
            let mut ems: Vec<f32> = Vec::new();
            for width in [370.0, 500.0, 700.0, 1400.0, 4096.0] {
                let (labels, _) = placed(&map, width);
                let Some(title) = title(&labels) else { continue };
                let [least, most] = around(title);
                let off = (least + most) * 0.5 - middle;
                // The title is centred on its place, so it is left of the middle, in it, or right of it.
                let side = if off.x.abs() < 2.0 { 0 } else { off.x.signum() as i32 };
                places.push([side, off.y.signum() as i32]);
                if width >= 1400.0 {
                    ems.push(title.em);
                }
                assert!(title.em * width / map.domain().size.x >= 10.99, "{land} {seed} at {width}: dust");
            }
            assert!(places.len() >= 2 && places.iter().all(|place| *place == places[0]), "{land} {seed}: {places:?}");
            assert!(ems.len() == 2 && ems[0] == ems[1], "{land} {seed}: {ems:?}");
        }
    }
}

#[test]
fn the_smallest_pictures_of_islands_have_their_title_on_open_water() {
    let mut shown = 0;
    for seed in ["tay", "elbe", "kauri", "mara", "two", "rimu"] {
        for cartouche in ["auto", "framed"] {
            let session = finished(&format!(
                "land=island&attractors=900&country=usual&seed={seed}&labels=some&cartouche={cartouche}"
            ));
            let map = session.map().unwrap();
            let (labels, input) = placed(&map, 370.0);
            let coast = input.as_ref().unwrap().map.coast().unwrap();
            let Some(title) = title(&labels) else { continue };
            shown += 1;
            let [least, most] = around(title);
            for (x, y) in (0..=60).flat_map(|x| (0..=12).map(move |y| (x, y))) {
                let at = least + (most - least) * Vec2::new(x as f32 / 60.0, y as f32 / 12.0);
                assert!(coast.height(at) < 0.0, "{seed} {cartouche}: land at {at}");
            }
            assert!(title.cleared.is_empty());
        }
    }
    assert!(shown >= 11, "{shown}");
}

#[test]
fn maps_with_names_show_their_title_unless_they_are_told_not_to() {
    for (link, is_shown) in [
        ("labels=some", true),
        ("labels=none", false),
        ("labels=few&cartouche=auto", true),
        ("labels=few&cartouche=none", false),
        ("labels=none&cartouche=plain", true),
        ("labels=none&cartouche=lengths", true),
        ("labels=none&cartouche=profile", true),
    ] {
        let session = finished(&format!("land=island&attractors=900&country=usual&seed=kea&{link}"));
        let map = session.map().unwrap();
        let (labels, _) = placed(&map, 1400.0);
        assert_eq!(title(&labels).is_some(), is_shown, "{link}");
        assert_eq!(labels.iter().any(|label| label.kind == Kind::Margin), is_shown, "{link}");
    }
}

#[test]
fn no_sea_is_named_on_the_title_s_line() {
    let mut seas = 0;
    for seed in ["elbe", "kauri", "tay", "mara", "ardea", "thera"] {
        let session = finished(&format!("land=island&attractors=900&country=usual&seed={seed}&labels=some"));
        let map = session.map().unwrap();
        for width in [700.0, 1400.0] {
            let (labels, _) = placed(&map, width);
            let [least, most] = around(title(&labels).unwrap());
            let em = title(&labels).unwrap().em;
            for sea in labels.iter().filter(|label| label.kind == Kind::Water) {
                let [from, to] = around(sea);
                let is_level = to.y > least.y && from.y < most.y;
                let gap = (from.x - most.x).max(least.x - to.x);
                assert!(!is_level || gap > 5.0 * em, "{seed} at {width}: {} is {gap} beside the title", sea.text);
                seas += 1;
            }
        }
    }
    assert!(seas >= 8, "{seas}");
}

#[test]
fn a_scale_bar_is_as_long_as_it_says_and_so_is_that_of_a_legend() {
    for (span, says) in [
        ("10", ["0", "0.5", "1 km"]),
        ("37", ["0", "2.5", "5 km"]),
        ("200", ["0", "10", "20 km"]),
        ("320", ["0", "25", "50 km"]),
        ("5000", ["0", "250", "500 km"]),
    ] {
        check_scale_bar(span, says);
    }
}

/// Measures a scale bar by the width of its map.
fn check_scale_bar(span: &str, says: [&str; 3]) {
    let session =
        finished(&format!("land=island&attractors=900&country=usual&seed=kauri&labels=some&style=atlas&span={span}"));
    let map = session.map().unwrap();
    let kilometres = span.parse::<f64>().unwrap() / f64::from(map.domain().size.x);
    let [half, whole] = [1, 2].map(|i| says[i].trim_end_matches(" km").parse::<f64>().unwrap());
    let (labels, _) = placed(&map, 1400.0);
    let bar = labels.iter().find(|label| label.kind == Kind::Margin).unwrap();
    let length = |stroke: &Stroke| f64::from(stroke.ends[0].distance(stroke.ends[1]));
    let longest = bar.strokes.iter().map(length).fold(0.0, f64::max);
    assert!((longest * kilometres / whole - 1.0).abs() < 1e-4, "{span}: {longest}");
    let texts: Vec<&str> =
        labels.iter().filter(|label| label.kind == Kind::Margin).map(|label| label.text.as_str()).collect();
    assert_eq!(texts, says);
    // Its numbers stand over what they tell.
    let [zero, middle] = [0, 1].map(|i| {
        let [least, most] = around(labels.iter().filter(|label| label.kind == Kind::Margin).nth(i).unwrap());
        f64::from((least.x + most.x) * 0.5)
    });
    assert!(((middle - zero) * kilometres / half - 1.0).abs() < 0.05, "{span}: {}", middle - zero);
}

#[test]
fn a_part_of_a_map_shows_a_title_or_a_scale_bar_whole_or_not_at_all() {
    let session = finished("country=usual&seed=kauri&attractors=900&labels=some");
    let map = session.map().unwrap();
    let size = map.domain().size;
    let of = |labels: &[Label], kind: Kind| labels.iter().filter(|label| label.kind == kind).count();
    let (all, _) = placed(&map, 900.0);
    let kinds = [Kind::Title, Kind::Seed, Kind::Margin];
    let whole = kinds.map(|kind| of(&all, kind));
    assert_eq!(whole, [1, 1, 3]);
    let mut seen = [0; 2];
    for step in 0..60 {
        // A window that leaves the map on one side after the other.
        let off = Vec2::new(step as f32 / 40.0 - 0.75, (step % 7) as f32 / 20.0 - 0.15) * size;
        let view = [off, off + size];
        let input = labels::input(&map, view, 900.0 / size.x).unwrap();
        let labels = place(&input, &Raster::new(&input));
        let [titles, seeds, numbers] = kinds.map(|kind| of(&labels, kind));
        assert!(titles == seeds && (numbers == 0 || numbers == whole[2]), "{off}: {titles}, {seeds}, {numbers}");
        seen[usize::from(titles + numbers > 0)] += 1;
    }
    assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
}

#[test]
fn the_plate_of_lengths_tells_those_of_the_network_the_longest_first() {
    for link in [
        "land=island&country=usual&seed=tay",
        "land=rectangle&country=usual&seed=elbe&style=survey",
        "land=continent&country=usual&seed=kauri&growth=colonize",
    ] {
        let session = finished(&format!("{link}&attractors=2000&labels=some&cartouche=lengths"));
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1600.0);
        let plate: Vec<&Label> = labels.iter().filter(|label| label.kind == Kind::Plate).collect();
        let names = Names::of(&map);
        // Straight from the places of the network.
        let network = map.network();
        let mut lengths: Vec<(f64, String)> = Vec::new();
        for (river, name) in network.rivers.iter().zip(&names.rivers) {
            let places: Vec<Vec2> = network.course(river).map(|vertex| vertex.at).collect();
            let length: f64 = places.windows(2).map(|pair| f64::from(pair[0].distance(pair[1]))).sum();
            lengths.push((length * map.scale().metres_a_unit / 1000.0, name.name.clone()));
        }
        lengths.sort_by(|a, b| b.0.total_cmp(&a.0));
        let told: Vec<&&Label> = plate.iter().filter(|label| label.river.is_some()).collect();
        assert!((8..=14).contains(&told.len()), "{link}: {} rivers", told.len());
        for (label, (length, name)) in told.iter().zip(&lengths) {
            let (called, says) = label.text.rsplit_once(", ").unwrap();
            let km: f64 = says.strip_suffix(" km").unwrap().parse().unwrap();
            assert!((km - length).abs() <= 0.6, "{link}: {} and {length}", label.text);
            assert_eq!(called, name, "{link}");
        }
        let Plate::Lengths(rivers) = input.as_ref().unwrap().map.cartouche.as_ref().unwrap().plate.as_ref().unwrap()
        else {
            unreachable!("it is the plate of lengths")
        };
        assert!(rivers.is_sorted_by(|a, b| a.kilometres >= b.kilometres), "{link}");
        // Drawn to one scale: the first is as much higher than the last as it is longer.
        let height = |label: &Label| {
            let x = label.letters[0].at.x;
            let foot = label.letters[0].at.y;
            let of_river = title(&labels).unwrap().strokes.iter().filter(|stroke| {
                let ends = stroke.ends;
                ends.iter().all(|end| end.x < x && end.x > x - 1.6 * label.em) && ends[0].y != ends[1].y
            });
            foot - of_river.flat_map(|stroke| stroke.ends).map(|end| end.y).fold(f32::MAX, f32::min)
        };
        let [first, last] = [told[1], told[told.len() - 1]].map(|label| height(label));
        let share = f64::from(last / first) / (lengths[told.len() - 1].0 / lengths[1].0);
        assert!((0.8..1.1).contains(&share), "{link}: {share}");
    }
}

#[test]
fn a_profile_never_falls_upstream_and_ends_at_the_river_s_length() {
    for link in [
        "country=usual&seed=tay&style=ink",
        "country=usual&seed=elbe&land=continent&style=atlas",
        "country=usual&seed=kauri&growth=colonize&style=atlas",
    ] {
        let session = finished(&format!("{link}&attractors=2000&labels=some&cartouche=profile"));
        let map = session.map().unwrap();
        let (labels, input) = placed(&map, 1600.0);
        let cartouche = input.as_ref().unwrap().map.cartouche.as_ref().unwrap();
        let Some(Plate::Profile(profile)) = &cartouche.plate else { unreachable!("{link}: it has heights") };
        assert!(profile.heights.is_sorted() && *profile.heights.last().unwrap() > 10.0, "{link}");
        let network = map.network();
        let greatest = network.rivers.iter().map(|river| network.discharge(river)).max().unwrap();
        assert_eq!(network.discharge(&network.rivers[profile.river as usize]), greatest, "{link}");
        let length = map.scale().kilometres(network.length(&network.rivers[profile.river as usize]));
        let says = format!("{} km", figures(length));
        assert!(labels.iter().any(|label| label.kind == Kind::Plate && label.text == says), "{link}: {says}");
        let joining = network.rivers.iter().filter(|river| river.parent == profile.river).count();
        assert_eq!(profile.tributaries.len(), joining, "{link}");
        assert!(profile.tributaries.iter().all(|tributary| (0.0..=1.0).contains(&tributary.share)), "{link}");
        assert!(joining == 0 || profile.tributaries.iter().any(|tributary| !tributary.name.is_empty()), "{link}");
    }
    // Without heights, and where there is no room, the title stands alone.
    let session =
        finished("country=usual&seed=kauri&growth=colonize&style=ink&attractors=900&labels=some&cartouche=profile");
    let map = session.map().unwrap();
    let (labels, _) = placed(&map, 1400.0);
    assert!(title(&labels).is_some() && labels.iter().all(|label| label.kind != Kind::Plate));
}

#[test]
fn plates_and_titles_stay_within_the_map_and_apart_from_all_else_with_any_title() {
    let titles =
        ["W".repeat(40), "Ål".to_owned(), String::new(), "\u{1f30a}\u{1f30a}".to_owned(), "\u{6771}\u{4eac}".into()];
    for cartouche in ["auto", "framed", "lengths", "profile"] {
        for (title, style) in
            titles.iter().zip([Style::Atlas, Style::Parchment, Style::Survey, Style::Ink, Style::Blueprint])
        {
            let mut recipe = link::read(&format!(
                "land=island&attractors=900&country=usual&seed=kea&labels=many&cartouche={cartouche}"
            ))
            .unwrap();
            recipe.set(Key::Style, style.word().name).unwrap();
            recipe.set(Key::Names, &format!("t.{title}")).unwrap();
            let mut session = Session::new(recipe).unwrap();
            session.finish().unwrap();
            let map = session.map().unwrap();
            for width in [200.0, 370.0, 1400.0] {
                check(&map, width, &format!("{title} {style:?} {cartouche} {width}"));
            }
        }
    }
}

/// The letters and lines of the cartouche are within the map, and no other label stands among them.
fn check(map: &Map, width: f32, context: &str) {
    let (labels, input) = placed(map, width);
    let [least, most] = input.as_ref().unwrap().frame;
    let (own, others): (Vec<&Label>, Vec<&Label>) = labels.iter().partition(|label| label.kind.is_of_cartouche());
    for label in own {
        let letters = around(label);
        let strokes = label.strokes.iter().flat_map(|stroke| stroke.ends);
        for at in strokes.clone().chain(letters) {
            assert!(at.cmpge(least).all() && at.cmple(most).all(), "{context}: {} leaves the map", label.text);
        }
        let [from, to] = strokes.fold(letters, |[from, to], at| [from.min(at), to.max(at)]);
        for other in others.iter().filter(|other| !other.letters.is_empty()) {
            let [a, b] = around(other);
            let meet = other.letters.iter().flat_map(|letter| letter.around(other.em).corners());
            let is_within = |at: Vec2| at.cmpgt(from).all() && at.cmplt(to).all();
            assert!(!meet.into_iter().any(is_within), "{context}: {} [{a} {b}] is under {}", other.text, label.text);
        }
    }
}
