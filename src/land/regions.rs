//! Regions: connected components of land, or of water. No river leads from one region of land to another, so each needs
//! its own mouth.

use glam::Vec2;

use super::cell::{CELL_SIZE, Cell};
use crate::base::sort;

/// The cells `start..end` of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// The row.
    pub row: u32,
    /// The first column.
    pub start: u32,
    /// The column after the last.
    pub end: u32,
    /// The number of the region's cells before the run.
    pub before: u32,
}

impl Run {
    /// Returns the north-western and the south-eastern corner of the box around its cells, in units.
    pub(crate) fn corners(&self) -> [Vec2; 2] {
        [(self.start, self.row), (self.end, self.row + 1)].map(|(x, y)| Vec2::new(x as f32, y as f32) * CELL_SIZE)
    }
}

/// A place where a river may reach the sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shore {
    /// The middle of a cell of land beside the sea.
    pub at: Vec2,
    /// The unit vector away from the water.
    pub inland: Vec2,
}

/// Cells that are connected by their sides.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Region {
    /// The cells, row by row.
    pub runs: Vec<Run>,
    /// The number of cells.
    pub cells: u32,
    /// The cells of land beside the sea, row by row.
    pub shores: Vec<Shore>,
}

impl Region {
    /// Returns `true` if a cell belongs to the region.
    pub fn contains(&self, column: u32, row: u32) -> bool {
        is_in(&self.runs, column, row)
    }

    /// Returns `true` if a point lies in one of its cells.
    pub fn holds(&self, point: Vec2) -> bool {
        let cell = (point / CELL_SIZE).floor();
        cell.min_element() >= 0.0 && self.contains(cell.x as u32, cell.y as u32)
    }

    /// Returns its area, in square units.
    pub(crate) fn area(&self) -> f32 {
        self.cells as f32 * (CELL_SIZE * CELL_SIZE)
    }

    /// Returns the north-western and the south-eastern corner of the box around its cells, in units; `None` if it has none.
    pub(crate) fn corners(&self) -> Option<[Vec2; 2]> {
        around(self.runs.iter().map(Run::corners))
    }
}

/// Returns `true` if a cell lies in one of some runs, which come row by row.
pub(super) fn is_in(runs: &[Run], column: u32, row: u32) -> bool {
    let next = runs.partition_point(|run| (run.row, run.start) <= (row, column));
    next.checked_sub(1).is_some_and(|run| runs[run].row == row && column < runs[run].end)
}

/// Returns the box around some boxes, each of which is given by its least and its greatest corner; `None` if there are none.
pub(super) fn around(boxes: impl Iterator<Item = [Vec2; 2]>) -> Option<[Vec2; 2]> {
    boxes.reduce(|all, one| [all[0].min(one[0]), all[1].max(one[1])])
}

/// The cells of some regions, region after region, each row by row, found by their numbers without a search among all
/// runs.
#[derive(Clone, Debug)]
pub struct Cells {
    runs: Vec<Run>,
    /// The run of every [`MANY`](Self::MANY)-th cell.
    run_of: Vec<u32>,
    count: u32,
}

impl Cells {
    /// The number of cells for each entry of the index: far fewer than a run across the domain has.
    const MANY: u32 = 64;

    /// Numbers the cells of regions.
    pub fn of<'a>(regions: impl Iterator<Item = &'a Region>) -> Self {
        let mut this = Self { runs: Vec::new(), run_of: Vec::new(), count: 0 };
        for run in regions.flat_map(|region| &region.runs) {
            let end = this.count + run.end - run.start;
            let firsts = end.div_ceil(Self::MANY) as usize;
            this.run_of.resize(firsts, this.runs.len() as u32);
            this.runs.push(Run { before: this.count, ..*run });
            this.count = end;
        }
        this
    }

    /// Returns the number of cells.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Returns the column and row of a cell; `None` if there is no such number.
    pub fn cell(&self, number: u32) -> Option<(u32, u32)> {
        let first = *self.run_of.get((number / Self::MANY) as usize)? as usize;
        let has = |run: &&Run| number < run.before + (run.end - run.start);
        let run = self.runs.get(first..)?.iter().find(has)?;
        Some((run.start + number - run.before, run.row))
    }
}

/// Finds the regions of cells of a kind, the largest first; among equally large ones, the northernmost first.
pub(super) fn regions(cells: &[Cell], kind: Cell, columns: usize) -> Vec<Region> {
    regions_of(&runs(cells, kind, columns))
}

/// Finds the regions of runs, the largest first; among equals, the northernmost. Runs must come row by row and not touch within a row.
pub(super) fn regions_of(runs: &[Run]) -> Vec<Region> {
    let mut joined = UnionFind((0..runs.len() as u32).collect());
    let mut above = 0;
    for (i, run) in runs.iter().enumerate() {
        while above < i
            && (runs[above].row + 1 < run.row || (runs[above].row < run.row && runs[above].end <= run.start))
        {
            above += 1;
        }
        let touching = runs[above..i].iter().take_while(|over| over.row < run.row && over.start < run.end);
        (above..).zip(touching).for_each(|(over, _)| joined.join(over as u32, i as u32));
    }
    gather(runs, &mut joined)
}

/// Returns the gaps between runs, row by row. Runs must come row by row and not touch within a row.
pub(super) fn between(runs: &[Run], columns: u32, rows: u32) -> Vec<Run> {
    let (mut gaps, mut runs) = (Vec::new(), runs.iter().peekable());
    for row in 0..rows {
        let mut start = 0;
        while let Some(run) = runs.next_if(|run| run.row == row) {
            gaps.extend((start < run.start).then_some(Run { row, start, end: run.start, before: 0 }));
            start = run.end;
        }
        gaps.extend((start < columns).then_some(Run { row, start, end: columns, before: 0 }));
    }
    gaps
}

/// Returns the runs of cells of a kind, row by row.
pub(super) fn runs(cells: &[Cell], kind: Cell, columns: usize) -> Vec<Run> {
    let mut runs = Vec::new();
    for (row, cells) in (0..).zip(cells.chunks(columns.max(1))) {
        let mut start = 0;
        for stretch in cells.chunk_by(|a, b| (*a == kind) == (*b == kind)) {
            let end = start + stretch.len() as u32;
            if stretch[0] == kind {
                runs.push(Run { row, start, end, before: 0 });
            }
            start = end;
        }
    }
    runs
}

/// Removes some cells from runs. Cells are given by index, row by row in ascending order.
pub(super) fn without(runs: &[Run], cells: &[usize], columns: usize) -> Vec<Run> {
    let mut left = Vec::with_capacity(runs.len() + cells.len());
    let mut cells = cells.iter().peekable();
    for run in runs {
        let first = run.row as usize * columns;
        let mut start = run.start;
        while let Some(cell) = cells.next_if(|&&cell| cell < first + run.end as usize) {
            let column = (cell - first) as u32;
            left.extend((start < column).then_some(Run { start, end: column, ..*run }));
            start = column + 1;
        }
        left.extend((start < run.end).then_some(Run { start, ..*run }));
    }
    left
}

fn gather(runs: &[Run], joined: &mut UnionFind) -> Vec<Region> {
    let mut regions: Vec<Region> = Vec::new();
    let mut number = vec![u32::MAX; runs.len()];
    for (i, run) in (0..).zip(runs) {
        let number = &mut number[joined.first(i) as usize];
        if *number == u32::MAX {
            *number = regions.len() as u32;
            regions.push(Region::default());
        }
        let region = &mut regions[*number as usize];
        region.runs.push(Run { before: region.cells, ..*run });
        region.cells += run.end - run.start;
    }
    let largest_first = sort::argsort(regions.iter().map(|region| !region.cells));
    largest_first.into_iter().map(|i| std::mem::take(&mut regions[i])).collect()
}

/// Sets of connected runs, by union-find: each run refers to an earlier one, and the first of a set to itself (Tarjan
/// 1975).
struct UnionFind(Vec<u32>);

impl UnionFind {
    fn first(&mut self, mut run: u32) -> u32 {
        while self.0[run as usize] != run {
            let earlier = self.0[self.0[run as usize] as usize];
            self.0[run as usize] = earlier;
            run = earlier;
        }
        run
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.first(a), self.first(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    /// Finds regions by flood fill, cell by cell.
    fn flooded(cells: &[Cell], columns: usize) -> Vec<Vec<usize>> {
        let mut seen = vec![false; cells.len()];
        let mut regions = Vec::new();
        for start in 0..cells.len() {
            let (mut region, mut next) = (Vec::new(), vec![start]);
            while let Some(i) = next.pop() {
                if cells[i] != Cell::Land || std::mem::replace(&mut seen[i], true) {
                    continue;
                }
                region.push(i);
                let column = i % columns;
                next.extend(
                    [i.checked_sub(columns), i.checked_add(columns).filter(|&i| i < cells.len())].into_iter().flatten(),
                );
                next.extend((column > 0).then(|| i - 1).into_iter().chain((column + 1 < columns).then(|| i + 1)));
            }
            region.sort_unstable();
            regions.extend((!region.is_empty()).then_some(region));
        }
        regions.sort_by_key(|region| std::cmp::Reverse(region.len()));
        regions
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn regions_are_what_a_flood_reaches(land in proptest::collection::vec(0u8..5, 1..400), columns in 1usize..25) {
            let cells: Vec<Cell> = land.iter().map(|&c| if c < 3 { Cell::Land } else { Cell::Water }).collect();
            let cells = &cells[..cells.len() / columns * columns];
            let ours: Vec<Vec<usize>> = regions(cells, Cell::Land, columns)
                .iter()
                .map(|region| {
                    let cells = Cells::of(std::iter::once(region));
                    let at = |i| cells.cell(i).map(|(column, row)| row as usize * columns + column as usize).unwrap();
                    (0..region.cells).map(at).collect()
                })
                .collect();
            prop_assert_eq!(ours, flooded(cells, columns));
        }
    }
}
