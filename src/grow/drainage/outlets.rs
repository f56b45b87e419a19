//! Outlets: the places along the coast where water leaves the land.
//!
//! An edge of the triangulation from a parcel on land to a place in water crosses the coast, and there is an outlet: the
//! nearest one for each parcel. So there is about one for each spacing, and no way to an outlet crosses an edge. Water
//! decides which of them become great rivers. The frame of a picture is not a coast, since land continues beyond it,
//! except for the chosen sides of a rectangle.

use glam::Vec2;

use crate::base::geometry::distance;
use crate::base::sort;
use crate::base::work;
use crate::grow::mouths::{mouths, on_chosen_sides};
use crate::grow::{GrowthSettings, Mouth};
use crate::land::Land;
use crate::recipe::Sides;

/// A place on the coast that a parcel drains to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Outlet {
    pub at: Vec2,
    pub parcel: u32,
}

/// Finds the outlets of a land, as many as are asked for. `beyond` names the places around a parcel that are not its
/// neighbours.
pub(super) fn find<B: Iterator<Item = Vec2>>(
    settings: &GrowthSettings,
    parcels: &[Vec2],
    beyond: impl Fn(usize) -> B,
) -> Vec<Outlet> {
    let mut all = Vec::new();
    for (parcel, &from) in parcels.iter().enumerate() {
        let coasts = beyond(parcel).filter_map(|there| settings.coast_toward(from, there));
        let nearer = |a: Vec2, b: Vec2| if b.distance_squared(from) < a.distance_squared(from) { b } else { a };
        all.extend(coasts.reduce(nearer).map(|at| Outlet { at, parcel: parcel as u32 }));
    }
    if settings.mouths > 0 { nearest_to_mouths(settings, &all) } else { thin_out(settings, all) }
}

/// Finds for each requested mouth the nearest outlet on the same land that is not taken.
fn nearest_to_mouths(settings: &GrowthSettings, all: &[Outlet]) -> Vec<Outlet> {
    let mut is_left = vec![true; all.len()];
    let nearest = |mouth: Mouth| {
        work::count(all.len());
        let is_near = |&i: &usize| is_left[i] && settings.is_same_region(mouth.at, all[i].at);
        let far = |i: usize| all[i].at.distance_squared(mouth.at);
        let nearest = (0..all.len()).filter(is_near).reduce(|a, b| if far(b) < far(a) { b } else { a })?;
        is_left[nearest] = false;
        Some(all[nearest])
    };
    mouths(settings).into_iter().filter_map(nearest).collect()
}

/// Keeps outlets on the chosen shores that are far enough from all others, those in bays first.
fn thin_out(settings: &GrowthSettings, all: Vec<Outlet>) -> Vec<Outlet> {
    let Some(land) = settings.land.as_deref().filter(|_| settings.shores != Sides::ALL || settings.mouth_spacing > 0.0)
    else {
        return all;
    };
    let mut kept = Vec::new();
    for region in land.regions() {
        let outlets: Vec<Outlet> = all.iter().filter(|outlet| region.holds(outlet.at)).copied().collect();
        let chosen = on_chosen_sides(region, settings.shores, outlets, |outlet| outlet.at);
        kept.extend(keep_apart(land, chosen, settings.mouth_spacing));
    }
    kept
}

fn keep_apart(land: &Land, outlets: Vec<Outlet>, apart: f32) -> Vec<Outlet> {
    let mut kept: Vec<Outlet> = Vec::new();
    let bays_first = sort::argsort(outlets.iter().map(|outlet| !sort::key(land.shelter(outlet.at))));
    for outlet in bays_first.into_iter().map(|i| outlets[i]) {
        work::count(kept.len());
        if kept.iter().all(|other| distance(other.at, outlet.at) > apart) {
            kept.push(outlet);
        }
    }
    kept
}
