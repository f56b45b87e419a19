//! The distance from all shores, those of the sea and of lakes, for what stands on the land or lies on the water.

use super::cells::fill;
use super::list::Lakes;
use crate::base::geometry::fast_min;
use crate::base::work;
use crate::domain::Domain;
use crate::land::{CELL_SIZE, CoastDistance, Region, Run};
use crate::relief::Grid;

impl Lakes {
    /// Returns the distance of each place of a map from the nearest shore, in units, positive on dry land: that of a coast, with lakes
    /// taken out of the land. Without a coast all of the map is land. `None` without lakes.
    pub fn shoreline(&self, coast: Option<&CoastDistance>, domain: &Domain) -> Option<CoastDistance> {
        if self.is_empty() {
            return None;
        }
        let rings = self.list.iter().flat_map(|lake| lake.rings.iter().cloned()).collect();
        let spacing = coast.map_or(CoastDistance::SPACING, CoastDistance::spacing);
        let lakes = CoastDistance::within(domain, spacing, rings);
        work::count(lakes.heights().len());
        let inland = |corner: usize| coast.map_or(f32::INFINITY, |coast| coast.heights()[corner]);
        let heights = lakes.heights().iter().enumerate().map(|(corner, lake)| fast_min(-lake, inland(corner)));
        Some(lakes.with_heights_of(&heights.collect::<Vec<_>>()))
    }

    /// Returns the cells of a lake, as those of land are counted, on a map with a domain.
    pub fn region(&self, lake: usize, domain: &Domain) -> Region {
        let grid = Grid { cell_size: CELL_SIZE, ..Grid::of(domain) };
        let count = |length: f32| (length / CELL_SIZE).ceil() as usize;
        let grid = Grid { columns: count(domain.size.x), rows: count(domain.size.y), ..grid };
        let mut region = Region::default();
        fill(&self.list[lake].rings, &grid, |cell| {
            let (row, column) = ((cell / grid.columns) as u32, (cell % grid.columns) as u32);
            match region.runs.last_mut() {
                Some(run) if (run.row, run.end) == (row, column) => run.end += 1,
                _ => region.runs.push(Run { row, start: column, end: column + 1, before: region.cells }),
            }
            region.cells += 1;
        });
        region
    }
}
