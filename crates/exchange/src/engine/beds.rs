//! Beds: the ground under rivers, lowered between their banks, so that water that an engine lays there covers it.
//!
//! Across a river the bed is a parabola, as deep in the middle as the river is, and no narrower than heights can show.
//! Water still runs where it ran: below a bed that is lower than the ground which its water runs to, that is lowered, too.

use std::io::Result;

use riverseed::Map;
use riverseed::analyse::statistics::Drained;
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::glam::DVec2;

use super::splines::depth;
use super::terrain::Terrain;
use crate::memory::ask;

/// The least half of a bed's width, in pixels. At a place in its middle, heights between the corners around are then lowered
/// by three quarters of the depth at least.
const LEAST_HALF: f64 = 1.5;

/// Lowers the ground of a map's landscape to the beds of its rivers.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn lowered(terrain: &Terrain, map: &Map, rasters: &Rasters) -> Result<Terrain> {
    /// Another landscape, the depths, the way of water, the order of cells and their least steps.
    const BYTES_A_CELL: usize = 2 + 4 + 1 + 4 + 2;
    ask(terrain.columns * terrain.rows * BYTES_A_CELL)?;
    let mut ground = terrain.clone();
    let depths = depths(terrain, map);
    let Values::Bytes(flow) = rasters.values(Layer::Flow) else { return Ok(ground) };
    lower(ground.steps_mut(), &Flow { directions: &flow, columns: terrain.columns }, |cell| {
        (f64::from(depths[cell]) / terrain.metres_a_step).round() as u16
    });
    Ok(ground)
}

/// Computes how deep the bed of a river lies under the ground at each corner of a landscape, in metres; 0 beside beds.
fn depths(terrain: &Terrain, map: &Map) -> Vec<f32> {
    let mut depths = vec![0.0; terrain.columns * terrain.rows];
    let (network, drained, pixels_a_metre) = (map.network(), Drained::of(map), 1.0 / terrain.metres_a_pixel);
    for river in &network.rivers {
        let places: Vec<Place> = network
            .course(river)
            .map(|vertex| {
                let width = drained.river_width(vertex.discharge);
                let half = (width * 0.5 * pixels_a_metre).max(LEAST_HALF);
                Place { at: terrain.corners(vertex.at), half, depth: depth(width) }
            })
            .collect();
        places.windows(2).for_each(|reach| dig([reach[0], reach[1]], terrain, &mut depths));
    }
    depths
}

/// A place in the middle of a river; lengths in pixels, the depth in metres.
#[derive(Clone, Copy)]
struct Place {
    at: DVec2,
    half: f64,
    depth: f64,
}

/// Digs the bed of a reach from place to place.
fn dig([from, to]: [Place; 2], terrain: &Terrain, depths: &mut [f32]) {
    let half = from.half.max(to.half);
    let first = (from.at.min(to.at) - half).ceil().max(DVec2::ZERO);
    let last = (from.at.max(to.at) + half).floor();
    let way = to.at - from.at;
    for row in first.y as usize..terrain.rows.min((last.y + 1.0) as usize) {
        for column in first.x as usize..terrain.columns.min((last.x + 1.0) as usize) {
            let off = DVec2::new(column as f64, row as f64) - from.at;
            let share = if way == DVec2::ZERO { 0.0 } else { (off.dot(way) / way.length_squared()).clamp(0.0, 1.0) };
            let between = |a: f64, b: f64| a + (b - a) * share;
            let half = between(from.half, to.half);
            let rise = (off - way * share).length_squared() / (half * half);
            let deep = (between(from.depth, to.depth) * (1.0 - rise)) as f32;
            let bed = &mut depths[row * terrain.columns + column];
            *bed = bed.max(deep);
        }
    }
}

/// The way of water from cell to cell.
struct Flow<'a> {
    /// Directions in ESRI's codes; 0 where there is none.
    directions: &'a [u8],
    columns: usize,
}

impl Flow<'_> {
    /// Returns the cell that a cell's water runs to; `None` at sea and off the landscape.
    fn next(&self, cell: usize) -> Option<usize> {
        /// East and south of each direction.
        const WAYS: [[isize; 2]; 8] = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];
        let [east, south] = *WAYS.get(self.directions[cell].trailing_zeros() as usize)?;
        let column = (cell % self.columns).checked_add_signed(east).filter(|column| *column < self.columns)?;
        let row = (cell / self.columns).checked_add_signed(south)?;
        Some(row * self.columns + column).filter(|next| *next < self.directions.len())
    }
}

/// Lowers heights by a number of steps in each cell, or as far as water still falls a step from cell to cell.
fn lower(steps: &mut [u16], flow: &Flow<'_>, by: impl Fn(usize) -> u16) {
    let mut from_below: Vec<u32> =
        (0..steps.len() as u32).filter(|cell| flow.directions[*cell as usize] != 0).collect();
    // Water runs to lower cells: those come first. Cells of one height have nothing to do with each other.
    from_below.sort_unstable_by_key(|cell| steps[*cell as usize]);
    let mut least: Vec<u16> = vec![0; steps.len()];
    for &cell in &from_below {
        least[cell as usize] = flow.next(cell as usize).map_or(0, |next| least[next].saturating_add(1));
    }
    for (cell, step) in steps.iter_mut().enumerate() {
        *step = step.saturating_sub(by(cell)).max(least[cell]);
    }
    for &cell in from_below.iter().rev() {
        if let Some(next) = flow.next(cell as usize) {
            steps[next] = steps[next].min(steps[cell as usize].saturating_sub(1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lowers cells that stand in a row, whose water runs east.
    fn in_a_row(mut steps: Vec<u16>, by: &[u16]) -> Vec<u16> {
        let directions: Vec<u8> = (1..=steps.len()).map(|i| u8::from(i < steps.len())).collect();
        lower(&mut steps, &Flow { directions: &directions, columns: directions.len() }, |cell| by[cell]);
        steps
    }

    #[test]
    fn water_that_a_bed_would_hold_finds_its_way_on() {
        assert_eq!(in_a_row(vec![90, 80, 79, 78, 20], &[0, 20, 5, 0, 0]), [90, 60, 59, 58, 20]);
        assert_eq!(in_a_row(vec![90, 80, 70, 60], &[0; 4]), [90, 80, 70, 60]);
    }

    #[test]
    fn a_bed_is_never_so_low_that_water_could_not_leave_it() {
        assert_eq!(in_a_row(vec![9, 8, 7, 1], &[9, 9, 0, 0]), [3, 2, 1, 0]);
    }

    #[test]
    fn water_leaves_the_landscape_at_its_edges() {
        let ways =
            |directions: &[u8]| (0..4).map(|cell| Flow { directions, columns: 2 }.next(cell)).collect::<Vec<_>>();
        assert_eq!(ways(&[1, 1, 2, 64]), [Some(1), None, None, Some(1)]);
        assert_eq!(ways(&[16, 8, 128, 0]), [None, Some(2), Some(1), None]);
    }
}
