//! The labels of a session's rivers.

use glam::Vec2;

use super::Session;
use crate::chart::{Input, Label, Raster, River, place};
use crate::domain::AREA;
use crate::land::{CELL_SIZE, Land};
use crate::memory;
use crate::network::{NONE, Network, Place};
use crate::recipe::{Key, Labels};

/// The smallest letters that can be read: their em in pixels.
const LEAST_EM: f32 = 11.0;

impl Session {
    /// The labels of a picture that shows a part of the map, its north-western and its south-eastern corner, with so many pixels to a unit:
    /// the greatest rivers first. None if the recipe wants none, if rivers are not finished, or if there is not enough memory.
    pub(crate) fn labels(&self, frame: [Vec2; 2], scale: f32) -> Vec<Label> {
        self.label_input(frame, scale).map_or_else(Vec::new, |input| place(&input, &Raster::new(&input)))
    }

    /// What those labels are placed by.
    #[doc(hidden)]
    pub fn label_input(&self, frame: [Vec2; 2], scale: f32) -> Option<Input<'_>> {
        let share = match self.recipe.get() {
            Labels::None => return None,
            Labels::Few => 0.02,
            Labels::Some => 0.05,
            Labels::Many => 0.1,
        };
        let is_finished = self.shaping.as_ref().is_some_and(crate::network::Shaping::is_finished);
        let network = self.network().filter(|_| is_finished)?;
        /// A course's places, its pieces, and their numbers in squares.
        const BYTES_A_VERTEX: usize = 80;
        if !memory::can_allocate(Raster::BYTES + network.vertices.len() * BYTES_A_VERTEX) {
            return None;
        }
        let land = self.land();
        let rivers = network.rivers.iter();
        Some(Input {
            frame,
            least_em: LEAST_EM / scale,
            label_size: self.recipe.number(Key::LabelSize),
            most_area: share * land.map_or(AREA, |land| area(land)),
            total_discharge: rivers
                .clone()
                .filter(|river| river.parent == NONE)
                .map(|river| network.discharge(river))
                .sum(),
            rivers: (0..)
                .zip(rivers)
                .map(|(number, river)| River {
                    course: network.middle(river),
                    discharge: network.discharge(river),
                    name: name(number),
                })
                .collect(),
            obstacles: obstacles(network, land.map(std::convert::AsRef::as_ref)),
            coast: land.map(|land| land.coast_distance()),
        })
    }
}

/// How large a land is, in square units.
fn area(land: &Land) -> f32 {
    land.regions().iter().map(|region| region.cells as f32).sum::<f32>() * CELL_SIZE * CELL_SIZE
}

/// Lakes and ridges.
fn obstacles(network: &Network, land: Option<&Land>) -> Vec<Vec<Place>> {
    /// How wide a ridge's strokes are on either side, in units.
    const RIDGE: f32 = 3.0;
    let ridges = land.into_iter().flat_map(Land::ridges);
    let ridges = ridges.map(|ridge| ridge.iter().map(|&at| Place { at, half: RIDGE }).collect());
    network.oxbows.iter().map(crate::network::Oxbow::middle).chain(ridges).collect()
}

/// A river's name in full, and in short. Until rivers have names of their own, words in turn.
fn name(number: usize) -> [String; 2] {
    const WORDS: [&str; 16] = [
        "Tárkan", "Vierken", "Hiettin", "Jiennun", "Dellen", "Broshim", "Swengom", "Thackil", "Gerchir", "Tuddath",
        "Gwidrog", "Carchoth", "Beinnurd", "Funner", "Þoldud", "Heirges",
    ];
    let word = WORDS[number % WORDS.len()];
    [format!("{word} River"), word.into()]
}
