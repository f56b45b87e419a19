//! The flood above a dam: water rises over the ground upstream, the lowest first.

use glam::Vec2;

use super::upstream::Upstream;
use crate::base::geometry::distance;
use crate::base::queue::Queue;
use crate::base::work;
use crate::relief::{Grid, Relief};

/// The ground that is flooded, cell by cell.
pub(super) struct Ground<'a> {
    pub relief: &'a Relief,
    pub upstream: &'a Upstream,
    /// `true` for cells in another lake or close to one.
    pub is_taken: &'a [bool],
}

/// The water above a dam.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Flooded {
    pub cells: Vec<usize>,
    /// The height of the water, in units: that of its highest cell.
    pub level: f32,
    /// The height of the lowest cell, in units.
    pub bed: f32,
}

/// The greatest depth of a lake, in units.
const DEEPEST: f32 = 18.0;

/// The distance from the dam within which a moraine holds back the water, in units.
const MORAINE: f32 = 9.0;

/// The least height of a lake's bed over the sea, in units.
const OVER_SEA: f32 = 0.6;

impl Ground<'_> {
    /// Floods the ground above a dam until so many cells are under water. `None` if it cannot hold them.
    pub fn flood(&self, dam: usize, cells: usize) -> Option<Flooded> {
        let bed = self.relief.heights()[dam];
        if bed < OVER_SEA || self.is_taken[dam] {
            return None;
        }
        let (mut queue, mut flooded) = (Queue::default(), Flooded { level: bed, bed, ..Flooded::default() });
        let mut spill = bed + DEEPEST;
        queue.push(bed, dam as u32);
        while let Some(cell) = queue.pop() {
            let cell = cell as usize;
            let height = self.relief.heights()[cell].max(flooded.level);
            if height >= spill {
                return None;
            }
            flooded.level = height;
            flooded.cells.push(cell);
            spill = spill.min(self.spread(cell, dam, &mut queue));
            if flooded.cells.len() >= cells {
                return (spill > height).then_some(flooded);
            }
        }
        None
    }

    /// Lets water spread from a cell to those whose water it takes. Returns the height at which it would run over elsewhere.
    fn spread(&self, cell: usize, dam: usize, queue: &mut Queue) -> f32 {
        let heights = self.relief.heights();
        work::count(8);
        let mut spill = f32::INFINITY;
        for beside in around(&self.relief.grid(), cell) {
            let Some(beside) = beside else { return f32::NEG_INFINITY };
            if self.upstream.is_above(beside, dam) {
                if self.is_taken[beside] {
                    return f32::NEG_INFINITY;
                }
                if self.upstream.to[beside] as usize == cell && beside != dam {
                    queue.push(heights[beside], beside as u32);
                }
            } else if heights[beside] <= 0.0 || self.is_taken[beside] || !self.is_at_dam(beside, dam) {
                spill = spill.min(heights[beside]);
            }
        }
        spill
    }

    /// Returns `true` if a moraine may hold back the water at a cell.
    pub fn is_at_dam(&self, cell: usize, dam: usize) -> bool {
        let Grid { cell_size, columns, .. } = self.relief.grid();
        let place = |cell: usize| Vec2::new((cell % columns) as f32, (cell / columns) as f32) * cell_size;
        distance(place(cell), place(dam)) <= MORAINE
    }
}

/// Returns the eight cells around a cell; `None` for those beyond the grid.
pub(super) fn around(grid: &Grid, cell: usize) -> [Option<usize>; 8] {
    const OFFSETS: [(isize, isize); 8] = [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)];
    let (column, row) = (cell % grid.columns, cell / grid.columns);
    OFFSETS.map(|(east, south)| {
        let column = column.checked_add_signed(east).filter(|column| *column < grid.columns)?;
        let row = row.checked_add_signed(south).filter(|row| *row < grid.rows)?;
        Some(row * grid.columns + column)
    })
}
