//! Plates: panels with figures about the rivers under the map's title, in the largest free part of the sea.

use glam::Vec2;

use super::anchor;
use super::background::Background;
use super::corner;
use super::frames;
use super::input::{Cartouche, Input, Plate};
use super::letters::{Box, Label};
use super::panel::Panel;
use super::{lengths, profile};

/// The length of the em of its letters, in units.
const EM: f32 = 11.0;
/// The widths of plates that are tried, the first that fits, as shares of the side of a square as large as the map; and the number of the
/// one that a plate on land has.
const WIDTHS: [f32; 7] = [0.53, 0.48, 0.43, 0.38, 0.34, 0.3, 0.265];
const ON_LAND: usize = 3;
/// The greatest width and height of a plate, as shares of the map's.
const MOST: [f32; 2] = [0.9, 0.7];
/// The distance between places that are tried, and the least one from the coast, in units.
const STEP: f32 = 20.0;
const FROM_COAST: f32 = 5.0;
/// The greatest number of places that are tried side by side, in frames that show much more than the map.
const MOST_STEPS: f32 = 60.0;

/// A plate in its place.
pub struct Set {
    pub labels: Vec<Label>,
    pub around: Box,
}

/// Puts a plate into the largest free part of the sea, or into a corner of the land. `None` if there is no room, or if its letters would
/// be too small to be read.
pub fn set<G: Background>(input: &Input<'_>, background: &G, cartouche: &Cartouche, plate: &Plate) -> Option<Set> {
    let aspect = match plate {
        Plate::Lengths(_) => 1.38,
        Plate::Profile(_) => 2.1,
    };
    let [at, size] = place(input, background, aspect)?;
    let [least, most] = input.inner_frame();
    let at = at.max(least).min(most - size);
    let em = (EM * input.label_size.min(1.2)).max(input.least());
    let mut panel = Panel::new(at, size, em, cartouche, plate)?;
    let is_drawn = match plate {
        Plate::Lengths(rivers) => lengths::draw(&mut panel, rivers),
        Plate::Profile(profile) => profile::draw(&mut panel, profile),
    };
    let mut labels = panel.labels;
    let first = labels.first_mut().filter(|_| is_drawn)?;
    first.strokes = frames::strokes(cartouche.frame, at, size, em);
    first.strokes.extend(panel.strokes);
    first.cleared = corner::filled(at, size, 0.3 * em);
    Some(Set { labels, around: Box::level(at, at + size) })
}

/// Returns the upper left corner and the size of the largest plate that fits; the same in pictures of all sizes.
fn place<G: Background>(input: &Input<'_>, background: &G, aspect: f32) -> Option<[Vec2; 2]> {
    let [least, most] = input.frame;
    let room = most - least;
    let sizes = WIDTHS.map(|share| {
        let width = (share * (room.x * room.y).sqrt()).min(MOST[0] * room.x).min(MOST[1] * room.y * aspect);
        Vec2::new(width, width / aspect)
    });
    let at_sea = || sizes.iter().find_map(|&size| Some([at_sea(input, [least, most], size)?, size]));
    let size = sizes[ON_LAND];
    at_sea().or_else(|| Some([corner::best(input, background, size, EM, &[])?.at, size]))
}

/// Returns the place at sea for a block that is nearest to a corner; `None` if there is none.
fn at_sea(input: &Input<'_>, frame: [Vec2; 2], size: Vec2) -> Option<Vec2> {
    let corners = [0, 1, 2, 3].map(|i| anchor::Anchor::ALL[i].place(frame, size));
    let room = corners[3] - corners[0];
    if room.min_element() < 0.0 {
        return None;
    }
    let counts = (room / STEP).ceil().max(Vec2::ONE).min(Vec2::splat(MOST_STEPS));
    let places = (0..=counts.y as u32).flat_map(|row| (0..=counts.x as u32).map(move |column| (column, row)));
    let places = places.map(|(column, row)| corners[0] + Vec2::new(column as f32, row as f32) / counts * room);
    let from_corner = |at: Vec2| corners.iter().map(|corner| (*corner - at).length_squared()).fold(f32::MAX, f32::min);
    let mut best: Option<(f32, Vec2)> = None;
    for at in places {
        let off = from_corner(at);
        if best.is_none_or(|(least, _)| off < least) && anchor::is_open(input, at, size, FROM_COAST) {
            best = Some((off, at));
        }
    }
    best.map(|(_, at)| at)
}
