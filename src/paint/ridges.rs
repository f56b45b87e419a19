//! Ridges as engravers drew them: a crest that sinks towards the coast and towards its ends, and short strokes down
//! both sides.

use glam::Vec2;

use crate::land::{Cell, Land};

/// An end of a stroke: its position and half its width, in units.
pub(crate) type End = (Vec2, f32);

/// The distance between points of a crest, in units.
const PIECE: f32 = 4.0;
/// Half the width of a crest, and of a stroke where it begins, in units.
const CREST: f32 = 0.9;
const STROKE: f32 = 0.6;
/// The distance from its ends and from the coast at which a ridge reaches its full height, in units.
const RISE: f32 = 40.0;

/// Draws the strokes of all ridges of a land.
pub(crate) fn ridges(land: &Land) -> Vec<[End; 2]> {
    let mut strokes = Vec::new();
    for ridge in land.ridges().iter().filter(|ridge| ridge.len() > 1) {
        let crest = crest(ridge);
        let heights = heights(land, &crest);
        let is_ashore = |at: Vec2| land.coast_distance().height(at) > 0.0;
        let ashore = |&(i, pair): &(usize, &[Vec2])| heights[i] > 0.0 && is_ashore(pair[1]);
        for (i, pair) in crest.windows(2).enumerate().filter(ashore) {
            strokes.push([(pair[0], CREST * heights[i]), (pair[1], CREST * heights[i + 1])]);
            strokes.extend(down_both_sides(i, pair[0], pair[1] - pair[0], heights[i]));
        }
    }
    strokes
}

/// Returns the line of a ridge, evenly divided and smoothed.
fn crest(ridge: &[Vec2]) -> Vec<Vec2> {
    const ROUNDS: u32 = 5;
    let (mut crest, mut ahead) = (Vec::new(), 0.0);
    for pair in ridge.windows(2) {
        let length = pair[0].distance(pair[1]);
        while ahead < length {
            crest.push(pair[0].lerp(pair[1], ahead / length));
            ahead += PIECE;
        }
        ahead -= length;
    }
    crest.extend(ridge.last());
    for _ in 0..ROUNDS {
        let before = crest.clone();
        for (at, around) in crest.iter_mut().skip(1).zip(before.windows(3)) {
            *at = (around[0] + around[1] * 2.0 + around[2]) * 0.25;
        }
    }
    crest
}

/// Returns the height of a ridge at each point of its crest, from 0 to 1. It rises and falls from peak to peak.
fn heights(land: &Land, crest: &[Vec2]) -> Vec<f32> {
    /// The number of peaks per point, and the height between peaks.
    const PEAKS: f32 = 0.05;
    const SADDLE: f32 = 0.45;
    let last = crest.len() - 1;
    // A ridge that leaves the map, or is closed, does not end there.
    let goes_on =
        |end: usize, before: usize| crest[0] == crest[last] || land.at(crest[end] * 2.0 - crest[before]) == Cell::Water;
    let ends = [goes_on(0, last.min(2)), goes_on(last, last.saturating_sub(2))];
    let height = |(i, at): (usize, &Vec2)| {
        let from_end = |goes_on: bool, points: usize| if goes_on { RISE } else { points as f32 * PIECE };
        let least = from_end(ends[0], i).min(from_end(ends[1], last - i)).min(land.coast_distance().height(*at));
        let way = (i as f32 * PEAKS).fract();
        (least / RISE).clamp(0.0, 1.0).sqrt() * (SADDLE + (1.0 - SADDLE) * 4.0 * way * (1.0 - way))
    };
    crest.iter().enumerate().map(height).collect()
}

/// Draws the two strokes down from a point of a crest that runs in the direction `along`.
fn down_both_sides(i: usize, at: Vec2, along: Vec2, height: f32) -> [[End; 2]; 2] {
    /// Multiples of the golden ratio lie evenly and without order on a circle: as good as random numbers, and never
    /// repeated.
    const GOLDEN: f32 = 0.618_034;
    [along.perp(), -along.perp()].map(|down| {
        let uneven = ((2 * i + usize::from(down.x > 0.0)) as f32 * GOLDEN).fract();
        let to = at + (down * (1.2 + 2.4 * uneven) + along * (uneven - 0.5)) * height;
        [(at, STROKE * height), (to, 0.0)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;

    fn land(link: &str) -> std::sync::Arc<Land> {
        Land::of(&link::read(link).unwrap()).unwrap()
    }

    /// Returns the distance of a point from a line.
    fn off(line: &[Vec2], at: Vec2) -> f32 {
        let from_piece = |pair: &[Vec2]| {
            let along = pair[1] - pair[0];
            let t = ((at - pair[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            at.distance(pair[0] + along * t)
        };
        line.windows(2).map(from_piece).fold(f32::MAX, f32::min)
    }

    #[test]
    fn ridges_stay_ashore_and_where_no_river_crosses() {
        for seed in 0..6 {
            let land = land(&format!("aspect=1.5&land=valley&sea=0.5&roughness=0.5&seed={seed}"));
            let strokes = ridges(&land);
            let near = |at: Vec2| land.ridges().iter().map(|ridge| off(ridge, at)).fold(f32::MAX, f32::min);
            for [(from, half_from), (to, half_to)] in &strokes {
                assert!(near(*from) < 2.0, "{from} is off its ridge");
                // Strokes are thin at the coast, and there are none beyond it.
                let shore = land.coast_distance().height(*from).min(land.coast_distance().height(*to));
                assert!(shore > 0.0 || half_from.max(*half_to) < 0.25, "{half_from} wide at {from}, {shore} inland");
            }
            let wide = |stroke: &&[End; 2]| stroke[0].1 > 0.8 * CREST;
            assert!(strokes.iter().filter(wide).count() > 20);
        }
    }

    #[test]
    fn a_ridge_sinks_to_its_ends_but_not_at_the_frame() {
        let land = land("country=usual&aspect=1.5&land=valley&sea=0.5&roughness=0");
        let first = |from: f32| heights(&land, &crest(&[Vec2::new(from, 100.0), Vec2::new(400.0, 100.0)]))[0];
        assert!(first(200.0) < 0.01, "{}", first(200.0));
        assert!(first(0.0) > 0.4, "{}", first(0.0));
    }

    #[test]
    fn a_closed_ridge_is_as_high_at_its_seam_as_opposite() {
        let land = land("country=usual&land=valley&roughness=0&sea=0.3&aspect=1");
        // A ring around a place far from any coast.
        let at =
            |i: u32| Vec2::from_angle(std::f32::consts::TAU * (i % 48) as f32 / 48.0) * 60.0 + Vec2::new(500.0, 300.0);
        let ring: Vec<Vec2> = (0..=48).map(at).collect();
        let crest = crest(&ring);
        let heights = heights(&land, &crest);
        let highest = |part: &[f32]| part.iter().copied().fold(0.0, f32::max);
        let (seam, opposite) = (highest(&heights[..8]), highest(&heights[heights.len() / 2 - 10..][..20]));
        assert_eq!(crest.first(), crest.last());
        assert!(land.coast_distance().height(ring[0]) > RISE && opposite > 0.9, "{opposite}");
        // The height varies between saddle and peak, but is lower nowhere.
        assert!(heights[0] > 0.4 && heights[crest.len() - 1] > 0.4, "{} and {}", heights[0], heights[crest.len() - 1]);
        assert!(seam > 0.7, "{seam} where the ring begins, {opposite} opposite");
    }
}
