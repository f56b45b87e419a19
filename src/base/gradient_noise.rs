//! Gradient noise on a lattice of unit squares.

use glam::Vec2;

use super::random::ItemHash;

/// Returns gradient noise (Perlin 1985, with the fade of 2002), from about -1 to 1, and its gradient. `number` tells noises of one hash apart.
pub(crate) fn noise(hash: ItemHash, number: u32, at: Vec2) -> (f32, Vec2) {
    let corner = at.floor();
    let within = at - corner;
    let [west, north] = [corner.x, corner.y].map(|x| x as i32);
    let dot = |east: i32, south: i32| {
        let slope =
            SLOPES[(hash.bits([(west + east) as u32, (north + south) as u32, number]) >> 29) as usize % SLOPES.len()];
        (slope.dot(within - Vec2::new(east as f32, south as f32)), slope)
    };
    let [(a, slope_a), (b, slope_b), (c, slope_c), (d, slope_d)] = [dot(0, 0), dot(1, 0), dot(0, 1), dot(1, 1)];
    let fade = within * within * within * (within * (within * 6.0 - 15.0) + 10.0);
    let steep = within * within * (within * (within - 2.0) + 1.0) * 30.0;
    let height = a + fade.x * (b - a) + fade.y * (c - a) + fade.x * fade.y * (a - b - c + d);
    let mixed = slope_a
        + (slope_b - slope_a) * fade.x
        + (slope_c - slope_a) * fade.y
        + (slope_a - slope_b - slope_c + slope_d) * (fade.x * fade.y);
    let twist = a - b - c + d;
    let turned = Vec2::new(b - a + fade.y * twist, c - a + fade.x * twist) * steep;
    (height * GAIN, (mixed + turned) * GAIN)
}

/// Brings the noise to a range of about -1 to 1.
const GAIN: f32 = 1.4;

/// The slopes at the corners of the noise's lattice.
const SLOPES: [Vec2; 8] = {
    const HALF: f32 = std::f32::consts::FRAC_1_SQRT_2;
    [
        Vec2::new(1.0, 0.0),
        Vec2::new(HALF, HALF),
        Vec2::new(0.0, 1.0),
        Vec2::new(-HALF, HALF),
        Vec2::new(-1.0, 0.0),
        Vec2::new(-HALF, -HALF),
        Vec2::new(0.0, -1.0),
        Vec2::new(HALF, -HALF),
    ]
};
