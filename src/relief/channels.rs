//! Rivers on cells: the path of each from cell to cell, with the height of the water in each.

use std::ops::Range;

use glam::Vec2;

use super::cells::Cells;
use crate::base::geometry::{distance, fast_min};
use crate::base::memory::{Refused, ask, lengthen, reserve};
use crate::base::work;
use crate::network::{NONE, Network, River, hydrology};

/// A cell that a river passes, and the height of the water there, in units.
pub(super) type Step = (u32, f32);

/// A river's path.
#[derive(Clone, Copy, Debug)]
struct Path {
    /// Its first step, at the source, and the one behind its last. Each step touches the next.
    start: u32,
    end: u32,
    /// The step of another river's path where it joins that; [`NONE`] if it reaches the sea.
    junction: u32,
}

impl Path {
    fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// The paths of all rivers.
#[derive(Clone, Debug, Default)]
pub(super) struct Channels {
    /// Of all paths, one after another.
    steps: Vec<Step>,
    /// Of the rivers that have been walked.
    paths: Vec<Path>,
    /// The numbers of all rivers, each after the one that it joins.
    parents_first: Vec<u32>,
    /// Until all have been walked: of each vertex its elevation, in units, and its step.
    elevations: Vec<f32>,
    step_of: Vec<u32>,
}

/// The least fall from one cell to the next, as a share of a cell's side.
const LEAST_SLOPE: f32 = 5e-5;

impl Channels {
    /// Rivers that have not been walked yet. They are as high as given for each vertex, in units, or by the law of rivers.
    pub fn new(network: &Network, total_discharge: u32, given: Option<&[f32]>) -> Result<Self, Refused> {
        /// Of elevations, and of what they are made of.
        const BYTES_A_VERTEX: usize = 20;
        let vertices = network.vertices.len();
        let mut this = Self { parents_first: parents_first(network)?, ..Self::default() };
        reserve(&mut this.paths, network.rivers.len())?;
        lengthen(&mut this.step_of, vertices, 0)?;
        ask(vertices * BYTES_A_VERTEX)?;
        work::count(4 * vertices);
        this.elevations = match given {
            Some(heights) => heights.to_vec(),
            None => hydrology::elevations(network, total_discharge),
        };
        Ok(this)
    }

    /// Walks some more rivers from cell to cell. Returns whether there are more.
    pub fn walk(&mut self, cells: &Cells, network: &Network) -> Result<bool, Refused> {
        /// Having walked over so many cells, it goes on another time.
        const CELLS_A_STEP: usize = 50_000;
        let begun = self.steps.len();
        while let Some(river) = network.rivers.get(self.paths.len()) {
            if self.steps.len() - begun >= CELLS_A_STEP {
                return Ok(true);
            }
            self.walk_river(cells, network, river)?;
        }
        for (path, river) in self.paths.iter_mut().zip(&network.rivers) {
            path.junction = self.step_of.get(river.junction as usize).copied().unwrap_or(NONE);
        }
        (self.step_of, self.elevations) = (Vec::new(), Vec::new());
        Ok(false)
    }

    fn walk_river(&mut self, cells: &Cells, network: &Network, river: &River) -> Result<(), Refused> {
        let start = self.paths.last().map_or(0, |path| path.end as usize);
        // Nothing is left of a walk that was refused.
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
        self.paths.push(Path { start: start as u32, end, junction: NONE });
        Ok(())
    }

    /// Lowers rivers to a surface, and what is below them with them: a river is nowhere lower than farther down, and none
    /// lower at its end than the one it joins. Returns by how much, in units, over all cells.
    pub fn lower(&mut self, surface: &[f32]) -> f32 {
        work::count(self.steps.len());
        let mut lowered = 0.0;
        for &river in self.parents_first.iter().rev() {
            let path = self.paths[river as usize];
            let mut above = f32::INFINITY;
            for (cell, height) in &mut self.steps[path.range()] {
                let least = height.min(surface[*cell as usize]).min(above);
                lowered += *height - least;
                (*height, above) = (least, least);
            }
            if let Some((_, height)) = self.steps.get_mut(path.junction as usize) {
                lowered += (*height - above).max(0.0);
                *height = height.min(above);
            }
        }
        lowered
    }

    /// Notes, for each cell of a river, how high that or the lowest of its banks is, of the heights of all cells. A bank that touches the
    /// river's next cell does not count: water that runs over it comes back. `surface` has the rivers' cells, and is infinite elsewhere.
    pub fn note_banks(&self, cells: &Cells, heights: &[f32], surface: &mut [f32]) {
        work::count(9 * self.steps.len());
        self.steps.iter().for_each(|&(cell, _)| surface[cell as usize] = heights[cell as usize]);
        for pair in self.paths.iter().flat_map(|path| self.steps[path.range()].windows(2)) {
            let (cell, next) = (pair[0].0 as usize, pair[1].0 as usize);
            let is_bank = |&beside: &usize| surface[beside] == f32::INFINITY && cells.is_land(beside);
            let banks = cells.around(cell).into_iter().filter(is_bank).filter(|&bank| !cells.touch(bank, next));
            surface[cell] = banks.map(|bank| heights[bank]).fold(surface[cell], f32::min);
        }
    }

    /// Makes every river fall from each cell to the next, its end being where it joins another, or the sea.
    pub fn let_fall(&mut self, cells: &Cells) {
        work::count(self.steps.len());
        let least = LEAST_SLOPE * cells.size;
        for &river in &self.parents_first {
            let path = self.paths[river as usize];
            let mut below = self.steps.get(path.junction as usize).map_or(least, |junction| junction.1);
            let mut upward = self.steps[path.range()].iter_mut().rev();
            upward.next().into_iter().for_each(|end| end.1 = below);
            for (_, height) in upward {
                *height = height.max((below + least).max(below.next_up()));
                below = *height;
            }
        }
    }

    /// The cells of each river's path, from its source down.
    pub fn paths(&self) -> impl Iterator<Item = impl Iterator<Item = usize> + '_> + '_ {
        self.paths.iter().map(|path| self.steps[path.range()].iter().map(|&(cell, _)| cell as usize))
    }

    /// Each river's cells with the height of the water there, and those of its junction.
    #[cfg(test)]
    pub fn rivers(&self) -> impl Iterator<Item = (&[Step], Option<Step>)> + '_ {
        self.paths.iter().map(|path| (&self.steps[path.range()], self.steps.get(path.junction as usize).copied()))
    }

    /// How many cells rivers pass, each as often as they do.
    pub fn count(&self) -> usize {
        self.steps.len()
    }

    /// Notes the height of the water in each cell, of several rivers the lowest; infinite where there is none.
    pub fn note_heights(&self, heights: &mut [f32]) {
        work::count(heights.len() + self.steps.len());
        heights.fill(f32::INFINITY);
        for &(cell, height) in &self.steps {
            heights[cell as usize] = fast_min(height, heights[cell as usize]);
        }
    }
}

/// The numbers of all rivers, each after the one that it joins: rivers that take over another's upper course may stand before it.
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

/// The making of one path.
struct Walk<'a> {
    cells: &'a Cells,
    steps: &'a mut Vec<Step>,
    /// Its first step.
    start: usize,
}

impl Walk<'_> {
    /// Goes from one place to the next, each with its height.
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

    /// From a mouth on by the way down, until there is sea beside it: a coast runs through its cells anyhow.
    fn down_to_the_sea(&mut self) -> Result<(), Refused> {
        let cells = self.cells;
        while let Some(&(cell, height)) = self.steps[self.start..].last() {
            let cell = cell as usize;
            let around = cells.around(cell);
            work::count(around.len());
            let is_there = !cells.is_land(cell) || around.into_iter().any(|beside| cells.is_sea(beside));
            let nearer = around.into_iter().min_by(|&a, &b| cells.inland[a].total_cmp(&cells.inland[b]));
            match nearer.filter(|&next| !is_there && cells.is_land(next) && cells.inland[next] < cells.inland[cell]) {
                Some(next) => self.enter(next, height)?,
                None => break,
            }
        }
        Ok(())
    }
}
