//! The margin of a map whose land runs off it: paper between the edges of its picture and the thin line at which the map ends.

use glam::Vec2;

use super::Land;
use crate::recipe::Shown;
use crate::recipe::Style;

/// The width of the margin of a picture, from its edges to the map, in units.
pub(crate) const MARGIN: f32 = 9.0;

/// Returns the margin that pictures and files of the whole map have in a style, in units; 0 if they have none. `land` is `None` if all of
/// the map is land, and `size` the map's, in units.
pub(crate) fn margin_of(style: Style, size: Vec2, land: Option<&Land>) -> f32 {
    if style.shows(Shown::Neatline) && runs_off(size, land) { MARGIN } else { 0.0 }
}

/// Returns `true` if a part of the map's border that can be seen is land.
pub(crate) fn runs_off(size: Vec2, land: Option<&Land>) -> bool {
    /// The share of the border that may be land before that ends at a line.
    const SHARE: f32 = 0.03;
    /// The number of places to look at along each side.
    const PLACES: u16 = 256;
    let Some(land) = land else { return true };
    let side = |from: Vec2, to: Vec2| {
        let places = (0..PLACES).map(move |i| from.lerp(to, (f32::from(i) + 0.5) / f32::from(PLACES)));
        let ashore = places.filter(|&at| land.coast_distance().height(at) > 0.0).count();
        ashore as f32 / f32::from(PLACES) * (to - from).abs().element_sum()
    };
    let (east, south) = (Vec2::new(size.x, 0.0), Vec2::new(0.0, size.y));
    let ashore = side(Vec2::ZERO, east) + side(south, size) + side(Vec2::ZERO, south) + side(east, size);
    ashore > SHARE * 2.0 * size.element_sum()
}
