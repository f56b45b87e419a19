//! The settings of growth, in domain units.

use std::sync::Arc;

use glam::Vec2;

use super::starts::starts;
use super::{DrainageSettings, Start};
use crate::base::random::Seed;
use crate::domain::{AREA, Domain};
use crate::land::{CELL_SIZE, Land, Region};
use crate::recipe::{GrowthMethod, IntegerKey, LandKind, NumberKey, Recipe, Scatter, Sides};

/// The settings of growth, with ratios turned into lengths.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct GrowthSettings {
    /// The seed's 64 bits.
    pub seed: Seed,
    /// The rectangle of the map.
    pub domain: Domain,
    /// The land; `None` if the whole domain is land.
    pub(in crate::grow) land: Option<Arc<Land>>,
    /// The number of rivers that reach the sea. On land with several regions, and around a lake, there are more.
    pub mouths: u32,
    /// The number of these in each region of the land, largest region first. Regions without one stay dry.
    pub basins: Vec<u32>,
    /// The drawn mouths, which replace all others; empty if none are drawn.
    pub starts: Arc<[Start]>,
    /// The smallest distance between mouths.
    pub mouth_spacing: f32,
    /// The sides of a plain rectangle beyond which the sea lies: with starts, all.
    pub sides: Sides,
    /// The sides on which mouths may lie on a coast, seen from its middle.
    pub shores: Sides,
    /// The growth method.
    pub method: GrowthMethod,
    /// The step of a Brownian tree's last passes, in units.
    pub sensitivity: f32,
    /// The number of attractors: the requested number, or on a grid about that number, unless hardly any land has a
    /// river mouth.
    pub attractors: u32,
    /// The placement of attractors.
    pub scatter: Scatter,
    /// The mean distance between attractors, √(area of land / number), or with valleys √(area of the domain / number).
    /// A recipe gives the next three lengths in this unit.
    pub spacing: f32,
    /// The distance from which an attractor pulls (the paper's distance in step 2).
    pub reach: f32,
    /// The distance from a river at which an attractor is used up (step 5).
    pub kill: f32,
    /// The length by which a river grows in a tick (the unit length of step 4).
    pub step: f32,
    /// The paper's k: the share of the previous direction that is subtracted from the new one.
    pub momentum: f32,
    /// The paper's θ_c, in radians.
    pub curl: f32,
    /// The paper's c: the number of nodes in a stretch that curls to one side.
    pub stretch: u32,
    /// The settings of drainage alone.
    pub drainage: DrainageSettings,
}

/// The area, in square units, that limits the density of attractors. On less land there are fewer of them, and none if
/// no land has a coast. Therefore the memory of growth depends only on the requested number.
const LEAST_AREA: f32 = AREA / 20.0;

/// The number of mouths of a lake or a gulf for each requested one. Rivers reach it from all sides; with as few mouths as an
/// island has, they would run along its shore.
const MOUTHS_OF_A_LAKE: u32 = 3;

impl GrowthSettings {
    /// Resolves a recipe, land and all.
    pub fn of(recipe: &Recipe) -> Self {
        Self::new(recipe, Land::of(recipe))
    }

    /// Resolves a recipe with given land; `None` if the whole domain is land.
    pub fn new(recipe: &Recipe, land: Option<Arc<Land>>) -> Self {
        let attractors = recipe.integer(IntegerKey::Attractors);
        let domain = Domain::of(recipe);
        let starts = starts(recipe, &domain, land.as_deref());
        let is_drawn = !starts.is_empty();
        let mouths = if is_drawn { starts.len() as u32 } else { mouths_of(recipe) };
        let is_lake = recipe.get::<LandKind>().holds_water();
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
        // With valleys, attractors keep their places in the plane, and those not on land are left out.
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
            mouth_spacing: recipe.number(NumberKey::MouthSpacing),
            sides: recipe.open_sides(),
            shores: recipe.shores(),
            method: recipe.get(),
            sensitivity: recipe.integer(IntegerKey::Sensitivity) as f32,
            attractors,
            scatter: recipe.get(),
            spacing,
            reach: spacings(NumberKey::Reach),
            kill: spacings(NumberKey::Kill),
            step: spacings(NumberKey::Step),
            momentum: recipe.number(NumberKey::Momentum),
            curl: recipe.number(NumberKey::Curl),
            stretch: recipe.integer(IntegerKey::Stretch),
            drainage,
        }
    }
}

impl GrowthSettings {
    /// Returns the land; `None` if the whole domain is land.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.land.as_ref()
    }

    /// Returns `true` if the lowest attractor in reach pulls first, instead of all at once.
    pub fn has_valleys(&self) -> bool {
        self.method == GrowthMethod::Colonize && self.drainage.valleys > 0.0
    }

    /// Returns the regions of the land that have a mouth; the plain rectangle has no regions.
    pub fn watered(&self) -> impl Iterator<Item = &Region> {
        watered(self.land.as_deref(), &self.basins)
    }

    /// Returns `true` if a river may run straight from one point to another.
    #[inline]
    pub fn allows(&self, from: Vec2, to: Vec2) -> bool {
        match &self.land {
            None => self.domain.contains(to),
            Some(land) => self.domain.contains(to) && land.allows(from, to),
        }
    }

    /// Returns the point at which the straight way from a point on land to another reaches the sea; `None` if it does
    /// not, or reaches something else first. A plain rectangle has the sea beyond its chosen sides.
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
        let mut first: Option<(char, f32)> = None;
        for (side, share, is_beyond) in crossed {
            if is_beyond && first.is_none_or(|(_, least)| share < least) {
                first = Some((side, share));
            }
        }
        let (_, share) = first.filter(|&(side, _)| self.sides.contains(side))?;
        Some((from + way * share).clamp(Vec2::ZERO, size))
    }

    /// Returns `true` if two points of land are connected.
    pub(in crate::grow) fn is_same_region(&self, a: Vec2, b: Vec2) -> bool {
        let Some(land) = &self.land else { return true };
        land.regions().iter().any(|region| region.holds(a) && region.holds(b))
    }

    /// Returns the land if it may hide attractors within reach of a node.
    #[inline]
    pub fn hidden_from(&self, node: Vec2) -> Option<&Land> {
        self.land.as_deref().filter(|land| !land.sees_all(node, self.reach))
    }

    /// Returns `true` if an attractor can pull a node: not through a ridge, nor across the water between islands.
    pub fn sees(&self, node: Vec2, attractor: Vec2) -> bool {
        self.land.as_ref().is_none_or(|land| land.sees(node, attractor))
    }
}

/// Returns the requested number of mouths. In drainage, 0 means all along the coast.
fn mouths_of(recipe: &Recipe) -> u32 {
    const USUAL: u32 = 8;
    match recipe.integer(IntegerKey::Mouths) {
        0 if recipe.get::<GrowthMethod>() != GrowthMethod::Drainage => USUAL,
        mouths => mouths,
    }
}

/// Counts the starts in each region.
fn starts_in(land: &Land, starts: &[Start]) -> Vec<u32> {
    let count = |region: &Region| starts.iter().filter(|start| region.holds(start.mouth.at)).count() as u32;
    land.regions().iter().map(count).collect()
}

fn watered<'a>(land: Option<&'a Land>, basins: &'a [u32]) -> impl Iterator<Item = &'a Region> {
    let regions = land.map_or(&[][..], Land::regions);
    regions.iter().zip(basins).filter(|(_, mouths)| **mouths > 0).map(|(region, _)| region)
}

/// Distributes mouths among regions by size, as parliaments distribute seats (Webster and Sainte-Laguë): a region gets
/// its second mouth before another gets its first only if it has three times the land. But each region with a fair
/// share of the land gets one first, even if this exceeds the requested number, so that no island lies bare beside full
/// ones. Regions without a coast get none.
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
