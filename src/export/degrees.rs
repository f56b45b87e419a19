//! Places in degrees. The domain lies around the null meridian and the equator, with north up.
//!
//! Places are rounded to a grid before anything is made of them, so that rings are as valid in a file as they are here. Its step is the
//! coarsest decimal place, from the fifth on, that is finer than a thousandth of a unit.

use glam::Vec2;

use super::rings::GridPoint;
use crate::scale::MapScale;

/// The metres of a degree of the equator, and of a meridian: as many, as on a sphere.
pub const METRES_A_DEGREE: f64 = 111_320.0;

/// The grid of the places in a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct DegreeGrid {
    middle: Vec2,
    steps_a_unit: f64,
    steps_a_degree: f64,
}

impl DegreeGrid {
    /// Makes the grid of a domain of this size.
    pub fn of(size: Vec2, scale: &MapScale) -> Self {
        const LEAST_STEPS_A_UNIT: f64 = 1000.0;
        let degrees_a_unit = scale.metres_a_unit / METRES_A_DEGREE;
        let mut steps_a_degree = 1e5;
        while steps_a_degree < 1e9 && degrees_a_unit * steps_a_degree < LEAST_STEPS_A_UNIT {
            steps_a_degree *= 10.0;
        }
        Self { middle: size * 0.5, steps_a_unit: degrees_a_unit * steps_a_degree, steps_a_degree }
    }

    /// Returns a place in steps east and north of the middle.
    pub fn steps(&self, at: Vec2) -> GridPoint {
        let from_middle = at - self.middle;
        [from_middle.x, -from_middle.y].map(|x| (f64::from(x) * self.steps_a_unit).round() as i32)
    }

    /// Converts steps to degrees.
    pub fn degrees(&self, steps: GridPoint) -> [f64; 2] {
        steps.map(|steps| f64::from(steps) / self.steps_a_degree)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::recipe::Recipe;

    #[test]
    fn a_map_is_as_many_degrees_wide_as_its_span_on_the_equator() {
        for (span, degrees, places) in
            [("10", 0.08983, 8), ("200", 1.79662, 6), ("1113.2", 10.0, 6), ("5000", 44.91556, 5)]
        {
            let recipe: Recipe = format!("span={span}").parse().unwrap();
            let size = Domain::of(&recipe).size;
            let grid = DegreeGrid::of(size, &MapScale::of(&recipe));
            let [west, east] = [Vec2::ZERO, size].map(|at| grid.degrees(grid.steps(at))[0]);
            assert!(((east - west) / degrees - 1.0).abs() < 1e-4, "{span}: {west} {east}");
            assert_eq!(grid.steps_a_degree, libm::pow(10.0, places.into()), "{span}");
        }
    }
}
