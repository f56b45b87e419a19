//! The labels of a session's map: its names, and what they are placed by.

use glam::Vec2;

use crate::chart::{Input, Label, Raster, Reach, River, place};
use crate::domain::AREA;
use crate::geometry::distance;
use crate::land::{CELL_SIZE, Land};
use crate::memory;
use crate::name::{Names, PlaceKind, ReachName};
use crate::network::{NONE, Network, Oxbow, Place};
use crate::recipe::{Key, Labels};
use crate::session::{Phase, Session};

/// The smallest letters that can be read: their em in pixels.
const LEAST_EM: f32 = 11.0;

/// The labels of a picture that shows a part of the map, its north-western and its south-eastern corner, with so many pixels to a unit:
/// the greatest rivers first. None if the recipe wants none, if rivers are not finished, or if there is not enough memory.
pub(crate) fn labels(session: &Session, frame: [Vec2; 2], scale: f32) -> Vec<Label> {
    input(session, frame, scale).map_or_else(Vec::new, |input| place(&input, &Raster::new(&input)))
}

/// What those labels are placed by.
pub fn input(session: &Session, frame: [Vec2; 2], scale: f32) -> Option<Input<'_>> {
    /// A course's places, its pieces, their numbers in squares, and names.
    const BYTES_A_VERTEX: usize = 120;
    let (recipe, land) = (session.recipe(), session.land());
    let share = share_of_land(recipe.get())?;
    let network = session.network().filter(|_| matches!(session.phase(), Phase::Relief | Phase::Finished))?;
    if !memory::can_allocate(Raster::BYTES + network.vertices.len() * BYTES_A_VERTEX) {
        return None;
    }
    let names = Names::of(session);
    let reach = |reach: &ReachName| reach_of(network, reach);
    let water = names.places.iter().find(|place| matches!(place.kind, PlaceKind::Sea | PlaceKind::Lake));
    Some(Input {
        frame,
        least_em: LEAST_EM / scale,
        label_size: recipe.number(Key::LabelSize),
        most_area: share * land.map_or(AREA, |land| area(land)),
        total_discharge: total_discharge(network),
        reaches: names.reaches.iter().filter_map(reach).collect(),
        water: water.map(|water| forms(&water.name)),
        rivers: rivers(network, names),
        lakes: network.oxbows.iter().map(Oxbow::middle).collect(),
        ridges: land.map_or_else(Vec::new, |land| ridges(land)),
        coast: land.map(|land| land.coast_distance()),
    })
}

/// The share of the land that labels may cover; `None` if there are to be none.
fn share_of_land(labels: Labels) -> Option<f32> {
    match labels {
        Labels::None => None,
        Labels::Few => Some(0.02),
        Labels::Some => Some(0.05),
        Labels::Many => Some(0.1),
    }
}

/// How large a land is, in square units.
fn area(land: &Land) -> f32 {
    land.regions().iter().map(|region| region.cells as f32).sum::<f32>() * CELL_SIZE * CELL_SIZE
}

pub(crate) fn total_discharge(network: &Network) -> u32 {
    let mouths = network.rivers.iter().filter(|river| river.parent == NONE);
    mouths.map(|river| network.discharge(river)).fold(0, u32::saturating_add)
}

fn rivers(network: &Network, names: Names) -> Vec<River> {
    let rivers = network.rivers.iter().zip(names.rivers);
    let river = |(river, name): (&crate::River, crate::name::RiverName)| River {
        course: network.middle(river),
        discharge: network.discharge(river),
        name: [name.name, name.short],
    };
    rivers.map(river).collect()
}

/// A reach with the banks of its river.
fn reach_of(network: &Network, reach: &ReachName) -> Option<Reach> {
    let course = network.middle(network.rivers.get(reach.river as usize)?);
    let nearest = |at: Vec2| {
        let nearer = |a: &usize, b: &usize| distance(course[*a].at, at).total_cmp(&distance(course[*b].at, at));
        (0..course.len()).min_by(nearer)
    };
    let (first, last) = (nearest(*reach.course.first()?)?, nearest(*reach.course.last()?)?);
    let course = course.get(first..=last)?.to_vec();
    Some(Reach { river: reach.river, course, name: forms(&reach.name) })
}

/// A name in full, and without its article.
fn forms(name: &str) -> [String; 2] {
    [name.into(), name.strip_prefix("The ").unwrap_or(name).into()]
}

pub(crate) fn ridges(land: &Land) -> Vec<Vec<Place>> {
    /// How wide a ridge's strokes are on either side, in units.
    const HALF: f32 = 3.0;
    land.ridges().iter().map(|ridge| ridge.iter().map(|&at| Place { at, half: HALF }).collect()).collect()
}
