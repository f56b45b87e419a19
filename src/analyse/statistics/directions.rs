//! The directions of a whole network's rivers, by which patterns of drainage are told apart.

use glam::{DVec2, Vec2};

use super::fit;
use super::parallels::evenly;
use crate::base::geometry::direction;
use crate::network::Network;

/// Number of classes of direction, of 15° each; a line and the same line run backward are in one class.
const CLASSES: usize = 12;

/// The directions of a network, over all its chords of one spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Directions {
    /// |mean e^(2iθ)|: 0 if lines run in all directions alike, 1 if they are parallel.
    pub grain: f64,
    /// |mean e^(4iθ)|: also 1 for lines of two directions at right angles.
    pub cross_grain: f64,
    /// |mean e^(iθ)| of the way that water runs: 1 if all flows in one direction.
    pub flow: f64,
    /// The entropy of the twelve classes of direction, over ln 12: 1 if each is as frequent as the others.
    pub entropy: f64,
    /// The mean of cos² of the angle to the middle of the rivers: 1/2 for any directions, 1 for the spokes of a wheel,
    /// 0 for its rim.
    pub radial: f64,
    /// The mean cosine of the angle between the flow and the way from the middle: from −1, all flows inward, to 1, all
    /// flows outward.
    pub outward: f64,
}

impl Directions {
    /// Measures the directions of a network's courses. `None` if they have no chord.
    pub fn of(network: &Network, spacing: f32) -> Option<Self> {
        let chords = chords(network, spacing);
        let count = chords.len() as f64;
        let middle = (chords.iter().map(|chord| chord.0.as_dvec2()).sum::<DVec2>() / count).as_vec2();
        let [mut once, mut twice, mut four] = [DVec2::ZERO; 3];
        let (mut classes, mut radial, mut outward) = ([0u32; CLASSES], 0.0, 0.0);
        for &(at, along) in &chords {
            let doubled = squared(along.as_dvec2());
            once += along.as_dvec2();
            twice += doubled;
            four += squared(doubled);
            classes[class(along)] += 1;
            let cosine = f64::from(along.dot(direction(at - middle)));
            radial += cosine * cosine;
            outward += cosine;
        }
        let length = |sum: DVec2| sum.length_squared().sqrt() / count;
        (!chords.is_empty()).then(|| Self {
            grain: length(twice),
            cross_grain: length(four),
            flow: length(once),
            entropy: entropy(&classes),
            radial: radial / count,
            outward: outward / count,
        })
    }
}

/// Returns the middles and directions of all chords of one spacing along the rivers.
fn chords(network: &Network, spacing: f32) -> Vec<(Vec2, Vec2)> {
    let mut chords = Vec::new();
    for river in &network.rivers {
        let places = evenly(&network.places(river), spacing);
        chords.extend(places.windows(2).map(|pair| (pair[0].midpoint(pair[1]), direction(pair[1] - pair[0]))));
    }
    chords
}

/// Doubles the angle of a unit vector.
fn squared(unit: DVec2) -> DVec2 {
    DVec2::new(unit.x * unit.x - unit.y * unit.y, 2.0 * unit.x * unit.y)
}

fn class(along: Vec2) -> usize {
    let turns = libm::atan2f(along.y, along.x) / std::f32::consts::PI + 1.0;
    (turns * CLASSES as f32) as usize % CLASSES
}

fn entropy(classes: &[u32]) -> f64 {
    let all: u32 = classes.iter().sum();
    let shares = classes.iter().filter(|&&count| count > 0).map(|&count| f64::from(count) / f64::from(all));
    -shares.map(|share| share * fit::log(share)).sum::<f64>() / fit::log(CLASSES as f64)
}

#[cfg(test)]
mod tests {
    use super::super::samples::{network, to_sea};
    use super::*;

    fn of(lines: &[[(f32, f32); 2]]) -> Directions {
        let rivers: Vec<_> = lines.iter().map(|line| to_sea(line)).collect();
        Directions::of(&network(&rivers), 1.0).unwrap()
    }

    fn near(value: f64, expected: f64) -> bool {
        (value - expected).abs() < 1e-5
    }

    #[test]
    fn parallel_rivers_have_a_grain_even_if_they_run_against_each_other() {
        let same = of(&[[(0.0, 0.0), (10.5, 0.0)], [(0.0, 5.0), (10.5, 5.0)]]);
        assert!(
            near(same.grain, 1.0) && near(same.cross_grain, 1.0) && near(same.flow, 1.0) && near(same.entropy, 0.0)
        );
        let against = of(&[[(0.0, 0.0), (10.5, 0.0)], [(10.5, 5.0), (0.0, 5.0)]]);
        assert!(near(against.grain, 1.0) && near(against.flow, 0.0) && near(against.entropy, 0.0), "{against:?}");
    }

    #[test]
    fn rivers_at_right_angles_have_a_cross_grain_only() {
        let cross = of(&[[(0.0, 0.2), (10.5, 0.2)], [(5.0, -5.0), (5.0, 5.5)]]);
        assert!(near(cross.grain, 0.0) && near(cross.cross_grain, 1.0), "{cross:?}");
        // Two classes of twelve.
        assert!(near(cross.entropy, libm::log(2.0) / libm::log(12.0)), "{cross:?}");
    }

    #[test]
    fn spokes_are_radial_and_flow_outward_or_inward() {
        let spokes = |from: f32, to: f32| {
            let ways = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
            of(&ways.map(|(x, y)| [(x * from, y * from), (x * to, y * to)]))
        };
        let (out, inward) = (spokes(2.0, 12.5), spokes(12.0, 1.5));
        assert!(near(out.radial, 1.0) && near(out.outward, 1.0) && near(out.flow, 0.0), "{out:?}");
        assert!(near(inward.radial, 1.0) && near(inward.outward, -1.0), "{inward:?}");
    }

    #[test]
    fn a_network_without_rivers_has_no_directions() {
        assert_eq!(Directions::of(&Network::default(), 1.0), None);
    }
}
