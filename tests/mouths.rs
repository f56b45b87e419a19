//! Mouths of rivers in pictures: the line of the coast is open, and the river's water is the sea's or turns into it.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::svg_ids::without_number;
use riverseed::glam::Vec2;
use riverseed::paint::Framing;
use riverseed::recipe::{Choice, Style};
use riverseed::{Picture, Session};

const LINK: &str =
    "country=usual&seed=leven&attractors=3000&land=island&sea=0.55&width=16&meander=none&bank-variation=0";

/// A distance from the coast at which there is nothing but the sea, in units: its line has ended and no ring has begun. Where
/// beaches sink into the sea, that is farther.
const OFFSHORE: f32 = 1.4;

fn finished(link: &str) -> Session {
    let mut session = Session::new(link.parse().unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// The mouth of the widest river: a point of the coast, the way to the sea, and the river's width.
fn widest_mouth(session: &Session) -> (Vec2, Vec2, f32) {
    let network = session.network().unwrap();
    let width = |id: u32| network.vertices[network.rivers[id as usize].end as usize - 1].width();
    let widest = network.mouths().into_iter().max_by(|a, b| width(*a).total_cmp(&width(*b))).unwrap();
    let at = network.vertices[network.rivers[widest as usize].end as usize - 1].at;
    let distance = session.land().unwrap().coast_distance();
    let seaward = -distance.slope(at).normalize();
    (at + seaward * distance.height(at), seaward, width(widest))
}

/// The place so far up the river whose mouth is nearest to a point of the coast.
fn above_mouth(session: &Session, mouth: Vec2, far: f32) -> Vec2 {
    let network = session.network().unwrap();
    let course = |id: u32| {
        let river = &network.rivers[id as usize];
        network.vertices[river.start as usize..river.end as usize].iter().rev().map(|vertex| vertex.at)
    };
    let end = |id: u32| course(id).next().unwrap();
    let nearest =
        network.mouths().into_iter().min_by(|a, b| end(*a).distance(mouth).total_cmp(&end(*b).distance(mouth)));
    let (mut left, mut below) = (far, mouth);
    for at in course(nearest.unwrap()) {
        let step = below.distance(at);
        if step >= left {
            return below.lerp(at, left / step);
        }
        (left, below) = (left - step, at);
    }
    below
}

/// A picture of the surroundings of a point, 12 pixels for each unit.
struct Close {
    picture: Picture,
}

impl Close {
    fn of(session: &Session, at: Vec2) -> Self {
        const SIDE: u32 = 760;
        let size = session.domain().size;
        let across = SIDE as f32 / 12.0 / size.x;
        let corner = at / size.x - across / 2.0;
        let mut picture = Picture::new(SIDE, SIDE).unwrap();
        picture.frame(session, Framing::new(corner.x, corner.y, across));
        picture.paint(session);
        Self { picture }
    }

    fn pixel(&self, at: Vec2) -> [u8; 4] {
        let pixmap = self.picture.pixmap();
        let at = self.picture.view().pixel(at);
        let i = (at.y as usize * pixmap.width() as usize + at.x as usize) * 4;
        pixmap.data()[i..i + 4].try_into().unwrap()
    }

    /// The mean of the pixels around a point, in which the grain of paper is gone.
    fn mean(&self, at: Vec2) -> [u8; 4] {
        const FAR: i32 = 3;
        let pixel = |i: i32| {
            let (x, y) = (i % (2 * FAR + 1) - FAR, i / (2 * FAR + 1) - FAR);
            self.pixel(at + Vec2::new(x as f32, y as f32) / 12.0)
        };
        let pixels: Vec<[u8; 4]> = (0..(2 * FAR + 1).pow(2)).map(pixel).collect();
        std::array::from_fn(|k| {
            let sum: u32 = pixels.iter().map(|pixel| u32::from(pixel[k])).sum();
            (sum / pixels.len() as u32) as u8
        })
    }
}

fn apart(a: [u8; 4], b: [u8; 4]) -> i32 {
    (0..3).map(|i| (i32::from(a[i]) - i32::from(b[i])).abs()).sum()
}

/// The point of the coast, as it is drawn, that lies so far beside another.
fn along_coast(shown: impl Fn(Vec2) -> f32, at: Vec2, seaward: Vec2, aside: f32) -> Vec2 {
    let at = at + seaward.perp() * aside;
    at + seaward * shown(at)
}

#[test]
fn the_line_of_the_coast_is_open_across_a_river_in_all_styles() {
    for &style in Style::ALL.iter().filter(|style| **style != Style::Skeleton) {
        let session = finished(&format!("{LINK}&style={}", style.word().name));
        let (at, seaward, width) = widest_mouth(&session);
        let distance = session.land().unwrap().coast_distance();
        let close = Close::of(&session, at);
        let coast = |aside: f32| close.pixel(along_coast(|at| distance.height(at), at, seaward, aside * width));
        let offshore = if style == Style::Orbit { 8.0 } else { OFFSHORE };
        let sea = close.pixel(at + seaward * offshore);
        for tenth in -3..=3 {
            let here = coast(tenth as f32 * 0.1);
            assert!(apart(here, sea) < 24, "{style:?}: {here:?} is not the sea, {sea:?}, at {tenth}");
        }
        // Beside the river it is closed. Its line is thin in so close a picture, and a little off the corners' coast.
        for aside in [-1.2, 1.2] {
            let coast = along_coast(|at| distance.height(at), at, seaward, aside * width);
            let across = |tenth: i32| close.pixel(coast + seaward * (tenth as f32 * 0.1));
            let is_line = |pixel: [u8; 4]| apart(pixel, sea) > 30 && apart(pixel, across(-40)) > 30;
            assert!((-15..=15).map(across).any(is_line), "{style:?}: the line of the coast is open beside the river");
        }
    }
}

/// The end of the widest branch of a delta: a point of the coast, the way to the sea, and its width.
fn widest_tip(session: &Session) -> (Vec2, Vec2, f32) {
    let deltas = session.deltas().unwrap();
    let tips = deltas.distributaries.iter().filter(|branch| branch.reaches_sea);
    let place = |branch: &riverseed::deltas::Distributary| *branch.line.last().unwrap();
    let end = tips.map(place).max_by(|a, b| a.half.total_cmp(&b.half)).unwrap();
    let distance = session.land().unwrap().coast_distance();
    let seaward = -distance.slope(end.at).normalize();
    (end.at + seaward * distance.height(end.at), seaward, 2.0 * end.half)
}

#[test]
fn branches_of_a_delta_open_the_line_of_the_coast() {
    for style in OPEN {
        let session = finished(&format!("seed=Veldemar&deltas=0.5&labels=none&style={style}"));
        let (at, seaward, width) = widest_tip(&session);
        assert!(width > 5.0, "{width}");
        let distance = session.land().unwrap().coast_distance();
        let close = Close::of(&session, at);
        let sea = close.mean(at + seaward * OFFSHORE);
        for tenth in -1..=1 {
            let aside = tenth as f32 * 0.1 * width;
            let here = close.mean(along_coast(|at| distance.height(at), at, seaward, aside));
            assert!(apart(here, sea) < 24, "{style}: {here:?} is not the sea, {sea:?}, at {tenth}");
        }
    }
}

#[test]
fn a_river_turns_into_the_sea_within_its_mouth() {
    for style in ["dark", "night", "blueprint", "basins"] {
        let session = finished(&format!("{LINK}&style={style}"));
        let (at, seaward, width) = widest_mouth(&session);
        let close = Close::of(&session, at);
        let upstream = |widths: f32| close.pixel(above_mouth(&session, at, widths * width));
        let [river, above, mouth] = [3.0, 2.4, 0.2].map(upstream);
        let sea = close.pixel(at + seaward * OFFSHORE);
        assert!(apart(mouth, sea) * 8 < apart(river, sea), "{style}: {river:?}, {mouth:?}, {sea:?}");
        assert!(apart(above, river) * 8 < apart(river, sea), "{style}: {river:?}, {above:?}, {sea:?}");
    }
}

/// Styles whose wide rivers are two banks with water between.
const OPEN: [&str; 6] = ["ink", "atlas", "survey", "parchment", "past-courses", "ink-wash"];

#[test]
fn between_the_banks_of_a_wide_river_is_the_water_of_the_sea() {
    for style in OPEN {
        let session = finished(&format!("{LINK}&style={style}&labels=none&woods=0&hills=0"));
        let (at, seaward, width) = widest_mouth(&session);
        let close = Close::of(&session, at);
        let sea = close.pixel(at + seaward * OFFSHORE);
        for tenth in 0..20 {
            let at = above_mouth(&session, at, tenth as f32 * 0.1 * width);
            // Paper is uneven, but it does not jump.
            assert!(
                apart(close.pixel(at), sea) < 24,
                "{style}: {:?} is not the sea, {sea:?}, at {tenth}",
                close.pixel(at)
            );
        }
        // Two banks, one on either side, are all that crosses the way over the river.
        let [below, middle] = [1.4, 1.5].map(|widths| above_mouth(&session, at, widths * width));
        let aside = (middle - below).perp().normalize();
        for side in [-1.0, 1.0] {
            let dark = (0..12).map(|step| close.pixel(middle + aside * (side * (0.38 + step as f32 * 0.015) * width)));
            let darkest = dark.map(|pixel| apart(pixel, sea)).max().unwrap();
            assert!(darkest > 60, "{style}: no bank, {darkest}");
        }
    }
}

#[test]
fn in_files_the_water_of_all_rivers_lies_over_all_banks() {
    for style in OPEN {
        let svg = without_number(
            &riverseed::export::svg::svg(&finished(&format!("{LINK}&style={style}")).map().unwrap()).unwrap(),
        );
        let places = ["<g id=\"rivers\"", "<path id=\"river-", "<g id=\"water\"", "<use href=\"#coast\" fill=\"none\""]
            .map(|part| svg.rfind(part).unwrap_or(0));
        assert!(places[0] > 0 && places.is_sorted(), "{style}: {places:?}");
        assert!(!svg.contains("radialGradient"), "{style}: something is handed over");
    }
    let closed = riverseed::export::svg::svg(&finished(&format!("{LINK}&style=night")).map().unwrap()).unwrap();
    assert!(!closed.contains("<g id=\"water\"") && closed.contains("radialGradient"));
}

#[test]
fn the_sea_in_a_mouth_is_cut_out_with_the_sea() {
    for style in ["atlas", "orbit", "past-courses"] {
        let session = finished(&format!("{LINK}&style={style}"));
        let (at, seaward, width) = widest_mouth(&session);
        let mut close = Close::of(&session, at);
        close.picture.cut_out(&session);
        let opacity = [0.0, -0.3, -3.0].map(|widths| close.pixel(at + seaward * (widths * width))[3]);
        assert!(opacity[0] < 3 && opacity[1] < 40 && opacity[2] == 255, "{style}: {opacity:?}");
    }
}

#[test]
fn a_brook_ends_in_the_line_of_the_coast() {
    let session =
        finished("country=usual&seed=leven&attractors=3000&land=island&roughness=0.2&drowning=0&width=1.5&style=ink");
    let (at, seaward, _) = widest_mouth(&session);
    let close = Close::of(&session, at);
    let distance = session.land().unwrap().coast_distance();
    let [here, aside] = [0.0, 4.0].map(|aside| close.pixel(along_coast(|at| distance.height(at), at, seaward, aside)));
    assert!(apart(here, aside) < 12, "{here:?} in {aside:?}");
}

#[test]
fn a_river_that_leaves_the_map_at_its_frame_has_no_mouth() {
    let svg = |link: &str| riverseed::export::svg::svg(&finished(link).map().unwrap()).unwrap();
    assert!(svg(LINK).contains("id=\"mouths\""));
    assert!(!svg(&LINK.replace("island", "rectangle")).contains("id=\"mouths\""));
}

#[test]
fn in_files_the_line_of_the_coast_lies_over_rivers_and_mouths_lie_over_the_line() {
    for style in ["ink", "atlas", "past-courses"] {
        let session = finished(&format!("{LINK}&style={style}"));
        let svg = without_number(&riverseed::export::svg::svg(&session.map().unwrap()).unwrap());
        let places = ["<g id=\"rivers\"", "<use href=\"#coast\" fill=\"none\"", "<g id=\"mouths\""]
            .map(|part| svg.rfind(part).unwrap_or(0));
        assert!(places[0] > 0 && places.is_sorted(), "{style}: {places:?}");
        let (at, ..) = widest_mouth(&session);
        let document = roxmltree::Document::parse(&svg).unwrap();
        let mouths = document.descendants().find(|node| node.attribute("id") == Some("mouths")).unwrap();
        // Each begins a river's width or two inland.
        let is_here = |data: &str| {
            let start = data.trim_start_matches('M').split(|c: char| c.is_ascii_alphabetic()).next().unwrap();
            let (x, y) = start.split_once([' ', '-']).unwrap();
            Vec2::new(x.parse().unwrap(), y.parse().unwrap()).distance(at) < 60.0
        };
        assert!(mouths.descendants().filter_map(|node| node.attribute("d")).any(is_here), "{style}: {at}");
    }
}
