//! Outlets: where water leaves the land, along all of its coast.
//!
//! An edge of the lattice from a parcel to a cell in the water crosses the coast, and there is an outlet: the nearest of each parcel. So
//! there is about one a spacing, and none of the ways to them crosses an edge. Which of them become great rivers is for
//! the water to find out. The frame of a picture is no coast, where land runs on beyond it, but for a rectangle's chosen sides.

use glam::Vec2;

use super::directions::NONE;
use super::lattice::Lattice;
use crate::geometry::distance;
use crate::grow::mouths::{mouths, on_chosen_sides};
use crate::grow::{GrowthSettings, Mouth};
use crate::land::{Land, Region};
use crate::recipe::Sides;
use crate::sort;
use crate::work;

/// A place on the coast that a parcel drains to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Outlet {
    pub at: Vec2,
    pub parcel: u32,
}

/// The outlets of a land, as many as are asked for.
pub(super) fn find(
    settings: &GrowthSettings,
    lattice: &Lattice,
    cells: &[usize],
    neighbours: &[[u32; 6]],
) -> Vec<Outlet> {
    let nearest = |(parcel, &cell): (usize, &usize)| {
        let from = lattice.at[cell];
        let around = lattice.neighbours(cell);
        let ways = (0..6).filter(|&way| neighbours[parcel][way] == NONE && lattice.is_edge(cell, way));
        let coasts = ways.filter_map(|way| settings.coast_toward(from, lattice.at[around[way]]));
        let nearest = coasts.reduce(|a, b| if b.distance_squared(from) < a.distance_squared(from) { b } else { a });
        nearest.map(|at| Outlet { at, parcel: parcel as u32 })
    };
    let all: Vec<Outlet> = cells.iter().enumerate().filter_map(nearest).collect();
    if settings.mouths > 0 { nearest_to_mouths(settings, &all) } else { thin_out(settings, all) }
}

/// For each mouth that is asked for, the outlet nearest to it on the same land, of those that are left.
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

/// Outlets on the chosen shores, each at least so far from all others, those in bays first.
fn thin_out(settings: &GrowthSettings, all: Vec<Outlet>) -> Vec<Outlet> {
    let Some(land) = settings.land.as_deref().filter(|_| settings.shores != Sides::ALL || settings.mouth_spacing > 0.0)
    else {
        return all;
    };
    let of_region = |region: &Region| {
        let outlets: Vec<Outlet> = all.iter().filter(|outlet| land.is_in(region, outlet.at)).copied().collect();
        let chosen = on_chosen_sides(region, settings.shores, outlets, |outlet| outlet.at);
        keep_apart(land, chosen, settings.mouth_spacing)
    };
    land.regions().iter().flat_map(of_region).collect()
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
