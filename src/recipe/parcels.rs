//! The greatest number of parcels of a country or a widget.

use super::Recipe;
use super::choice::LandKind;

/// The greatest number of attractors, or of parcels on land, that a country or a widget has.
const MOST_PARCELS: f32 = 24_000.0;

/// Returns the greatest number of attractors that a country or a widget has. With less sea than suits the land there are more
/// parcels on land than the recipe says.
pub(super) fn most_attractors(recipe: &Recipe) -> u32 {
    let more_land = (1.0 - recipe.sea()) / (1.0 - recipe.get::<LandKind>().usual_sea());
    (MOST_PARCELS / more_land.max(1.0)).round() as u32
}
