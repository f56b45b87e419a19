//! The settings of growth, in domain units.

use std::sync::Arc;

use glam::Vec2;

use super::starts::starts;
use super::{DrainageSettings, Start};
use crate::domain::{AREA, Domain};
use crate::land::{CELL_SIZE, Land, Region};
use crate::random::Seed;
use crate::recipe::{GrowthMethod, Key, LandKind, Recipe, Scatter, Sides};

/// The settings of growth, resolved: ratios turned into lengths.
#[derive(Clone, Debug, PartialEq)]
pub struct GrowthSettings {
    /// The seed's 64 bits.
    pub seed: Seed,
    /// The rectangle.
    pub domain: Domain,
    /// The land; `None` if all of the domain is.
    pub(in crate::grow) land: Option<Arc<Land>>,
    /// How many rivers reach the sea; on land with several regions, and around a lake, there are more.
    pub mouths: u32,
    /// How many of them in each region of the land, largest first. Regions without one stay dry.
    pub basins: Vec<u32>,
    /// The mouths that are drawn, in the place of all others; empty if none are.
    pub starts: Arc<[Start]>,
    /// How far apart mouths are at least.
    pub mouth_spacing: f32,
    /// Which sides of a plain rectangle have the sea: of one with starts all.
    pub sides: Sides,
    /// Where on a coast they lie, as seen from its middle.
    pub shores: Sides,
    /// How rivers grow.
    pub method: GrowthMethod,
    /// The step of a Brownian tree's last passes, in units.
    pub sensitivity: f32,
    /// How many attractors there are, on a grid about: as many as asked for, unless next to no land has a river mouth.
    pub attractors: u32,
    /// How they lie.
    pub scatter: Scatter,
    /// The mean distance between attractors, √(area of land / number), or with valleys √(area of the domain / number): the unit of the
    /// three lengths below in a recipe.
    pub spacing: f32,
    /// How far an attractor pulls (the paper's distance of step 2).
    pub reach: f32,
    /// How near a river has to come for an attractor to be done with (step 5).
    pub kill: f32,
    /// How far a river grows in a tick (the unit length of step 4).
    pub step: f32,
    /// The paper's k: the share of the last direction that is taken from the new one.
    pub momentum: f32,
    /// The paper's θ_c, in radians.
    pub curl: f32,
    /// The paper's c: nodes in a stretch that curls to one side.
    pub stretch: u32,
    /// What drainage needs besides.
    pub drainage: DrainageSettings,
}

/// Attractors are never packed closer than on this much land, in square units: on less land there are fewer, and none at
/// all where no land has a coast. So the memory of growth depends on the number asked for alone.
const LEAST_AREA: f32 = AREA / 20.0;

/// Rivers come to a lake from all sides, so it has this many mouths for each requested one: with as few as an island, they
/// would run along its shore instead.
const MOUTHS_OF_A_LAKE: u32 = 3;

impl GrowthSettings {
    /// Resolves a recipe, land and all.
    pub fn of(recipe: &Recipe) -> Self {
        Self::new(recipe, Land::of(recipe))
    }

    /// Resolves a recipe whose land has been shaped before; `None` if all of the domain is.
    pub fn new(recipe: &Recipe, land: Option<Arc<Land>>) -> Self {
        let attractors = recipe.integer(Key::Attractors);
        let domain = Domain::of(recipe);
        let starts = starts(recipe, &domain, land.as_deref());
        let is_drawn = !starts.is_empty();
        let mouths = if is_drawn { starts.len() as u32 } else { mouths_of(recipe) };
        let is_lake = recipe.get::<LandKind>() == LandKind::Basin;
        let asked = if is_lake { MOUTHS_OF_A_LAKE * mouths } else { mouths };
        let basins = match &land {
            Some(land) if is_drawn => starts_in(land, &starts),
            Some(land) => share_out(land.regions(), asked),
            None => Vec::new(),
        };
        let area = match &land {
            None => AREA,
            Some(land) => watered(Some(land), &basins).map(|region| region.cells as f32 * CELL_SIZE * CELL_SIZE).sum(),
        };
        let drainage = DrainageSettings::new(recipe);
        let has_valleys = recipe.get::<GrowthMethod>() == GrowthMethod::Colonize && drainage.valleys > 0.0;
        // With valleys the land hides attractors, and moves none.
        let spacing = if has_valleys { drainage.spacing } else { (area.max(LEAST_AREA) / attractors as f32).sqrt() };
        let attractors = attractors.min((area / (spacing * spacing)).round() as u32);
        let spacings = |key| recipe.number(key) * spacing;
        Self {
            seed: Seed::from_text(recipe.seed()),
            domain,
            land,
            starts,
            basins,
            mouths,
            mouth_spacing: recipe.number(Key::MouthSpacing),
            sides: recipe.open_sides(),
            shores: recipe.sides(Key::Shores),
            method: recipe.get(),
            sensitivity: recipe.number(Key::Sensitivity),
            attractors,
            scatter: recipe.get(),
            spacing,
            reach: spacings(Key::Reach),
            kill: spacings(Key::Kill),
            step: spacings(Key::Step),
            momentum: recipe.number(Key::Momentum),
            curl: recipe.number(Key::Curl),
            stretch: recipe.integer(Key::Stretch),
            drainage,
        }
    }
}

impl GrowthSettings {
    /// The land; for tests: a session has it, too.
    #[doc(hidden)]
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.land.as_ref()
    }

    /// Whether the lowest attractor in reach pulls first, and not all at once.
    pub fn has_valleys(&self) -> bool {
        self.method == GrowthMethod::Colonize && self.drainage.valleys > 0.0
    }

    /// The regions of the land that have a mouth; the plain rectangle has no regions.
    pub fn watered(&self) -> impl Iterator<Item = &Region> {
        watered(self.land.as_deref(), &self.basins)
    }

    /// Whether a river may run straight from one point to another.
    #[inline]
    pub fn allows(&self, from: Vec2, to: Vec2) -> bool {
        match &self.land {
            None => self.domain.contains(to),
            Some(land) => self.domain.contains(to) && land.allows(from, to),
        }
    }

    /// Where the straight way from a point of land to another comes to the sea; `None` if it does not, or to something else first.
    /// A plain rectangle has the sea beyond its chosen sides.
    pub(in crate::grow) fn coast_toward(&self, from: Vec2, to: Vec2) -> Option<Vec2> {
        match &self.land {
            None => self.side_toward(from, to),
            Some(land) => land.coast_toward(from, to),
        }
    }

    fn side_toward(&self, from: Vec2, to: Vec2) -> Option<Vec2> {
        let (size, way) = (self.domain.size, to - from);
        let crossed = [
            ('n', -from.y / way.y, to.y < 0.0),
            ('e', (size.x - from.x) / way.x, to.x > size.x),
            ('s', (size.y - from.y) / way.y, to.y > size.y),
            ('w', -from.x / way.x, to.x < 0.0),
        ];
        let crossed = crossed.into_iter().filter(|(.., is_beyond)| *is_beyond);
        let (side, share, _) = crossed.reduce(|a, b| if b.1 < a.1 { b } else { a })?;
        self.sides.contains(side).then(|| (from + way * share).clamp(Vec2::ZERO, size))
    }

    /// Whether two points of land are connected.
    pub(in crate::grow) fn is_same_region(&self, a: Vec2, b: Vec2) -> bool {
        let Some(land) = &self.land else { return true };
        land.regions().iter().any(|region| land.is_in(region, a) && land.is_in(region, b))
    }

    /// The land, if it may hide attractors within the reach of a node.
    #[inline]
    pub fn hidden_from(&self, node: Vec2) -> Option<&Land> {
        self.land.as_deref().filter(|land| !land.sees_all(node, self.reach))
    }

    /// Whether an attractor pulls a node: it does not through a ridge, or across the water between islands.
    pub fn sees(&self, node: Vec2, attractor: Vec2) -> bool {
        self.land.as_ref().is_none_or(|land| land.sees(node, attractor))
    }
}

/// How many mouths are asked for. Of drainage 0 means all along the coast.
fn mouths_of(recipe: &Recipe) -> u32 {
    const USUAL: u32 = 8;
    match recipe.integer(Key::Mouths) {
        0 if recipe.get::<GrowthMethod>() != GrowthMethod::Drainage => USUAL,
        mouths => mouths,
    }
}

/// How many starts lie in each region.
fn starts_in(land: &Land, starts: &[Start]) -> Vec<u32> {
    let count = |region| starts.iter().filter(|start| land.is_in(region, start.mouth.at)).count() as u32;
    land.regions().iter().map(count).collect()
}

fn watered<'a>(land: Option<&'a Land>, basins: &'a [u32]) -> impl Iterator<Item = &'a Region> {
    let regions = land.into_iter().flat_map(Land::regions);
    regions.zip(basins).filter(|(_, mouths)| **mouths > 0).map(|(region, _)| region)
}

/// Shares mouths out among regions by their size, as parliaments share out seats (Webster and Sainte-Laguë): a second
/// mouth only goes where there is three times the land of a region without one. But first each region with a fair share of
/// the land has one, even if there are then more than asked for: no island lies bare beside full ones. Only regions with a
/// coast have any.
fn share_out(regions: &[Region], mouths: u32) -> Vec<u32> {
    /// A region with one in this number of cells of land has a fair share.
    const FAIR: u32 = 100;
    let land: u32 = regions.iter().map(|region| region.cells).sum();
    let mut shares = vec![0; regions.len()];
    for shared in 0.. {
        let claim = |&(i, region): &(usize, &Region)| {
            let comes_first = shares[i] == 0 && region.cells >= land / FAIR;
            (comes_first, region.cells / (2 * shares[i] + 1))
        };
        let coastal = regions.iter().enumerate().filter(|(_, region)| !region.shores.is_empty());
        match coastal.reduce(|a, b| if claim(&b) > claim(&a) { b } else { a }) {
            Some(next) if shared < mouths || claim(&next).0 => shares[next.0] += 1,
            _ => break,
        }
    }
    shares
}
