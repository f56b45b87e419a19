//! Fixed cells of the plane with one place in each: a triangular lattice, jittered and then bent.
//!
//! Where the land has a grain, the lattice is turned to lie along it: then the grain is as strong at any strike.
//!
//! A place belongs to its cell, and cells are counted from the middle of the domain: places that are not near land are
//! left out, and no place moves.

use glam::{Vec2, Vec2Swizzles};

use super::bends::Bends;
use super::settings::DrainageSettings;
use crate::base::random::{ItemHash, Purpose};
use crate::base::work;
use crate::domain::Domain;
use crate::grow::GrowthSettings;
use crate::recipe::Pattern;

/// The greatest distance of a place from the middle of its cell, as a share of a triangle's side. It is less than
/// 0.433, half a triangle's height, so that the jitter alone turns no triangle over.
const JITTER: f32 = 0.4;

/// A triangle's side for a spacing of 1: √(2/√3).
const SIDE: f32 = 1.074_57;

/// A triangle's height, for a side of 1: √3/2.
const HEIGHT: f32 = 0.866_025_4;

/// The least distance from the coast and from the border of the domain, in spacings, of places that are left out: no
/// edge of a place on land reaches so far.
const MARGIN: f32 = 4.0;

/// Places of the plane on the land of a domain and slightly beyond.
#[derive(Clone, Debug, Default)]
pub(super) struct Lattice {
    /// The places, in domain units.
    pub at: Vec<Vec2>,
    /// The places before the plane was bent.
    pub unbent: Vec<Vec2>,
    /// Two numbers that identify the cell of each place, whatever the domain.
    pub identity: Vec<[u32; 2]>,
}

impl Lattice {
    /// Estimates the number of places over a whole domain.
    pub fn count(domain: &Domain, settings: &DrainageSettings) -> usize {
        let size = 2.0 * half_extent(domain, settings) / settings.spacing;
        (size.x * size.y) as usize
    }

    /// Lays out the places, except those far out at sea.
    pub fn new(growth: &GrowthSettings) -> Self {
        let GrowthSettings { domain, drainage: settings, .. } = growth;
        let extent = half_extent(domain, settings);
        let mut bends = Bends::new(settings, extent);
        let (half, turn) = (domain.size / 2.0, turn(settings));
        // A place may be bent into the margin from beyond it, and out of it.
        let margin = MARGIN * settings.spacing;
        let is_within = |at: Vec2, far: f32| {
            at.abs().cmple(half + far).all()
                && growth.land.as_ref().is_none_or(|land| land.coast_distance().height(half + at) >= -far)
        };
        let chance = settings.seed.item_hash(Purpose::Attractors);
        let side = settings.spacing * SIDE;
        let reach = Vec2::new(extent.dot(turn.abs()), extent.dot(turn.abs().yx()));
        let [columns, rows] = (reach / (side * Vec2::new(1.0, HEIGHT))).to_array().map(|cells| cells as i32 + 1);
        work::count((2 * columns as usize + 1) * (2 * rows as usize + 1));
        let mut this = Self::default();
        for j in -rows..=rows {
            let aside = if (j & 1) == 0 { 0.0 } else { 0.5 };
            for i in -columns..=columns {
                let corner = Vec2::new(i as f32 + aside, j as f32 * HEIGHT) * side;
                let place = turn.rotate(corner + jitter(chance, i, j) * side);
                if !is_within(place, margin + settings.farthest_bend()) {
                    continue;
                }
                let bent = bends.bend(place);
                if is_within(bent, margin) {
                    this.at.push(half + bent);
                    this.unbent.push(half + place);
                    this.identity.push([i as u32, j as u32]);
                }
            }
        }
        this
    }
}

/// Returns the distance from the middle of the domain, in each direction, within which there are places.
fn half_extent(domain: &Domain, settings: &DrainageSettings) -> Vec2 {
    domain.size / 2.0 + settings.farthest_bend() + MARGIN * settings.spacing
}

/// Returns the direction of the rows, a unit vector: along the strike if the land has a grain, and otherwise from west to east.
fn turn(settings: &DrainageSettings) -> Vec2 {
    match settings.pattern {
        Pattern::Trellis | Pattern::Rectangular => settings.strike,
        _ => Vec2::X,
    }
}

/// Draws a random point in a disc: one in the square around it, drawn in if it is outside the disc. (Sine and cosine
/// would add 3 kB to the module.)
fn jitter(chance: ItemHash, i: i32, j: i32) -> Vec2 {
    let unit = |number| 2.0 * chance.unit([i as u32, j as u32, number]) - 1.0;
    let at = Vec2::new(unit(0), unit(1));
    let share = if at.length_squared() > 1.0 { std::f32::consts::FRAC_1_SQRT_2 } else { 1.0 };
    at * (JITTER * share)
}
