//! Light and shadow on a relief, as shapes: half transparent areas, each laid over the one before.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::paint::palette::{Colour, ReliefLook};
use crate::paint::relief::light_of;
use crate::relief::Relief;

/// Writes all shadows and lights that a style has.
pub(super) fn light(out: &mut Text, relief: &Relief, exaggeration: f32, look: &ReliefLook) {
    let tints = &look.tints;
    let mut light = vec![1.0; relief.heights().len()];
    light_of(relief, exaggeration, &mut light);
    // The less light changes a style's colours, the fewer steps are enough.
    let step = 0.1 + 0.02 / (tints.light[1] - tints.light[0]);
    out.text("<g id=\"shade\">\n");
    steps(out, relief, &light, (tints.shadow, -step), |light| tints.factor(light));
    // Land is seldom much lighter than flat land, so steps are half as long there. What is laid over colours to make them lighter takes
    // a share of what they lack of it.
    let (colour, usual) = lightest(look);
    steps(out, relief, &light, (colour, step * 0.5), |light| (1.0 - usual * tints.factor(light)).max(0.02));
    out.text("</g>\n");
}

/// Steps from the light on flat land on, in one colour. In the middle of each, so much is left of what is under it as `left` says.
fn steps(out: &mut Text, relief: &Relief, light: &[f32], (colour, step): (Colour, f32), left: impl Fn(f32) -> f32) {
    const MOST: u8 = 16;
    let mut before = left(1.0);
    for middle in (1..=MOST).map(|i| 1.0 + step * f32::from(i)) {
        // In whole hundredths, as it is written: what is lost by that, the next step makes up for.
        let opacity = f32::from((100.0 - 100.0 * left(middle.max(0.0)) / before + 0.5) as u8) / 100.0;
        before *= 1.0 - opacity;
        if opacity > 0.0 {
            area(out, relief, colour, opacity, light.iter().map(|light| (light - middle) / step + 0.5));
        }
    }
}

/// A tint of white with the hue of a style's land, and how light that land usually is as a share of it.
fn lightest(look: &ReliefLook) -> (Colour, f32) {
    let colours: Vec<Colour> = match &look.basins {
        Some(basins) => (0..=basins.colours.len()).map(|number| basins.tint(number)).collect(),
        None => look.tints.stops.iter().map(|stop| stop.1).collect(),
    };
    let sum = |i: usize| colours.iter().map(|colour| f32::from(colour[i])).sum::<f32>();
    let mean = [0, 1, 2].map(|i| sum(i) / colours.len() as f32);
    let most = 255.0 / mean.into_iter().fold(1.0, f32::max);
    let tint = mean.map(|part| (part * most + 255.0) / 2.0);
    (tint.map(|part| (part + 0.5) as u8), mean.iter().sum::<f32>() / tint.iter().sum::<f32>())
}

/// Everything with a value above 0.
fn area(out: &mut Text, relief: &Relief, colour: Colour, opacity: f32, values: impl Iterator<Item = f32>) {
    let mut path = Path::default();
    for ring in relief.rings_around(values) {
        // Edges so soft need no more than every third point.
        path.ring(&ring.into_iter().step_by(3).collect::<Vec<Vec2>>());
    }
    if path.is_empty() {
        return;
    }
    out.text("<path fill=\"").colour(colour).text("\" fill-opacity=\"").units(opacity);
    out.text("\" d=\"").path(&path).text("\"/>\n");
}
