//! Drowned coasts: the sea rises over land that rivers have cut.
//!
//! ```text
//! low stand ─► drainage ─► valleys ─► coarse relief ─► waves ─► level ─► silt ─► rias ─► land
//! ```
//!
//! Rivers grow on the land of a low stand. Then a coarse relief gives each corner of its lattice a height, low along rivers and
//! high between them, and the land is what lies above the level at which the sea covers the share that the recipe asks for.
//! Every valley that reaches below that level becomes an inlet: a ria (von Richthofen 1886), or a fjord where rock is hard.

mod fjords;
mod level;
mod rias;
mod silt;
#[cfg(test)]
mod tests;
mod transgression;
mod valleys;
mod waves;

use std::sync::Arc;

use crate::base::geometry::smooth_step;
use crate::base::memory::{Refused, ask};
use crate::base::random::DEVIATION;
use crate::base::work;
use crate::deltas::Sediment;
use crate::grow::DrainageSettings;
use crate::land::{CoastDistance, Land, LowStand};
use crate::recipe::Recipe;
use crate::relief::LowStandRelief;
use crate::tree::Tree;
use level::Level;
use valleys::Marking;
use waves::Waves;

pub(crate) use rias::Silted;
pub(crate) use transgression::Transgression;
pub(crate) use valleys::Valleys;

/// The search for the level to which the sea rises, step by step.
#[derive(Debug)]
pub(crate) struct Drowning {
    low_stand: Arc<LowStand>,
    recipe: Recipe,
    drainage: DrainageSettings,
    /// The hardness of the ground at each corner, mostly from −1 to 1; empty until it is needed.
    rock: Vec<f32>,
    next: Part,
}

/// The part that the next step does, or goes on with.
#[derive(Debug)]
enum Part {
    Begin,
    /// Marks the valleys of the tree.
    Mark(Marking),
    Hillsides(Arc<Valleys>),
    /// Raises ridges, from a segment on.
    Ridges(Arc<Valleys>, LowStandRelief, usize),
    March(Arc<Valleys>, LowStandRelief),
    Waves(Arc<Valleys>, Waves),
    Level(Arc<Valleys>, Level),
    /// No part: only once the level is known.
    Between,
}

/// The land that the sea has left, and the valleys that the sea rose into.
#[derive(Clone, Debug)]
pub(crate) struct Drowned {
    pub land: Arc<Land>,
    pub valleys: Arc<Valleys>,
    pub silted: Arc<Silted>,
}

impl Drowning {
    /// The approximate memory of a rise, in megabytes.
    pub const MEGABYTES: u32 = 12;

    /// Begins the rise of the sea from the low stand of a recipe.
    pub fn new(recipe: &Recipe, low_stand: Arc<LowStand>) -> Self {
        Self {
            low_stand,
            recipe: recipe.clone(),
            drainage: DrainageSettings::new(recipe),
            rock: Vec::new(),
            next: Part::Begin,
        }
    }

    /// Begins the rise of the sea over valleys that are known already.
    pub fn over(recipe: &Recipe, low_stand: Arc<LowStand>, valleys: Arc<Valleys>) -> Self {
        Self { next: Part::Hillsides(valleys), ..Self::new(recipe, low_stand) }
    }

    /// Returns the share of the work that is done, from 0 to 1.
    pub fn progress(&self) -> f32 {
        match &self.next {
            Part::Begin => 0.0,
            Part::Mark(_) => 0.1,
            Part::Hillsides(_) => 0.2,
            Part::Ridges(..) => 0.3,
            Part::March(..) => 0.4,
            Part::Waves(..) => 0.6,
            Part::Level(..) => 0.8,
            Part::Between => 1.0,
        }
    }

    /// Does a step of the work for the tree that grew on the low stand. Returns the transgression once its level is known.
    ///
    /// # Errors
    /// Fails if there is not enough memory. A further call begins again.
    pub fn step(&mut self, tree: &Tree) -> Result<Option<Transgression>, Refused> {
        let part = std::mem::replace(&mut self.next, Part::Begin);
        let (next, transgression) = self.advance(part, tree)?;
        self.next = next;
        Ok(transgression)
    }

    #[inline(never)] // one copy for sessions and drafts
    fn advance(&mut self, part: Part, tree: &Tree) -> Result<(Part, Option<Transgression>), Refused> {
        let next = match part {
            Part::Begin => Part::Mark(Marking::new(tree, self.lattice(), self.drainage.spacing)?),
            Part::Mark(mut marking) => match marking.advance(tree) {
                true => Part::Mark(marking),
                false => Part::Hillsides(Arc::new(marking.into_valleys())),
            },
            Part::Hillsides(valleys) => {
                self.rock = self.rock()?;
                Part::Ridges(valleys.clone(), self.hillsides(&valleys)?, 0)
            }
            Part::Ridges(valleys, mut relief, from) => match relief.raise_ridges(from) {
                Some(next) => Part::Ridges(valleys, relief, next),
                None => {
                    relief.start()?;
                    Part::March(valleys, relief)
                }
            },
            Part::March(valleys, mut relief) => match relief.advance() {
                true => Part::March(valleys, relief),
                false => Part::Waves(valleys, Waves::new(self.lattice(), relief.heights()?, &self.softness())?),
            },
            Part::Waves(valleys, mut waves) => match waves.advance() {
                true => Part::Waves(valleys, waves),
                false => {
                    let level = Level::new(&self.low_stand.land, waves.into_heights(), self.low_stand.sea)?;
                    Part::Level(valleys, level.with_sediment(Sediment::of(&self.recipe)))
                }
            },
            Part::Level(valleys, mut level) => match level.advance(&self.low_stand.land, &valleys.rivers)? {
                None => Part::Level(valleys, level),
                Some((reached, land)) => {
                    let drowned = Drowned { land: land.into(), valleys, silted: level.take_silted().into() };
                    let transgression =
                        Transgression::new(self.low_stand.clone(), level.into_heights(), reached, drowned);
                    return Ok((Part::Between, Some(transgression)));
                }
            },
            Part::Between => Part::Begin,
        };
        Ok((next, None))
    }

    /// Prepares the relief of the low stand, with valleys, hard and soft ground, and a gentle shelf.
    fn hillsides(&self, valleys: &Valleys) -> Result<LowStandRelief, Refused> {
        let mut relief = LowStandRelief::new(&self.recipe, &self.low_stand.land)?;
        let today = self.low_stand.today.heights();
        relief.steepen(|corner| {
            let hardness = self.rock[corner];
            valleys.steepness(corner, hardness) * of_rock(hardness) * of_shelf(today[corner])
        });
        Ok(relief)
    }

    fn lattice(&self) -> &CoastDistance {
        self.low_stand.land.coast_distance()
    }

    /// Computes the hardness of the ground at each corner of the low stand; 0 at sea, where it does not matter.
    fn rock(&self) -> Result<Vec<f32>, Refused> {
        let (lattice, noise) = (self.lattice(), self.drainage.rock());
        let corners = lattice.heights().len();
        ask(size_of_val(lattice.heights()))?;
        work::count(4 * corners);
        let hardness = |(corner, &height): (usize, &f32)| {
            let at = lattice.corner(corner);
            if height > 0.0 { DEVIATION * noise.get_noise_2d(at.x, at.y) } else { 0.0 }
        };
        Ok(lattice.heights().iter().enumerate().map(hardness).collect())
    }

    /// Returns the ease with which waves move the ground at each corner, from 0 to 1.
    fn softness(&self) -> Vec<f32> {
        self.rock.iter().map(|&rock| smooth(SOFT.0, SOFT.1, rock)).collect()
    }
}

/// The hardness at which waves begin to move ground, and at which ground counts as fully soft.
const SOFT: (f32, f32) = (-0.5, -1.3);

/// Returns the steepness of ground of some hardness, as a share of the usual.
fn of_rock(hardness: f32) -> f32 {
    const CONTRAST: f32 = 0.4;
    const MOST: f32 = 1.2;
    libm::expf(CONTRAST * hardness.clamp(-MOST, MOST))
}

/// Returns the steepness of ground, as a share of the usual, at a distance from today's coast, in units, negative off
/// it. Off that coast land is a gentle shelf, which drowns first; so the large form stays.
fn of_shelf(inland: f32) -> f32 {
    const SHELF: f32 = 0.35;
    const BLEND: f32 = 24.0;
    SHELF + (1.0 - SHELF) * smooth(-0.5 * BLEND, 0.5 * BLEND, inland)
}

/// Rises smoothly from 0 to 1 as a value goes from one number to another.
fn smooth(from: f32, to: f32, value: f32) -> f32 {
    smooth_step((value - from) / (to - from))
}
