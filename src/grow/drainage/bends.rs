//! Bends of the plane: a flow that follows the contours of fractal noise, so that it neither gathers nor scatters
//! places. The noise is stronger in one place than in another; as its height varies and not the flow itself, areas are
//! still kept.
//!
//! Each place is moved in many small steps, so heights are computed once for each knot of a grid, when first needed.
//! Between the knots lies a quadratic B-spline, whose slope is continuous.

use fastnoise_lite::FastNoiseLite;
use glam::{IVec2, Vec2};

use super::settings::DrainageSettings;
use crate::base::random::DEVIATION;
use crate::base::work;

/// The number of steps. With fewer the flow leaves its contours where it is strong.
const STEPS: u32 = 8;

/// The greatest wavelength of the noise, in spacings, its octaves and their gain.
const WAVELENGTH: f32 = 16.0;
const OCTAVES: i32 = 3;
const GAIN: f32 = 0.2;

/// The wavelength of the strength, in spacings.
const STRENGTH_WAVELENGTH: f32 = 16.0;

/// The greatest strength, beyond which courses would be tangled.
const STRONGEST: f32 = 1.7;

/// The distance between knots, in spacings.
const KNOT_SPACING: f32 = 1.0;

/// The factor for the length of the flow that brings the root mean square displacement to about 0.75 times the bending.
const FLOW: f32 = 0.24;

/// The flow, with the heights whose contours it follows. Positions are relative to the middle of the domain.
pub(super) struct Bends {
    noise: FastNoiseLite,
    strength: FastNoiseLite,
    /// The deviation of the logarithm of the strength.
    variation: f32,
    /// The length of one step where the height rises by 1 a knot.
    step: f32,
    /// The distance between knots, in units.
    knot_spacing: f32,
    /// The number of columns of knots on each side of the middle one, and of rows: whole numbers.
    reach: Vec2,
    /// The column and row of the last knot.
    last: IVec2,
    /// The heights of knots, row by row; NaN where it has not been needed.
    heights: Vec<f32>,
    /// `true` for knots that are the north-western corner of nine whose heights are known.
    is_known: Vec<bool>,
}

impl Bends {
    /// Prepares the bends of places within `half` of the middle, in each direction.
    pub fn new(settings: &DrainageSettings, half: Vec2) -> Self {
        let knot_spacing = KNOT_SPACING * settings.spacing;
        let is_bent = settings.bending > 0.0;
        let reach = if is_bent { half + settings.farthest_bend() } else { Vec2::ZERO };
        // A spline needs the knots beside the nearest one.
        let reach = (reach / knot_spacing).as_ivec2() + 3;
        let last = 2 * reach;
        let knots = (last.x as usize + 1) * (last.y as usize + 1);
        Self {
            noise: settings.noise(0, WAVELENGTH * settings.spacing, OCTAVES, GAIN),
            strength: settings.noise(1, STRENGTH_WAVELENGTH * settings.spacing, 1, 0.5),
            variation: settings.bending_variation,
            step: settings.bending / STEPS as f32 * FLOW * WAVELENGTH / KNOT_SPACING,
            knot_spacing,
            reach: reach.as_vec2(),
            last,
            heights: vec![f32::NAN; knots],
            is_known: vec![false; knots],
        }
    }

    /// Moves a place along its contour.
    pub fn bend(&mut self, at: Vec2) -> Vec2 {
        if self.step == 0.0 {
            return at;
        }
        work::count(STEPS as usize);
        (0..STEPS).fold(at, |at, _| at + self.slope(at / self.knot_spacing).perp() * self.step)
    }

    /// Returns the rise of the spline per knot in both directions, at a place in reach, counted in knots.
    fn slope(&mut self, at: Vec2) -> Vec2 {
        let from_corner = at + self.reach;
        // The nearest knot. Casting rounds down, and is faster than rounding.
        let knot = (from_corner + 0.5).as_ivec2().clamp(IVec2::ONE, self.last - 1);
        let off = from_corner - knot.as_vec2();
        let around = self.around(knot);
        let weights = |off: f32| [0.5 * (0.5 - off) * (0.5 - off), 0.75 - off * off, 0.5 * (0.5 + off) * (0.5 + off)];
        let rises = |off: f32| [off - 0.5, -2.0 * off, off + 0.5];
        let across = (weights(off.x), rises(off.x));
        let (down, rise_down) = (weights(off.y), rises(off.y));
        let mut slope = Vec2::ZERO;
        for row in 0..3 {
            let along = |weights: &[f32; 3]| {
                let [a, b, c] = around[row];
                a * weights[0] + b * weights[1] + c * weights[2]
            };
            slope += Vec2::new(along(&across.1) * down[row], along(&across.0) * rise_down[row]);
        }
        slope
    }

    /// Returns the heights of a knot and of the eight around it, row by row.
    fn around(&mut self, knot: IVec2) -> [[f32; 3]; 3] {
        let columns = self.last.x as usize + 1;
        let corner = (knot.y as usize - 1) * columns + knot.x as usize - 1;
        if !std::mem::replace(&mut self.is_known[corner], true) {
            for (row, column) in (0..3).flat_map(|row| (0..3).map(move |column| (row, column))) {
                let index = corner + row as usize * columns + column as usize;
                if self.heights[index].is_nan() {
                    self.heights[index] = self.height(knot + IVec2::new(column - 1, row - 1));
                }
            }
        }
        std::array::from_fn(|row| {
            let start = corner + row * columns;
            [self.heights[start], self.heights[start + 1], self.heights[start + 2]]
        })
    }

    /// Returns the height of a knot.
    fn height(&self, knot: IVec2) -> f32 {
        let at = (knot.as_vec2() - self.reach) * self.knot_spacing;
        self.noise.get_noise_2d(at.x, at.y) * self.strength(at)
    }

    /// Returns the strength of the noise at a place: a log-normal deviate with mean 1, but not above [`STRONGEST`].
    fn strength(&self, at: Vec2) -> f32 {
        if self.variation == 0.0 {
            return 1.0;
        }
        let deviate = DEVIATION * self.strength.get_noise_2d(at.x, at.y);
        libm::expf(self.variation * deviate - 0.5 * self.variation * self.variation).min(STRONGEST)
    }
}
