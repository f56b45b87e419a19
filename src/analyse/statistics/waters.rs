//! Measures of what rivers run into and through: coasts, lakes and deltas.

use glam::Vec2;

use super::fit::{log, slope};
use super::land_area;
use crate::deltas::RIVERS;
use crate::land::SmoothedDistance;
use crate::map::Map;

/// The sides of the boxes that are counted, in units.
const BOXES: [f32; 5] = [4.0, 8.0, 16.0, 32.0, 64.0];

/// The least number of the largest boxes: fewer tell nothing.
const LEAST_BOXES: usize = 8;

/// The least area of a lake that is counted, in square units, and the least number of them.
const LEAST_AREA: f32 = 80.0;
const LEAST_LAKES: usize = 20;

/// A mouth counts if it is at least this share as wide as the widest.
const WIDE: f32 = 1.0 / 12.0;

/// Measures of the waters of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Waters {
    /// The box-counting dimension of the coasts; `None` if they are short.
    pub coast_dimension: Option<f64>,
    /// The share of the land that is under lakes along rivers, from 0 to 1.
    pub lake_share: f64,
    /// The exponent of the areas of lakes; `None` for fewer than twenty.
    pub lake_exponent: Option<f64>,
    /// The share of great mouths that have a delta, from 0 to 1; `None` if there are no rivers.
    pub deltas: Option<f64>,
}

impl Waters {
    /// Measures the waters of a map.
    pub fn of(map: &Map) -> Self {
        let lakes = &map.lakes().list;
        let area = land_area(map);
        // A sum of nothing would be less than zero by its sign.
        let of_lakes = lakes.iter().fold(0.0, |sum, lake| sum + f64::from(lake.area));
        Self {
            coast_dimension: dimension(&coasts(map)),
            lake_share: if area > 0.0 { of_lakes / area } else { 0.0 },
            lake_exponent: exponent(lakes.iter().map(|lake| lake.area)),
            deltas: deltas(map),
        }
    }
}

/// Lists places along the coasts of a map, closer to each other than the smallest box is wide. The frame is no coast.
fn coasts(map: &Map) -> Vec<Vec2> {
    const OFF_FRAME: f32 = 2.0;
    let Some(land) = map.land() else { return Vec::new() };
    let end = map.domain().size - OFF_FRAME;
    let is_inside = |at: &Vec2| at.min_element() > OFF_FRAME && at.x < end.x && at.y < end.y;
    let rings = SmoothedDistance::of(land.coast_distance()).rings_above(0.0);
    rings.into_iter().flatten().filter(is_inside).collect()
}

/// Returns the box-counting dimension of places: how fast boxes that hold one become more as they become smaller.
fn dimension(places: &[Vec2]) -> Option<f64> {
    let count = |side: f32| {
        let mut boxes: Vec<[u32; 2]> =
            places.iter().map(|at| (*at / side).to_array().map(|along| along as u32)).collect();
        boxes.sort_unstable();
        boxes.dedup();
        boxes.len()
    };
    let points = BOXES.map(|side| (log(side.into()), count(side)));
    let enough = points.iter().all(|(_, count)| *count >= LEAST_BOXES);
    let logs = points.map(|(side, count)| (side, log(count as f64)));
    slope(&logs).filter(|_| enough).map(|slope| -slope)
}

/// Returns the exponent τ of the areas of lakes, P(a) ∝ a^−τ, of greatest likelihood (Newman 2005, Contemporary Physics 46, 323-351).
fn exponent(areas: impl Iterator<Item = f32>) -> Option<f64> {
    let areas: Vec<f32> = areas.filter(|area| *area >= LEAST_AREA).collect();
    let sum: f64 = areas.iter().map(|area| log(f64::from(area / LEAST_AREA))).sum();
    (areas.len() >= LEAST_LAKES && sum > 0.0).then(|| 1.0 + areas.len() as f64 / sum)
}

/// Returns the share of a map's greatest mouths that have a delta.
fn deltas(map: &Map) -> Option<f64> {
    let network = map.network();
    let width = |river: u32| {
        let course = &network.vertices[network.rivers[river as usize].vertex_range()];
        course.last().map_or(0.0, |end| end.width())
    };
    let mut widths: Vec<f32> = network.mouths().into_iter().map(width).collect();
    widths.sort_by(|a, b| b.total_cmp(a));
    let least = WIDE * *widths.first()?;
    let great = widths.iter().take(RIVERS).filter(|width| **width > least).count();
    let built = map.deltas().list.iter().filter(|delta| width(delta.river) > least).count();
    (great > 0).then(|| built as f64 / great as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::session::Session;

    #[test]
    fn a_line_has_the_dimension_1_and_an_area_2() {
        let line: Vec<Vec2> = (0..2000).map(|i| Vec2::new(i as f32 * 0.5, i as f32 * 0.35 + 3.0)).collect();
        assert!((dimension(&line).unwrap() - 1.0).abs() < 0.05, "{:?}", dimension(&line));
        let area: Vec<Vec2> =
            (0..300).flat_map(|y| (0..300).map(move |x| Vec2::new(x as f32, y as f32) * 3.0)).collect();
        assert!((dimension(&area).unwrap() - 2.0).abs() < 0.1, "{:?}", dimension(&area));
        assert_eq!(dimension(&line[..200]), None, "too short");
    }

    #[test]
    fn exponent_is_that_of_the_areas() {
        for tau in [1.8_f64, 2.14, 2.6] {
            // Quantiles of the power law.
            let area = |i: u32| LEAST_AREA * libm::pow((f64::from(i) + 0.5) / 400.0, -1.0 / (tau - 1.0)) as f32;
            let found = exponent((0..400).map(area));
            assert!((found.unwrap() - tau).abs() < 0.03, "{tau}: {found:?}");
            assert_eq!(exponent((0..LEAST_LAKES as u32 - 1).map(area)), None);
        }
    }

    #[test]
    fn waters_of_a_lakeland_and_of_a_plain_rectangle_are_measured() {
        let map = |text: &str| Session::new(link::read(text).unwrap()).unwrap().finish().unwrap();
        let waters = Waters::of(&map("seed=saimaa&country=lakeland&deltas=0.6"));
        assert!((1.0..1.6).contains(&waters.coast_dimension.unwrap()), "{waters:?}");
        assert!((0.03..0.15).contains(&waters.lake_share), "{waters:?}");
        assert!((1.5..3.0).contains(&waters.lake_exponent.unwrap()), "{waters:?}");
        assert!((0.0..=1.0).contains(&waters.deltas.unwrap()), "{waters:?}");
        let plain = Waters::of(&map("country=usual&land=rectangle&attractors=300&lakes=0"));
        assert_eq!((plain.coast_dimension, plain.lake_share, plain.lake_exponent), (None, 0.0, None));
        assert!(plain.lake_share.is_sign_positive());
        assert_eq!(plain.deltas, Some(0.0));
    }
}
