//! The layout of an archipelago: drowned summits in rows.

use glam::Vec2;

use super::curve::{Curve, swelling, turned};
use super::draws::Draws;
use super::room::{placed, room, roomier};
use super::spine::Spine;
use crate::base::geometry::length;

/// Lays out drowned summits as short spines in rows along arcs, on `area` square units. Areas fall with a power of the
/// rank (Korčak 1940).
pub(super) fn archipelago(draws: &mut Draws, size: Vec2, area: f32) -> Vec<Spine> {
    /// The exponent of areas over ranks.
    const FALL: f32 = 0.7;
    let arcs = arcs(draws, size);
    let count = draws.count(12, 17);
    let mut areas: Vec<f32> = (1..=count).map(|rank| libm::powf(rank as f32, -FALL)).collect();
    let whole: f32 = areas.iter().sum();
    areas.iter_mut().for_each(|share| *share = *share / whole * area);
    let rows = dealt(draws, &arcs, &areas);
    let mut spines: Vec<Spine> = Vec::new();
    for (arc, areas) in arcs.iter().zip(&rows) {
        row(draws, arc, areas, &mut spines);
    }
    for _ in 0..draws.count(20, 36) {
        spines.extend(stray(draws, &arcs, &spines, size));
    }
    placed(draws, spines, size)
}

/// Deals the areas of islands, the largest first, out to arcs, most likely to those that have room for more.
fn dealt(draws: &mut Draws, arcs: &[Curve], areas: &[f32]) -> Vec<Vec<f32>> {
    let mut rows: Vec<(f32, Vec<f32>)> = arcs.iter().map(|arc| (arc.length(), Vec::new())).collect();
    for &area in areas {
        let (mut best, mut greatest) = (0, f32::NEG_INFINITY);
        for (row, (room, _)) in rows.iter().enumerate() {
            let chance = room * draws.between(0.4, 1.0);
            if chance > greatest {
                (best, greatest) = (row, chance);
            }
        }
        let (room, row) = &mut rows[best];
        *room -= laid(area);
        // As likely at one end of a row as at the other.
        row.insert(draws.count(0, row.len() as u32) as usize, area);
    }
    rows.into_iter().map(|(_, row)| row).collect()
}

/// Estimates the length of an island with an area, together with the strait beside it, in units.
fn laid(area: f32) -> f32 {
    1.9 * area.sqrt() + 85.0
}

/// Draws three or four arcs, the longest first, aslant beside one another.
fn arcs(draws: &mut Draws, size: Vec2) -> Vec<Curve> {
    let way = roomier(draws, size);
    let (room, span) = (room(size, way), size.min_element());
    let bend = draws.either(0.05, 0.26);
    let side = draws.either(0.24, 0.34);
    let mut arcs = Vec::new();
    for number in 0..draws.count(3, 4) {
        let (off, long) = match number {
            0 => (0.0, draws.between(0.95, 1.15)),
            1 => (side, draws.between(0.7, 1.0)),
            2 => (-side, draws.between(0.5, 0.9)),
            _ => (2.0 * side, draws.between(0.3, 0.6)),
        };
        let way = turned(way, if number == 0 { 0.0 } else { draws.either(0.0, 0.35) });
        let middle = size / 2.0 + way.perp() * (off * span) + way * (room * draws.either(0.0, 0.18));
        let half = way * (0.5 * long * room);
        let bends = [0, 1].map(|_| bend * draws.between(0.5, 1.4));
        arcs.push(Curve::bent(middle - half, middle + half, bends));
    }
    fitted(arcs, size)
}

/// Moves curves to the middle of a rectangle; too large ones shrink to its inner part.
fn fitted(mut curves: Vec<Curve>, size: Vec2) -> Vec<Curve> {
    let border = 0.1 * size.min_element();
    let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for curve in &curves {
        for at in (0..=8).map(|i| curve.at(i as f32 / 8.0)) {
            (low, high) = (low.min(at), high.max(at));
        }
    }
    let shrunk = ((size - 2.0 * border) / (high - low).max(Vec2::ONE)).min(Vec2::ONE);
    let place = |at: Vec2| (at - (low + high) / 2.0) * shrunk + size / 2.0;
    for curve in &mut curves {
        curve.0 = curve.0.map(place);
    }
    curves
}

/// Adds a row of islands with these areas along an arc, short enough to leave straits between them.
fn row(draws: &mut Draws, arc: &Curve, areas: &[f32], spines: &mut Vec<Spine>) {
    let long = arc.length();
    let lengths: Vec<f32> = areas.iter().map(|area| area.sqrt() * draws.between(1.5, 2.8)).collect();
    let straits: Vec<f32> = areas.iter().map(|_| draws.between(45.0, 130.0)).collect();
    let laid = straits.iter().fold(lengths.iter().sum::<f32>(), |laid, strait| laid + strait);
    let fitted = (long / laid.max(1.0)).min(1.3);
    let lean = draws.either(0.0, 0.4);
    let mut t = draws.between(0.0, 1.0) * (1.0 - fitted * laid / long).max(0.0);
    for ((area, length), strait) in areas.iter().zip(&lengths).zip(&straits) {
        let (length, end) = (length * fitted, t + length * fitted / long);
        let ends = [arc.at(t), arc.at(end.min(1.0))];
        t = end + strait * fitted / long;
        let lean = lean * draws.between(0.5, 1.0);
        spines.push(summit(draws, ends, area / (1.55 * length).max(1.0), lean));
    }
}

/// Draws a summit of about a half width between two ends, turned by an angle.
fn summit(draws: &mut Draws, [from, to]: [Vec2; 2], width: f32, lean: f32) -> Spine {
    let middle = (from + to) / 2.0 + (to - from).perp() * draws.either(0.0, 0.2);
    let half = turned((to - from) / 2.0, lean);
    let bend = draws.either(0.02, 0.22);
    let (swollen, end) = (draws.between(0.2, 0.8), draws.between(0.1, 0.5));
    // The half width extends the summit beyond its ends, too.
    let inner = half * (1.0 - 0.5 * end * width / length(half).max(width)).max(0.1);
    let curve = Curve::bent(middle - inner, middle + inner, [bend, bend]);
    curve.spine(6, &|t| 1.15 * width * swelling(t, swollen, end))
}

/// Draws a small island beside an arc; `None` if there is no room at the place.
fn stray(draws: &mut Draws, arcs: &[Curve], spines: &[Spine], size: Vec2) -> Option<Spine> {
    let arc = arcs.get(draws.count(0, arcs.len() as u32 - 1) as usize)?;
    let t = draws.between(0.0, 1.0);
    let way = arc.way(t);
    let at = arc.at(t) + way.perp() * draws.either(0.02, 0.2) * size.min_element();
    let width = 10.0 + 26.0 * draws.between(0.0, 1.0) * draws.between(0.0, 1.0);
    let half = turned(way, draws.either(0.0, 0.7)) * (width * draws.between(0.4, 2.2));
    let highest = spines.iter().map(|spine| spine.height(at)).fold(f32::NEG_INFINITY, f32::max);
    let has_room = highest < -1.6 * width - 10.0;
    has_room.then(|| Curve::bent(at - half, at + half, [0.1, 0.1]).spine(3, &|t| width * swelling(t, 0.5, 0.5)))
}
