//! The corners of a map, for blocks of lines: which is the best, and the frame around one.

use glam::Vec2;

use super::background::Background;
use super::input::Input;
use super::letters::{Box, Stroke};

/// The distance of a block from the frame, and from the coast where it is on the sea, in ems.
const FROM_FRAME: f32 = 0.7;
const FROM_COAST: f32 = 0.3;

/// Half the widths of the double line around a block, outside and inside, and the distance of the inner line from the outer, in ems.
const RULES: [f32; 2] = [0.035, 0.014];
const BETWEEN_RULES: f32 = 0.14;

/// A place that a block may stand in.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// The place of the block's upper left corner.
    pub at: Vec2,
    /// The share of the block that is sea.
    pub sea: f32,
    /// The amount of ink under the block.
    pub ink: f32,
    /// Its distance from the coast, on average, in ems.
    off: f32,
}

impl Corner {
    /// Returns `true` if there is more sea under it, or as much and less ink.
    pub fn is_better_than(&self, other: &Self) -> bool {
        let order = self.sea.total_cmp(&other.sea).then(other.ink.total_cmp(&self.ink));
        order.then(self.off.total_cmp(&other.off)).is_gt()
    }
}

/// Returns the best of the four corners for a block of a size with letters of a size; `None` if all are taken.
pub fn best<G: Background>(
    input: &Input<'_>,
    background: &G,
    size: Vec2,
    em: f32,
    taken: &[(u32, Box)],
) -> Option<Corner> {
    best_of(corners(input, size, FROM_FRAME * em).into_iter().filter_map(|at| {
        let around = Box::level(at, at + size);
        let is_free = !taken.iter().any(|(_, other)| around.meets(other, FROM_FRAME * em));
        is_free.then(|| judged(input, background, at, size, em))
    }))
}

/// Returns the best of some places, the first of equals.
pub fn best_of(places: impl Iterator<Item = Corner>) -> Option<Corner> {
    places.reduce(|best, next| if next.is_better_than(&best) { next } else { best })
}

/// Returns the places of a block in the four corners of the frame, with a margin.
pub fn corners(input: &Input<'_>, size: Vec2, margin: f32) -> [Vec2; 4] {
    let [least, most] = input.frame;
    let (least, most) = (least + margin, most - margin - size);
    [least, Vec2::new(most.x, least.y), Vec2::new(least.x, most.y), most]
}

/// Judges a place by what lies under a block there, at points an em apart or less.
pub fn judged<G: Background>(input: &Input<'_>, background: &G, at: Vec2, size: Vec2, em: f32) -> Corner {
    const FAR: f32 = 4.0;
    const MOST_POINTS: f32 = 128.0;
    // In a frame that shows hardly any of the map letters are next to nothing.
    let counts = (size / (0.8 * em)).ceil().min(Vec2::splat(MOST_POINTS));
    let (mut sea, mut ink, mut off) = (0.0, 0.0, 0.0);
    for (row, column) in (0..=counts.y as u32).flat_map(|row| (0..=counts.x as u32).map(move |column| (row, column))) {
        let point = at + Vec2::new(column as f32, row as f32) / counts * size;
        let depth = input.map.sea.map_or(f32::MIN, |coast| -coast.height(point) / em);
        sea += if depth >= FROM_COAST { 1.0 } else { 0.0 };
        off += depth.clamp(0.0, FAR);
        let width = background.ink(point).width;
        ink += if width > 0.0 { 1.0 + width.min(20.0) } else { 0.0 };
    }
    let points = (counts.x + 1.0) * (counts.y + 1.0);
    Corner { at, sea: sea / points, ink, off: off / points }
}

/// Draws the double line around a block.
pub fn rules(at: Vec2, size: Vec2, em: f32) -> Vec<Stroke> {
    let rule = |(half, inward): (f32, f32)| {
        let [inward, half] = [inward, half].map(|ems| ems * em);
        let (least, most) = (at + inward, at + size - inward);
        let corners = [least, Vec2::new(most.x, least.y), most, Vec2::new(least.x, most.y)];
        [0, 1, 2, 3].map(|i| Stroke { ends: [corners[i], corners[(i + 1) % 4]], half })
    };
    [(RULES[0], RULES[0]), (RULES[1], BETWEEN_RULES)].into_iter().flat_map(rule).collect()
}

/// Fills a block with lines of a half width, row by row.
pub fn filled(at: Vec2, size: Vec2, half: f32) -> Vec<Stroke> {
    let rows = ((size.y - 2.0 * half) / half).ceil().max(1.0);
    let row = |row: u32| {
        let y = half + (size.y - 2.0 * half) * row as f32 / rows;
        Stroke { ends: [half, size.x - half].map(|x| at + Vec2::new(x, y)), half }
    };
    (0..=rows as u32).map(row).collect()
}
