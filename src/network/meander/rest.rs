//! The rest of bends: a stretch that winds enough stays as it is, so that old rivers keep to their belts and never become knots.
//!
//! The measure is sinuosity, the distance along the river over the straight one, in windows that hold two full
//! meanders. A loop that is nearly closed moves on until its neck is cut, which leaves its stretch room to wind anew.
//! Rivers that meander only gently rest much earlier, before there are any loops.

use super::super::settings::NetworkSettings;
use super::super::{Network, River};
use crate::base::geometry::{distance, fast_max, fast_min, smooth_step};
use crate::base::work;

/// The sinuosity beyond which a river that meanders fully rests: where no loop is nearly closed, and where one is.
const MOST: f32 = 2.6;
const MOST_WITH_LOOPS: f32 = 3.3;

/// The sinuosity beyond which a river that hardly meanders rests.
const MOST_OF_BROOKS: f32 = 1.3;

/// The mobility from which on a river meanders fully.
const FULLY: f32 = 0.7;

/// The share of the way to that sinuosity from which on bends slow down.
const NEARLY: f32 = 0.85;

/// The length of a stretch, in widths along the river; bends are about eleven widths long as the crow flies.
const STRETCH: f32 = 48.0;

/// The length of a loop, in widths, and the sinuosities at which it begins to count as nearly closed, and fully does.
const LOOP: f32 = 16.0;
const CLOSING: [f32; 2] = [2.1, 2.8];

/// The mobilities at which loops begin to close, and fully do.
const ALMOST_FULLY: [f32; 2] = [0.4, FULLY];

/// The factor below which a vertex rests.
const LEAST: f32 = 0.05;

/// Slows down stretches that wind enough: lowers the pace of each vertex, the factor for its moves.
pub(super) fn rest(network: &Network, pace: &mut [f32], settings: &NetworkSettings) {
    let (mut stretches, mut loops) = (Winding::default(), Winding::default());
    for river in &network.rivers {
        let pace = &mut pace[river.vertex_range()];
        if pace.iter().all(|&pace| pace == 0.0) {
            continue;
        }
        stretches.measure(network, river, STRETCH, settings);
        loops.measure(network, river, LOOP, settings);
        let own = &network.vertices[river.vertex_range()];
        for (i, (pace, vertex)) in pace.iter_mut().zip(own).enumerate() {
            let left = freedom(stretches.sinuosity[i], loops.sinuosity[i], vertex.mobility);
            *pace = if left < LEAST { 0.0 } else { *pace * left };
        }
    }
}

/// Returns the factor for the pace of a vertex, from 0 to 1, by the sinuosities of its stretch and of its loop and by its mobility.
fn freedom(stretch: f32, around: f32, mobility: f32) -> f32 {
    let fully = fast_min(mobility / FULLY, 1.0);
    let fully = fully * fully.sqrt();
    let most = MOST_OF_BROOKS + (MOST - MOST_OF_BROOKS) * fully;
    let closing = rise(mobility, ALMOST_FULLY) * rise(around, CLOSING) * (1.0 - rise(stretch, [MOST, MOST_WITH_LOOPS]));
    fast_max(1.0 - rise(stretch, [1.0 + (most - 1.0) * NEARLY, most]), closing)
}

/// Rises smoothly from 0 to 1 as a value goes from one number to another.
fn rise(value: f32, [from, to]: [f32; 2]) -> f32 {
    smooth_step((value - from) / (to - from))
}

/// The sinuosity along a river.
#[derive(Default)]
struct Winding {
    /// The distance of each vertex from the source along the river, in units.
    along: Vec<f32>,
    /// The greatest sinuosity of the windows that contain each vertex.
    sinuosity: Vec<f32>,
}

impl Winding {
    /// Measures windows of a river; their length is given in widths.
    fn measure(&mut self, network: &Network, river: &River, widths: f32, settings: &NetworkSettings) {
        /// The distance between the beginnings of windows, as a share of their length.
        const STRIDE: f32 = 0.0625;
        let own = &network.vertices[river.vertex_range()];
        self.along.clear();
        let mut along = 0.0;
        self.along.extend((0..own.len()).map(|i| {
            along += if i > 0 { distance(own[i - 1].at, own[i].at) } else { 0.0 };
            along
        }));
        self.sinuosity.clear();
        self.sinuosity.resize(own.len(), 1.0);
        let mut start = 0;
        while start < own.len() {
            let length = widths * fast_max(own[start].width(), settings.spacing);
            let end = self.reach(start, length);
            let way = self.along[end] - self.along[start];
            // Where the river ends within the window, it is taken to run straight on.
            let beyond = fast_max(length - way, 0.0);
            let sinuosity = (way + beyond) / (distance(own[start].at, own[end].at) + beyond);
            self.sinuosity[start..=end].iter_mut().for_each(|most| *most = fast_max(*most, sinuosity));
            work::count(end - start + 1);
            start = self.reach(start, length * STRIDE).max(start + 1);
        }
    }

    /// Returns the last vertex within a distance downstream of another.
    fn reach(&self, from: usize, way: f32) -> usize {
        let end = self.along[from] + way;
        from + self.along[from..].partition_point(|&along| along <= end) - 1
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{river, settings, sine_generated};
    use super::*;

    /// Returns the pace of the vertices of a sine-generated curve with waves of 22 widths, away from its ends.
    fn paces(omega: f32, mobility: f32) -> Vec<f32> {
        let mut network = river(&sine_generated(omega, 44.0, 12, 44), 2.0);
        network.vertices.iter_mut().for_each(|vertex| vertex.mobility = mobility);
        let mut pace = vec![mobility; network.vertices.len()];
        rest(&network, &mut pace, &settings());
        pace[132..396].to_vec()
    }

    #[test]
    fn what_winds_enough_rests() {
        // Sinuosities of 1.3, 2.1 and 3.2.
        for (omega, moves) in [(1.05, true), (1.57, true), (1.83, false)] {
            let paces = paces(omega, 1.0);
            assert!(paces.iter().all(|&pace| pace == if moves { 1.0 } else { 0.0 }), "{omega}: {paces:?}");
        }
    }

    #[test]
    fn gentle_rivers_rest_sooner() {
        assert!(paces(0.7, 0.3).iter().all(|&pace| pace == 0.3));
        assert!(paces(1.57, 0.3).iter().all(|&pace| pace == 0.0));
    }

    #[test]
    fn a_loop_that_is_nearly_closed_moves_on() {
        assert_eq!([freedom(2.7, 1.9, 1.0), freedom(2.6, 4.0, 1.0), freedom(3.3, 4.0, 1.0)], [0.0, 1.0, 0.0]);
        assert!(freedom(2.6, 4.0, 0.2) < 0.2, "but hardly one of a brook");
    }
}
