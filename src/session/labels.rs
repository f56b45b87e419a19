//! The labels of a session's rivers.

use glam::Vec2;

use super::Session;
use crate::chart::{Input, Label, Raster, Reach, River, place, winding};
use crate::domain::AREA;
use crate::land::{CELL_SIZE, CoastDistance, Land};
use crate::memory;
use crate::network::{NONE, Network, Oxbow, Place, Vertex};
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
            reaches: reaches(network),
            lakes: network.oxbows.iter().map(Oxbow::middle).collect(),
            ridges: land.map_or_else(Vec::new, |land| ridges(land)),
            water: land.map(|land| water_name(has_sea(land.coast_distance(), self.domain().size))),
            coast: land.map(|land| land.coast_distance()),
        })
    }
}

/// How large a land is, in square units.
fn area(land: &Land) -> f32 {
    land.regions().iter().map(|region| region.cells as f32).sum::<f32>() * CELL_SIZE * CELL_SIZE
}

fn ridges(land: &Land) -> Vec<Vec<Place>> {
    /// How wide a ridge's strokes are on either side, in units.
    const HALF: f32 = 3.0;
    land.ridges().iter().map(|ridge| ridge.iter().map(|&at| Place { at, half: HALF }).collect()).collect()
}

/// Whether there is water at the frame, and not only in lakes.
fn has_sea(coast: &CoastDistance, size: Vec2) -> bool {
    const STEPS: u32 = 100;
    let along = |i: u32| i as f32 / STEPS as f32;
    let around = |i: u32| [(along(i), 0.0), (along(i), 1.0), (0.0, along(i)), (1.0, along(i))];
    (0..=STEPS).flat_map(around).any(|at| coast.height(Vec2::from(at) * size) < 0.0)
}

/// The stretches on which great rivers wind, one a river at most: from where it first moves freely to where it last does, if that is so
/// many widths long and so much longer than its valley.
fn reaches(network: &Network) -> Vec<Reach> {
    const FREE: f32 = 0.55;
    const LEAST_WIDTHS: f32 = 12.0;
    const LEAST_WINDING: f32 = 1.3;
    let mut reaches: Vec<Reach> = Vec::new();
    for (number, river) in (0..).zip(&network.rivers) {
        let own = &network.vertices[river.vertex_range()];
        let is_free = |vertex: &Vertex| vertex.mobility >= FREE;
        let Some((first, last)) = own.iter().position(is_free).zip(own.iter().rposition(is_free)) else { continue };
        let course = network.middle(river)[first..=last].to_vec();
        if winding(&course, LEAST_WIDTHS) >= LEAST_WINDING {
            reaches.push(Reach { river: number, course, name: reach_name(reaches.len()) });
        }
    }
    reaches
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

/// The same of a stretch on which a river winds.
fn reach_name(number: usize) -> [String; 2] {
    const WORDS: [&str; 6] = ["Meanders", "Rambles", "Cringle-Crangles", "Serpentines", "Wimples", "Windings"];
    let word = WORDS[number % WORDS.len()];
    [format!("The {word}"), word.into()]
}

/// The same of the sea, or of a lake.
fn water_name(is_sea: bool) -> [String; 2] {
    let form = if is_sea { ["The Galder Sea", "Galder Sea"] } else { ["Lake Galder", "Galder"] };
    form.map(String::from)
}
