//! What labels are placed by.

use glam::Vec2;

use crate::land::CoastDistance;
use crate::network::Place;

/// A river that may have a label.
#[derive(Clone, Debug, PartialEq)]
pub struct River {
    /// Its centerline, from the source, with its banks, in units.
    pub course: Vec<Place>,
    /// Its discharge at its end.
    pub discharge: u32,
    /// Its name in full, and in short.
    pub name: [String; 2],
}

/// A stretch on which a great river winds, and that has a name of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// The number of its river.
    pub river: u32,
    /// Its centerline, with its banks, in units.
    pub course: Vec<Place>,
    /// Its name in full, and in short.
    pub name: [String; 2],
}

/// A map that labels are wanted for. Lengths are units.
#[derive(Clone, Debug)]
pub struct Input<'a> {
    /// The part of the domain that is seen: its north-western and its south-eastern corner.
    pub frame: [Vec2; 2],
    /// The smallest letters that can be read, as the length of their em.
    pub least_em: f32,
    /// What sizes of letters are multiplied by.
    pub label_size: f32,
    /// Labels end when they cover so much of the map, in square units.
    pub most_area: f32,
    /// What all rivers together bring to the sea, in the unit of their discharge.
    pub total_discharge: u32,
    /// The rivers.
    pub rivers: Vec<River>,
    /// Stretches of them with names of their own.
    pub reaches: Vec<Reach>,
    /// Lakes that rivers have left, which only letters of reaches may touch.
    pub lakes: Vec<Vec<Place>>,
    /// Ridges, which no letter may touch.
    pub ridges: Vec<Vec<Place>>,
    /// The name of the sea, or of the lake that there is instead, in full and in short; `None` if it is to have none.
    pub water: Option<[String; 2]>,
    /// How far inland each point lies; `None` if there is no sea.
    pub coast: Option<&'a CoastDistance>,
}
