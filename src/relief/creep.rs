//! Soil creep: hillsides are rounded a little, so that ridges are not sharp and gentle ground is smooth. Rivers stay as
//! high as they are, and each cell that had a lower neighbour still has one.

use std::num::NonZero;

use super::cells::Cells;
use crate::base::geometry::{fast_max, fast_min};
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
    /// The heights of all cells, the rim included; infinite where there is no land.
    pub heights: Vec<f32>,
    next: Vec<f32>,
    rounds: u32,
}

impl Creep {
    /// Begins with the heights of all cells of a map, in units.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn new(heights: Vec<f32>) -> Result<Self, Refused> {
        let mut next = Vec::new();
        lengthen(&mut next, heights.len(), f32::INFINITY)?;
        Ok(Self { heights, next, rounds: 0 })
    }

    /// Averages each cell with its neighbours once, but for cells that `is_fixed`. Returns `true` if another round follows.
    pub fn advance(&mut self, cells: &Cells, is_fixed: &[bool], threads: NonZero<usize>) -> bool {
        work::count(6 * self.heights.len());
        let Self { heights, next, .. } = self;
        for_each_row(next, cells.columns, threads, |row, next| {
            for (cell, next) in (row * cells.columns..).zip(next) {
                *next = match heights[cell] < f32::INFINITY && !is_fixed[cell] {
                    true => crept(heights, is_fixed, cells.columns, cell),
                    false => heights[cell],
                };
            }
        });
        std::mem::swap(&mut self.heights, &mut self.next);
        self.rounds += 1;
        self.rounds < ROUNDS
    }
}

/// Returns the next height of a cell. The cell falls at most halfway to its lowest neighbour and rises at most halfway
/// to the lowest of its higher neighbours, so its lowest neighbour stays lower. It does not fall below a river beside
/// it either, which would then stand on a dam.
#[inline]
fn crept(heights: &[f32], is_fixed: &[bool], columns: usize, cell: usize) -> f32 {
    let own = heights[cell];
    let wanted = own + SHARE * (average(heights, columns, cell) - own);
    let (mut least, mut most) = (f32::NEG_INFINITY, f32::INFINITY);
    let beside = [cell - 1, cell + 1, cell - columns, cell + columns].map(|beside| heights[beside]);
    let lowest = beside.into_iter().fold(own, fast_min);
    if lowest < own {
        least = halfway(lowest, own).1;
    }
    let (north, south) = (cell - columns, cell + columns);
    for near in [north - 1, north, north + 1, cell - 1, cell + 1, south - 1, south, south + 1] {
        if is_fixed[near] && heights[near] <= own {
            least = fast_max(least, halfway(heights[near], own).1);
        }
    }
    let above = beside.into_iter().filter(|&height| height > own).fold(f32::INFINITY, fast_min);
    if above < f32::INFINITY {
        most = halfway(own, above).0;
    }
    fast_min(fast_max(wanted, least), most)
}

/// Returns the greatest height that the lower of two neighbours may reach, and the least that the higher one may fall to.
fn halfway(low: f32, high: f32) -> (f32, f32) {
    let middle = low + (high - low) * 0.5;
    if middle > low { (middle.next_down(), middle) } else { (low, high) }
}

/// Returns the binomial average of a cell and its eight neighbours; neighbours without a height count as the cell itself.
#[inline]
fn average(heights: &[f32], columns: usize, cell: usize) -> f32 {
    let own = heights[cell];
    let at = |cell: usize| if heights[cell] < f32::INFINITY { heights[cell] } else { own };
    let row = |middle: usize| at(middle - 1) + 2.0 * at(middle) + at(middle + 1);
    (row(cell - columns) + 2.0 * row(cell) + row(cell + columns)) / 16.0
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
            let mut creep = Creep::new(before.clone()).unwrap();
            while creep.advance(&cells, &is_fixed, NonZero::<usize>::MIN) {}
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
        let mut creep = Creep::new((0..81).map(height).collect()).unwrap();
        creep.advance(&cells, &[false; 81], NonZero::<usize>::MIN);
        let row = &creep.heights[36..45];
        assert!((row[4] - 4.625).abs() < 1e-6 && row[3] == 4.0 && row[2] == 3.0, "{row:?}");
    }
}
