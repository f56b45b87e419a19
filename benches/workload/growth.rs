//! Growth, from a recipe to the last node.

use glam::Vec2;
use riverseed::base::random::Seed;
use riverseed::grow::{Brownian, Colonize, Growth, GrowthSettings, Raster};
use riverseed::land::Land;
use riverseed::recipe::preset::PRESETS;
use riverseed::recipe::{Key, Recipe, Sides};

use super::{BARE, DRAWN, Repetition, literal, recipe, twin};

pub fn settings(attractors: &str, reach: &str) -> Option<GrowthSettings> {
    let mut recipe = recipe(BARE)?;
    recipe.set(Key::Attractors, attractors).ok()?;
    recipe.set(Key::Reach, reach).ok()?;
    Some(GrowthSettings::of(&recipe))
}

pub fn grown(settings: &GrowthSettings) -> Option<Colonize> {
    let mut growth = Colonize::new(settings.clone()).ok()?;
    while growth.tick() {}
    Some(growth)
}

pub fn all_grown(recipe: &Recipe) -> Option<Growth> {
    let mut growth = Growth::new(GrowthSettings::of(recipe)).ok()?;
    while growth.tick() {}
    Some(growth)
}

/// Grows from the recipe to the last node. Returns the number of nodes.
pub fn growth(attractors: &str, reach: &str) -> Option<Repetition> {
    let settings = settings(attractors, reach)?;
    Some(Box::new(move || grown(&settings).map_or(0, |growth| growth.tree().len() as u32)))
}

/// Shapes a land. Returns the number of regions.
pub fn shaping(kind: &str) -> Option<Repetition> {
    let recipe = recipe(&format!("land={kind}"))?;
    Some(Box::new(move || Land::of(&recipe).map_or(0, |land| land.regions().len() as u32)))
}

/// Grows on an existing land. Returns the number of nodes.
pub fn growth_on(kind: &str, attractors: &str) -> Option<Repetition> {
    let land = if kind == "drawn" { DRAWN.to_owned() } else { format!("land={kind}") };
    let settings = GrowthSettings::of(&recipe(&format!("{BARE}&{land}&attractors={attractors}"))?);
    Some(Box::new(move || grown(&settings).map_or(0, |growth| growth.tree().len() as u32)))
}

/// Grows by brute force. Returns the number of nodes.
pub fn the_twin(attractors: &str, reach: &str) -> Option<Repetition> {
    let settings = settings(attractors, reach)?;
    Some(Box::new(move || twin::grow(&settings).len() as u32))
}

/// The number of trees that equal the twin's to the bit, out of 120: six presets with twenty seeds each.
pub fn equal_variants() -> u32 {
    let links = PRESETS.iter().flat_map(|preset| {
        (0..20u32).map(move |seed| format!("seed={seed}&preset={}&attractors=400&mouths={}", preset.name, 1 + seed % 4))
    });
    links.filter(|link| equals_twin(link).unwrap_or(false)).count() as u32
}

fn equals_twin(link: &str) -> Option<bool> {
    let growth = grown(&GrowthSettings::of(&recipe(link)?))?;
    let tree = growth.tree();
    let twin = twin::grow(growth.settings());
    let bits = |at: Vec2| [at.x.to_bits(), at.y.to_bits()];
    let is_same = |(i, (node, tick)): (usize, (&twin::Black, u32))| {
        let ours = (bits(tree.at[i]), tree.parent[i], tree.drained[i], tick);
        ours == (bits(node.at), node.parent, node.drained, node.tick)
    };
    Some(tree.len() == twin.len() && twin.iter().zip(tree.ticks()).enumerate().all(is_same))
}

/// A square raster of land with sea on all sides.
fn square(side: &str) -> Option<Raster> {
    let side = side.parse().ok()?;
    Some(Raster::with_sea(side, side, 1.0, Sides::parse("nesw")?))
}

/// Grows from the raster to the last node. Returns the number of nodes.
pub fn brownian(side: &str, sensitivity: &str) -> Option<Repetition> {
    let (raster, sensitivity) = (square(side)?, sensitivity.parse().ok()?);
    Some(Box::new(move || {
        let Ok(mut growth) = Brownian::new(raster.clone(), Seed::from_text("kauri"), sensitivity) else { return 0 };
        while growth.tick() {}
        growth.tree().len() as u32
    }))
}

/// Grows by a literal search of the disc after every move. Returns the number of nodes.
pub fn literal_brownian(side: &str, sensitivity: &str) -> Option<Repetition> {
    let (raster, sensitivity) = (square(side)?, sensitivity.parse().ok()?);
    Some(Box::new(move || literal::grow(&raster, Seed::from_text("kauri"), sensitivity).len() as u32))
}

/// Drains a square, from the recipe to the last round. Returns the number of nodes.
pub fn drainage(attractors: &str) -> Option<Repetition> {
    let recipe = recipe(&format!("growth=drainage&aspect=1&mouths=0&captures=5&attractors={attractors}"))?;
    Some(Box::new(move || all_grown(&recipe).map_or(0, |growth| growth.tree().len() as u32)))
}
