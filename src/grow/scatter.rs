//! Positions of attractors: anywhere on land that has a river mouth, or one in each cell of a grid; along valleys, one
//! in each cell of the plane.

use glam::Vec2;

use super::GrowthSettings;
use super::drainage::attractors_by_height;
use super::watered::Watered;
use crate::base::random::{Purpose, Stream};
use crate::base::work;
use crate::land::{Cells, Land};
use crate::recipe::Scatter;

/// Places the attractors, in the order in which they are drawn. One more attractor leaves all others where they are,
/// except on a grid. With valleys the lowest come first.
pub fn scatter(settings: &GrowthSettings) -> Vec<Vec2> {
    if settings.has_valleys() {
        return attractors_by_height(settings);
    }
    let mut chance = settings.seed.stream(Purpose::Attractors);
    match (&settings.land, settings.scatter) {
        (None, Scatter::Random) => {
            let anywhere = |_| Vec2::new(chance.unit(), chance.unit()) * settings.domain.size;
            (0..settings.attractors).map(anywhere).collect()
        }
        (None, Scatter::Grid) => on_grid(settings, settings.attractors, None, &mut chance),
        (Some(land), Scatter::Random) => on_land(settings, land, &mut chance),
        (Some(land), Scatter::Grid) => {
            // The grid is so fine that about as many cells lie on land as attractors are asked for.
            let size = settings.domain.size;
            let cells = (size.x * size.y / (settings.spacing * settings.spacing)) as u32;
            on_grid(settings, cells.max(1), Some(&Watered::of(settings, land)), &mut chance)
        }
    }
}

/// Places attractors anywhere in cells of land, with equal probability.
fn on_land(settings: &GrowthSettings, land: &Land, chance: &mut Stream) -> Vec<Vec2> {
    let cells = Cells::of(settings.watered());
    let mut places = Vec::with_capacity(settings.attractors as usize);
    for _ in 0..settings.attractors {
        let cell = (chance.unit() * cells.count() as f32) as u32;
        let within = Vec2::new(chance.unit(), chance.unit());
        if let Some((column, row)) = cells.cell(cell) {
            places.push(land.point(column, row, within));
        }
    }
    places
}

/// Places one attractor at random in each cell of a grid over the domain, and drops those that are not on land with a
/// river mouth.
fn on_grid(settings: &GrowthSettings, cells: u32, watered: Option<&Watered>, chance: &mut Stream) -> Vec<Vec2> {
    let size = settings.domain.size;
    let rows = ((size.y / settings.spacing).round() as u32).clamp(1, cells);
    let first_of = |row: u32| (u64::from(row) * u64::from(cells) / u64::from(rows)) as u32;
    let mut places = Vec::with_capacity(settings.attractors as usize);
    work::count(cells as usize);
    for row in 0..rows {
        let columns = first_of(row + 1) - first_of(row);
        let cell = size / Vec2::new(columns as f32, rows as f32);
        for column in 0..columns {
            let within = Vec2::new(chance.unit(), chance.unit());
            let place = (Vec2::new(column as f32, row as f32) + within) * cell;
            if watered.is_none_or(|watered| watered.holds(place)) {
                places.push(place);
            }
        }
    }
    places
}
