//! The heights from which valleys are found, before any river has worn them down: fractal noise, randomness, and a rise
//! away from the places where water leaves the land.

use glam::Vec2;

use super::parcels::Parcels;
use crate::base::random::{DEVIATION, Purpose};
use crate::base::sort;
use crate::base::work;
use crate::grow::GrowthSettings;
use crate::grow::watered::Watered;

/// The greatest random part of a parcel's height, compared with noise of the valleys' wavelength from −1 to 1.
const CHANCE: f32 = 0.45;

/// The octaves of the ground, down to a wavelength of about two parcels.
const OCTAVES: i32 = 5;
const GAIN: f32 = 0.65;

/// The additional height of the ground at a border that rivers should not run along.
const BORDER: f32 = 2.0;

/// The depth of the ground along a drawn river, which makes it lower than any other.
const STEM: f32 = 20.0;

/// Returns the heights of parcels for an invasion.
pub(super) fn heights(settings: &GrowthSettings, parcels: &Parcels) -> Vec<f32> {
    let stem = |(height, toll): (f32, &f32)| height + STEM * (toll - 1.0);
    let heights = ground(settings, parcels, 1.0, &from_outlets(parcels), &parcels.border);
    heights.into_iter().zip(&parcels.toll).map(stem).collect()
}

/// The distance from the coast, in spacings, within which there are no attractors that follow valleys. Land nearer to
/// the sea drains by itself, and rivers that came for it would run along the coast.
const COASTAL_STRIP: f32 = 0.6;

/// Places the attractors of space colonization along valleys, one in each cell of the plane, the lowest first.
pub(in crate::grow) fn attractors_by_height(settings: &GrowthSettings) -> Vec<Vec2> {
    let parcels = Parcels::without_costs(settings);
    let distance = from_outlets(&parcels);
    let rim = nearness_to_rim(&parcels, &distance);
    // The square root, because a little unevenness already changes the way of most rivers.
    let heights = ground(settings, &parcels, settings.drainage.valleys.sqrt(), &distance, &rim);
    let watered = settings.land.as_deref().map(|land| Watered::of(settings, land));
    let by_height = sort::argsort(heights.into_iter().map(sort::key)).into_iter().map(|i| parcels.at[i]);
    let is_inland = |at| {
        settings.land.as_ref().is_none_or(|land| land.coast_distance().height(at) > COASTAL_STRIP * settings.spacing)
    };
    by_height.filter(|&at| watered.as_ref().is_none_or(|watered| watered.holds(at)) && is_inland(at)).collect()
}

/// Returns the heights of all parcels. Noise and randomness make the ground uneven by `unevenness`, from 0 to 1. It
/// rises with the distance from the outlets, counted in parcels, and toward borders: `border` is the nearness of each
/// parcel to them, from 0 to 1.
fn ground(settings: &GrowthSettings, parcels: &Parcels, unevenness: f32, distance: &[u32], border: &[f32]) -> Vec<f32> {
    let settings = &settings.drainage;
    let noise = settings.noise(3, settings.valley_spacing, OCTAVES, GAIN);
    let chance = settings.seed.item_hash(Purpose::Ground);
    let tilt = settings.spacing / settings.valley_spacing;
    (0..parcels.len())
        .map(|i| {
            let (at, [column, row]) = (parcels.at[i], parcels.identity[i]);
            let own = CHANCE * (2.0 * chance.unit([column, row, 1]) - 1.0);
            let uneven = DEVIATION * noise.get_noise_2d(at.x, at.y) + own;
            unevenness * uneven + tilt * distance[i] as f32 + BORDER * border[i]
        })
        .collect()
}

fn from_outlets(parcels: &Parcels) -> Vec<u32> {
    distances(parcels, parcels.outlets.iter().map(|outlet| outlet.parcel).collect())
}

/// Returns the nearness of each parcel to the rim of the land, which is a coast, a ridge or the border of the domain:
/// from 0, far away, to 1. Ground that rises toward the rim keeps rivers from running along it. It does not rise around
/// outlets, because rivers have to reach the sea there.
fn nearness_to_rim(parcels: &Parcels, from_outlets: &[u32]) -> Vec<f32> {
    const PARCELS: f32 = 6.0;
    let on_rim = (0..parcels.len() as u32).filter(|&parcel| parcels.is_on_rim[parcel as usize]);
    let from_rim = distances(parcels, on_rim.collect());
    let nearness = |(from_rim, &from_outlet): (u32, &u32)| {
        let near = (1.0 - from_rim as f32 / PARCELS).max(0.0);
        near * near * (from_outlet as f32 / (2.0 * PARCELS)).min(1.0)
    };
    from_rim.into_iter().zip(from_outlets).map(nearness).collect()
}

/// Returns the number of steps from each parcel to the nearest of the given ones; 0 if no way leads to any.
fn distances(parcels: &Parcels, mut reached: Vec<u32>) -> Vec<u32> {
    let mut distance = vec![u32::MAX; parcels.len()];
    reached.iter().for_each(|&parcel| distance[parcel as usize] = 0);
    let mut next = 0;
    while let Some(&here) = reached.get(next) {
        next += 1;
        for &there in parcels.neighbours.of(here as usize) {
            if distance[there as usize] == u32::MAX {
                distance[there as usize] = distance[here as usize] + 1;
                reached.push(there);
            }
        }
    }
    work::count(6 * reached.len());
    distance.iter_mut().filter(|distance| **distance == u32::MAX).for_each(|distance| *distance = 0);
    distance
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grow::scatter;
    use crate::recipe::link;

    fn settings(link: &str) -> GrowthSettings {
        GrowthSettings::of(&link::read(&format!("growth=colonize&seed=kauri&{link}")).unwrap())
    }

    #[test]
    fn land_hides_attractors_and_moves_none() {
        let whole = scatter(&settings("land=island&sea=0.01&valleys=0.5&attractors=900"));
        let island = scatter(&settings("land=island&sea=0.6&valleys=0.5&attractors=900"));
        assert!(island.len() < whole.len() / 2 && island.len() > 200 && island.iter().all(|at| whole.contains(at)));
    }

    #[test]
    fn lowest_attractors_lie_near_mouths_and_highest_along_borders() {
        // The sea is only in the south; with hardly any unevenness, only tilt and borders are left.
        let settings = settings("land=rectangle&sides=s&mouths=1&valleys=0.01&attractors=4000&aspect=1");
        let places = scatter(&settings);
        let mouth = crate::grow::mouths(&settings)[0].at;
        let mean = |places: &[Vec2], of: &dyn Fn(Vec2) -> f32| {
            places.iter().map(|&at| of(at)).sum::<f32>() / places.len() as f32
        };
        let from_border = |at: Vec2| at.min(Vec2::splat(1000.0) - at).min_element();
        let (lowest, highest) = (&places[..400], &places[places.len() - 400..]);
        assert!(mean(lowest, &|at| at.distance(mouth)) < 400.0 && mean(highest, &|at| at.distance(mouth)) > 600.0);
        assert!(mean(highest, &from_border) < 30.0 && mean(lowest, &from_border) > 60.0);
    }
}
