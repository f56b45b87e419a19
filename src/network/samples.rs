//! Small networks for tests.

use glam::Vec2;

use super::{NONE, Network, NetworkSettings, River, Vertex};
use crate::recipe::link;

/// Returns settings for a plain rectangle with vertices a unit apart.
pub(super) fn settings() -> NetworkSettings {
    let recipe =
        link::read("land=rectangle&mouths=3&attractors=100&curl=0&trim=152&courses=smooth&width=14&bank-variation=0&meander-rounds=24&great-rivers=1")
            .unwrap();
    NetworkSettings { spacing: 1.0, hairline: 0.1, min_clearance: 0.5, ..NetworkSettings::new(&recipe, 100.0, 100) }
}

/// Makes a river through some points, of the same width everywhere, that moves freely.
pub(super) fn river(points: &[Vec2], width: f32) -> Network {
    let half = width * 0.5;
    let vertex =
        |&at: &Vec2| Vertex { at, discharge: 100, left: half, right: half, mobility: 1.0, ..Vertex::default() };
    let river =
        River { start: 0, end: points.len() as u32, junction: NONE, parent: NONE, order: 1, magnitude: 1, identity: 0 };
    Network { vertices: points.iter().map(vertex).collect(), rivers: vec![river], oxbows: vec![] }
}

impl Network {
    /// Adds another river, which joins the first at one of its vertices.
    pub(super) fn with_arm(mut self, points: &[Vec2], junction: u32, discharge: u32) -> Self {
        let start = self.vertices.len() as u32;
        let width = self.vertices[0].width() * 0.5;
        let arm = river(points, width).vertices.into_iter().map(|vertex| Vertex { discharge, ..vertex });
        self.vertices.extend(arm);
        let end = self.vertices.len() as u32;
        self.rivers.push(River { start, end, junction, parent: 0, order: 1, magnitude: 1, identity: 0 });
        self.rivers[0].magnitude += 1;
        self
    }
}

/// Returns evenly spaced points from one to another, both included.
pub(super) fn straight(from: (f32, f32), to: (f32, f32), pieces: u32) -> Vec<Vec2> {
    (0..=pieces).map(|i| Vec2::from(from).lerp(Vec2::from(to), i as f32 / pieces as f32)).collect()
}

/// Returns some waves of Langbein and Leopold's curve, whose direction is ω sin(2π s / M) at length s, with M = `wave`:
/// its curvature is ω (2π / M) cos(2π s / M), its sinuosity 1 / J₀(ω).
pub(super) fn sine_generated(omega: f32, wave: f32, waves: u32, pieces: u32) -> Vec<Vec2> {
    let piece = wave / pieces as f32;
    let mut line = vec![Vec2::new(20.0, 400.0)];
    for i in 0..waves * pieces {
        let heading = omega * libm::sinf(std::f32::consts::TAU * (i as f32 + 0.5) / pieces as f32);
        line.push(line[i as usize] + Vec2::new(libm::cosf(heading), libm::sinf(heading)) * piece);
    }
    line
}

/// Returns the length of a line over the distance between its ends.
pub(super) fn sinuosity(line: &[Vec2]) -> f32 {
    let length: f32 = line.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    length / line[0].distance(line[line.len() - 1])
}

/// Returns the positions of a network's vertices.
pub(super) fn places(network: &Network) -> Vec<Vec2> {
    network.vertices.iter().map(|vertex| vertex.at).collect()
}
