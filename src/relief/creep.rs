//! Soil creep: hillsides are rounded a little, so that ridges are not sharp and gentle ground is smooth. Rivers stay as
//! high as they are, and each cell that had a lower neighbour still has one.

use std::num::NonZero;

use wide::{f32x4, u32x4};

use super::cells::Cells;
use crate::base::geometry::fast_max;
use crate::base::memory::{Refused, lengthen};
use crate::base::parallel::for_each_row;
use crate::base::work;

/// The number of times that each cell is averaged with its neighbours.
const ROUNDS: u32 = 2;

/// The share of the way to the average of its neighbours that a cell moves in a round.
const SHARE: f32 = 0.75;

/// Heights while soil creeps.
#[derive(Clone, Debug, Default)]
pub(super) struct Creep {
    /// The heights of all cells, the rim included; infinite where there is no land, as in all of the rim.
    pub heights: Vec<f32>,
    next: Vec<f32>,
    /// For each cell, `true` if a river passes it, or one that touches it.
    is_near_river: Vec<bool>,
    rounds: u32,
}

impl Creep {
    /// Begins with the heights of all cells of a map, in units; `is_river` says which a river passes.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn new(cells: &Cells, heights: Vec<f32>, is_river: &[bool]) -> Result<Self, Refused> {
        let mut is_near_river = Vec::new();
        lengthen(&mut is_near_river, heights.len(), false)?;
        work::count(heights.len());
        for cell in (0..is_river.len()).filter(|&cell| is_river[cell] && !cells.is_rim(cell)) {
            is_near_river[cell] = true;
            cells.around(cell).into_iter().for_each(|near| is_near_river[near] = true);
        }
        Ok(Self { heights, is_near_river, ..Self::default() })
    }

    /// Averages each cell with its neighbours once, but for cells that a river passes. Returns `true` if another round follows.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn advance(&mut self, cells: &Cells, is_river: &[bool], threads: NonZero<usize>) -> Result<bool, Refused> {
        if self.next.is_empty() {
            lengthen(&mut self.next, self.heights.len(), f32::INFINITY)?;
        }
        work::count(3 * self.heights.len());
        let mut next = std::mem::take(&mut self.next);
        for_each_row(&mut next, cells.columns, threads, |row, next| {
            let inside = 1..cells.columns - 1;
            if !(1..cells.rows - 1).contains(&row) {
                return;
            }
            for column in inside.clone().step_by(LANES) {
                let crept = self.crept(row * cells.columns + column, cells.columns, is_river);
                next[column..inside.end].iter_mut().zip(crept).for_each(|(next, crept)| *next = crept);
            }
        });
        self.next = std::mem::replace(&mut self.heights, next);
        self.rounds += 1;
        let is_last = self.rounds == ROUNDS;
        if is_last {
            (self.next, self.is_near_river) = Default::default();
        }
        Ok(!is_last)
    }

    /// Returns the next heights of a cell and those to the east of it. A cell falls at most halfway to its lowest neighbour and rises at
    /// most halfway to the lowest of its higher neighbours, so its lowest neighbour stays lower. It does not fall below a river beside it
    /// either, which would then stand on a dam.
    #[inline]
    fn crept(&self, cell: usize, columns: usize, is_river: &[bool]) -> [f32; LANES] {
        let at = |cell: usize| four(&self.heights, cell);
        let own = at(cell);
        let is_land = own.simd_lt(f32x4::splat(f32::INFINITY));
        if is_land.none() {
            return own.to_array();
        }
        let beside = [at(cell - 1), at(cell + 1), at(cell - columns), at(cell + columns)];
        let corners = [cell - columns - 1, cell - columns + 1, cell + columns - 1, cell + columns + 1].map(at);
        let wanted = own + (average(own, beside, corners) - own) * SHARE;
        let lowest = beside.into_iter().fold(own, f32x4::fast_min);
        let mut least = lowest.simd_lt(own).select(halfway(lowest, own).1, f32x4::splat(f32::NEG_INFINITY));
        let near = cell..(cell + LANES).min(self.heights.len());
        if self.is_near_river[near.clone()].contains(&true) {
            let mut banks = [f32::NEG_INFINITY; LANES];
            banks.iter_mut().zip(near.clone()).for_each(|(bank, cell)| *bank = self.bank(cell, columns, is_river));
            least = least.fast_max(f32x4::from(banks));
        }
        let higher = beside.map(|height| height.simd_gt(own).select(height, f32x4::splat(f32::INFINITY)));
        let above = higher.into_iter().fold(f32x4::splat(f32::INFINITY), f32x4::fast_min);
        let most =
            above.simd_lt(f32x4::splat(f32::INFINITY)).select(halfway(own, above).0, f32x4::splat(f32::INFINITY));
        let mut crept = is_land.select(wanted.fast_max(least).fast_min(most), own).to_array();
        for (crept, cell) in crept.iter_mut().zip(near).filter(|(_, cell)| is_river[*cell]) {
            *crept = self.heights[cell];
        }
        crept
    }

    /// Returns the least height to which a cell may fall beside the rivers around it, in units.
    fn bank(&self, cell: usize, columns: usize, is_river: &[bool]) -> f32 {
        let mut least = f32::NEG_INFINITY;
        if !self.is_near_river[cell] || self.heights[cell] == f32::INFINITY {
            return least;
        }
        let own = self.heights[cell];
        let (north, south) = (cell - columns, cell + columns);
        for near in [north - 1, north, north + 1, cell - 1, cell + 1, south - 1, south, south + 1] {
            if is_river[near] && self.heights[near] <= own {
                let [river, own] = [self.heights[near], own].map(f32x4::splat);
                least = fast_max(least, halfway(river, own).1.to_array()[0]);
            }
        }
        least
    }
}

/// The number of cells that are looked at at once.
const LANES: usize = 4;

/// Reads a cell and those to the east of it. Beyond the end of the list the last cell stands for others.
#[inline]
fn four(heights: &[f32], cell: usize) -> f32x4 {
    match heights[cell..].first_chunk() {
        Some(four) => f32x4::from(*four),
        None => f32x4::from([0, 1, 2, 3].map(|lane| heights[(cell + lane).min(heights.len() - 1)])),
    }
}

/// Returns the greatest height that the lower of two neighbours may reach, and the least that the higher one may fall to.
#[inline]
fn halfway(low: f32x4, high: f32x4) -> (f32x4, f32x4) {
    let middle = low + (high - low) * 0.5;
    // Land is above the sea, so the next lower number has the next lower bits.
    let below = f32x4::from_bits(middle.to_bits() - u32x4::splat(1));
    let is_between = middle.simd_gt(low);
    (is_between.select(below, low), is_between.select(middle, high))
}

/// Returns the binomial average of a cell and its eight neighbours: those to the west, east, north and south, and those north-west,
/// north-east, south-west and south-east. Neighbours without a height count as the cell itself.
#[inline]
fn average(own: f32x4, beside: [f32x4; 4], corners: [f32x4; 4]) -> f32x4 {
    let known = |height: f32x4| height.simd_lt(f32x4::splat(f32::INFINITY)).select(height, own);
    let ([west, east, north, south], [north_west, north_east, south_west, south_east]) =
        (beside.map(known), corners.map(known));
    let row = |west: f32x4, middle: f32x4, east: f32x4| west + middle * 2.0 + east;
    (row(north_west, north, north_east) + row(west, own, east) * 2.0 + row(south_west, south, south_east))
        * (1.0 / 16.0)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::property::cases;

    /// Generates a few cells with a rim, with few different heights, some of them nearly equal, some infinite; and which are fixed.
    fn cells() -> impl Strategy<Value = (Cells, Vec<f32>, Vec<bool>)> {
        (4usize..12, 4usize..12).prop_flat_map(|(columns, rows)| {
            let height =
                prop_oneof![4 => 0.01f32..9.0, 2 => Just(1.0), 2 => Just(1f32.next_up()), 1 => Just(f32::INFINITY)];
            let heights = prop::collection::vec(height, columns * rows);
            (heights, prop::collection::vec(prop::bool::weighted(0.2), columns * rows)).prop_map(
                move |(mut heights, is_fixed)| {
                    let cells = Cells {
                        columns,
                        rows,
                        size: 2.0,
                        middle: 0.5,
                        inland: vec![1.0; columns * rows],
                        ..Cells::default()
                    };
                    (0..columns * rows)
                        .filter(|&cell| cells.is_rim(cell))
                        .for_each(|cell| heights[cell] = f32::INFINITY);
                    (cells, heights, is_fixed)
                },
            )
        })
    }

    proptest! {
        #![proptest_config(cases(300))]

        #[test]
        fn each_cell_with_a_lower_neighbour_keeps_one((cells, before, is_fixed) in cells()) {
            let mut creep = Creep::new(&cells, before.clone(), &is_fixed).unwrap();
            while creep.advance(&cells, &is_fixed, NonZero::<usize>::MIN).unwrap() {}
            for cell in (0..before.len()).filter(|&cell| before[cell] < f32::INFINITY) {
                let has_lower = |heights: &[f32]| cells.beside(cell).iter().any(|&beside| heights[beside] < heights[cell]);
                prop_assert!(!has_lower(&before) || has_lower(&creep.heights));
                let rivers = cells.around(cell).into_iter().filter(|&near| is_fixed[near] && before[near] < before[cell]);
                prop_assert!(rivers.into_iter().all(|near| creep.heights[near] < creep.heights[cell]), "a dam");
                prop_assert!(creep.heights[cell] > 0.0);
                prop_assert!(!is_fixed[cell] || creep.heights[cell] == before[cell]);
            }
        }
    }

    #[test]
    fn a_ridge_becomes_round_and_a_slope_stays() {
        let cells = Cells { columns: 9, rows: 9, size: 2.0, middle: 0.5, inland: vec![1.0; 81], ..Cells::default() };
        let height =
            |cell: usize| if cells.is_rim(cell) { f32::INFINITY } else { 5.0 - (4.0 - (cell % 9) as f32).abs() };
        let mut creep = Creep::new(&cells, (0..81).map(height).collect(), &[false; 81]).unwrap();
        creep.advance(&cells, &[false; 81], NonZero::<usize>::MIN).unwrap();
        let row = &creep.heights[36..45];
        assert!((row[4] - 4.625).abs() < 1e-6 && row[3] == 4.0 && row[2] == 3.0, "{row:?}");
    }
}
