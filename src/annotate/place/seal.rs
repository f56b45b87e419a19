//! The seal: a small square near a corner, out of which letters are left, as painters stamp it.

use glam::Vec2;

use super::background::Background;
use super::corner::{self, Corner};
use super::input::{Input, Seal};
use super::letters::{Box, Kind, Label, Placed, Stroke, Text};
use crate::base::random::{ItemHash, Purpose};

/// The side of the square, as a share of the map's shorter side, and in ems of the smallest letters at least, for one letter and for two.
const SIDE: f32 = 0.04;
const LEAST: [f32; 2] = [1.7, 2.2];
/// The greatest share of the map's shorter side: where the seal would be larger there is none.
const MOST: f32 = 0.12;
/// The distance of the seal from the frame, and from other labels, in sides.
const FROM_FRAME: f32 = 0.9;
const FROM_LABELS: f32 = 0.5;
/// The number of steps from the corners in which places are tried, and the length of a step, in sides.
const STEPS: u32 = 12;
const STEP: f32 = 0.75;
/// The greatest size of its letters, and the width that they take up, in sides.
const EM: f32 = 0.98;
const LETTERS: f32 = 0.74;

/// The unevenness of its edge, half the width of its strokes, and the distance between these, in sides.
const UNEVEN: f32 = 0.05;
const HALF: f32 = 0.06;
const APART: f32 = 0.08;
/// The number of strokes of a side of its edge.
const EDGE: u32 = 6;

/// Puts the seal near the corner with the most sea, off the labels that there are. With the box around it; `None` if there is no room.
pub fn set<G: Background>(
    input: &Input<'_>,
    background: &G,
    seal: &Seal,
    taken: &[(u32, Box)],
) -> Option<(Label, Box)> {
    let text = Text::new(&seal.letters, Kind::Seal);
    let least = LEAST[usize::from(text.letters.len() > 1)] * input.least_em;
    let shorter = (input.frame[1] - input.frame[0]).min_element();
    let side = (SIDE * shorter).max(least);
    if side > MOST * shorter {
        return None;
    }
    let at = place(input, background, side, taken)?;
    let em = EM.min(LETTERS / text.length.max(0.1)) * side;
    let mut letters: Vec<Placed> = text.level(Vec2::ZERO, em);
    let corners = letters.iter().flat_map(|letter| letter.around(em).corners());
    let (least, most) = corners.fold((Vec2::MAX, Vec2::MIN), |(least, most), at| (least.min(at), most.max(at)));
    let middle = at + 0.5 * side - (least + most) * 0.5;
    letters.iter_mut().for_each(|letter| letter.at += middle);
    let mut label = Label::new(Kind::Seal, None, &seal.letters, em, letters);
    label.strokes = square(at, side, seal.seed.item_hash(Purpose::Names));
    Some((label, Box::level(at, at + side)))
}

/// Returns the first place that is all sea, from the corners on along the frame; else the first that is off rivers and coasts.
fn place<G: Background>(input: &Input<'_>, background: &G, side: f32, taken: &[(u32, Box)]) -> Option<Vec2> {
    let size = Vec2::splat(side);
    let places = |step: u32| {
        let corners = corner::corners(input, size, FROM_FRAME * side);
        let middle = (input.frame[0] + input.frame[1] - size) * 0.5;
        let off = STEP * side * step as f32;
        let moved = corners.into_iter().flat_map(move |at| {
            let inward = (middle - at).clamp(Vec2::splat(-off), Vec2::splat(off));
            [Vec2::new(inward.x, 0.0), Vec2::new(0.0, inward.y)].map(|by| at + by)
        });
        let is_free = |at: &Vec2| {
            let around = Box::level(*at, *at + size);
            !taken.iter().any(|(_, other)| around.meets(other, FROM_LABELS * side))
        };
        moved.filter(is_free).map(|at| corner::judged(input, background, at, size, 0.25 * side)).collect::<Vec<_>>()
    };
    let all: Vec<Vec<Corner>> = (0..STEPS).map(places).collect();
    let first = |is_fit: &dyn Fn(&Corner) -> bool| {
        all.iter().find_map(|places| corner::best_of(places.iter().copied().filter(is_fit)))
    };
    let is_sea = |place: &Corner| place.sea == 1.0;
    let is_bare = |place: &Corner| place.ink == 0.0 && is_off_coast(input, place.at, side);
    first(&is_sea).or_else(|| first(&is_bare)).map(|place| place.at)
}

/// Returns `true` if all of a square and its surroundings are land.
fn is_off_coast(input: &Input<'_>, at: Vec2, side: f32) -> bool {
    input.map.coast().is_none_or(|coast| coast.height(at + 0.5 * side) >= side)
}

/// Draws a square with an uneven edge, of strokes.
fn square(at: Vec2, side: f32, chance: ItemHash) -> Vec<Stroke> {
    let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let count = 4 * EDGE;
    let point = |i: u32| {
        let (from, to) = (corners[(i / EDGE % 4) as usize], corners[(i / EDGE + 1) as usize % 4]);
        let on_edge = from.lerp(to, (i % EDGE) as f32 / EDGE as f32);
        let by = |axis: u32| (chance.unit([i % count, axis, SEAL]) - 0.5) * UNEVEN;
        // Corners are rounded off, besides.
        let inward = if i.is_multiple_of(EDGE) { HALF + 0.03 } else { HALF };
        at + (0.5 + (on_edge - 0.5) * (1.0 - 2.0 * inward) + Vec2::new(by(0), by(1))) * side
    };
    let edge = (0..count).map(|i| Stroke { ends: [point(i), point(i + 1)], half: HALF * side });
    let rows = ((1.0 - 4.0 * HALF) / APART) as u32 + 1;
    let row = |i: u32| {
        let y = 2.0 * HALF + (1.0 - 4.0 * HALF) * i as f32 / rows as f32;
        Stroke { ends: [2.0 * HALF, 1.0 - 2.0 * HALF].map(|x| at + Vec2::new(x, y) * side), half: HALF * side }
    };
    edge.chain((0..=rows).map(row)).collect()
}

/// The item of chances of the seal's edge; those of words have other numbers.
const SEAL: u32 = 1 << 16;
