//! The tracts of land and water that have names, and a place in the midst of each.

use glam::Vec2;

use crate::land::{CELL_SIZE, Land, Region};

/// A sea, a lake or an island.
pub(super) struct Tract {
    /// Its place among its kind, the largest first.
    pub number: u32,
    /// In square units.
    pub area: f32,
    pub region: Region,
}

/// The seas, which reach the frame of the map; the lakes, which do not; and the islands, the main land first.
pub(super) fn tracts(land: &Land) -> [Vec<Tract>; 3] {
    let (seas, lakes): (Vec<Region>, Vec<Region>) =
        land.waters().into_iter().partition(|water| reaches_frame(land, water));
    let tract =
        |(number, region): (u32, Region)| Tract { number, area: region.cells as f32 * (CELL_SIZE * CELL_SIZE), region };
    [seas, lakes, land.islands()].map(|regions| (0..).zip(regions).map(tract).collect())
}

impl Tract {
    /// A place in the midst of it: the middle of the cell that is farthest from the coast.
    pub fn midst(&self, land: &Land) -> Vec2 {
        /// The distance from the coast rises by no more than this along a row, by the unit.
        const STEEPEST: f32 = 2.0;
        let mut midst = (Vec2::ZERO, -1.0);
        for run in &self.region.runs {
            let mut column = run.start;
            while column < run.end {
                let at = land.point(column, run.row, Vec2::splat(0.5));
                let far = land.coast_distance().height(at).abs();
                if far > midst.1 {
                    midst = (at, far);
                }
                // None of those that follow is farther off, as far as it would have to rise for that.
                column += 1 + ((midst.1 - far) / (STEEPEST * CELL_SIZE)) as u32;
            }
        }
        midst.0
    }
}

fn reaches_frame(land: &Land, region: &Region) -> bool {
    let (columns, rows) = (land.columns() as u32, land.rows() as u32);
    region.runs.iter().any(|run| run.row == 0 || run.row + 1 == rows || run.start == 0 || run.end == columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lands::lands_with_a_coast;
    use crate::recipe::link;

    #[test]
    fn no_cell_of_a_piece_is_farther_from_the_coast_than_its_midst() {
        for kind in lands_with_a_coast() {
            let land = Land::of(&link::read(&format!("aspect=1.5&{kind}&seed=kea")).unwrap()).unwrap();
            let from_coast = |at: Vec2| land.coast_distance().height(at).abs();
            for tract in tracts(&land).iter().flatten() {
                let cells =
                    tract.region.runs.iter().flat_map(|run| (run.start..run.end).map(|column| (column, run.row)));
                let farthest = cells
                    .map(|(column, row)| from_coast(land.point(column, row, Vec2::splat(0.5))))
                    .fold(-1.0, f32::max);
                assert_eq!(from_coast(tract.midst(&land)), farthest, "{kind}");
            }
        }
    }
}
