//! The rock of a coast: noise that moves it. Hard rock makes a ragged coast with skerries, soft rock a smooth one.

use fastnoise_lite::FastNoiseLite;
use glam::{Mat2, Vec2};

use super::kinds::Shape;
use crate::base::geometry::smooth_step;
use crate::base::random::Purpose;
use crate::base::trigonometry::sine_and_cosine;

use std::f32::consts::PI;

/// Noise over the plane, in units of height.
pub(super) struct Rock {
    /// Rotates to coordinates along and across the grain.
    grain: Mat2,
    /// The factor by which forms are longer along the grain, and narrower across it.
    stretch: f32,
    warp: [FastNoiseLite; 2],
    broad: FastNoiseLite,
    spurs: FastNoiseLite,
    fine: FastNoiseLite,
    /// A thousandth of the domain's shorter side, in units.
    scale: f32,
    roughness: f32,
}

/// The effect of rock on the height at a point.
pub(super) struct Relief {
    /// The point from which land is taken there.
    pub at: Vec2,
    /// The height that is added, in units.
    pub rise: f32,
    /// A slowly changing number, from −1 to 1.
    pub stray: f32,
}

/// The heights of noise, and the distance by which it warps the plane, in thousandths of the domain's shorter side.
#[derive(Clone, Copy)]
pub(super) struct Amplitudes {
    pub warp: f32,
    pub broad: f32,
    pub spurs: f32,
    pub fine: f32,
}

impl Rock {
    pub fn new(shape: &Shape) -> Self {
        let chance = |number: u32| shape.seed.item_hash(Purpose::Land).unit([6, number, 0]);
        let (sine, cosine) = sine_and_cosine(PI * chance(0));
        let grain = Vec2::new(cosine, sine);
        let octave = |index: u32, bumps: f32| shape.noise(index, bumps, 1);
        Self {
            grain: Mat2::from_cols(grain, grain.perp()).transpose(),
            stretch: (1.0 + 0.5 * chance(1)).sqrt(),
            warp: [0, 1].map(|index| shape.noise(index, 1.7, 1)),
            broad: shape.noise(6, 2.1, 2),
            spurs: octave(7, 5.0),
            fine: octave(8, 1.0),
            scale: shape.span() / 1000.0,
            roughness: shape.roughness,
        }
    }

    /// Returns the relief at a point.
    pub fn at(&self, point: Vec2, amplitudes: &Amplitudes) -> Relief {
        let strays = [0, 1].map(|i| self.warp[i].get_noise_2d(point.x, point.y));
        // Smooth coasts are bent, too.
        let (bent, rough) = (self.scale * (0.5 + 0.5 * self.roughness), self.scale * self.roughness);
        let at = point + Vec2::from(strays) * (amplitudes.warp * bent);
        let hard = smooth_step(0.5 + 1.3 * strays[1]);
        let broad = amplitudes.broad * self.broad.get_noise_2d(at.x, at.y);
        let along = self.grain * at * Vec2::new(1.0 / self.stretch, self.stretch);
        let spurs = amplitudes.spurs * (0.45 + 0.75 * hard) * self.spurs(along);
        let fine = if amplitudes.fine > 0.0 { amplitudes.fine * self.fine(along, hard) } else { 0.0 };
        Relief { at, rise: broad * bent + (spurs + fine) * rough, stray: strays[0] }
    }

    /// Returns spurs with valleys between them: ridged noise (Musgrave 1994), since spurs are narrow and long and so
    /// are peninsulas.
    fn spurs(&self, at: Vec2) -> f32 {
        let first = self.spurs.get_noise_2d(at.x, at.y);
        let second = self.spurs.get_noise_2d(2.03 * at.x + 311.0, 2.03 * at.y - 173.0);
        let ridge = |noise: f32| 0.72 - 1.7 * (noise * noise + 0.02).sqrt();
        ridge(first) + 0.4 * ridge(second)
    }

    /// Returns detail, whose finer octaves are strong on hard rock and weak on soft rock.
    fn fine(&self, at: Vec2, hard: f32) -> f32 {
        let gain = 0.45 + 0.33 * hard;
        let (mut sum, mut strength, mut at) = (0.0, 0.3 + 0.95 * hard, at * 17.0);
        for _ in 0..3 {
            sum += strength * self.fine.get_noise_2d(at.x, at.y);
            strength *= gain;
            at = at * 2.07 + 97.0;
        }
        sum
    }
}
