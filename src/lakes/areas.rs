//! The areas that lakes are to have: a power law, as in nature.

/// The share of the land under lakes if all are asked for.
const MOST_SHARE: f32 = 0.12;

/// The area of the greatest lake as a share of all, and at most, in square units.
const GREATEST: f32 = 0.25;
const MOST: f32 = 9_000.0;

/// The least area of a lake, in square units.
pub(super) const LEAST: f32 = 50.0;

/// The power by which areas fall with their rank: the inverse of τ − 1, with τ = 2.14 (Cael and Seekell 2016).
const BY_RANK: f32 = 1.0 / 1.14;

/// Lists the areas that lakes are to have, in square units, the greatest first: of all land under lakes, `share` of the most.
pub(super) fn areas(share: f32, land: f32) -> Vec<f32> {
    let all = share * MOST_SHARE * land;
    let greatest = (all * GREATEST).min(MOST);
    let (mut areas, mut sum) = (Vec::new(), 0.0);
    loop {
        let area = greatest * libm::powf(areas.len() as f32 + 1.0, -BY_RANK);
        if area < LEAST || sum + LEAST > all {
            return areas;
        }
        areas.push(area.min(all - sum));
        sum += area;
    }
}
