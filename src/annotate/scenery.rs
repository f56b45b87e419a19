//! The woods and hills of a map, and the input of their placement.

use glam::Vec2;

use crate::annotate::labels::{heights, on_map, ridges, shoreline};
use crate::annotate::place::{Box, Kind, Label, Scenery, SceneryInput, Standing, Stroke, Weather};
use crate::base::memory;
use crate::base::random::Seed;
use crate::map::Map;
use crate::network::{Oxbow, PastRound, Place};
use crate::recipe::{NumberKey, Style};
use crate::relief::{Rainfall, Wind};

/// Places the scenery of a map with these labels, the hindmost first; none if the recipe wants none, or if the style shows none.
pub(crate) fn scenery(map: &Map, labels: &[Label]) -> Vec<Standing> {
    input(map, labels).map_or_else(Vec::new, |input| Scenery::whole(&input))
}

/// Gathers the input of the placement of scenery; `None` if there is to be none, or if there is not enough memory.
pub fn input<'a>(map: &'a Map, labels: &[Label]) -> Option<SceneryInput<'a>> {
    /// The memory of a vertex: two lists of a course's pieces, their numbers in squares, and its place.
    const BYTES_A_VERTEX: usize = 90;
    let (recipe, network, land) = (map.recipe(), map.network(), map.land());
    let [woods, hills] = recipe.scenery();
    if woods + hills == 0.0 {
        return None;
    }
    if !memory::can_allocate(Scenery::BYTES + network.vertices.len() * BYTES_A_VERTEX) {
        return None;
    }
    Some(SceneryInput {
        size: map.domain().size,
        seed: Seed::from_text(recipe.seed()),
        woods,
        hills,
        weather: weather(map),
        network,
        lakes: network.oxbows.iter().map(Oxbow::middle).chain(beds(map)).collect(),
        ridges: land.map_or_else(Vec::new, |land| ridges(land)),
        coast: shoreline(map),
        heights: map.shown_relief().map(|relief| heights(relief)),
        letters: boxes(labels).into_iter().chain(margins(map)).collect(),
    })
}

/// Reads the climate of a map. Rain is even where no relief is shown.
fn weather(map: &Map) -> Weather {
    let recipe = map.recipe();
    let rainfall = map.shown_relief().zip(Wind::of(recipe)).map(|(relief, wind)| Rainfall::of(relief, wind));
    let [warmth, rain] = [NumberKey::Warmth, NumberKey::Rain].map(|key| recipe.number(key));
    let even = Weather::even(warmth, rain);
    let Some(Rainfall { grid, deviations }) = rainfall else { return even };
    Weather { deviations, columns: grid.columns, cell_size: grid.cell_size, ..even }
}

/// Returns the beds in which great rivers ran before, if the style shows them.
fn beds(map: &Map) -> Vec<Vec<Place>> {
    let rounds = if map.recipe().get::<Style>().has_beds() { map.past().rounds() } else { &[] };
    rounds.iter().flat_map(PastRound::beds).flatten().map(|bed| bed.line.clone()).collect()
}

/// Returns the boxes of the margin, if the map has one.
fn margins(map: &Map) -> Vec<Box> {
    let (size, [least, most]) = (map.domain().size, on_map(map));
    if least.min_element() <= 0.0 {
        return Vec::new();
    }
    let between = |from: Vec2, to: Vec2| {
        let half = (to - from) * 0.5;
        Box { middle: from + half, along: Vec2::new(half.x, 0.0), down: Vec2::new(0.0, half.y) }
    };
    let (east, south) = (Vec2::new(size.x, least.y), Vec2::new(least.x, size.y));
    vec![
        between(Vec2::ZERO, east),
        between(Vec2::ZERO, south),
        between(Vec2::new(0.0, most.y), size),
        between(Vec2::new(most.x, 0.0), size),
    ]
}

/// Returns the boxes of all letters, of what is cleared for them, and of the symbols of spot heights.
fn boxes(labels: &[Label]) -> Vec<Box> {
    let symbols = labels.iter().filter(|label| label.kind == Kind::SpotHeight).flat_map(|label| &label.strokes);
    let strokes = labels.iter().flat_map(|label| &label.cleared).chain(symbols).map(Stroke::around);
    labels.iter().flat_map(|label| label.letters.iter().map(|letter| letter.around(label.em))).chain(strokes).collect()
}
