//! Heights in metres in which water still runs down.

use riverseed::export::rasters::Rasters;
use riverseed::relief::let_fall;

/// Returns the heights of a map's cells in metres over the sea.
pub fn metres(rasters: &Rasters) -> Vec<f32> {
    let (relief, flow) = (rasters.relief(), rasters.flow());
    let grid = relief.grid();
    falling(relief.heights(), rasters.map_scale.metres_up, |cell| flow.next(&grid, cell), rasters.lakes())
}

/// Converts heights in units to metres, of which a unit has `metres_up`. `next` is the cell that a cell's water runs to. Multiplying can round two
/// heights to one, so a cell that would not be higher than that is raised by the least step there is; lakes as wholes.
fn falling(heights: &[f32], metres_up: f32, next: impl Fn(usize) -> Option<usize>, lakes: &[u32]) -> Vec<f32> {
    let mut metres: Vec<f32> = heights.iter().map(|height| height * metres_up).collect();
    let_fall(&mut metres, |height| height <= 0.0, next, lakes, f32::next_up);
    metres
}

#[cfg(test)]
mod tests {
    use super::*;

    const METRES: f32 = 25.0;

    #[test]
    fn water_runs_down_where_heights_are_as_near_as_numbers_can_be() {
        // Above 1.28, 25 times a number needs a bit more than there is.
        let heights: Vec<f32> = [-1.0]
            .into_iter()
            .chain(std::iter::successors(Some(1.3f32), |height| Some(height.next_up())).take(100))
            .collect();
        let plain: Vec<f32> = heights.iter().map(|height| height * METRES).collect();
        assert!(plain.windows(2).any(|pair| pair[0] == pair[1]), "or this proves nothing");
        let metres = falling(&heights, METRES, |cell| cell.checked_sub(1), &[]);
        assert!(metres.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(metres.iter().zip(plain).all(|(metres, plain)| (metres - plain).abs() < 1e-3));
    }

    #[test]
    fn land_that_is_far_enough_apart_and_the_sea_are_as_high_as_they_are() {
        assert_eq!(
            falling(&[-4.0, 2.0, 1.0, -0.0], METRES, |cell| cell.checked_sub(1), &[]),
            [-100.0, 50.0, 50.0f32.next_up(), 0.0]
        );
        assert_eq!(
            falling(&[3.0, 2.0, 1.0], METRES, |cell| Some(cell + 1).filter(|next| *next < 3), &[]),
            [75.0, 50.0, 25.0]
        );
    }
}
