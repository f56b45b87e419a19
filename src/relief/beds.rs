//! Beds: rivers lie below the ground at both of their sides.
//!
//! A river has its height from its own profile, and ground between it and a lower one nearby has that of its hillside. So a brook
//! on the side of a larger valley, and the upper limb of a hairpin, would run beside their valley instead of in it:
//! no spur can rise in a few units. They come down to the lowest ground beside them, and dig a valley of their own.

use glam::Vec2;

use super::cells::Cells;
use super::channels::{Channels, Step};
use crate::base::geometry::{direction, fast_min};
use crate::base::memory::Refused;
use crate::base::work;

/// The farthest ground that counts, in units.
const FARTHEST: f32 = 8.0;

/// The nearest ground that counts, in cells: beyond those that touch the river's.
const NEAREST: f32 = 1.5;

/// The distance from one look at the ground to the next, in cells: short enough to miss none.
const STEP: f32 = 0.5;

/// The number of steps up and down a path between which its direction is taken.
const AROUND: usize = 3;

impl Channels {
    /// Calls `lower` with each cell of a river that stands above ground to one of its sides, and with the height of the
    /// lowest such ground, by the given heights of all cells. Beyond the sea and beyond other rivers the ground does not count.
    /// Returns `true` if there is any such cell.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn find_perched(
        &self,
        cells: &Cells,
        heights: &[f32],
        mut lower: impl FnMut(usize, f32),
    ) -> Result<bool, Refused> {
        let is_river = self.marked(heights.len())?;
        work::count(14 * self.len());
        let mut is_any = false;
        for path in self.paths() {
            for (place, &(cell, _)) in path.iter().enumerate().filter(|(_, step)| cells.is_land(step.0 as usize)) {
                let own = heights[cell as usize];
                let across = along(cells, path, place).perp();
                let side = |across: Vec2| lowest(cells, heights, &is_river, cells.point(cell as usize), across);
                let lowest = fast_min(side(across), side(-across));
                if lowest < own {
                    is_any = true;
                    lower(cell as usize, lowest);
                }
            }
        }
        Ok(is_any)
    }
}

/// Returns the direction of a path at one of its steps, a unit vector; zero for a path of a single cell.
fn along(cells: &Cells, path: &[Step], place: usize) -> Vec2 {
    let at = |place: usize| cells.point(path[place.min(path.len() - 1)].0 as usize);
    direction(at(place + AROUND) - at(place.saturating_sub(AROUND)))
}

/// Returns the height of the lowest ground from a place in one direction, in units; infinite if there is none.
fn lowest(cells: &Cells, heights: &[f32], is_river: &[bool], from: Vec2, way: Vec2) -> f32 {
    let mut lowest = f32::INFINITY;
    let mut far = NEAREST * cells.size;
    while far <= FARTHEST {
        let cell = cells.of((from + way * far).max(Vec2::ZERO));
        if is_river[cell] || !cells.is_land(cell) {
            break;
        }
        lowest = fast_min(lowest, heights[cell]);
        far += STEP * cells.size;
    }
    lowest
}

#[cfg(test)]
mod tests {
    use super::super::CELL_SIZE;
    use super::*;

    const COLUMNS: usize = 15;

    /// A slope that falls to the south by a unit a cell, and a river that runs east along the middle of it.
    fn slope() -> (Cells, Vec<f32>, Vec<(usize, f32)>) {
        let inland = (0..COLUMNS * COLUMNS).map(|cell| if is_rim(cell) { f32::NEG_INFINITY } else { 50.0 });
        let cells = Cells {
            columns: COLUMNS,
            rows: COLUMNS,
            size: CELL_SIZE,
            middle: 0.5,
            inland: inland.collect(),
            ..Cells::default()
        };
        let heights = (0..COLUMNS * COLUMNS).map(|cell| 20.0 - (cell / COLUMNS) as f32).collect();
        (cells, heights, (2..COLUMNS - 2).map(|column| (7 * COLUMNS + column, 13.0)).collect())
    }

    fn is_rim(cell: usize) -> bool {
        [cell % COLUMNS, cell / COLUMNS].into_iter().any(|index| index == 0 || index == COLUMNS - 1)
    }

    /// The rows and heights that cells are lowered to.
    fn lowered(cells: &Cells, heights: &[f32], rivers: &[Vec<(usize, f32)>]) -> Vec<(usize, f32)> {
        let mut lowered = Vec::new();
        let found = Channels::of_paths(rivers)
            .find_perched(cells, heights, |cell, height| lowered.push((cell / COLUMNS, height)));
        assert_eq!(found.unwrap(), !lowered.is_empty());
        lowered
    }

    #[test]
    fn river_on_a_slope_comes_down_to_the_ground_below_it() {
        let (cells, heights, river) = slope();
        // Four cells down the slope, which are eight units.
        let back = river.iter().rev().copied().collect();
        for river in [river, back] {
            assert_eq!(lowered(&cells, &heights, std::slice::from_ref(&river)), vec![(7, 9.0); river.len()]);
        }
    }

    #[test]
    fn ground_beyond_another_river_or_the_sea_does_not_count() {
        let (mut cells, heights, river) = slope();
        let below: Vec<_> = (1..COLUMNS - 1).map(|column| (9 * COLUMNS + column, heights[9 * COLUMNS])).collect();
        let found = lowered(&cells, &heights, &[river.clone(), below]);
        assert!(found.iter().all(|&(row, height)| row == 9 || height == 12.0), "{found:?}");
        (1..COLUMNS - 1).for_each(|column| cells.inland[9 * COLUMNS + column] = -1.0);
        assert!(lowered(&cells, &heights, &[river]).iter().all(|&(_, height)| height == 12.0));
    }

    #[test]
    fn river_in_a_valley_stays() {
        let (cells, mut heights, river) = slope();
        (0..heights.len()).for_each(|cell| heights[cell] = 1.0 + (cell / COLUMNS).abs_diff(7) as f32);
        assert_eq!(lowered(&cells, &heights, &[river]), []);
    }
}
