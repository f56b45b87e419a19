//! Bends of the plane: a flow that follows the contours of fractal noise, so that it neither gathers nor scatters
//! places. The noise is stronger in one place than in another; as its height varies and not the flow itself, areas are
//! still kept.
//!
//! Each place is moved in many small steps, so heights are computed once for each knot of a grid, when first needed.
//! Between the knots lies a quadratic B-spline, whose slope is continuous.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::settings::DrainageSettings;
use crate::base::random::DEVIATION;
use crate::base::work;

/// The number of steps. With fewer the flow leaves its contours where it is strong.
const STEPS: u32 = 8;

/// The greatest wavelength of the noise, in spacings, its octaves and their gain.
const WAVELENGTH: f32 = 10.0;
const OCTAVES: i32 = 3;
const GAIN: f32 = 0.2;

/// The wavelength of the strength, in spacings.
const STRENGTH_WAVELENGTH: f32 = 16.0;

/// The greatest strength, beyond which courses would be tangled.
const STRONGEST: f32 = 1.7;

/// The distance between knots, in spacings.
const KNOT_SPACING: f32 = 0.8;

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
    /// The number of columns of knots on each side of the middle one, and of rows.
    reach: [i32; 2],
    /// The heights of knots, row by row; NaN where it has not been needed.
    heights: Vec<f32>,
}

impl Bends {
    /// Prepares the bends of places within `half` of the middle, in each direction.
    pub fn new(settings: &DrainageSettings, half: Vec2) -> Self {
        let knot_spacing = KNOT_SPACING * settings.spacing;
        let is_bent = settings.bending > 0.0;
        let reach = if is_bent { half + settings.farthest_bend() } else { Vec2::ZERO };
        // A spline needs the knots beside the nearest one.
        let reach = (reach / knot_spacing).to_array().map(|knots| knots as i32 + 3);
        let [columns, rows] = reach.map(|knots| 2 * knots as usize + 1);
        Self {
            noise: settings.noise(0, WAVELENGTH * settings.spacing, OCTAVES, GAIN),
            strength: settings.noise(1, STRENGTH_WAVELENGTH * settings.spacing, 1, 0.5),
            variation: settings.bending_variation,
            step: settings.bending / STEPS as f32 * FLOW * WAVELENGTH / KNOT_SPACING,
            knot_spacing,
            reach,
            heights: vec![f32::NAN; columns * rows],
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

    /// The rise of the spline in both directions, a knot. The place is counted in knots.
    fn slope(&mut self, at: Vec2) -> Vec2 {
        let knot = at.round();
        let off = at - knot;
        let weights = |off: f32| [0.5 * (0.5 - off) * (0.5 - off), 0.75 - off * off, 0.5 * (0.5 + off) * (0.5 + off)];
        let rises = |off: f32| [off - 0.5, -2.0 * off, off + 0.5];
        let (across, down) = ((weights(off.x), rises(off.x)), (weights(off.y), rises(off.y)));
        let (mut slope, knot) = (Vec2::ZERO, knot.as_ivec2());
        for row in 0..3 {
            for column in 0..3 {
                let height = self.height(knot.x + column - 1, knot.y + row - 1);
                let (column, row) = (column as usize, row as usize);
                slope += height * Vec2::new(across.1[column] * down.0[row], across.0[column] * down.1[row]);
            }
        }
        slope
    }

    /// The height of a knot.
    fn height(&mut self, column: i32, row: i32) -> f32 {
        let [across, down] = self.reach;
        let knot = (row + down) * (2 * across + 1) + column + across;
        let Some(known) = self.heights.get(knot as usize).copied() else { return 0.0 };
        if !known.is_nan() {
            return known;
        }
        let at = Vec2::new(column as f32, row as f32) * self.knot_spacing;
        let height = self.noise.get_noise_2d(at.x, at.y) * self.strength(at);
        self.heights[knot as usize] = height;
        height
    }

    /// The strength of the noise at a place: a log-normal deviate with mean 1, but not above [`STRONGEST`].
    fn strength(&self, at: Vec2) -> f32 {
        if self.variation == 0.0 {
            return 1.0;
        }
        let deviate = DEVIATION * self.strength.get_noise_2d(at.x, at.y);
        libm::expf(self.variation * deviate - 0.5 * self.variation * self.variation).min(STRONGEST)
    }
}
