//! The woods and hills of a map, and what they are placed by.

use crate::chart::{Box, Kind, Label, Scenery, SceneryInput, Standing, Stream, Stroke};
use crate::domain::Domain;
use crate::labels::{heights, ridges, total_discharge};
use crate::land::Land;
use crate::memory;
use crate::network::{Network, Oxbow};
use crate::random::Seed;
use crate::river_map::RiverMap;

/// The scenery of a map with these labels, what is behind first; none if the recipe wants none, or the style shows none.
#[cfg(feature = "files")]
pub(crate) fn scenery(map: &RiverMap<'_>, labels: &[Label]) -> Vec<Standing> {
    input(map, labels).map_or_else(Vec::new, |input| Scenery::whole(&input))
}

/// What it is placed by. None if there is to be none, if rivers are not finished, or their relief, or if there is not enough memory.
pub fn input<'a>(map: &RiverMap<'a>, labels: &[Label]) -> Option<SceneryInput<'a>> {
    /// Two lists of a course's pieces, their numbers in squares, and its places.
    const BYTES_A_VERTEX: usize = 90;
    let RiverMap { options, network, land, .. } = map;
    let [woods, hills] = options.scenery();
    if !map.is_finished || woods + hills == 0.0 {
        return None;
    }
    if !memory::can_allocate(Scenery::BYTES + network.vertices.len() * BYTES_A_VERTEX) {
        return None;
    }
    Some(SceneryInput {
        size: Domain::with_aspect(options.aspect).size,
        seed: Seed::from_text(&options.seed),
        woods,
        hills,
        total_discharge: total_discharge(network),
        streams: streams(network),
        lakes: network.oxbows.iter().map(Oxbow::middle).chain(map.beds.iter().cloned()).collect(),
        ridges: land.map_or_else(Vec::new, ridges),
        coast: land.map(Land::coast_distance),
        heights: map.relief.map(heights),
        letters: boxes(labels),
    })
}

fn streams(network: &Network) -> Vec<Stream> {
    let stream = |river: &crate::River| Stream {
        course: network.middle(river),
        discharge: network.discharge(river),
        parent: river.parent,
    };
    network.rivers.iter().map(stream).collect()
}

/// The boxes of all letters, of what is cleared for them, and of the symbols of spot heights.
fn boxes(labels: &[Label]) -> Vec<Box> {
    let symbols = labels.iter().filter(|label| label.kind == Kind::SpotHeight).flat_map(|label| &label.strokes);
    let strokes = labels.iter().flat_map(|label| &label.cleared).chain(symbols).map(Stroke::around);
    labels.iter().flat_map(|label| label.letters.iter().map(|letter| letter.around(label.em))).chain(strokes).collect()
}
