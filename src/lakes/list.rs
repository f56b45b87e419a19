//! The lakes of a map as plain data, and what they cover.

use glam::Vec2;

use super::cells::{around, cell_at, fill};
use crate::base::rings::are_around;
use crate::network::{NONE, Network, River};
use crate::relief::{Grid, Relief, let_fall};

/// A lake through which a river runs.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Lake {
    /// The identity of the river at the outlet, mixed with the place of the dam along it. No other lake has the same.
    pub identity: u32,
    /// A place in its midst, far from its shores, in units.
    pub at: Vec2,
    /// The height of the water over the sea, in units.
    pub level: f32,
    /// The greatest depth, in units.
    pub depth: f32,
    /// The area of the water, in square units.
    pub area: f32,
    /// The river that runs out of the lake, and its vertex nearest to the dam.
    pub outlet: Outlet,
    /// The shores, in units: first the outer one, then those of islands. The last point of a ring is followed by its first.
    pub rings: Vec<Vec<Vec2>>,
}

/// The outlet of a lake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Outlet {
    /// The index of the river.
    pub river: u32,
    /// The index of the vertex in the network.
    pub vertex: u32,
}

/// The lakes of a map, the greatest first.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Lakes {
    /// The lakes.
    pub list: Vec<Lake>,
    /// What each cell of the map's own relief is to the lakes; empty if there are none.
    pub(super) cells: Vec<Cell>,
    /// The cells of shores that would lie under the level, each with the height that it is raised to, in units.
    pub(super) raised: Vec<(u32, f32)>,
    /// The grid of these cells; `None` if there are no lakes.
    pub(super) grid: Option<Grid>,
}

/// A cell's place among lakes: an index of a lake, and whether the cell is water or its shore.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cell(pub u32);

impl Cell {
    /// Neither a lake nor a shore.
    pub const DRY: Self = Self(u32::MAX);
    /// The bit that tells a shore from water.
    pub const SHORE: u32 = 1 << 31;

    pub fn water(self) -> Option<usize> {
        (self.0 & Self::SHORE == 0).then_some(self.0 as usize)
    }

    /// Returns the lake that the cell is of, as water or as shore.
    fn lake(self) -> Option<usize> {
        (self != Self::DRY).then_some((self.0 & !Self::SHORE) as usize)
    }
}

/// The height over a lake, in units, up to which its shore is raised where it would lie under the level.
pub(super) const SHORE: f32 = 0.5;

/// A stretch of a river's course that lies in a lake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Passage {
    /// The index of the lake.
    pub lake: usize,
    /// The first and the last point of the river's course that lie in it, counted from 0 at the source.
    pub points: [usize; 2],
}

impl Lakes {
    /// Lists the stretches of a river's course that lie in lakes, from the source down.
    pub fn passages(&self, network: &Network, river: &River) -> Vec<Passage> {
        let mut passages: Vec<Passage> = Vec::new();
        if self.is_empty() {
            return passages;
        }
        for (point, vertex) in network.course(river).enumerate() {
            let Some(lake) = self.at(vertex.at) else { continue };
            match passages.last_mut() {
                Some(last) if last.lake == lake && last.points[1] + 1 == point => last.points[1] = point,
                _ => passages.push(Passage { lake, points: [point; 2] }),
            }
        }
        passages
    }

    /// Returns `true` if there are no lakes.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Returns the index of the lake at a point in units.
    pub fn at(&self, point: Vec2) -> Option<usize> {
        // No shore is farther than two cells from the water of its lake, so most points need no look at shores.
        let own = self.grid.as_ref()?;
        let beside = |cell: usize| around(own, cell).into_iter().flatten();
        let cell = cell_at(own, point);
        let water = |cell: usize| self.cells[cell].water();
        let near = water(cell).or_else(|| beside(cell).find_map(water));
        let near = near.or_else(|| beside(cell).flat_map(beside).find_map(water))?;
        are_around(&self.list[near].rings, point).then_some(near)
    }

    /// Finds the lake that covers each cell of a grid, by its index: of the map's own grid as its relief says, of others by the middle
    /// of the cell; [`NONE`] elsewhere. Empty if there are no lakes.
    pub fn on(&self, grid: &Grid) -> Vec<u32> {
        if self.is_empty() {
            return Vec::new();
        }
        if self.grid.as_ref() == Some(grid) {
            return self.cells.iter().map(|cell| cell.water().map_or(NONE, |lake| lake as u32)).collect();
        }
        let mut covered = vec![NONE; grid.columns * grid.rows];
        for (id, lake) in (0..).zip(&self.list) {
            fill(&lake.rings, grid, |cell| covered[cell] = id);
        }
        covered
    }

    /// Returns the heights of the surface of a relief of the map, in units: the level of the water where there is a lake, and a shore
    /// nowhere under it.
    pub fn surface(&self, relief: &Relief) -> Vec<f32> {
        let mut heights = relief.heights().to_vec();
        self.raise(&mut heights, &relief.grid(), &self.on(&relief.grid()));
        heights
    }

    /// Raises the heights of the ground, in units, to the surface of lakes; `covered` is the lake that covers each cell.
    fn raise(&self, heights: &mut [f32], grid: &Grid, covered: &[u32]) {
        let is_own = self.grid == Some(*grid);
        for (cell, lake) in covered.iter().enumerate() {
            if let Some(lake) = self.list.get(*lake as usize) {
                heights[cell] = lake.level;
            } else if let Some(lake) = self.shore_at(grid, cell).filter(|_| !is_own) {
                heights[cell] = raised((lake.level, lake.level - lake.depth), heights[cell]);
            }
        }
        for &(cell, height) in self.raised.iter().filter(|_| is_own) {
            heights[cell as usize] = height;
        }
    }

    /// Puts the surface of the water in place of its bed in a relief of the map. `covered` is the lake that covers each cell, and `next`
    /// the cell that a cell's water runs to: on grids other than the map's own, land that would not be higher is raised a little over it.
    pub(crate) fn fill(&self, relief: Relief, covered: &[u32], next: impl Fn(usize) -> Option<usize>) -> Relief {
        let grid = relief.grid();
        let mut heights = relief.into_heights();
        self.raise(&mut heights, &grid, covered);
        if self.grid != Some(grid) {
            let_fall(&mut heights, |height| height <= 0.0, next, covered, f32::next_up);
        }
        Relief::on(grid, heights)
    }

    /// Lists the cells that lakes cover, each with the depth of the water on a relief, in units; `covered` is the lake that covers each
    /// cell.
    pub(crate) fn depths(&self, relief: &Relief, covered: &[u32]) -> Vec<(u32, f32)> {
        let water = (0..).zip(covered).zip(relief.heights()).filter_map(|((cell, lake), height)| {
            let lake = self.list.get(*lake as usize)?;
            Some((cell, (lake.level - height).max(0.0)))
        });
        water.collect()
    }

    /// Returns the lake on whose shore a cell of a grid lies, in it or beside it.
    fn shore_at(&self, grid: &Grid, cell: usize) -> Option<&Lake> {
        let own = self.grid.as_ref()?;
        let at = (Vec2::new((cell % grid.columns) as f32, (cell / grid.columns) as f32) + 0.5) * grid.cell_size;
        self.cells[cell_at(own, at)].lake().map(|lake| &self.list[lake])
    }
}

/// Raises the height of a shore over the level of its lake, all in units; what was lower stays lower.
pub(super) fn raised((level, bed): (f32, f32), height: f32) -> f32 {
    let share = (height - bed) / (level - bed + SHORE);
    if share < 1.0 { level + share.max(0.0) * SHORE } else { height }
}
