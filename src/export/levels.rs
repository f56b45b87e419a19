//! Heights as whole 16-bit numbers, in which water still runs down.

use std::cell::Cell;

use crate::base::memory::{Refused, lengthen};
use crate::relief::{CELL_SIZE, let_fall};

/// The scale of heights written as whole numbers, called steps. Step 0 is the map's deepest place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The step of the sea's surface. The sea has this step or less, land more.
    pub sea_level: u16,
    /// The height of a step, in metres.
    pub metres_a_step: f64,
    /// The metres of a unit of height.
    pub metres_up: f64,
}

impl Scale {
    /// Makes the finest scale for heights in units of so many metres that leaves `free` steps above the highest.
    fn of(heights: &[f32], metres_up: f64, free: u16) -> Self {
        let most = f64::from(u16::MAX - free);
        let (deepest, highest) = heights.iter().fold((0.0f32, 0.0f32), |(a, b), &x| (a.min(x), b.max(x)));
        let (down, up) = (f64::from(-deepest), f64::from(highest).max(f64::from(CELL_SIZE)));
        // The sea's surface is a whole step, with room for everything below it.
        let sea_level = (most * down / (down + up)).ceil();
        Self { sea_level: sea_level as u16, metres_a_step: up * metres_up / (most - sea_level), metres_up }
    }

    /// Returns the step nearest to a height in units. Land is at least a step above the sea.
    pub fn step(&self, height: f32) -> u16 {
        let steps = (f64::from(height) * self.metres_up / self.metres_a_step).round();
        let least = if height > 0.0 { f64::from(self.sea_level) + 1.0 } else { 0.0 };
        (steps + f64::from(self.sea_level)).max(least).min(f64::from(u16::MAX)) as u16
    }

    /// Returns the height of a step, in metres above the sea.
    pub fn metres(&self, step: u16) -> f64 {
        (f64::from(step) - f64::from(self.sea_level)) * self.metres_a_step
    }
}

/// The heights of all cells in steps, with their scale.
pub(super) struct Levels {
    pub scale: Scale,
    pub steps: Vec<u16>,
}

impl Levels {
    /// Rounds heights in units of so many metres to steps. `next` is the cell that a cell's water runs to, and `lakes` the lake of each
    /// cell, as for [`let_fall`]: what would not be higher than the cell that its water runs to is raised to the step above that.
    pub fn new(
        heights: &[f32],
        metres_up: f64,
        next: impl Fn(usize) -> Option<usize>,
        lakes: &[u32],
    ) -> Result<Self, Refused> {
        /// Numbers of steps to leave free at the top, tried in turn until raised land fits below it. Only a slope of
        /// tens of thousands of cells without a step of its own would need more than the last.
        const FREE: [u16; 6] = [0, 16, 128, 1024, 8192, 32_768];
        let mut steps = Vec::new();
        lengthen(&mut steps, heights.len(), 0)?;
        let mut scale = Scale::of(heights, metres_up, 0);
        for free in FREE {
            scale = Scale::of(heights, metres_up, free);
            steps.iter_mut().zip(heights).for_each(|(step, height)| *step = scale.step(*height));
            let fits = Cell::new(true);
            let above = |below: u16| {
                fits.set(fits.get() && below < u16::MAX);
                below.saturating_add(1)
            };
            let_fall(&mut steps, |step| step <= scale.sea_level, &next, lakes, above);
            if fits.get() {
                break;
            }
        }
        Ok(Self { scale, steps })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::NONE;

    const METRES: f64 = 25.0;

    /// Makes a slope whose first cell lies in the sea, and whose water runs to the cell before.
    fn slope(heights: &[f32]) -> Levels {
        Levels::new(heights, METRES, |cell| cell.checked_sub(1), &[]).unwrap()
    }

    fn rises(steps: &[u16]) -> bool {
        steps.windows(2).all(|pair| pair[0] < pair[1])
    }

    #[test]
    fn land_that_steps_tell_apart_is_as_high_as_it_is() {
        let levels = slope(&[-1.0, 1.0, 2.0, 50.0]);
        assert_eq!(levels.steps, [-1.0, 1.0, 2.0, 50.0].map(|height| levels.scale.step(height)));
        assert_eq!((levels.steps[0], levels.steps[3]), (0, u16::MAX));
    }

    #[test]
    fn level_land_is_raised_by_a_step_a_cell() {
        let levels = slope(&[-1.0, 1e-6, 2e-6, 3e-6, 50.0]);
        let sea = levels.scale.sea_level;
        assert_eq!(levels.steps[1..4], [sea + 1, sea + 2, sea + 3]);
    }

    #[test]
    fn lakes_stay_level_and_land_above_them_rises() {
        let heights = [-1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 50.0];
        let lakes: Vec<u32> = (0..7).map(|cell| if (2..5).contains(&cell) { 0 } else { NONE }).collect();
        let levels = Levels::new(&heights, METRES, |cell| cell.checked_sub(1), &lakes).unwrap();
        let level = levels.scale.step(2.0);
        assert_eq!(levels.steps[2..6], [level, level, level, level + 1]);
    }

    #[test]
    fn scale_makes_room_where_raised_land_would_not_fit() {
        for level in [2, 10, 100, 5000, 20_000] {
            let top = (0..level).map(|i| 50.0 + i as f32 * 4e-6);
            let levels = slope(&[-1.0].into_iter().chain(top).collect::<Vec<_>>());
            assert!(rises(&levels.steps), "{level} level cells");
            let off = levels.scale.metres(levels.steps[1]) - 50.0 * METRES;
            assert!(off.abs() <= levels.scale.metres_a_step, "{level}: the lowest is as high as it is");
        }
    }

    #[test]
    fn steps_never_fall_and_never_overflow_on_a_slope_that_is_too_long() {
        let levels = slope(&(0..70_000).map(|i| i as f32 * 1e-9).collect::<Vec<_>>());
        assert!(levels.steps.is_sorted() && levels.steps.last() == Some(&u16::MAX));
    }
}
