//! Names of ranges stand on high ground between rivers, and not across them.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fmt;

use crate::common::finished;
use crate::common::tier::{Tier, tiers};
use glam::Vec2;
use riverseed::Session;
use riverseed::annotate::labels;
use riverseed::annotate::names::PlaceKind;
use riverseed::annotate::place::{Input, Kind, Label, Raster, place};
use riverseed::relief::Relief;

/// Words whose maps are measured: the first few in the first tier.
const WORDS: [&str; 12] = [
    "Thornwick",
    "Quill",
    "kauri",
    "Veldemar",
    "tay",
    "Ardenmoor",
    "rimu",
    "galicia",
    "Otter",
    "Kestrel",
    "Saltmarsh",
    "kea",
];

/// The height of a capital, in ems.
const CAPITAL: f32 = 0.65;

/// A count of names of ranges.
#[derive(Default)]
struct Count {
    /// Those on maps.
    labels: usize,
    /// Those that cross a river in mid-course.
    crossing: usize,
    /// The ground under each, as a share of the highest near.
    ground: f32,
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ground = self.ground / self.labels as f32;
        write!(f, "{} of {} cross a river, the ground is {ground:.3} of the highest near", self.crossing, self.labels)
    }
}

/// Returns the middles of the letters of a label.
fn middles(label: &Label) -> Vec<Vec2> {
    let middle = |x: f32| Vec2::new(0.5 * x, -0.5 * CAPITAL);
    label.letters.iter().map(|letter| letter.place(middle(letter.glyph.advance), label.em)).collect()
}

/// Returns `true` if the band of some letters holds a point of a river that is more than 25 units below its source.
fn crosses_river(middles: &[Vec2], half: f32, input: &Input<'_>) -> bool {
    let is_in_band = |at: Vec2| {
        middles.windows(2).any(|pair| {
            let (along, out) = (pair[1] - pair[0], at - pair[0]);
            let share = (out.dot(along) / along.length_squared()).clamp(0.0, 1.0);
            out.distance(along * share) <= half
        })
    };
    input.map.courses.iter().any(|course| {
        let mut below = 0.0;
        course.windows(2).any(|pair| {
            let [from, to] = [pair[0].at, pair[1].at];
            below += from.distance(to);
            let count = from.distance(to).ceil().max(1.0);
            below > 25.0 && (0..=count as u32).any(|i| is_in_band(from.lerp(to, i as f32 / count)))
        })
    })
}

/// Returns the mean height of some places, as shares of the highest within 20 units of each.
fn ground(places: &[Vec2], relief: &Relief) -> f32 {
    const NEAR: f32 = 20.0;
    let steps = || (-10..=10).map(|i| i as f32 * 0.1 * NEAR);
    let around = || steps().flat_map(|y| steps().map(move |x| Vec2::new(x, y))).filter(|off| off.length() <= NEAR);
    let share = |&at: &Vec2| relief.at(at) / around().map(|off| relief.at(at + off)).fold(relief.at(at), f32::max);
    places.iter().map(share).sum::<f32>() / places.len() as f32
}

/// Counts the names of ranges on a map.
fn count(session: &Session, count: &mut Count) {
    let map = session.map().unwrap();
    let size = map.domain().size;
    let input = labels::input(&map, [Vec2::ZERO, size], 1400.0 / size.x).unwrap();
    let places = input.map.names.places.iter().filter(|place| place.kind == PlaceKind::Range);
    let names: Vec<&str> = places.map(|place| place.name.as_str()).collect();
    for label in place(&input, &Raster::new(&input)).iter().filter(|label| label.kind == Kind::Region) {
        if names.iter().any(|name| name.strip_prefix("The ").unwrap_or(name) == label.text) {
            let middles = middles(label);
            count.labels += 1;
            count.crossing += usize::from(crosses_river(&middles, 0.5 * CAPITAL * label.em, &input));
            count.ground += ground(&middles, map.shown_relief().unwrap());
        }
    }
}

fn names_of_ranges_stand_on_high_ground_and_cross_no_rivers() {
    let is_first = Tier::here() == Tier::First;
    let words = if is_first { &WORDS[..4] } else { &WORDS[..] };
    for (land, least) in LEAST_GROUND {
        let mut all = Count::default();
        for word in words {
            count(&finished(&format!("country=usual&seed={word}&land={land}&style=atlas&labels=some"), ""), &mut all);
        }
        println!("{land}: {all}");
        assert!(all.labels >= words.len() / 2, "{land}: {all}");
        // A few names say little: those of four maps are on the lowest ground of twelve.
        let (most, least) = if is_first { (2, least - 0.04) } else { (all.labels * 2 / 7, least) };
        assert!(all.crossing <= most, "{land}: {all}");
        assert!(all.ground >= least * all.labels as f32, "{land}: {all}");
    }
}

/// The least height under names on a land, as a share of the highest ground within 20 units. Letters are taller than crests are wide.
const LEAST_GROUND: [(&str, f32); 2] = [("island", 0.75), ("continent", 0.80)];

tiers!(names_of_ranges_stand_on_high_ground_and_cross_no_rivers);
