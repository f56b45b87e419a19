//! How much land a discharge stands for, and how wide a river of it is.

use super::land_area;
use crate::map::Map;
use crate::scale::{MapScale, river_width};

/// The land that drains to the rivers of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drained {
    /// The discharge that stands for all land.
    all: u32,
    /// The area of all land, in square units.
    land_area: f64,
    scale: MapScale,
}

impl Drained {
    /// Measures the land of a map.
    pub fn of(map: &Map) -> Self {
        let network = map.network();
        let mouths = network.mouths();
        let at_mouths = mouths.iter().map(|&mouth| network.discharge(&network.rivers[mouth as usize]));
        let drained = at_mouths.fold(0, u32::saturating_add);
        // The total discharge of a Brownian tree is only an approximation.
        let all = map.grown().total_discharge.max(drained).max(1);
        Self { all, land_area: land_area(map), scale: map.scale() }
    }

    /// Returns the share of all land that a discharge stands for, from 0 to 1.
    pub fn share(&self, discharge: u32) -> f64 {
        f64::from(discharge) / f64::from(self.all)
    }

    /// Returns the area of that land, in square units.
    pub fn area(&self, discharge: u32) -> f64 {
        self.share(discharge) * self.land_area
    }

    /// Returns the width of a river with this discharge, in metres. What drains less than can be counted is a river, too.
    pub fn river_width(&self, discharge: u32) -> f64 {
        river_width(self.scale.square_kilometres(self.area(discharge.max(1))))
    }
}
