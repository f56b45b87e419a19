//! What labels and scenery are placed by.

use glam::Vec2;

use super::letters::Box;
use crate::land::CoastDistance;
use crate::network::Place;
use crate::random::Seed;

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

/// A river that scenery keeps off.
#[derive(Clone, Debug, PartialEq)]
pub struct Stream {
    /// Its centerline, from the source, with its banks, in units.
    pub course: Vec<Place>,
    /// Its discharge at its end.
    pub discharge: u32,
    /// The number of the river that it joins; `u32::MAX` if it reaches the sea.
    pub parent: u32,
}

/// How high the land is, cell by cell, row by row from the map's north-western corner on.
#[derive(Clone, Copy, Debug)]
pub struct Heights<'a> {
    /// Heights over the sea, in units.
    pub heights: &'a [f32],
    /// How many cells lie side by side.
    pub columns: usize,
    /// The side of a cell, in units.
    pub cell_size: f32,
    /// The height that counts as the highest.
    pub highest: f32,
}

/// A map that woods and hills are wanted for. Lengths are units.
#[derive(Clone, Debug)]
pub struct SceneryInput<'a> {
    /// Width and height of the domain.
    pub size: Vec2,
    /// What chance is drawn from.
    pub seed: Seed,
    /// How much of the land is wooded, from 0 to 1.
    pub woods: f32,
    /// How thickly hills stand, from 0 to 1.
    pub hills: f32,
    /// What all rivers together bring to the sea, in the unit of their discharge.
    pub total_discharge: u32,
    /// The rivers.
    pub streams: Vec<Stream>,
    /// Lakes that rivers have left.
    pub lakes: Vec<Vec<Place>>,
    /// Ridges, which are drawn in strokes of their own.
    pub ridges: Vec<Vec<Place>>,
    /// How far inland each point lies; `None` if there is no sea.
    pub coast: Option<&'a CoastDistance>,
    /// The relief; `None` if it is not known.
    pub heights: Option<Heights<'a>>,
    /// The boxes of all letters on the map.
    pub letters: Vec<Box>,
}
