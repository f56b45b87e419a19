//! Areas of the third colour that are too wide to be lines: they are traced around, and nothing grows within.

use super::contour;
use super::ground::Ground;
use glam::Vec2;

/// The longer side of a picture over the greatest width of a line.
const OF_THE_PICTURE: usize = 32;
/// The greatest width of a line in small pictures, in blocks.
const WIDEST_LINE: usize = 6;

/// Removes everything connected with a wide place from the ridges. Returns the closed lines around it, whose last point
/// equals the first.
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

/// Removes the outermost blocks: those that share a side, or also a corner, with a block outside. Alternating both
/// wears straight and slanted edges equally.
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

/// Iterates over the blocks around one, within the picture.
fn around(i: usize, columns: usize, count: usize) -> impl Iterator<Item = usize> {
    let (x, y) = (i % columns, i / columns);
    let rows = y.saturating_sub(1)..(y + 2).min(count / columns);
    let across = x.saturating_sub(1)..(x + 2).min(columns);
    rows.flat_map(move |row| across.clone().map(move |column| row * columns + column)).filter(move |&j| j != i)
}

/// Turns a ring into a line that returns to its beginning. It begins at the point farthest from the middle, which
/// simplifying would keep anyway.
fn closed(mut ring: Vec<Vec2>) -> Vec<Vec2> {
    let middle = ring.iter().sum::<Vec2>() / ring.len().max(1) as f32;
    let far = |i: &usize| ring[*i].distance_squared(middle);
    let farthest = (0..ring.len()).reduce(|a, b| if far(&b) > far(&a) { b } else { a }).unwrap_or(0);
    ring.rotate_left(farthest);
    ring.extend(ring.first().copied());
    ring
}
