//! Rivers on cells: the path of each from cell to cell, with the height of the water in each.

use std::ops::Range;

use glam::Vec2;

use super::cells::Cells;
use crate::base::geometry::{distance, fast_min};
use crate::base::memory::{Refused, lengthen, reserve};
use crate::base::work;
use crate::network::{Network, River};

/// A cell that a river passes, with the height of the water there by the river's own profile, in units.
pub(super) type Step = (u32, f32);

/// A river's path.
#[derive(Clone, Copy, Debug)]
struct Path {
    /// The first step, at the source, and the end of the range. The cell of each step touches the next.
    start: u32,
    end: u32,
}

impl Path {
    fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// The paths of all rivers.
#[derive(Clone, Debug, Default)]
pub(super) struct Channels {
    /// The steps of all paths, one path after another.
    steps: Vec<Step>,
    /// The paths of the rivers that have been walked, in the order of rivers.
    paths: Vec<Path>,
    /// The indices of all rivers, each after the one that it joins.
    parents_first: Vec<u32>,
    /// The elevation of each vertex, in units, and its step; both empty once all rivers have been walked.
    elevations: Vec<f32>,
    step_of: Vec<u32>,
}

/// The least fall from one cell to the next, as a share of the height.
const LEAST_FALL: f32 = 1e-5;

impl Channels {
    /// Prepares rivers for the walk; `elevations` has the height of each vertex, in units.
    pub fn new(network: &Network, elevations: Vec<f32>) -> Result<Self, Refused> {
        let vertices = network.vertices.len();
        let mut this = Self { parents_first: parents_first(network)?, elevations, ..Self::default() };
        reserve(&mut this.paths, network.rivers.len())?;
        lengthen(&mut this.step_of, vertices, 0)?;
        work::count(vertices);
        Ok(this)
    }

    /// Makes rivers that have been walked from the steps of their paths; none joins another.
    #[cfg(test)]
    pub fn of_paths(paths: &[Vec<(usize, f32)>]) -> Self {
        let mut this = Self { parents_first: (0..paths.len() as u32).collect(), ..Self::default() };
        for path in paths {
            let start = this.steps.len() as u32;
            this.steps.extend(path.iter().map(|&(cell, height)| (cell as u32, height)));
            this.paths.push(Path { start, end: this.steps.len() as u32 });
        }
        this
    }

    /// Walks some more rivers from cell to cell. Returns `true` if there are more.
    pub fn walk(&mut self, cells: &Cells, network: &Network) -> Result<bool, Refused> {
        /// The number of cells after which a call ends.
        const CELLS_A_STEP: usize = 50_000;
        let begun = self.steps.len();
        while let Some(river) = network.rivers.get(self.paths.len()) {
            if self.steps.len() - begun >= CELLS_A_STEP {
                return Ok(true);
            }
            self.walk_river(cells, network, river)?;
        }
        (self.step_of, self.elevations) = (Vec::new(), Vec::new());
        Ok(false)
    }

    fn walk_river(&mut self, cells: &Cells, network: &Network, river: &River) -> Result<(), Refused> {
        let start = self.paths.last().map_or(0, |path| path.end as usize);
        // A walk that ran out of memory may have left steps.
        self.steps.truncate(start);
        let mut walk = Walk { cells, steps: &mut self.steps, start };
        let place = |i: usize| (network.vertices[i].at, self.elevations[i]);
        let mut last = place(river.start as usize);
        for i in river.vertex_range() {
            walk.straight(std::mem::replace(&mut last, place(i)), place(i))?;
            self.step_of[i] = walk.steps.len() as u32 - 1;
        }
        match network.vertices.get(river.junction as usize) {
            Some(_) => walk.straight(last, place(river.junction as usize))?,
            None => walk.down_to_the_sea()?,
        }
        let end = self.steps.len() as u32;
        self.paths.push(Path { start: start as u32, end });
        Ok(())
    }

    /// Makes every river fall from each cell to the next, minimally where it is level. Heights are only ever lowered,
    /// and stay above the sea. Where rivers share cells, only the one that the others join is sure to fall.
    pub fn let_fall(&self, cells: &Cells, heights: &mut [f32]) {
        work::count(self.steps.len());
        for &river in self.parents_first.iter().rev() {
            let mut above = f32::INFINITY;
            for &(cell, _) in self.path(river as usize).iter().filter(|step| cells.is_land(step.0 as usize)) {
                let height = &mut heights[cell as usize];
                *height = fast_min(*height, fast_min(above * (1.0 - LEAST_FALL), above.next_down()));
                above = *height;
            }
        }
    }

    /// Calls `lower` with each cell of a river that stands above a bank, and with the height of its lowest bank, by the
    /// given heights of all cells. A bank that touches the river's next cell does not count: water that runs over it
    /// comes back. Returns the sum of the differences, in units.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn find_dams(&self, cells: &Cells, heights: &[f32], mut lower: impl FnMut(usize, f32)) -> Result<f32, Refused> {
        work::count(9 * self.steps.len());
        let is_river = self.marked(heights.len())?;
        let mut lowered = 0.0;
        for pair in self.paths().flat_map(|path| path.windows(2)) {
            let (cell, next) = (pair[0].0 as usize, pair[1].0 as usize);
            let is_bank =
                |&beside: &usize| heights[beside] < heights[cell] && !is_river[beside] && !cells.touch(beside, next);
            let banks = cells.around(cell).into_iter().filter(is_bank).map(|bank| heights[bank]);
            let lowest = banks.fold(heights[cell], fast_min);
            if lowest < heights[cell] && cells.is_land(cell) {
                lowered += heights[cell] - lowest;
                lower(cell, lowest);
            }
        }
        Ok(lowered)
    }

    /// Returns for each of so many cells `true` if a river passes it.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn marked(&self, cells: usize) -> Result<Vec<bool>, Refused> {
        let mut is_river = Vec::new();
        lengthen(&mut is_river, cells, false)?;
        self.steps.iter().for_each(|step| is_river[step.0 as usize] = true);
        Ok(is_river)
    }

    /// Returns the number of steps of all paths.
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    fn path(&self, river: usize) -> &[Step] {
        &self.steps[self.paths[river].range()]
    }

    /// Iterates over the paths of all rivers, each as its steps from the source down.
    pub fn paths(&self) -> impl Iterator<Item = &[Step]> + '_ {
        self.paths.iter().map(|path| &self.steps[path.range()])
    }
}

/// Lists the indices of all rivers, each after the one that it joins, which comes later in the network if an upper
/// course was taken over.
pub(super) fn parents_first(network: &Network) -> Result<Vec<u32>, Refused> {
    let (mut order, mut upward, mut is_listed) = (Vec::new(), Vec::new(), Vec::new());
    reserve(&mut order, network.rivers.len())?;
    reserve(&mut upward, network.rivers.len())?;
    lengthen(&mut is_listed, network.rivers.len(), false)?;
    for start in 0..network.rivers.len() as u32 {
        let mut river = start;
        while is_listed.get(river as usize) == Some(&false) {
            is_listed[river as usize] = true;
            upward.push(river);
            river = network.rivers[river as usize].parent;
        }
        order.extend(upward.drain(..).rev());
    }
    Ok(order)
}

/// A path in the making.
struct Walk<'a> {
    cells: &'a Cells,
    steps: &'a mut Vec<Step>,
    /// The index of the first step of the path.
    start: usize,
}

impl Walk<'_> {
    /// Walks straight from one point to another, each with its height, in units.
    fn straight(&mut self, from: (Vec2, f32), to: (Vec2, f32)) -> Result<(), Refused> {
        // At most a cell to the side each time.
        let count = (distance(from.0, to.0) / (0.5 * self.cells.size)).ceil().max(1.0);
        work::count(count as usize);
        for i in 1..=count as usize {
            let share = i as f32 / count;
            self.enter(self.cells.of(from.0.lerp(to.0, share).max(Vec2::ZERO)), from.1 + (to.1 - from.1) * share)?;
        }
        Ok(())
    }

    fn enter(&mut self, cell: usize, height: f32) -> Result<(), Refused> {
        match self.steps[self.start..].last_mut() {
            Some((last, lowest)) if *last as usize == cell => *lowest = lowest.min(height),
            _ => {
                reserve(self.steps, 1)?;
                self.steps.push((cell as u32, height));
            }
        }
        Ok(())
    }

    /// Walks from a mouth on until a neighbouring cell is sea: the mouth lies on the coast line, which passes through
    /// cells.
    fn down_to_the_sea(&mut self) -> Result<(), Refused> {
        let cells = self.cells;
        while let Some(&(cell, height)) = self.steps[self.start..].last() {
            let cell = cell as usize;
            let around = cells.around(cell);
            work::count(around.len());
            if !cells.is_land(cell) || around.into_iter().any(|beside| cells.is_sea(beside)) {
                break;
            }
            let nearer = around.into_iter().min_by(|&a, &b| cells.inland[a].total_cmp(&cells.inland[b]));
            match nearer.filter(|&next| cells.is_land(next) && cells.inland[next] < cells.inland[cell]) {
                Some(next) => self.enter(next, height)?,
                None => {
                    let sea = cells.sea_near(cell).map(|sea| (cells.point(sea), height));
                    return sea.map_or(Ok(()), |sea| self.straight((cells.point(cell), height), sea));
                }
            }
        }
        Ok(())
    }
}
