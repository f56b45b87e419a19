//! Light and shadow on a relief, as shapes: half transparent areas, each laid over the one before.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::paint::palette::{Colour, Tints};
use crate::paint::relief::light_of;
use crate::relief::Relief;

/// The shadows that are told apart: what colours are multiplied by where each begins, and in the middle of it.
const SHADOWS: [(f32, f32); 9] = [
    (0.97, 0.94),
    (0.9, 0.86),
    (0.82, 0.78),
    (0.74, 0.7),
    (0.66, 0.62),
    (0.58, 0.53),
    (0.48, 0.43),
    (0.38, 0.33),
    (0.28, 0.22),
];
/// The same in the light.
const LIGHTS: [(f32, f32); 4] = [(1.03, 1.06), (1.09, 1.12), (1.16, 1.2), (1.24, 1.3)];

/// Writes all shadows and lights that a style has.
pub(super) fn light(out: &mut Text, relief: &Relief, exaggeration: f32, tints: &Tints) {
    let mut light = vec![1.0; relief.heights().len()];
    light_of(relief, exaggeration, &mut light);
    let factor: Vec<f32> = light.into_iter().map(|light| tints.factor(light)).collect();
    out.text("<g id=\"shade\">\n");
    let mut before = 1.0;
    for (level, after) in SHADOWS {
        area(out, relief, tints.shadow, 1.0 - after / before, factor.iter().map(|factor| level - factor));
        before = after;
    }
    // What is laid over colours to make them lighter takes a share of what they lack of it.
    let (colour, usual) = lightest(tints);
    let lack = |factor: f32| (1.0 - usual * factor).max(0.02);
    let mut before = 1.0;
    for (level, after) in LIGHTS {
        let share = 1.0 - lack(after) / lack(before);
        area(out, relief, colour, share, factor.iter().map(|factor| factor - level));
        before = after;
    }
    out.text("</g>\n");
}

/// A tint of white with the hue of a style's land, and how light that land usually is as a share of it.
fn lightest(tints: &Tints) -> (Colour, f32) {
    let sum = |i: usize| tints.stops.iter().map(|(_, colour)| f32::from(colour[i])).sum::<f32>();
    let mean = [0, 1, 2].map(|i| sum(i) / tints.stops.len() as f32);
    let most = 255.0 / mean.into_iter().fold(1.0, f32::max);
    let tint = mean.map(|part| (part * most + 255.0) / 2.0);
    (tint.map(|part| (part + 0.5) as u8), mean.iter().sum::<f32>() / tint.iter().sum::<f32>())
}

/// Everything with a value above 0.
fn area(out: &mut Text, relief: &Relief, colour: Colour, opacity: f32, values: impl Iterator<Item = f32>) {
    /// So much change of a colour counts as far.
    const FAR: f32 = 0.1;
    let mut path = Path::default();
    for ring in relief.rings_around(values.map(|value| value / FAR)) {
        // Every second point is enough.
        path.ring(&ring.into_iter().step_by(2).collect::<Vec<Vec2>>());
    }
    if path.data().is_empty() {
        return;
    }
    out.text("<path fill=\"").colour(colour).text("\" fill-opacity=\"").units(opacity);
    out.text("\" d=\"").text(path.data()).text("\"/>\n");
}
