//! Bends of great rivers, from one inflection to the next: which way they lean, and how unlike their lengths are.

use glam::Vec2;

use super::fit;
use super::parallels::evenly;
use crate::base::geometry::{distance, fast_max};
use crate::base::sort;
use crate::network::{Network, River};

/// The number of rivers that count: those with the greatest discharge.
const RIVERS: usize = 5;

/// The distance between the places that a river is measured at, in widths, and the deviation of the weights by which
/// curvature is smoothed, in places.
const STEP: f32 = 0.0625;
const SMOOTH: f32 = 8.0;

/// The fewest places of a bend.
const FEWEST: usize = 16;

/// The length over the chord from which on a bend counts at all, and from which on it may lean.
const BENT: f32 = 1.1;
const STRONGLY_BENT: f32 = 1.5;

/// The fewest bends that say something.
const LEAST_BENDS: usize = 10;

/// The bends of the five greatest rivers of a map.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Bends {
    /// The share, from 0 to 1, of bends longer than 1.5 times their chord whose curvature lies upstream of their middle, as that of most
    /// natural ones does (Carson and Lapointe 1983). `None` for fewer than ten such bends.
    pub upstream: Option<f64>,
    /// The standard deviation of the natural logarithm of the wavelength in widths, which is twice the chord, over bends longer than
    /// 1.1 times that. `None` for fewer than ten bends.
    pub wavelength_spread: Option<f64>,
}

/// A piece of a river between two inflections.
struct Bend {
    /// The length along the river over that of the chord.
    sinuosity: f32,
    /// Twice the chord, in widths.
    wavelength: f32,
    /// The middle of the curvature, as a share of the way from the upper end to the lower one.
    middle: f32,
}

impl Bends {
    /// Measures the bends of a network. Rivers narrower than a spacing, in units, count as that wide.
    pub fn of(network: &Network, spacing: f32) -> Self {
        let by_discharge = network.rivers.iter().map(|river| u32::MAX - network.discharge(river));
        let great = sort::argsort(by_discharge).into_iter().take(RIVERS);
        let bends: Vec<Bend> = great.flat_map(|river| bends(network, &network.rivers[river], spacing)).collect();
        let beyond = |least: f32| bends.iter().filter(move |bend| bend.sinuosity > least);
        let of_any = |values: Vec<f64>| Some(values).filter(|values| values.len() >= LEAST_BENDS);
        let leans = of_any(beyond(STRONGLY_BENT).map(|bend| f64::from(u8::from(bend.middle < 0.5))).collect());
        let waves = of_any(beyond(BENT).map(|bend| fit::log(bend.wavelength.into())).collect());
        Self {
            upstream: leans.and_then(|leans| fit::mean(&leans)),
            wavelength_spread: waves.and_then(|waves| spread(&waves)),
        }
    }
}

/// Returns the standard deviation of values.
fn spread(values: &[f64]) -> Option<f64> {
    let mean = fit::mean(values)?;
    let squares: Vec<f64> = values.iter().map(|value| (value - mean) * (value - mean)).collect();
    fit::mean(&squares).map(f64::sqrt)
}

/// Lists the bends of a river.
fn bends(network: &Network, river: &River, spacing: f32) -> Vec<Bend> {
    let own = &network.vertices[river.vertex_range()];
    let width = fast_max(own.iter().map(|vertex| vertex.width()).sum::<f32>() / own.len().max(1) as f32, spacing);
    let places = evenly(&network.places(river), STEP * width);
    let curvature = smoothed(&turns(&places));
    let mut bends = Vec::new();
    let mut from = None;
    for to in 1..curvature.len() {
        if (curvature[to] > 0.0) == (curvature[to - 1] > 0.0) {
            continue;
        }
        // What lies before the first inflection is a part of a bend.
        if let Some(from) = from.replace(to)
            && to - from >= FEWEST
        {
            bends.push(bend(&places[from..=to], &curvature[from..to], width));
        }
    }
    bends
}

/// Measures a bend, given its places and the curvature at all but the last.
fn bend(places: &[Vec2], curvature: &[f32], width: f32) -> Bend {
    let chord = distance(places[0], places[places.len() - 1]);
    let all: f32 = curvature.iter().map(|curvature| curvature.abs()).sum();
    let middle: f32 = curvature.iter().enumerate().map(|(i, curvature)| (i as f32 + 0.5) * curvature.abs()).sum();
    Bend {
        sinuosity: curvature.len() as f32 * STEP * width / fast_max(chord, STEP * width),
        wavelength: 2.0 * chord / width,
        middle: middle / (all * curvature.len() as f32),
    }
}

/// Returns the turn at each place but the last, in radians; none at the first.
fn turns(places: &[Vec2]) -> Vec<f32> {
    let turn = |at: &[Vec2]| {
        let (from, to) = (at[1] - at[0], at[2] - at[1]);
        libm::atan2f(from.perp_dot(to), from.dot(to))
    };
    std::iter::once(0.0).chain(places.windows(3).map(turn)).collect()
}

/// Returns means of values along a line, with the weights of a Gaussian.
fn smoothed(values: &[f32]) -> Vec<f32> {
    /// The reach of the weights, in deviations.
    const REACH: f32 = 3.0;
    let reach = (REACH * SMOOTH) as usize;
    let weights: Vec<f32> =
        (0..=reach).map(|off| libm::expf(-0.5 * (off as f32 / SMOOTH) * (off as f32 / SMOOTH))).collect();
    let mean = |place: usize| {
        let near = place.saturating_sub(reach)..(place + reach + 1).min(values.len());
        let (sum, all) = near.fold((0.0, 0.0), |(sum, all), other| {
            let weight = weights[other.abs_diff(place)];
            (sum + weight * values[other], all + weight)
        });
        sum / all
    };
    (0..values.len()).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::super::samples::{Sample, network, to_sea};
    use super::*;

    /// Returns a line whose direction at length s is ω sin φ + ω³ k cos 3φ, with φ = 2π s / `wave`: Kinoshita's curve, whose bends lean
    /// one way or the other by the sign of `skew`, the k.
    fn kinoshita(skew: f32, wave: f32, waves: u32) -> Vec<(f32, f32)> {
        const OMEGA: f32 = 1.6;
        let mut at = Vec2::new(0.0, 0.0);
        let step = wave / 400.0;
        (0..waves * 400)
            .map(|i| {
                let place: (f32, f32) = at.into();
                let phase = std::f32::consts::TAU * i as f32 / 400.0;
                let heading = OMEGA * libm::sinf(phase) + OMEGA * OMEGA * OMEGA * skew * libm::cosf(3.0 * phase);
                at += Vec2::new(libm::cosf(heading), libm::sinf(heading)) * step;
                place
            })
            .collect()
    }

    fn measured(lines: &[Vec<(f32, f32)>]) -> Bends {
        let rivers: Vec<Sample<'_>> = lines.iter().map(|line| to_sea(line)).collect();
        Bends::of(&network(&rivers), 1.0)
    }

    #[test]
    fn bends_lean_one_way_and_the_other_way_when_turned_around() {
        let line = kinoshita(1.0 / 32.0, 20.0, 8);
        let reversed: Vec<_> = line.iter().rev().copied().collect();
        let [one, other] = [&line, &reversed].map(|line| measured(std::slice::from_ref(line)).upstream.unwrap());
        assert!(one + other == 1.0 && one.min(other) == 0.0, "{one}, {other}");
        let mirrored: Vec<_> = kinoshita(-1.0 / 32.0, 20.0, 8);
        assert_eq!(measured(&[mirrored]).upstream, Some(other));
    }

    #[test]
    fn bends_that_are_sharp_at_their_upper_ends_lean_upstream() {
        /// The number of steps of a bend, and the mean turn of a step, in radians.
        const STEPS: usize = 100;
        const TURN: f32 = 0.036;
        let (mut at, mut heading) = (Vec2::ZERO, 0.0f32);
        let line = (0..16 * STEPS).map(|i| {
            let side = if (i / STEPS).is_multiple_of(2) { 1.0 } else { -1.0 };
            heading += side * TURN * 2.0 * (1.0 - (i % STEPS) as f32 / STEPS as f32);
            at += Vec2::new(libm::cosf(heading), libm::sinf(heading)) * 0.1;
            at.into()
        });
        assert_eq!(measured(&[line.collect()]).upstream, Some(1.0));
    }

    #[test]
    fn waves_of_one_length_have_no_spread_and_those_of_two_have_that_of_their_ratio() {
        let [short, long] = [20.0, 40.0].map(|wave| kinoshita(0.0, wave, 8));
        assert!(measured(std::slice::from_ref(&short)).wavelength_spread.unwrap() < 0.03);
        // Half of the bends are twice as long as the others.
        let both = measured(&[short, long]).wavelength_spread.unwrap();
        assert!((both - std::f64::consts::LN_2 / 2.0).abs() < 0.03, "{both}");
    }

    #[test]
    fn few_bends_say_nothing() {
        assert_eq!(measured(&[kinoshita(0.0, 20.0, 4)]), Bends::default());
        assert_eq!(measured(&[vec![(0.0, 0.0), (100.0, 0.0)]]), Bends::default());
        assert_eq!(Bends::of(&Network::default(), 1.0), Bends::default());
    }
}
