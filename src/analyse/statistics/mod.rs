//! Measures of a finished network: the numbers by which hydrologists compare river networks, and counts of features
//! that map readers dislike. [`TABLE`] names them and gives the values of natural rivers.

mod along_coast;
mod areas;
mod bends;
mod beside;
mod courses;
mod directions;
mod drained;
mod fit;
mod hooks;
mod index;
mod knots;
mod parallels;
mod pattern;
mod pieces;
#[cfg(test)]
pub(crate) mod samples;
mod streams;
mod table;
#[cfg(test)]
mod tests;
mod umbrellas;
mod waters;

pub use along_coast::along_coast;
pub use areas::area_exponent;
pub use bends::Bends;
pub use beside::beside;
pub use courses::{Angles, junction_angles, sinuosity, total_length, tributary_angle};
pub use directions::Directions;
pub use drained::Drained;
pub use hooks::hooks;
pub(crate) use index::Index;
pub use knots::knots;
pub use parallels::parallels;
pub use pattern::{PATTERNS, Pattern};
pub use pieces::Look;
pub use streams::{Streams, hack_exponent};
pub use table::{Measure, Nature, TABLE};
pub use umbrellas::umbrellas;
pub use waters::Waters;

use glam::Vec2;

use crate::domain::parcel_spacing;
use crate::land::CELL_SIZE;
use crate::map::Map;
use crate::recipe::{GrowthMethod, Sides};
use crate::tree::Hydrology;

/// The distance above a junction at which its angle is measured, in spacings.
pub const ANGLE_SPACINGS: f32 = 3.0;

/// The measures of a network. A measure is `None` if the network is too small for it.
///
/// A *spacing* is the distance that attractors would have if all of the domain were land, so maps of space colonization
/// and of drainage share one ruler. For a Brownian tree it is the sensitivity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Measures {
    /// Horton's bifurcation ratio.
    pub bifurcation_ratio: Option<f64>,
    /// Horton's length ratio.
    pub length_ratio: Option<f64>,
    /// Tokunaga's T_1.
    pub tokunaga_t1: Option<f64>,
    /// Tokunaga's c.
    pub tokunaga_c: Option<f64>,
    /// Hack's exponent.
    pub hack_exponent: Option<f64>,
    /// The median sinuosity of the rivers of order 2 and higher.
    pub sinuosity: Option<f64>,
    /// The length of river per area of land, in 1/unit.
    pub drainage_density: f64,
    /// The drainage density times a spacing: the length of river, in spacings, on a square spacing of land.
    pub density_per_spacing: f64,
    /// The angles between rivers at junctions.
    pub junction_angles: Option<Angles>,
    /// Number of trunks of similar size that meet at mouths.
    pub umbrellas: u32,
    /// Total length of pairs of rivers that run beside each other for long, in units.
    pub parallels: f64,
    /// The length of river that runs along a coast, in units.
    pub along_coast: f64,
    /// The median angle at which rivers of order 1 join others, in degrees.
    pub tributary_angle: Option<f64>,
    /// Number of places where three rivers or more crowd without joining, per 1,000 spacings of river.
    pub knots: Option<f64>,
    /// The share of headwater brooks that are fishhooks.
    pub hooks: Option<f64>,
    /// The share of the length of rivers that lies beside its valley instead of in it.
    pub beside: Option<f64>,
    /// The bends of the greatest rivers.
    pub bends: Bends,
    /// The exponent of the areas that drain to places of the greatest basin.
    pub area_exponent: Option<f64>,
    /// The looks of the map's pieces, drawn as densely as the world's maps.
    pub look: Look,
    /// The directions of the rivers.
    pub directions: Option<Directions>,
    /// The coasts, lakes and deltas.
    pub waters: Waters,
}

impl Measures {
    /// Measures the rivers of a map.
    pub fn of(map: &Map) -> Self {
        let network = map.network();
        let spacing = ruler(map);
        let pruned = map.pruned();
        let order = &pruned.hydrology.order;
        let streams = Streams::of(&pruned.tree, order);
        let area = land_area(map);
        let density = if area > 0.0 { total_length(network) / area } else { 0.0 };
        Self {
            bifurcation_ratio: streams.bifurcation_ratio(),
            length_ratio: streams.length_ratio(),
            tokunaga_t1: streams.side_branches(1),
            tokunaga_c: streams.tokunaga_c(),
            hack_exponent: hack_exponent(&pruned.tree, order, &pruned.hydrology.discharge),
            sinuosity: sinuosity(network).map(f64::from),
            drainage_density: density,
            density_per_spacing: density * f64::from(spacing),
            junction_angles: junction_angles(network, ANGLE_SPACINGS * spacing),
            umbrellas: umbrellas(network),
            parallels: parallels(network, spacing),
            along_coast: along_coast(network, spacing, |at| inland(map, map.recipe().sides(), at)),
            tributary_angle: tributary_angle(network, ANGLE_SPACINGS * spacing),
            knots: knots(network, spacing),
            hooks: hooks(network, spacing),
            beside: map.make_relief().ok().and_then(|relief| beside(network, &relief, None)),
            bends: Bends::of(network, spacing),
            area_exponent: area_exponent(map.tree(), &Hydrology::of(map.tree()).discharge),
            look: Look::typical(&Look::all(network, map.domain().size, density as f32)),
            directions: Directions::of(network, spacing),
            waters: Waters::of(map),
        }
    }

    /// Names the pattern of drainage. `None` if there is no river or no junction.
    pub fn pattern(&self) -> Option<Pattern> {
        Some(Pattern::of(self.directions?, self.junction_angles?))
    }
}

/// Returns the spacing of streams, the ruler for all lengths. Space colonization is measured by that of drainage with
/// as many parcels; a Brownian tree has its own.
fn ruler(map: &Map) -> f32 {
    match map.recipe().get() {
        GrowthMethod::Colonize => parcel_spacing(map.recipe()),
        GrowthMethod::Drainage | GrowthMethod::Brownian => map.grown().stream_spacing,
    }
}

/// Returns the area of a map's land, in square units.
pub(crate) fn land_area(map: &Map) -> f64 {
    let domain = map.domain().size;
    let of_cells = |cells: u32| f64::from(cells) * f64::from(CELL_SIZE * CELL_SIZE);
    let all = || f64::from(domain.x) * f64::from(domain.y);
    map.land().map_or_else(all, |land| land.regions().iter().map(|region| of_cells(region.cells)).sum())
}

/// Returns the distance of a point from the coast, in units; positive inland. In a rectangle everything is land, and
/// `sides` are its coasts.
pub(crate) fn inland(map: &Map, sides: Sides, at: Vec2) -> f32 {
    let beyond = map.domain().size - at;
    let from_sides = || {
        let all = [('n', at.y), ('e', beyond.x), ('s', beyond.y), ('w', at.x)];
        all.into_iter().filter(|(side, _)| sides.contains(*side)).map(|(_, far)| far).fold(f32::INFINITY, f32::min)
    };
    map.land().map_or_else(from_sides, |land| land.coast_distance().height(at))
}
