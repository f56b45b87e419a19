//! The pattern of drainage (Twidale 2004), named by the class whose mean is nearest.

use super::{Angles, Directions};
use crate::base::sort;

/// Number of patterns.
pub const PATTERNS: usize = 8;

/// Number of features that patterns are told apart by.
const FEATURES: usize = 8;

/// Stands for a mean that is not known: the feature is left out for the class.
const ANY: f64 = f64::NAN;

/// A pattern and the means of its features.
struct Class {
    name: &'static str,
    /// Grain, cross-grain, flow, entropy, mean and spread of junction angles in degrees, radial, outward.
    means: [f64; FEATURES],
}

const fn class(name: &'static str, means: [f64; FEATURES]) -> Class {
    Class { name, means }
}

/// The means of ten maps of each pattern: of several lands, numbers of parcels and shapes, with tributaries selected and
/// not.
static CLASSES: [Class; PATTERNS] = [
    // Its common flow is that of its land: 0.55 on a rectangle with one coast, about 0 on an island.
    class("dendritic", [0.08, 0.03, ANY, 1.00, 67.3, 24.8, 0.51, 0.00]),
    class("parallel", [0.58, 0.11, 0.87, 0.85, 42.7, 13.5, 0.46, -0.05]),
    class("trellis", [0.57, 0.40, 0.28, 0.83, 72.0, 44.7, 0.51, 0.07]),
    class("rectangular", [0.04, 0.31, 0.20, 0.96, 83.4, 32.1, 0.51, 0.05]),
    class("radial", [0.04, 0.05, 0.10, 1.00, 44.8, 14.5, 0.74, 0.83]),
    class("annular", [0.11, 0.06, 0.08, 0.99, 72.8, 38.9, 0.30, 0.29]),
    class("centripetal", [0.06, 0.03, 0.10, 1.00, 46.3, 15.9, 0.75, -0.84]),
    class("deranged", [0.04, 0.02, 0.18, 1.00, 83.0, 31.4, 0.51, 0.16]),
];

/// The standard deviations of the features among maps of one pattern.
const SPREADS: [f64; FEATURES] = [0.045, 0.023, 0.125, 0.016, 3.2, 1.7, 0.026, 0.18];

/// A network's distances from all patterns.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Pattern {
    /// The names of the patterns, in a fixed order, and the distance from the mean of each: the root of the mean square
    /// of the features' deviations, each in its own spread.
    pub distances: [(&'static str, f64); PATTERNS],
}

impl Pattern {
    /// Compares a network's features with those of all patterns.
    pub fn of(directions: Directions, angles: Angles) -> Self {
        let Directions { grain, cross_grain, flow, entropy, radial, outward } = directions;
        let features = [grain, cross_grain, flow, entropy, angles.mean, angles.spread, radial, outward];
        Self { distances: std::array::from_fn(|i| (CLASSES[i].name, distance(&features, &CLASSES[i].means))) }
    }

    /// Returns the names and distances of the patterns, first the nearest, after which the network is named.
    pub fn nearest_first(&self) -> [(&'static str, f64); PATTERNS] {
        let order = sort::argsort(self.distances.iter().map(|(_, distance)| sort::key(*distance as f32)));
        std::array::from_fn(|i| self.distances[order[i]])
    }

    /// Returns the name of the nearest pattern.
    pub fn name(&self) -> &'static str {
        self.nearest_first()[0].0
    }
}

fn distance(features: &[f64; FEATURES], means: &[f64; FEATURES]) -> f64 {
    let deviations =
        (0..FEATURES).map(|i| (features[i] - means[i]) / SPREADS[i]).filter(|deviation| !deviation.is_nan());
    let (sum, count) =
        deviations.fold((0.0, 0.0), |(sum, count), deviation| (sum + deviation * deviation, count + 1.0));
    f64::sqrt(sum / count)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pattern(features: [f64; FEATURES]) -> Pattern {
        let [grain, cross_grain, flow, entropy, mean, spread, radial, outward] = features;
        Pattern::of(Directions { grain, cross_grain, flow, entropy, radial, outward }, Angles { mean, spread })
    }

    #[test]
    fn each_class_s_mean_has_its_name_and_no_distance() {
        for class in &CLASSES {
            let found = pattern(class.means.map(|mean| if mean.is_nan() { 0.5 } else { mean }));
            assert_eq!(found.name(), class.name);
            let own = found.distances.iter().find(|(name, _)| *name == class.name).unwrap();
            assert_eq!(own.1, 0.0);
        }
    }

    #[test]
    fn the_nearest_comes_first() {
        let nearest_first =
            pattern(CLASSES[3].means.map(|mean| if mean.is_nan() { 0.5 } else { mean })).nearest_first();
        assert_eq!(nearest_first[0], ("rectangular", 0.0));
        assert!(nearest_first.windows(2).all(|pair| pair[0].1 <= pair[1].1));
    }

    #[test]
    fn distances_are_in_spreads() {
        let mut features = CLASSES[4].means;
        features[4] += 2.0 * SPREADS[4];
        // Of eight features one is off by two spreads.
        let far = pattern(features).distances[4].1;
        assert!((far - (4.0f64 / 8.0).sqrt()).abs() < 1e-12, "{far}");
    }

    #[test]
    fn the_flow_tells_spokes_that_run_outward_from_those_that_run_inward() {
        let spokes = |outward| pattern([0.03, 0.1, 0.03, 0.99, 40.0, 20.0, 0.86, outward]).name();
        assert_eq!((spokes(0.8), spokes(-0.8)), ("radial", "centripetal"));
    }
}
