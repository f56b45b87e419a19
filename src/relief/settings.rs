//! The settings of the relief stage, in domain units.

use std::num::NonZero;
use std::sync::Arc;

use fastnoise_lite::FastNoiseLite;

use super::hillsides::Hillsides;
use super::{Grid, Rills};
use crate::base::random::{Purpose, Seed};
use crate::domain::Domain;
use crate::land::{CoastDistance, Land};
use crate::recipe::{NumberKey, Recipe, Sides};

/// The settings of the relief stage, resolved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReliefSettings {
    /// The seed's 64 bits.
    pub seed: Seed,
    /// The rectangle of the map.
    pub domain: Domain,
    /// The cells whose heights are found.
    pub grid: Grid,
    /// The land; `None` if all of the domain is land.
    pub land: Option<Arc<Land>>,
    /// The distances from the coast of the low stand, if the sea has risen since the rivers began; hillsides go by them.
    pub low_stand: Option<Arc<CoastDistance>>,
    /// The distance into flat ground that rivers have laid, in units, negative elsewhere; `None` if there is none.
    pub(crate) flats: Option<Arc<CoastDistance>>,
    /// The sides beyond which lies the sea, where all of the domain is land.
    pub sides: Sides,
    /// The discharge of a river that would drain the whole map.
    pub total_discharge: u32,
    /// The slope of hillsides far from any coast: rise over run.
    pub mountains: f32,
    /// The distance from the coast at which hillsides reach the slope of mountains, in units.
    pub plains: f32,
    /// The number of threads that may work on the relief. The result does not depend on it.
    pub threads: NonZero<usize>,
    /// The strength with which rills carve the hillsides, from 0 to 1.
    pub rills: f32,
    /// The constants of hillsides.
    pub(super) hillsides: Hillsides,
    /// The wavelength, in units, and the contrast of the hard and soft ground that rivers grew on; `None` if they grew on even ground.
    pub(crate) rock: Option<(f32, f32)>,
    /// The rills; `None` if they are unknown, or carve nothing.
    pub(crate) rill_lines: Option<Arc<Rills>>,
}

impl ReliefSettings {
    /// Resolves a recipe's settings on some land, for the map's own grid; `total_discharge` is that of a river that
    /// would drain the whole map.
    pub fn new(recipe: &Recipe, land: Option<Arc<Land>>, total_discharge: u32) -> Self {
        let domain = Domain::of(recipe);
        Self {
            seed: Seed::from_text(recipe.seed()),
            domain,
            grid: Grid::of(&domain),
            land,
            low_stand: None,
            flats: None,
            sides: recipe.open_sides(),
            total_discharge: total_discharge.max(1),
            mountains: recipe.number(NumberKey::Mountains),
            plains: recipe.number(NumberKey::Plains),
            threads: NonZero::<usize>::MIN,
            rills: recipe.number(NumberKey::Rills),
            hillsides: Hillsides::OF_A_MAP,
            rock: None,
            rill_lines: None,
        }
    }

    /// Replaces the coast of the low stand from which the sea has risen; `None` if it has not.
    #[must_use]
    pub(crate) fn with_low_stand(self, low_stand: Option<Arc<CoastDistance>>) -> Self {
        Self { low_stand, ..self }
    }

    /// Replaces the flat ground that rivers have laid; `None` if there is none.
    #[must_use]
    pub(crate) fn with_flats(self, flats: Option<Arc<CoastDistance>>) -> Self {
        Self { flats, ..self }
    }

    /// Replaces hillsides by those of a low stand, and mountains and plains by the usual ones, whatever the recipe asks for.
    pub(super) fn of_low_stand(self) -> Self {
        let usual = Recipe::usual();
        let [mountains, plains] = [NumberKey::Mountains, NumberKey::Plains].map(|key| usual.number(key));
        Self { mountains, plains, hillsides: Hillsides::OF_A_LOW_STAND, ..self }
    }

    /// Replaces the wavelength, in units, and the contrast of hard and soft ground; `None` for even ground.
    pub(crate) fn with_rock(self, rock: Option<(f32, f32)>) -> Self {
        Self { rock, ..self }
    }

    /// Adds rills. `lines` is called only if they carve anything.
    pub(crate) fn with_rills(mut self, lines: impl FnOnce() -> Arc<Rills>) -> Self {
        self.rill_lines = (self.rills > 0.0).then(lines);
        self
    }

    /// Returns noise over the map, from −1 to 1, with a wavelength in units. Each index has noise of its own.
    pub(super) fn noise(&self, index: u32, wavelength: f32, octaves: i32) -> FastNoiseLite {
        self.seed.noise(Purpose::Relief, index, 1.0 / wavelength, octaves)
    }
}
