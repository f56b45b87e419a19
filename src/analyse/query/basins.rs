//! The first river that the water of each land cell comes to.

use glam::Vec2;

use crate::map::Map;
use crate::network::NONE;
use crate::relief::{Flow, Grid, rings_around};

/// A river for each cell of the relief.
#[derive(Debug)]
pub(super) struct RiverBasins {
    grid: Grid,
    /// The first river on the way of each cell's water; [`NONE`] at sea, and where water reaches the sea without a
    /// river.
    rivers: Vec<u32>,
}

impl RiverBasins {
    /// Finds the rivers for a map's relief, which is made if it does not exist yet; `None` if there is not enough
    /// memory.
    pub fn new(map: &Map) -> Option<Self> {
        let (relief, settings) = (map.make_relief().ok()?, map.relief_settings());
        let Flow { directions, mut rivers, .. } = Flow::new(&relief, map.network(), &settings).ok()?;
        let mut is_known = vec![false; directions.len()];
        let mut way = Vec::new();
        for cell in 0..directions.len() {
            let mut at = Some(cell);
            while let Some(here) = at.filter(|&here| !is_known[here] && rivers[here] == NONE) {
                is_known[here] = true;
                way.push(here);
                at = downstream(here, directions[here], &settings.grid);
            }
            let river = at.map_or(NONE, |end| rivers[end]);
            while let Some(cell) = way.pop() {
                rivers[cell] = river;
            }
        }
        Some(Self { grid: settings.grid, rivers })
    }

    /// Returns the rings around the cells of the wanted rivers, in units.
    pub fn rings(&self, is_wanted: impl Fn(u32) -> bool) -> Vec<Vec<Vec2>> {
        let mut cells = Vec::new();
        // Neighbouring cells mostly belong to one river.
        let mut last = (NONE, false);
        for (cell, &river) in self.rivers.iter().enumerate() {
            if river != last.0 {
                last = (river, river != NONE && is_wanted(river));
            }
            if last.1 {
                cells.push(cell);
            }
        }
        rings_around(&cells, &self.grid)
    }
}

/// Returns the cell that a direction leads to from another; `None` if it leads off the map.
fn downstream(cell: usize, code: u8, grid: &Grid) -> Option<usize> {
    const OFFSETS: [(isize, isize); 8] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
    let &(east, south) = OFFSETS.get(code.trailing_zeros() as usize)?;
    let column = (cell % grid.columns).checked_add_signed(east).filter(|&column| column < grid.columns)?;
    let row = (cell / grid.columns).checked_add_signed(south).filter(|&row| row < grid.rows)?;
    Some(row * grid.columns + column)
}
