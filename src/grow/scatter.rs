//! Where attractors lie: anywhere on land that has a river mouth, or each in a cell of a grid; or, where they follow valleys, each in a
//! cell of the plane.

use glam::Vec2;

use super::GrowthSettings;
use super::drainage::attractors_by_height;
use super::watered::Watered;
use crate::land::{Cells, Land};
use crate::random::{Purpose, Stream};
use crate::recipe::Scatter;
use crate::work;

/// Places the attractors, in the order of their drawing: one more leaves all others where they are, unless on a grid. With valleys the
/// lowest comes first.
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
        (None, Scatter::Grid) => on_grid(settings, settings.attractors, |_| true, &mut chance),
        (Some(land), Scatter::Random) => on_land(settings, land, &mut chance),
        (Some(land), Scatter::Grid) => {
            // A grid so fine that about as many cells lie on the land as attractors are asked for.
            let size = settings.domain.size;
            let cells = (size.x * size.y / (settings.spacing * settings.spacing)) as u32;
            let watered = Watered::of(settings, land);
            on_grid(settings, cells.max(1), |place| watered.holds(place), &mut chance)
        }
    }
}

/// Anywhere in cells of land, each as likely as any other.
fn on_land(settings: &GrowthSettings, land: &Land, chance: &mut Stream) -> Vec<Vec2> {
    let cells = Cells::of(settings.watered());
    let anywhere = |_| {
        let cell = (chance.unit() * cells.count() as f32) as u32;
        let within = Vec2::new(chance.unit(), chance.unit());
        cells.cell(cell).map(|(column, row)| land.point(column, row, within))
    };
    (0..settings.attractors).filter_map(anywhere).collect()
}

/// One at random in each cell of a grid over the domain, those left out that are not wanted.
fn on_grid(settings: &GrowthSettings, cells: u32, is_wanted: impl Fn(Vec2) -> bool, chance: &mut Stream) -> Vec<Vec2> {
    let size = settings.domain.size;
    let rows = ((size.y / settings.spacing).round() as u32).clamp(1, cells);
    let first_of = |row: u32| (u64::from(row) * u64::from(cells) / u64::from(rows)) as u32;
    let mut places = Vec::with_capacity(settings.attractors as usize);
    work::count(cells as usize);
    for row in 0..rows {
        let columns = first_of(row + 1) - first_of(row);
        let cell = size / Vec2::new(columns as f32, rows as f32);
        let anywhere = (0..columns)
            .map(|column| (Vec2::new(column as f32, row as f32) + Vec2::new(chance.unit(), chance.unit())) * cell);
        places.extend(anywhere.filter(|&place| is_wanted(place)));
    }
    places
}
