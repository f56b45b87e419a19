//! Widths: by discharge, with a small variation of each bank.
//!
//! Width is the square root of discharge (Leopold and Maddock 1953), so that squared widths add where rivers join; 0 at a
//! source. The two banks vary each for itself, since banks that bulge together look like beads on a string. Below a junction no
//! river is ever narrower than its arms were there.

use fastnoise_lite::FastNoiseLite;

use super::parameters::Parameters;
use super::{NONE, Network};
use crate::plane::{distance, least, most};

/// How many spacings a river takes to come from nothing to its width.
const TAPER: f32 = 8.0;

/// Gives every vertex its banks.
pub(super) fn widen(network: &mut Network, parameters: &Parameters) {
    let noise = parameters.width_noise();
    let mut floors = Floors(vec![(0.0, 0.0); network.vertices.len()]);
    // Tributaries stand after the rivers that they join.
    for number in (0..network.rivers.len()).rev() {
        widen_river(network, number, parameters, &noise, &mut floors);
    }
}

/// The least half-widths that arms ask for at junctions.
struct Floors(Vec<(f32, f32)>);

impl Floors {
    fn raise(&mut self, vertex: u32, half: f32) {
        if let Some((left, right)) = self.0.get_mut(vertex as usize) {
            (*left, *right) = (most(*left, half), most(*right, half));
        }
    }
}

/// Makes a vertex that has become a junction as wide as what comes down to it, and lets no bank below it come nearer than
/// it is there: as far down as the next junction of which that is true already.
pub(super) fn settle(network: &mut Network, river: usize, junction: u32, arm: f32) {
    let is_junction = network.junctions();
    let river = network.rivers[river];
    let above = network.vertices[(junction.max(river.start + 1) - 1) as usize];
    let mut floor = (most(arm, above.left), most(arm, above.right));
    let below = junction as usize..river.end as usize;
    for (i, (vertex, &is_junction)) in network.vertices[below.clone()].iter_mut().zip(&is_junction[below]).enumerate() {
        if i > 0 && is_junction && vertex.left >= floor.0 && vertex.right >= floor.1 {
            return;
        }
        (vertex.left, vertex.right) = (most(vertex.left, floor.0), most(vertex.right, floor.1));
        if is_junction {
            floor = (vertex.left, vertex.right);
        }
    }
    let last = network.vertices[river.end as usize - 1];
    if river.joins != NONE {
        settle(network, river.parent as usize, river.joins, last.width() * 0.5);
    }
}

fn widen_river(
    network: &mut Network,
    number: usize,
    parameters: &Parameters,
    noise: &FastNoiseLite,
    floors: &mut Floors,
) {
    let river = network.rivers[number];
    let (mut along, mut floor, mut last) = (0.0f32, (0.0f32, 0.0f32), (0.0f32, 0.0f32));
    let mut previous = None;
    for i in river.own() {
        let vertex = &mut network.vertices[i];
        along += previous.map_or(0.0, |at| distance(vertex.at, at));
        previous = Some(vertex.at);
        let taper = least(along / (parameters.spacing * TAPER), 1.0).sqrt();
        let half = parameters.half_width(vertex.discharge) * taper;
        let bank = |side: f32| {
            // Some ten widths to a bulge.
            let place = along / (most(half, parameters.hairline) * 20.0) * 1.7;
            half * (1.0 + parameters.vary * noise.get_noise_2d(place, number as f32 * 17.3 + side))
        };
        let arms = floors.0[i];
        let is_junction = arms.0 > 0.0;
        if is_junction {
            floor = (most(floor.0, most(arms.0, last.0)), most(floor.1, most(arms.1, last.1)));
        }
        (vertex.left, vertex.right) = (most(bank(0.0), floor.0), most(bank(71.0), floor.1));
        if is_junction {
            floor = (vertex.left, vertex.right);
        }
        last = (vertex.left, vertex.right);
    }
    if river.joins != NONE {
        // Both arms: what is below has to be as wide as the tributary, and on each side half of it.
        floors.raise(river.joins, most((last.0 + last.1) * 0.5, f32::MIN_POSITIVE));
    }
}
