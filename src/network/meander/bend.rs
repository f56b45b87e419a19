//! Meandering by vectors (Hodgin; Dragons Abound): each point moves toward the outside of its bend and down the meander
//! belt, in proportion to the river's curvature there.
//!
//! Curvature is measured in widths, so that wide rivers and narrow ones bend alike; capped, so that no sharp corner runs
//! away; and smoothed along the river, over a distance at which bends of about eleven widths grow fastest, as they do
//! in nature. The cap comes first: one corner does not outweigh a bend.

use glam::Vec2;

use super::super::curvature::curvature;
use super::super::settings::NetworkSettings;
use super::super::{Network, River};
use crate::base::geometry::{direction, distance, fast_max};

/// The curvature, times width, above which bends move no faster: a radius of two widths.
const SHARPEST: f32 = 0.5;

/// The distance over which curvature is smoothed, in widths. A small bend's rate of growth goes with k² / (1 + k²L²)²,
/// which is greatest at a wavelength of 2πL; grown bends come out somewhat shorter.
const MEMORY: f32 = 2.2;

/// The distance up and down the river over which the direction of its belt is taken, in widths: about a bend either way.
const BELT: f32 = 8.0;

/// The share of the sharpest bend from which on bends are eased.
const NEARLY: f32 = 0.7;

/// The share of the way to the midpoint of its neighbours that a vertex is drawn in a round where the river bends
/// almost too sharply. Drawn so everywhere, rivers would pull straight like rubber bands.
const EASE: f32 = 0.4;

/// The distance that the sharpest bend moves in a round at full strength, in widths.
const PACE: f32 = 1.2;

/// Returns the offset by which each vertex is to move in a round, in units.
pub(super) fn moves(network: &Network, step_scale: &[f32], settings: &NetworkSettings) -> Vec<Vec2> {
    let mut moves = vec![Vec2::ZERO; network.vertices.len()];
    let mut course = Course::default();
    for river in &network.rivers {
        if step_scale[river.vertex_range()].iter().any(|&step_scale| step_scale > 0.0) {
            course.read(network, river, settings);
            course.smooth();
            course.bend(&step_scale[river.vertex_range()], settings, &mut moves[river.vertex_range()]);
        }
    }
    moves
}

/// The curvature along a river, in widths.
#[derive(Default)]
pub(super) struct Course {
    pub at: Vec<Vec2>,
    /// The width that counts: rivers narrower than a spacing bend as if they were as wide as that.
    pub width: Vec<f32>,
    /// Curvature times width over that of the sharpest bend, from -1 to 1.
    pub bend: Vec<f32>,
    /// The excess of the uncapped bend over the share from which on bends are eased, from 0 to 1.
    pub kink: Vec<f32>,
    /// The length of the segment upstream, in units.
    pub step: Vec<f32>,
}

impl Course {
    /// Measures a river, its junction included.
    pub fn read(&mut self, network: &Network, river: &River, settings: &NetworkSettings) {
        self.at.clear();
        self.width.clear();
        for vertex in network.course(river) {
            self.at.push(vertex.at);
            self.width.push(fast_max(vertex.width(), settings.spacing));
        }
        let count = self.at.len();
        self.step.clear();
        self.step.push(0.0);
        self.step.extend(self.at.windows(2).map(|pair| distance(pair[0], pair[1])));
        self.bend.clear();
        self.kink.clear();
        for i in 0..count {
            // Measured over about a width either way: nearer points would measure noise.
            let stride = ((self.width[i] / settings.step(self.width[i])) as usize).max(1).min(i).min(count - 1 - i);
            let kappa = curvature(self.at[i - stride], self.at[i], self.at[i + stride]);
            let bend = kappa * self.width[i] / SHARPEST;
            self.bend.push(bend.clamp(-1.0, 1.0));
            self.kink.push((bend.abs() - NEARLY).clamp(0.0, 1.0));
        }
    }

    /// Returns the unit vector downstream at a vertex.
    pub fn tangent(&self, i: usize) -> Vec2 {
        direction(self.at[(i + 1).min(self.at.len() - 1)] - self.at[i.saturating_sub(1)])
    }

    /// Returns the unit vector down the meander belt around a vertex.
    fn belt(&self, i: usize, settings: &NetworkSettings) -> Vec2 {
        let stride = (BELT * self.width[i] / settings.step(self.width[i])) as usize;
        direction(self.at[(i + stride).min(self.at.len() - 1)] - self.at[i.saturating_sub(stride)])
    }

    /// Returns the bend at a vertex without its cap: up to 1.7 times the sharpest.
    pub fn uncapped(&self, i: usize) -> f32 {
        let beyond = fast_max(self.kink[i] - (1.0 - NEARLY), 0.0);
        self.bend[i] + beyond.copysign(self.bend[i])
    }

    /// Returns the offset of a vertex that takes a kink out of a line.
    pub fn ease(&self, i: usize) -> Vec2 {
        ((self.at[i - 1] + self.at[i + 1]) * 0.5 - self.at[i]) * (EASE * self.kink[i])
    }

    /// Smooths curvature by an exponential filter, once down and once up the river.
    fn smooth(&mut self) {
        let mut last = 0.0f32;
        for i in 0..self.bend.len() {
            last += (self.bend[i] - last) * share(self.step[i], self.width[i]);
            self.bend[i] = last;
        }
        last = 0.0;
        for i in (0..self.bend.len()).rev() {
            last += (self.bend[i] - last) * share(self.step.get(i + 1).copied().unwrap_or(0.0), self.width[i]);
            self.bend[i] = last;
        }
    }

    fn bend(&self, step_scale: &[f32], settings: &NetworkSettings, moves: &mut [Vec2]) {
        for (i, (&step_scale, way)) in step_scale.iter().zip(moves).enumerate() {
            if step_scale == 0.0 || i == 0 || i + 1 == self.at.len() {
                continue;
            }
            let (bend, tangent) = (self.bend[i], self.tangent(i));
            // A positive bend turns toward `perp`, so its outside is on the other side.
            let outward = tangent.perp() * -bend;
            // A move along the river's own line would change nothing: bends travel down the belt in which they lie.
            let onward = self.belt(i, settings) * bend.abs();
            let push = outward * settings.mix + onward * (1.0 - settings.mix);
            let far = PACE * settings.strength * self.width[i];
            *way = (push * far + self.ease(i)) * step_scale;
        }
    }
}

/// Returns the share of a new value that the filter takes in over a step.
fn share(step: f32, width: f32) -> f32 {
    step / (step + MEMORY * width)
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{river, settings, sine_generated, straight};
    use super::*;

    const PIECES: u32 = 60;

    /// Returns the offsets of the vertices of a river five units wide along a line.
    fn ways(line: &[Vec2], mix: f32) -> Vec<Vec2> {
        let settings = NetworkSettings { mix, strength: 1.0, ..settings() };
        moves(&river(line, 5.0), &vec![1.0; line.len()], &settings)
    }

    #[test]
    fn bends_move_outward_and_downstream_by_the_mix() {
        let line = sine_generated(1.0, 60.0, 3, PIECES);
        // Apexes, where curvature is greatest; away from the ends, which stay.
        for apex in [60usize, 90, 120] {
            let turn = (line[apex] - line[apex - 1]).perp_dot(line[apex + 1] - line[apex]);
            let tangent = direction(line[apex + 1] - line[apex - 1]);
            let outside = tangent.perp() * -turn.signum();
            let (outward, onward) = (ways(&line, 1.0)[apex], ways(&line, 0.0)[apex]);
            assert!(outward.dot(outside) > 0.5 && outward.dot(tangent).abs() < 0.1, "{apex}: {outward}");
            assert!(onward.dot(tangent) > 0.5 && onward.dot(outside).abs() < 0.1, "{apex}: {onward}");
        }
    }

    #[test]
    fn straight_rivers_and_ends_stay() {
        assert!(ways(&straight((0.0, 0.0), (90.0, 40.0), 90), 0.6).iter().all(|way| way.length() < 1e-3));
        let bent = ways(&sine_generated(1.0, 60.0, 3, PIECES), 0.6);
        assert_eq!((bent[0], bent[bent.len() - 1]), (Vec2::ZERO, Vec2::ZERO));
    }

    #[test]
    fn no_bend_pulls_more_than_the_sharpest() {
        // A hairpin of half a width.
        let hairpin: Vec<Vec2> =
            straight((0.0, 0.0), (60.0, 0.0), 60).into_iter().chain(straight((60.0, 2.5), (0.0, 2.5), 60)).collect();
        assert!(ways(&hairpin, 1.0).iter().all(|way| way.length() <= PACE * 5.0 + EASE * 60.0));
        assert!(ways(&hairpin, 1.0).iter().any(|way| way.length() > 0.2));
    }

    #[test]
    fn what_has_no_pace_stays() {
        let line = sine_generated(1.0, 60.0, 3, PIECES);
        let still = moves(&river(&line, 5.0), &vec![0.0; line.len()], &settings());
        assert!(still.iter().all(|way| *way == Vec2::ZERO));
    }
}
