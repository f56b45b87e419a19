//! Heights in metres in which water still runs down.

use riverseed::export::rasters::Rasters;
use riverseed::relief::METRES;

/// The heights of a map's cells in metres over the sea. Multiplying can round two heights to one, so a cell that would
/// not be higher than the one that its water runs to is raised by the least step there is.
pub fn metres(rasters: &Rasters) -> Vec<f32> {
    let (relief, flow) = (rasters.relief(), rasters.flow());
    let (grid, heights) = (relief.grid(), relief.heights());
    let mut metres: Vec<f32> = heights.iter().map(|height| height * METRES).collect();
    let mut is_done: Vec<bool> = heights.iter().map(|&height| height <= 0.0).collect();
    let mut upstream = Vec::new();
    for start in 0..heights.len() {
        let mut cell = Some(start);
        while let Some(open) = cell.filter(|&cell| !is_done[cell]) {
            is_done[open] = true;
            upstream.push(open);
            cell = flow.next(&grid, open);
        }
        let mut below = cell.map(|cell| metres[cell]);
        while let Some(cell) = upstream.pop() {
            metres[cell] = below.map_or(metres[cell], |below| metres[cell].max(below.next_up()));
            below = Some(metres[cell]);
        }
    }
    metres
}
