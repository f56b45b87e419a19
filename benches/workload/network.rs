//! From a tree to rivers, and work on rivers.

use glam::Vec2;
use riverseed::grow::Growth;
use riverseed::network::{self, Meander, NONE, Network, Shaping};
use riverseed::prune::{self, Trim};
use riverseed::recipe::{Key, NumberKey, Recipe};
use riverseed::session::Session;
use riverseed::tree::Hydrology;

use super::bends::{Bend, bends};
use super::growth::all_grown;
use super::{Repetition, pairs, recipe};

/// Turns the tree of a plain map into rivers, with all rounds of meandering. Returns the number of vertices.
pub fn shaping_of_rivers() -> Option<Repetition> {
    let recipe = recipe("")?;
    let growth = all_grown(&recipe)?;
    Some(Box::new(move || {
        let Some(mut shaping) = unshaped(&recipe, &growth) else { return 0 };
        while shaping.step() {}
        shaping.network().map_or(0, |network| network.vertices.len() as u32)
    }))
}

/// The rivers of a tree on a plain rectangle, before they are shaped.
fn unshaped(recipe: &Recipe, growth: &Growth) -> Option<Shaping> {
    let pruned = prune::trim(
        growth.tree(),
        &Hydrology::of(growth.tree()),
        Trim::new(recipe.number(NumberKey::Trim), growth.node_length(), !growth.mouths_are_chosen()),
    );
    let settings = network::NetworkSettings::new(recipe, growth.stream_spacing(), growth.total_discharge());
    Shaping::new(&pruned.tree, growth.may_cross(), None, settings).ok()
}

/// About 10,000 vertices of rivers halfway through their rounds, on each of several maps side by side.
fn half_meandered(maps: u32) -> Option<Meander> {
    const ATTRACTORS: &str = "9000";
    let mut recipe = recipe("meander-rounds=400")?;
    recipe.set(Key::Attractors, ATTRACTORS).ok()?;
    let growth = all_grown(&recipe)?;
    let mut shaping = unshaped(&recipe, &growth)?;
    while shaping.meander().is_none_or(|meander| meander.rounds() < 20) {
        shaping.step();
    }
    let meander = shaping.meander()?;
    let network = side_by_side(meander.network(), maps, meander.settings().domain.size);
    Some(Meander::of(network, None, wide(meander, maps)))
}

/// The settings for several maps from west to east.
fn wide(meander: &Meander, maps: u32) -> network::NetworkSettings {
    let mut settings = meander.settings().clone();
    settings.domain.size.x *= maps as f32;
    settings
}

fn side_by_side(network: &Network, maps: u32, size: Vec2) -> Network {
    let mut all = Network::default();
    for map in 0..maps {
        let (east, first) = (Vec2::new(size.x * map as f32, 0.0), all.vertices.len() as u32);
        let rivers = all.rivers.len() as u32;
        let moved = |number: u32, by: u32| if number == NONE { NONE } else { number + by };
        all.vertices.extend_from_slice(&network.vertices);
        all.vertices[first as usize..].iter_mut().for_each(|vertex| vertex.at += east);
        all.rivers.extend_from_slice(&network.rivers);
        for river in &mut all.rivers[rivers as usize..] {
            (river.start, river.end) = (river.start + first, river.end + first);
            (river.junction, river.parent) = (moved(river.junction, first), moved(river.parent, rivers));
        }
    }
    all
}

/// Makes rounds of meandering, one after the other. Returns the number of rivers.
pub fn round(maps: u32) -> Option<Repetition> {
    const ROUNDS: u32 = 12;
    let halfway = half_meandered(maps)?;
    let mut meander = halfway.clone();
    Some(Box::new(move || {
        if meander.rounds() == ROUNDS {
            meander = halfway.clone();
        }
        meander.round();
        meander.network().rivers.len() as u32
    }))
}

/// The survey for a round by all pairs, without moving anything.
pub fn all_pairs() -> Option<Repetition> {
    let meander = half_meandered(1)?;
    let network = meander.network().clone();
    let reach = meander.reach(&network.downstream(), &meander.step_scale());
    Some(Box::new(move || pairs::measure(&network, &reach, meander.caps()).1.len() as u32))
}

/// A quantile, in percent, of a measure of the free bends of twenty maps, in hundredths.
pub fn bends_of(model: &str, measure: &str, percent: usize) -> Option<Repetition> {
    let measure = match measure {
        "wavelength" => |bend: &Bend| bend.wavelength,
        "radius" => |bend: &Bend| bend.radius,
        _ => |bend: &Bend| bend.sinuosity,
    };
    let link = format!("meander={model}&great-rivers=4&meander-rounds=60");
    let mut all: Vec<f32> = (0..20)
        .filter_map(|seed| {
            let mut session = Session::new(recipe(&format!("country=usual&seed={seed}&{link}"))?).ok()?;
            session.advance(u32::MAX).ok()?;
            Some(bends(session.network()?).iter().map(measure).collect::<Vec<f32>>())
        })
        .flatten()
        .collect();
    all.sort_by(f32::total_cmp);
    let value = all.get((all.len().saturating_sub(1)) * percent / 100).copied()?;
    Some(Box::new(move || (value * 100.0) as u32))
}
