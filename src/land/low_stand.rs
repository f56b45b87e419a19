//! The low stand: the land as it was before the sea rose, with more of it above the water.
//!
//! It is the shape that a recipe names, at a lower level of the sea. Parts that are islands today stay apart, because a
//! river through a strait would join them for good.

use std::sync::Arc;

use super::cell::Cell;
use super::coast_distance::CoastDistance;
use super::form::Form;
use super::kinds::Shape;
use super::queries::Land;
use super::ragged::Ragged;
use super::straits::straits;
use crate::recipe::{GrowthMethod, LandKind, NumberKey, Recipe};

/// The land of a low stand, and the coast of the same shape at the share of sea that the recipe asks for.
#[derive(Clone, Debug)]
pub(crate) struct LowStand {
    pub land: Arc<Land>,
    pub today: CoastDistance,
    /// The share of the domain that the sea covers once it has risen.
    pub sea: f32,
}

/// The share of the domain that a risen sea has taken: the least, so that it shows in spite of inexact coasts, and what
/// a sea risen in full has taken besides.
const LEAST_RISE: f32 = 0.03;
const RISE: f32 = 0.27;

/// The least share of sea at the lowest stand; more for islands, which would fill the frame; and, for small seas, a
/// share of today's.
const LEAST_SEA: f32 = 0.1;
const LEAST_SEA_AROUND_AN_ISLAND: f32 = 0.3;
const LEAST_SHARE: f32 = 0.6;
/// The most land of a figure at the lowest stand, as a multiple of today's: with more of it, its bays would be filled.
const MOST_LAND_OF_A_FIGURE: f32 = 1.7;

impl LowStand {
    /// Makes the low stand of a recipe, on a lattice with a spacing; `None` if the recipe drowns nothing.
    pub fn of(recipe: &Recipe, spacing: f32) -> Option<Self> {
        if !Self::is_wanted(recipe) {
            return None;
        }
        let shape = Shape::of(recipe);
        let form = Form::of(&shape)?;
        let today = form.with_sea(spacing, shape.sea).settled();
        let drowning = recipe.number(NumberKey::Drowning);
        // The lower the sea, the likelier is a part between ridges without a coast.
        let mut lowest = None;
        for share in LOWERINGS {
            let land = land(&shape, &form, &today, low_sea(&shape, drowning * share));
            if has_coasts(&land) {
                lowest = Some(land);
                break;
            }
            lowest.get_or_insert(land);
        }
        Some(Self { land: lowest?.into(), today, sea: shape.sea })
    }

    /// Returns `true` if the sea rises in a recipe: over the valleys of drainage, on a shaped coast.
    pub fn is_wanted(recipe: &Recipe) -> bool {
        recipe.number(NumberKey::Drowning) > 0.0
            && recipe.get::<GrowthMethod>() == GrowthMethod::Drainage
            && !matches!(recipe.get(), LandKind::Rectangle | LandKind::Drawn)
    }
}

/// The shares of the wanted drowning that are tried until every part of the land has a coast.
const LOWERINGS: [f32; 4] = [1.0, 0.6, 0.3, 0.0];

/// Makes the land where the sea covers a share of the domain, which keeps today's straits and loses none of today's seas.
fn land(shape: &Shape, form: &Form, today: &CoastDistance, sea: f32) -> Land {
    let low = form.with_sea(today.spacing(), sea);
    let mut kept = straits(today);
    kept.extend(lost_seas(today, &low));
    let land = Land::new(&shape.domain, form.finished(low.flooded(&kept)), shape.ridges());
    land.with_ragged(Ragged::of(shape))
}

/// Returns `true` if every part of a land that is large enough for rivers has a coast.
fn has_coasts(land: &Land) -> bool {
    /// The least number of cells of such a part, and of its cells beside the sea.
    const PART: u32 = 2_000;
    const COAST: usize = 60;
    land.regions().iter().all(|region| region.cells < PART || region.shores.len() >= COAST)
}

/// Returns the share of sea at the low stand, which falls evenly with drowning to that of the lowest stand.
fn low_sea(shape: &Shape, drowning: f32) -> f32 {
    let least = if shape.kind == LandKind::Island { LEAST_SEA_AROUND_AN_ISLAND } else { LEAST_SEA };
    let largest = if shape.kind.is_figure() { MOST_LAND_OF_A_FIGURE * (1.0 - shape.sea) } else { 1.0 };
    let lowest = (shape.sea - LEAST_RISE - RISE).max(least.min(LEAST_SHARE * shape.sea)).max(1.0 - largest);
    let highest = (shape.sea - LEAST_RISE).max(lowest);
    highest + (lowest - highest) * drowning
}

/// Lists the corners of today's seas of which nothing is left at the low stand: land around them would have no outlet.
fn lost_seas(today: &CoastDistance, low: &CoastDistance) -> Vec<usize> {
    let mut seas = today.regions(Cell::Water);
    seas.retain(|sea| today.corners_of(sea).all(|corner| low.heights()[corner] > 0.0));
    seas.iter().flat_map(|sea| today.corners_of(sea)).collect()
}
