//! The pieces of land and water that have names, and a place in the midst of each.

use glam::Vec2;

use crate::land::{CELL_SIZE, Land, Region};

/// A sea, a lake or an island.
pub(super) struct Piece {
    /// Its place among its kind, the largest first.
    pub number: u32,
    /// In square units.
    pub area: f32,
    /// The middle of the cell that is farthest from the coast.
    pub at: Vec2,
}

/// The seas, which reach the frame of the map; the lakes, which do not; and the islands, the main land first.
pub(super) fn pieces(land: &Land) -> [Vec<Piece>; 3] {
    let (seas, lakes): (Vec<Region>, Vec<Region>) =
        land.waters().into_iter().partition(|water| reaches_frame(land, water));
    [seas, lakes, land.islands()]
        .map(|regions| (0..).zip(&regions).map(|(number, region)| piece(land, number, region)).collect())
}

fn piece(land: &Land, number: u32, region: &Region) -> Piece {
    let cells = region.runs.iter().flat_map(|run| (run.start..run.end).map(|column| (column, run.row)));
    let from_coast = |at: Vec2| land.coast_distance().height(at).abs();
    let mut midst = (Vec2::ZERO, -1.0);
    for at in cells.map(|(column, row)| land.point(column, row, Vec2::splat(0.5))) {
        let far = from_coast(at);
        if far > midst.1 {
            midst = (at, far);
        }
    }
    Piece { number, area: region.cells as f32 * (CELL_SIZE * CELL_SIZE), at: midst.0 }
}

fn reaches_frame(land: &Land, region: &Region) -> bool {
    let (columns, rows) = (land.columns() as u32, land.rows() as u32);
    region.runs.iter().any(|run| run.row == 0 || run.row + 1 == rows || run.start == 0 || run.end == columns)
}
