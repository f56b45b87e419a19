//! The tracts of land and water that have names, and a place in the midst of each.

use glam::Vec2;

use super::PlaceKind;
use super::lattice::{Lattice, SIDE, smoothed};
use crate::land::{CELL_SIZE, Land, Region};

/// A place that is to have a name.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub kind: PlaceKind,
    /// A place in its midst, in units.
    pub at: Vec2,
    /// The line along which its name may run, in units; empty for most.
    pub line: Vec<Vec2>,
    /// Its size, in units.
    pub size: f32,
}

/// Finds the tracts of a land: the seas, which reach the frame of the map; the lakes, which do not; and the islands, the main land first.
pub(super) fn tracts(land: &Land) -> [Vec<Region>; 3] {
    let (mut seas, mut lakes) = (Vec::new(), Vec::new());
    for water in land.waters() {
        let kind = if reaches_frame(land, &water) { &mut seas } else { &mut lakes };
        kind.push(water);
    }
    [seas, lakes, land.islands()]
}

/// Returns a place in the midst of a tract: the middle of the cell that is farthest from the coast.
pub(super) fn midst(land: &Land, tract: &Region) -> Vec2 {
    /// The greatest rise of the distance from the coast along a row, per unit.
    const STEEPEST: f32 = 2.0;
    let mut midst = (Vec2::ZERO, -1.0);
    for run in &tract.runs {
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

/// Returns the axis of the main land, from west to east: the middles of its broadest parts from north to south, without its ends.
pub(super) fn axis(lattice: &Lattice) -> Vec<Vec2> {
    /// The share of the columns that is left out at either end.
    const LEFT_OUT: usize = 12;
    let mut middles = Vec::new();
    for column in 0..lattice.columns {
        let (mut best, mut length) = ((0, 0), 0);
        for row in 0..lattice.rows {
            length = if lattice.lands[row * lattice.columns + column] == 1 { length + 1 } else { 0 };
            if length > best.0 {
                best = (length, row);
            }
        }
        let (length, row) = best;
        if length > 0 {
            middles.push(Vec2::new(column as f32 + 0.5, row as f32 + 1.0 - 0.5 * length as f32) * SIDE);
        }
    }
    let out = middles.len() / LEFT_OUT;
    let mut line = middles[out..middles.len() - out].to_vec();
    // Where the broadest part is another one the middles jump.
    (0..8).for_each(|_| line = smoothed(&line));
    line
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
                let cells = tract.runs.iter().flat_map(|run| (run.start..run.end).map(|column| (column, run.row)));
                let farthest = cells
                    .map(|(column, row)| from_coast(land.point(column, row, Vec2::splat(0.5))))
                    .fold(-1.0, f32::max);
                assert_eq!(from_coast(midst(&land, tract)), farthest, "{kind}");
            }
        }
    }
}
