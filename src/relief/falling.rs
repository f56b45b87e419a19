//! Heights that fall along given ways of water.

use crate::network::NONE;

/// Raises land that is not higher than the cell that its water runs to, by as little as `above` says. `next` is that cell; what `is_sea`
/// stays as high as it is. `lakes` has the number of the lake that covers each cell, [`NONE`] elsewhere, and is empty if there are no
/// lakes: a lake is level, and rises as a whole over the cell that its water leaves it to.
#[doc(hidden)] // for the crate that writes files
pub fn let_fall<T: Copy + PartialOrd>(
    heights: &mut [T],
    is_sea: impl Fn(T) -> bool,
    next: impl Fn(usize) -> Option<usize>,
    lakes: &[u32],
    above: impl Fn(T) -> T,
) {
    let higher = |height: T, least: Option<T>| least.filter(|least| *least > height).unwrap_or(height);
    let lakes = Lakes::of(heights, lakes, &next);
    let mut is_done: Vec<bool> = heights.iter().map(|height| is_sea(*height)).collect();
    let mut upstream = Vec::new();
    for start in 0..heights.len() {
        let mut cell = Some(start);
        while let Some(open) = cell.filter(|cell| !is_done[*cell]) {
            lakes.level_with(&open).iter().for_each(|cell| is_done[*cell] = true);
            upstream.push(open);
            cell = lakes.lake(open).map_or_else(|| next(open), |lake| lakes.outlets[lake]);
        }
        let mut below = cell.map(|cell| heights[cell]);
        while let Some(cell) = upstream.pop() {
            let height = higher(heights[cell], below.map(&above));
            lakes.level_with(&cell).iter().for_each(|cell| heights[*cell] = height);
            below = Some(height);
        }
    }
}

/// The lakes of a grid.
struct Lakes<'a> {
    /// The number of the lake of each cell; empty if there are none.
    of: &'a [u32],
    cells: Vec<Vec<usize>>,
    /// The cell that the water of each lake runs to.
    outlets: Vec<Option<usize>>,
}

impl<'a> Lakes<'a> {
    fn of<T: Copy + PartialOrd>(heights: &[T], of: &'a [u32], next: &impl Fn(usize) -> Option<usize>) -> Self {
        let mut cells: Vec<Vec<usize>> = Vec::new();
        for (cell, lake) in of.iter().enumerate().filter(|(_, lake)| **lake != NONE) {
            cells.resize(cells.len().max(*lake as usize + 1), Vec::new());
            cells[*lake as usize].push(cell);
        }
        let mut this = Self { of, cells, outlets: Vec::new() };
        this.outlets = (0..this.cells.len()).map(|lake| this.outlet(lake, heights, next)).collect();
        this
    }

    fn lake(&self, cell: usize) -> Option<usize> {
        self.of.get(cell).filter(|lake| **lake != NONE).map(|lake| *lake as usize)
    }

    /// Returns the cells of a cell's lake, or that cell alone.
    fn level_with<'b>(&'b self, cell: &'b usize) -> &'b [usize] {
        self.lake(*cell).map_or(std::slice::from_ref(cell), |lake| &self.cells[lake])
    }

    /// Finds the lowest cell that the water of a lake runs to and does not come back from.
    fn outlet<T: Copy + PartialOrd>(
        &self,
        lake: usize,
        heights: &[T],
        next: &impl Fn(usize) -> Option<usize>,
    ) -> Option<usize> {
        let is_in = |cell: &usize| self.lake(*cell) == Some(lake);
        let comes_back = |cell: usize| {
            // Not even a way through all cells is longer.
            std::iter::successors(Some(cell), |cell| next(*cell)).take(heights.len()).any(|cell| is_in(&cell))
        };
        let left = self.cells[lake].iter().filter_map(|cell| next(*cell)).filter(|cell| !is_in(cell));
        let mut outlet: Option<usize> = None;
        for cell in left {
            if outlet.is_none_or(|lowest| heights[cell] < heights[lowest]) && !comes_back(cell) {
                outlet = Some(cell);
            }
        }
        outlet
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fall(heights: &mut [f32], next: impl Fn(usize) -> Option<usize>, lakes: &[u32]) {
        let_fall(heights, |height| height <= 0.0, next, lakes, f32::next_up);
    }

    /// The numbers of lakes of eight cells, one lake in some of them.
    fn lake(cells: std::ops::Range<usize>) -> Vec<u32> {
        (0..8).map(|cell| if cells.contains(&cell) { 0 } else { NONE }).collect()
    }

    #[test]
    fn land_falls_and_the_sea_and_lakes_stay() {
        let mut heights = [-4.0, 0.5, 1.0, 1.0, 1.0, 0.5];
        fall(&mut heights, |cell| cell.checked_sub(1), &lake(2..4));
        assert_eq!(heights, [-4.0, 0.5, 1.0, 1.0, 1.0f32.next_up(), 1.0f32.next_up().next_up()]);
    }

    #[test]
    fn a_lake_rises_as_a_whole_over_its_outlet() {
        let mut heights = [-4.0, 2.0, 2.0, 2.0, 2.0, 1.0];
        fall(&mut heights, |cell| cell.checked_sub(1), &lake(3..5));
        let [first, second, third] =
            [2.0f32.next_up(), 2.0f32.next_up().next_up(), 2.0f32.next_up().next_up().next_up()];
        assert_eq!(heights, [-4.0, 2.0, first, second, second, third]);
    }

    #[test]
    fn land_whose_water_comes_back_to_a_lake_is_no_outlet() {
        // The water of cell 3 runs out to cell 2 and back to 4; that of 4 to 5, and to the sea.
        let ways = [None, None, Some(4), Some(2), Some(5), Some(6), None];
        let mut heights = [9.0, 9.0, 1.0, 3.0, 3.0, 3.0, -1.0];
        fall(&mut heights, |cell| ways[cell], &lake(3..5));
        assert_eq!(heights[3..6], [3.0f32.next_up(), 3.0f32.next_up(), 3.0]);
        assert!(heights[2] > heights[4]);
    }

    #[test]
    fn land_that_falls_already_keeps_its_heights() {
        let mut heights = [3.0, 2.0, 1.0];
        fall(&mut heights, |cell| Some(cell + 1).filter(|next| *next < 3), &[]);
        assert_eq!(heights, [3.0, 2.0, 1.0]);
    }
}
