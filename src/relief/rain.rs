//! Where rain falls: it comes with the wind, and the ground that the wind climbs takes it from the country behind.
//!
//! A coarse stand-in for the models of orographic rain (Smith and Barstad 2004): the share of its moisture that air still has when it has
//! come to a place. Rising ground takes from it, and the sea gives back.

use glam::Vec2;

use super::{Grid, Relief};
use crate::base::random::{Purpose, Seed};
use crate::base::trigonometry::sine_and_cosine;
use crate::base::work;
use crate::recipe::{IntegerKey, NumberKey, Recipe};

/// The wind that brings rain to a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wind {
    /// The direction in which it blows, a unit vector.
    along: Vec2,
    /// The influence of ranges on rain, from 0 to 1.
    shadow: f32,
}

impl Wind {
    /// Reads the wind of a recipe; `None` if ranges hold back no rain.
    pub fn of(recipe: &Recipe) -> Option<Self> {
        let shadow = recipe.number(NumberKey::RainShadow);
        if shadow <= 0.0 {
            return None;
        }
        let chosen = 360.0 * Seed::from_text(recipe.seed()).item_hash(Purpose::Country).unit([3, 0, 0]);
        let degrees = match recipe.integer(IntegerKey::Wind) {
            0 => chosen,
            degrees => degrees as f32,
        };
        // The angle from the direction opposite to the wind's, which is within half a turn of it.
        let (sine, cosine) = sine_and_cosine((degrees - 180.0).to_radians());
        Some(Self { along: Vec2::new(sine, -cosine), shadow })
    }
}

/// How much more rain falls in each cell of a coarse grid than on all land, or less.
#[derive(Clone, Debug)]
pub(crate) struct Rainfall {
    pub grid: Grid,
    /// Deviations from the rain of the map, which runs from 0 to 1: at most [`Rainfall::MOST`], either way.
    pub deviations: Vec<f32>,
}

/// The side of a cell, in units.
const CELL: f32 = 20.0;
/// The ascent that leaves half of the moisture in the air, in units of height.
const HALVES: f32 = 45.0;
/// The shares of what it lacks that air takes up over a cell of sea and of land.
const FROM_SEA: f32 = 0.08;
const FROM_LAND: f32 = 0.015;
/// The difference in moisture that makes for the greatest deviation.
const GREAT: f32 = 0.3;

impl Rainfall {
    /// The greatest deviation.
    pub const MOST: f32 = 0.25;

    /// Lets the wind blow over a relief.
    pub fn of(relief: &Relief, wind: Wind) -> Self {
        let ground = Ground::of(relief);
        let cells = 0..ground.heights.len();
        let moisture: Vec<f32> = cells.clone().map(|cell| ground.moisture(cell, wind.along)).collect();
        let on_land = || cells.clone().filter(|&cell| ground.heights[cell] > 0.0);
        let mean = on_land().map(|cell| moisture[cell]).sum::<f32>() / on_land().count().max(1) as f32;
        let deviation = |cell| ((ground.mean_around(cell, &moisture) - mean) / GREAT).clamp(-1.0, 1.0);
        let most = Self::MOST * wind.shadow;
        Self { deviations: cells.clone().map(|cell| deviation(cell) * most).collect(), grid: ground.grid }
    }

    /// Returns the deviation at a point, between those of the nearest cells.
    pub fn at(&self, at: Vec2) -> f32 {
        let Grid { cell_size, columns, rows } = self.grid;
        let most = Vec2::new((columns - 1) as f32, (rows - 1) as f32);
        let place = (at / cell_size - 0.5).clamp(Vec2::ZERO, most);
        let (first, share) = (place.floor(), place.fract());
        let value = |at: Vec2| self.deviations[at.y as usize * columns + at.x as usize];
        let line = |y: f32| {
            let [west, east] = [first.x, (first.x + 1.0).min(most.x)].map(|x| value(Vec2::new(x, y)));
            west + (east - west) * share.x
        };
        let [north, south] = [first.y, (first.y + 1.0).min(most.y)].map(line);
        north + (south - north) * share.y
    }

    /// Returns the deviation in each cell of a relief's grid.
    pub fn of_cells(&self, Grid { cell_size, columns, rows }: Grid) -> impl Iterator<Item = f32> {
        let middle = move |cell: usize| (Vec2::new((cell % columns) as f32, (cell / columns) as f32) + 0.5) * cell_size;
        (0..columns * rows).map(move |cell| self.at(middle(cell)))
    }
}

/// The mean heights of land in coarse cells, in units of height.
struct Ground {
    grid: Grid,
    heights: Vec<f32>,
}

impl Ground {
    fn of(relief: &Relief) -> Self {
        let fine = relief.grid();
        let count = |cells: usize| (cells as f32 * fine.cell_size / CELL).ceil().max(1.0) as usize;
        let grid = Grid { cell_size: CELL, columns: count(fine.columns), rows: count(fine.rows) };
        let (mut heights, mut counts) = (vec![0.0; grid.columns * grid.rows], vec![0u32; grid.columns * grid.rows]);
        let coarse = |cell: usize| ((cell as f32 + 0.5) * fine.cell_size / CELL) as usize;
        for (row, line) in relief.heights().chunks(fine.columns).enumerate() {
            for (column, height) in line.iter().enumerate() {
                let cell = coarse(row) * grid.columns + coarse(column);
                heights[cell] += height.max(0.0);
                counts[cell] += 1;
            }
        }
        heights.iter_mut().zip(counts).for_each(|(height, count)| *height /= count.max(1) as f32);
        work::count(relief.heights().len());
        Self { grid, heights }
    }

    /// Returns the moisture of the air above a cell, from 0 to 1, which has come from beyond the map.
    fn moisture(&self, cell: usize, along: Vec2) -> f32 {
        let Grid { columns, rows, .. } = self.grid;
        let middle = Vec2::new((cell % columns) as f32, (cell / columns) as f32) + 0.5;
        let height = |steps: usize| {
            let at = (middle - along * steps as f32).floor();
            let is_inside = at.cmpge(Vec2::ZERO).all() && at.x < columns as f32 && at.y < rows as f32;
            is_inside.then(|| self.heights[at.y as usize * columns + at.x as usize])
        };
        // Straight upwind, a map ends once.
        let steps = (0..columns + rows).take_while(|&steps| height(steps).is_some()).count();
        work::count(2 * steps);
        let heights = (0..steps).rev().filter_map(height);
        let over = |(moisture, before): (f32, Option<f32>), here: f32| {
            let taken_up = (1.0 - moisture) * if here > 0.0 { FROM_LAND } else { FROM_SEA };
            let climbed = before.map_or(0.0, |before| (here - before).max(0.0));
            ((moisture + taken_up) * HALVES / (HALVES + climbed), Some(here))
        };
        heights.fold((1.0, None), over).0
    }

    /// Returns the mean of a value of a cell and of those beside it.
    fn mean_around(&self, cell: usize, values: &[f32]) -> f32 {
        let Grid { columns, rows, .. } = self.grid;
        let beside = |i: usize, count: usize| i.saturating_sub(1)..=(i + 1).min(count - 1);
        let lines = beside(cell / columns, rows);
        let around = lines.flat_map(|row| beside(cell % columns, columns).map(move |column| row * columns + column));
        let (sum, count) = around.fold((0.0, 0.0), |(sum, count), cell| (sum + values[cell], count + 1.0));
        sum / count
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::recipe::link;
    use crate::relief::CELL_SIZE;

    /// The side of the square map, in units.
    const SIDE: f32 = 1000.0;

    /// Lets the wind of a recipe blow over a square map with these heights.
    fn rain(text: &str, height: impl Fn(Vec2) -> f32) -> Rainfall {
        let domain = Domain::with_aspect(1.0);
        let columns = (domain.size.x / CELL_SIZE).ceil() as usize;
        let at = |cell: usize| (Vec2::new((cell % columns) as f32, (cell / columns) as f32) + 0.5) * CELL_SIZE;
        let heights = (0..columns * columns).map(|cell| height(at(cell))).collect();
        let wind = Wind::of(&link::read(text).unwrap()).unwrap();
        Rainfall::of(&Relief::of_heights(&domain, heights).unwrap(), wind)
    }

    /// A range from north to south in the middle of the map.
    fn range(at: Vec2) -> f32 {
        (80.0 - (at.x - 0.5 * SIDE).abs() * 0.5).max(1.0)
    }

    #[test]
    fn it_is_wet_before_a_range_and_dry_behind_it() {
        for (degrees, from_west) in [(270, true), (90, false)] {
            let rain = rain(&format!("rain-shadow=1&wind={degrees}"), range);
            let [west, east] = [0.2, 0.8].map(|share| rain.at(Vec2::new(share, 0.5) * SIDE));
            let [before, behind] = if from_west { [west, east] } else { [east, west] };
            assert!(before > 0.1 && behind < -0.1, "{before} before it and {behind} behind, from {degrees}°");
        }
        // A wind along a range brings as much rain to both of its sides.
        let rain = rain("rain-shadow=1&wind=360", range);
        let [west, east] = [0.2, 0.8].map(|share| rain.at(Vec2::new(share, 0.5) * SIDE));
        assert!((west - east).abs() < 0.02, "{west} and {east}");
    }

    #[test]
    fn rain_is_even_on_level_land_and_without_a_shadow() {
        let level = rain("rain-shadow=1&wind=200", |_| 5.0);
        assert!(level.deviations.iter().all(|deviation| deviation.abs() < 1e-3));
        assert_eq!(Wind::of(&link::read("rain-shadow=0&wind=200").unwrap()), None);
    }

    #[test]
    fn the_shadow_scales_deviations_which_have_bounds_and_cancel_out() {
        let [whole, half] =
            ["1", "0.5"].map(|shadow| rain(&format!("rain-shadow={shadow}&wind=250"), range).deviations);
        for (whole, half) in whole.iter().zip(&half) {
            assert!(whole.abs() <= Rainfall::MOST && (whole * 0.5 - half).abs() < 1e-6, "{whole} and {half}");
        }
        let mean = whole.iter().sum::<f32>() / whole.len() as f32;
        assert!(mean.abs() < 0.02, "{mean}");
    }

    #[test]
    fn each_seed_has_a_wind_of_its_own_unless_it_is_given() {
        let winds = |given: &str| {
            let wind =
                |seed: u32| Wind::of(&link::read(&format!("seed={seed}&rain-shadow=1{given}")).unwrap()).unwrap();
            [1, 2, 3].map(wind)
        };
        let [a, b, c] = winds("");
        assert!(a != b && b != c && a != c);
        let [a, b, c] = winds("&wind=45");
        assert!(a == b && b == c);
        // From the north-east to the south-west.
        assert!((a.along - Vec2::new(-0.5f32.sqrt(), 0.5f32.sqrt())).length() < 1e-6, "{}", a.along);
    }
}
