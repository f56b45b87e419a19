//! Light on a relief, in three scales: that on its broad forms, that on its detail, and what stands above its surroundings or lies
//! below them.
//!
//! Light on detail alone breaks a range up into facets of equal weight; that on generalised heights shows which side of the whole
//! range is dark (Patterson and Jenny 2011 call for both). The third share, the height over generalised heights, stands in for
//! Brown's texture shading (2010): crests are lighter and valleys darker whichever way they run, as the sky lights them.

use glam::{Vec2, Vec3};

use super::blur::{blurred, radius_of};
use crate::base::work;
use crate::land::beside;
use crate::relief::Relief;
use crate::scale::USUAL_METRES;

/// Three lights: from the north-west at 45° above the horizon with a share of 0.55, from the west at 50° with 0.25 and
/// from the north at 55° with 0.2. The strongest light is the lowest, and ridges of all directions have a dark side
/// (after Imhof 1965). Each vector points to its light and is as long as its share.
const LIGHTS: [Vec3; 3] =
    [Vec3::new(-0.275, -0.275, 0.388_909), Vec3::new(-0.160_697, 0.0, 0.191_511), Vec3::new(0.0, -0.114_715, 0.163_83)];

/// The light of all three on flat land.
const ON_FLAT: f32 = 0.744_25;

/// The standard deviation of the blur that generalises heights, in units.
const GENERALISED: f32 = 12.0;

/// The shares of broad forms and of detail in the light, each with what makes up for its gentler or steeper slopes.
const BROAD: f32 = 0.36;
const BROAD_SLOPES: f32 = 2.0;
const DETAIL: f32 = 0.52;
/// The share of what stands above its surroundings, and the factor for its height, as a share of the blur's deviation.
const STANDING: f32 = 0.12;
const STANDING_HEIGHT: f32 = 2.5;

/// Factors for what is darker and for what is lighter than flat land: a slope cannot be as much lighter as it can be darker.
const DARKER: f32 = 3.4;
const LIGHTER: f32 = 4.2;

/// A light on a relief.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Light {
    /// The factor by which slopes are steeper for this light.
    pub exaggeration: f32,
}

impl Light {
    /// Returns the share of their full strength that hachures have: all where slopes are exaggerated as usual, or more.
    pub fn strength_of_hachures(self) -> f32 {
        const USUAL: f32 = 0.45;
        const LEAST: f32 = 0.25;
        LEAST + (1.0 - LEAST) * (self.exaggeration / USUAL).clamp(0.0, 1.0)
    }
}

/// Computes the light on each cell, from -1 in the deepest shadow over 0 on flat land to 1.
pub(crate) fn light_of(relief: &Relief, Light { exaggeration }: Light) -> Vec<f32> {
    let (columns, cell_size) = (relief.columns(), relief.cell_size());
    let heights: Vec<f32> = relief.heights().iter().map(|height| height.max(0.0)).collect();
    let radius = radius_of(GENERALISED / cell_size);
    let broad = blurred(heights.clone(), columns, radius);
    work::count(heights.len() * 2);
    let (steeper, higher) = (exaggeration / cell_size, exaggeration * STANDING_HEIGHT / GENERALISED);
    let mut light = Vec::with_capacity(heights.len());
    for_each_rise([&heights, &broad], columns, |cell, [detail, generalised]| {
        let lit = DETAIL * lit(detail * steeper) + BROAD * lit(generalised * (steeper * BROAD_SLOPES));
        let standing = STANDING * (heights[cell] - broad[cell]) * higher;
        light.push(toned((lit + standing) * contrast(heights[cell] * USUAL_METRES)));
    });
    light
}

/// Visits the rise of two fields over each cell, row by row. At the border it is that towards the next cell within.
fn for_each_rise(fields: [&[f32]; 2], columns: usize, mut visit: impl FnMut(usize, [Vec2; 2])) {
    let rows = fields[0].len() / columns.max(1);
    // Over two intervals inside, over one at the border.
    let share = |[before, _, after]: [usize; 3]| if after - before == 2 { 0.5 } else { 1.0 };
    for row in 0..rows {
        let lines = beside(row, rows);
        let [north, here, south] = lines.map(|row| row * columns);
        for column in 0..columns {
            let around = beside(column, columns);
            let [west, _, east] = around;
            let shares = Vec2::new(share(around), share(lines));
            let rise = |field: &[f32]| {
                let east = field[here + east] - field[here + west];
                Vec2::new(east, field[south + column] - field[north + column]) * shares
            };
            visit(here + column, fields.map(rise));
        }
    }
}

/// Computes the light on a slope beyond that on flat land, as a share of the latter.
fn lit(rise: Vec2) -> f32 {
    let normal = (-rise).extend(1.0);
    let length = (rise.length_squared() + 1.0).sqrt();
    let light: f32 = LIGHTS.iter().map(|light| normal.dot(*light).max(0.0)).sum();
    light / (length * ON_FLAT) - 1.0
}

/// Returns the contrast at a height, in metres: high land stands closer to the eye, and haze lies over the lowland
/// (aerial perspective, Imhof 1965).
fn contrast(metres: f32) -> f32 {
    const LOW: f32 = 0.8;
    const HIGH: f32 = 1.3;
    const ABOVE: f32 = 1200.0;
    LOW + (HIGH - LOW) * (metres / ABOVE).min(1.0)
}

/// Tones light down to between -1 and 1, however great it is.
fn toned(light: f32) -> f32 {
    let light = light * if light < 0.0 { DARKER } else { LIGHTER };
    light / (1.0 + light * light).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::relief::CELL_SIZE;

    /// Computes the light on a square map with these heights, in units, and the number of its columns.
    fn light(exaggeration: f32, height: impl Fn(Vec2) -> f32) -> (Vec<f32>, usize) {
        let domain = Domain::with_aspect(1.0);
        let columns = (domain.size.x / CELL_SIZE).ceil() as usize;
        let at = |cell: usize| Vec2::new((cell % columns) as f32, (cell / columns) as f32) * CELL_SIZE;
        let heights = (0..columns * columns).map(|cell| height(at(cell))).collect();
        let relief = Relief::of_heights(&domain, heights).unwrap();
        (light_of(&relief, Light { exaggeration }), columns)
    }

    #[test]
    fn a_slope_has_no_rim_where_it_runs_off_the_map() {
        let (light, columns) = light(0.45, |at| 200.0 + at.x * 0.2 - at.y * 0.1);
        let middle = light[columns * columns / 2];
        assert!(middle.abs() > 0.05, "{middle}");
        for (cell, light) in light.into_iter().enumerate() {
            assert!((light - middle).abs() < 0.01, "{light} in cell {cell}, {middle} in the middle");
        }
    }

    #[test]
    fn light_falls_from_the_north_west_and_is_bounded() {
        let ridge = |at: Vec2| (300.0 - (at.x + at.y - 1000.0).abs() * 0.5).max(0.0) + 1.0;
        for exaggeration in [0.45, 1.0, 50.0] {
            let (light, columns) = light(exaggeration, ridge);
            let [lit, dark] = [400, 600].map(|at| light[at / 2 * columns + at / 2]);
            assert!(lit > dark + 0.3 && dark < -0.2, "{lit} and {dark}");
            assert!(lit > 0.2 || exaggeration > 1.0, "{lit}");
            assert!(light.iter().all(|light| (-1.0..=1.0).contains(light)));
        }
        assert!(self::light(0.0, ridge).0.iter().all(|light| light.abs() < 1e-3), "no shade, no light");
    }

    #[test]
    fn a_valley_is_darker_than_its_crest_whichever_way_it_runs() {
        // Valleys along the light, which does not tell their sides apart.
        let waves = |at: Vec2| 100.0 + 4.0 * libm::sinf((at.x - at.y) * 0.1);
        let (light, columns) = light(0.45, waves);
        let mean = |is_high: bool| {
            let cells = (0..light.len()).filter(|cell| {
                let at = Vec2::new((cell % columns) as f32, (cell / columns) as f32) * CELL_SIZE;
                (waves(at) > 103.5 && is_high) || (waves(at) < 96.5 && !is_high)
            });
            let (sum, count) = cells.fold((0.0, 0.0), |(sum, count), cell| (sum + light[cell], count + 1.0));
            sum / count
        };
        assert!(mean(true) > mean(false) + 0.1, "{} and {}", mean(true), mean(false));
    }
}
