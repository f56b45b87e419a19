//! Areas of the third colour: those too wide to be lines are traced around, and nothing grows within.

use super::contour;
use super::ground::Ground;
use glam::Vec2;

/// The greatest width of a line is the picture's longer side, in blocks, over this;
const OF_THE_PICTURE: usize = 32;
/// in small pictures, this many blocks.
const WIDEST_LINE: usize = 6;

/// Takes all that is connected with a wide place out of the ridges. Returns the lines around it, closed: their last
/// point is their first.
pub(super) fn take_out(ground: &Ground, ridges: &mut [u8]) -> Vec<Vec<Vec2>> {
    let widest = (ground.columns.max(ground.rows) / OF_THE_PICTURE).max(WIDEST_LINE);
    let mut core = ridges.to_vec();
    (0..widest.div_ceil(2)).for_each(|round| erode(&mut core, ground.columns, round % 2 == 0));
    let mut found: Vec<usize> = (0..core.len()).filter(|&i| core[i] != 0).collect();
    if found.is_empty() {
        return Vec::new();
    }
    let mut area = vec![0.0; ridges.len()];
    while let Some(i) = found.pop() {
        if std::mem::take(&mut ridges[i]) != 0 {
            area[i] = 1.0;
            found.extend(around(i, ground.columns, ridges.len()));
        }
    }
    contour::rings(&ground.with_land(&area)).into_iter().map(closed).collect()
}

/// Takes the outermost blocks away: those that share a side, or a corner too, with a block outside. Both in turn wear
/// straight and slanting edges alike.
fn erode(mask: &mut [u8], columns: usize, by_corners: bool) {
    let before = mask.to_vec();
    let is_within = |i: usize| {
        let beside = around(i, columns, before.len());
        let wanted = if by_corners { 8 } else { 4 };
        beside
            .filter(|&j| before[j] != 0 && (by_corners || j % columns == i % columns || j / columns == i / columns))
            .count()
            == wanted
    };
    for (i, block) in mask.iter_mut().enumerate() {
        *block = u8::from(*block != 0 && is_within(i));
    }
}

/// The blocks around one, as far as there are any.
fn around(i: usize, columns: usize, count: usize) -> impl Iterator<Item = usize> {
    let (x, y) = (i % columns, i / columns);
    let rows = y.saturating_sub(1)..(y + 2).min(count / columns);
    let across = x.saturating_sub(1)..(x + 2).min(columns);
    rows.flat_map(move |row| across.clone().map(move |column| row * columns + column)).filter(move |&j| j != i)
}

/// A ring as a line that comes back to where it begins: far out, at a point that simplifying would leave too.
fn closed(mut ring: Vec<Vec2>) -> Vec<Vec2> {
    let middle = ring.iter().sum::<Vec2>() / ring.len().max(1) as f32;
    let far = |i: &usize| ring[*i].distance_squared(middle);
    let farthest = (0..ring.len()).reduce(|a, b| if far(&b) > far(&a) { b } else { a }).unwrap_or(0);
    ring.rotate_left(farthest);
    ring.extend(ring.first().copied());
    ring
}
