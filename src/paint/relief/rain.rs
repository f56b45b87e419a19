//! Rain from place to place, as far as it decides tints: in so many levels that no edge is seen between two.

use glam::Vec2;

use super::field::{Field, Place, places};
use crate::paint::palette::Tints;
use crate::paint::styles::{Scheme, palette};
use crate::paint::view::View;
use crate::relief::{Rainfall, Relief, Wind};

/// The number of levels: an odd one, so that one of them is that of the whole map.
const LEVELS: usize = 33;

/// Returns the tints of a scheme at each of some levels of rain, the driest first; none if it has no relief.
pub(crate) fn by_rain(scheme: Scheme, levels: usize) -> Vec<Tints> {
    let more = |level: usize| (level as f32 / (levels - 1) as f32 * 2.0 - 1.0) * Rainfall::MOST;
    let tints = |level| palette(scheme.with_more_rain(more(level))).relief.map(|look| look.tints);
    (0..levels).filter_map(tints).collect()
}

/// Returns the tints of a scheme at each level of rain in pictures; only those of the whole map where rain makes no difference.
pub(crate) fn tints_of(scheme: Scheme, wind: Option<Wind>) -> Vec<Tints> {
    if wind.is_some() && scheme.style.has_climate() {
        return by_rain(scheme, LEVELS);
    }
    palette(scheme).relief.iter().map(|look| look.tints).collect()
}

/// The level of rain in each pixel of a picture.
#[derive(Clone, Debug)]
pub(super) struct RainLevels {
    pub wind: Wind,
    /// The deviations, as shares of the greatest.
    field: Field,
    places: Vec<Place>,
}

impl RainLevels {
    pub fn new(relief: &Relief, wind: Wind, view: &View) -> Self {
        let Rainfall { grid, deviations } = Rainfall::of(relief, wind);
        let values = deviations.iter().map(|deviation| deviation / Rainfall::MOST).collect();
        Self { wind, field: Field { grid, values }, places: places(view, grid) }
    }

    /// Calls `visit` for each pixel of a row, with its number and its level.
    pub fn for_each(&self, view: &View, y: u32, mut visit: impl FnMut(usize, usize)) {
        let line = self.field.line(view.point(Vec2::splat(y as f32 + 0.5)).y, false);
        for (i, &Place { column, along }) in self.places.iter().enumerate() {
            let share = line[column].at(along) * 0.5 + 0.5;
            // A conversion turns negative numbers into 0.
            visit(i, ((share * (LEVELS - 1) as f32 + 0.5) as usize).min(LEVELS - 1));
        }
    }
}
