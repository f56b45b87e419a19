//! Land that has a river mouth.

use glam::Vec2;

use super::GrowthSettings;
use crate::land::{CELL_SIZE, Land};

/// The cells of land that have a river mouth. A map is used because there may be millions of places and hundreds of
/// regions.
pub(super) struct Watered {
    cells: Vec<bool>,
    columns: usize,
}

impl Watered {
    pub fn of(settings: &GrowthSettings, land: &Land) -> Self {
        let columns = land.columns() as usize;
        let mut cells = vec![false; columns * land.rows() as usize];
        for run in settings.watered().flat_map(|region| &region.runs) {
            let row = run.row as usize * columns;
            cells[row + run.start as usize..row + run.end as usize].fill(true);
        }
        Self { cells, columns }
    }

    /// Returns `true` if a point of the domain lies on land with a river mouth; never on the far borders of the domain.
    pub fn holds(&self, place: Vec2) -> bool {
        let (column, row) = ((place.x / CELL_SIZE) as usize, (place.y / CELL_SIZE) as usize);
        column < self.columns && self.cells.get(row * self.columns + column) == Some(&true)
    }
}
