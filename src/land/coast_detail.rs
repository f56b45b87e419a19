//! Detail of coasts that is finer than the lattice of their distances: noise that moves the line of the coast a little, for pictures
//! whose pixels are small enough to show it.
//!
//! It depends on the seed and on the place alone, so any part of a map at any size has the same coast. An octave fades in as pixels get
//! smaller than its wavelength; the amplitude of an octave is a share of its wavelength. Near rivers nothing moves, so no mouth is cut
//! off from its sea.

use glam::Vec2;

use super::Land;
use crate::base::geometry::smooth_step;
use crate::base::gradient_noise::noise;
use crate::base::random::{ItemHash, Purpose, Seed};
use crate::base::work;

/// The distance from the coast within which detail moves anything, in units.
pub(crate) const REACH: f32 = 2.8;

/// The wavelength of the broadest octave, in units: half the shortest wave that the lattice of coast distances holds.
const BROADEST: f32 = 4.2;
/// The number of octaves, each of half the wavelength of the one before.
const OCTAVES: u32 = 5;
/// The size of a wave at which it begins to show and at which all of it does, in pixels.
const FIRST_SEEN: f32 = 7.0;
const ALL_SEEN: f32 = 13.0;
/// The same, in widths of the coast's line. A wave's headland is half as long as the wave: where that is less than one and a
/// half widths, it is a crumb of ink beside the line.
const FIRST_BESIDE_LINE: f32 = 2.2;
const ALL_BESIDE_LINE: f32 = 3.6;

/// A coast's detail at one size of pixels.
#[derive(Clone, Debug)]
pub(crate) struct CoastDetail {
    hash: ItemHash,
    octaves: Vec<Octave>,
    free: Free,
}

/// Noise of one wavelength.
#[derive(Clone, Copy, Debug)]
struct Octave {
    number: u32,
    /// The number of squares of its lattice in a unit.
    per_unit: f32,
    amplitude: f32,
}

impl CoastDetail {
    /// Makes the detail that a coast shows with `per_unit` pixels to a unit, on a map of a given size, where its line has some
    /// width, in units. `roughness` is the recipe's, from 0 to 1; `lines` are the centerlines of all rivers with half the width at each place, in
    /// units. `None` if pixels are too large for any detail.
    pub fn of(
        land: &Land,
        size: Vec2,
        (seed, roughness): (Seed, f32),
        (per_unit, width): (f32, f32),
        lines: impl Iterator<Item = Vec<(Vec2, f32)>>,
    ) -> Option<Self> {
        let octaves = octaves(roughness, per_unit, width);
        if octaves.is_empty() {
            return None;
        }
        let mut free = Free::on(size);
        for line in lines {
            line.windows(2).filter(|ends| is_near(land, ends[0])).for_each(|ends| free.keep_off([ends[0], ends[1]]));
        }
        Some(Self { hash: seed.item_hash(Purpose::CoastDetail), octaves, free })
    }

    /// Returns the distance by which a place is moved inland, in units, and its gradient; `distance` is the place's distance from the
    /// coast, `slope` how steeply that rises. Midway between two coasts it hardly rises, and any move would make specks of land and water.
    pub fn shift(&self, at: Vec2, distance: f32, slope: f32) -> (f32, Vec2) {
        let way = (1.0 - distance.abs() / REACH).max(0.0);
        let share = smooth_step(way) * smooth_step(slope) * self.free.at(at);
        if share <= 0.0 {
            return (0.0, Vec2::ZERO);
        }
        let share = share * self.hardness(at);
        self.octaves.iter().fold((0.0, Vec2::ZERO), |(height, rise), octave| {
            let amplitude = octave.amplitude * share;
            let (more, steeper) = noise(self.hash, octave.number, at * octave.per_unit);
            (height + more * amplitude, rise + steeper * (amplitude * octave.per_unit))
        })
    }

    /// Returns the strength of detail at a place, by its rock from soft to hard: beaches are smooth, cliffs rough.
    fn hardness(&self, at: Vec2) -> f32 {
        const SOFT: f32 = 0.25;
        const HARD: f32 = 1.25;
        let hard = (noise(self.hash, HARDNESS, at * HARD_STRETCHES).0 * 0.8 + 0.5).clamp(0.0, 1.0);
        SOFT + (HARD - SOFT) * hard
    }
}

/// The number of the noise that tells hard stretches from soft ones, and the number of its squares in a unit.
const HARDNESS: u32 = 99;
const HARD_STRETCHES: f32 = 1.0 / 45.0;

/// Returns the octaves that can be seen.
fn octaves(roughness: f32, per_unit: f32, width: f32) -> Vec<Octave> {
    /// The amplitude as a share of the wavelength, for smooth and for rough coasts: on the hardest rock a wave is at most 0.35 of
    /// its length from crest to trough, so that no headland overhangs.
    const SMOOTH: f32 = 0.03;
    const ROUGH: f32 = 0.14;
    /// The factor for that share from octave to octave: a coast of steep small waves looks like foam.
    const LESS: f32 = 0.8;
    let share = SMOOTH + (ROUGH - SMOOTH) * roughness.clamp(0.0, 1.0);
    let octave = |number: u32| {
        let wavelength = BROADEST / (1 << number) as f32;
        let beside = (wavelength / width - FIRST_BESIDE_LINE) / (ALL_BESIDE_LINE - FIRST_BESIDE_LINE);
        let seen = smooth_step((wavelength * per_unit - FIRST_SEEN) / (ALL_SEEN - FIRST_SEEN)) * smooth_step(beside);
        // Gradient noise has its crests about two squares apart.
        Octave { number, per_unit: 2.0 / wavelength, amplitude: wavelength * share * seen }
    };
    let lessened = |octave: Octave| Octave {
        amplitude: octave.amplitude * (0..octave.number).fold(1.0, |less, _| less * LESS),
        ..octave
    };
    (0..OCTAVES).map(octave).map(lessened).filter(|octave| octave.amplitude > 0.0).collect()
}

/// Returns `true` if a place on a river is so near the coast that its banks may reach what detail moves.
fn is_near(land: &Land, (at, half): (Vec2, f32)) -> bool {
    land.coast_distance().height(at).abs() < half + REACH + far(half)
}

/// The distance from a bank up to which nothing moves, in units: more than the diagonal of a cell, so no bank lies between
/// four free corners.
const NEAR: f32 = 1.5;

/// Returns the distance from a bank from which on everything may move, in units: the farther the wider the river is, of which
/// half the width is given. The smooth shore at a great river's mouth becomes rough over 20 units.
fn far(half: f32) -> f32 {
    const LEAST: f32 = 4.5;
    const BY_HALF: f32 = 3.0;
    const MOST: f32 = 21.5;
    (LEAST + BY_HALF * half).min(MOST)
}

/// The freedom of the coast to move, on a lattice with a corner at every unit, in 255ths: not at all near rivers.
#[derive(Clone, Debug)]
struct Free {
    columns: usize,
    shares: Vec<u8>,
}

impl Free {
    fn on(size: Vec2) -> Self {
        let [columns, rows] = size.to_array().map(|length| length as usize + 2);
        Self { columns, shares: vec![u8::MAX; columns * rows] }
    }

    /// Holds the coast around a segment of a river.
    fn keep_off(&mut self, [(from, half_from), (to, half_to)]: [(Vec2, f32); 2]) {
        let along = to - from;
        let widest = half_from.max(half_to);
        let (far, reach) = (far(widest), widest + far(widest));
        let [[left, right], [top, bottom]] = [0, 1].map(|axis| {
            let (least, most) = (from.min(to)[axis] - reach, from.max(to)[axis] + reach);
            // A conversion turns negative numbers into 0.
            [least.ceil() as usize, (most.floor() + 1.0) as usize]
        });
        let (right, bottom) = (right.min(self.columns), bottom.min(self.shares.len() / self.columns));
        work::count(bottom.saturating_sub(top) * right.saturating_sub(left));
        for (row, column) in (top..bottom).flat_map(|row| (left..right).map(move |column| (row, column))) {
            let off = Vec2::new(column as f32, row as f32) - from;
            let way = (off.dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
            let away = (off - along * way).length() - (half_from + (half_to - half_from) * way);
            let free = smooth_step((away - NEAR) / (far - NEAR));
            let share = &mut self.shares[row * self.columns + column];
            *share = (*share).min((free * 255.0) as u8);
        }
    }

    /// Returns the freedom at a place, from 0 to 1. Beyond the map it is that at the border.
    fn at(&self, at: Vec2) -> f32 {
        let last = Vec2::new(self.columns as f32 - 2.0, (self.shares.len() / self.columns) as f32 - 2.0);
        let at = at.max(Vec2::ZERO).min(last);
        let (column, row) = (at.x as usize, at.y as usize);
        let within = at - at.floor();
        let share = |down: usize, across: usize| f32::from(self.shares[(row + down) * self.columns + column + across]);
        let [north, south] = [0, 1].map(|down| share(down, 0) + (share(down, 1) - share(down, 0)) * within.x);
        (north + (south - north) * within.y) / 255.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::recipe::link;

    const ROUGHNESS: f32 = 0.5;

    fn detail(per_unit: f32, lines: &[Vec<(Vec2, f32)>]) -> Option<CoastDetail> {
        let recipe = link::read("land=island&aspect=1.5").unwrap();
        let land = Land::of(&recipe).unwrap();
        CoastDetail::of(
            &land,
            Domain::of(&recipe).size,
            (Seed::from_text("kauri"), ROUGHNESS),
            (per_unit, 1.8 * (1.65 / per_unit).min(1.0).sqrt()),
            lines.iter().cloned(),
        )
    }

    /// Iterates over places all over a square without rivers.
    fn places() -> impl Iterator<Item = Vec2> {
        (0..40_000).map(|i| Vec2::new((i % 200) as f32 * 0.731, (i / 200) as f32 * 0.917) + 300.0)
    }

    #[test]
    fn coarse_pixels_show_none_and_finer_ones_more_and_more() {
        for width in [200.0, 1024.0, 1440.0, 1920.0] {
            assert!(detail(width / 1224.7, &[]).is_none(), "{width} pixels");
        }
        let mean = |per_unit: f32| {
            let detail = detail(per_unit, &[]).unwrap();
            places().map(|at| detail.shift(at, 0.0, 1.0).0.abs()).sum::<f32>() / 40_000.0
        };
        let [small, large, largest] = [2.2, 3.3, 6.7].map(mean);
        assert!(0.0 < small && small < large && large < largest, "{small} {large} {largest}");
        assert!((0.05..0.3).contains(&largest), "{largest}");
    }

    #[test]
    fn nothing_moves_on_a_river_or_far_from_the_coast() {
        let recipe = link::read("land=island&aspect=1.5").unwrap();
        let land = Land::of(&recipe).unwrap();
        let shore = land.regions()[0].shores[0].at;
        let line: Vec<_> = (-40..40).map(|i| (shore + Vec2::new(i as f32 * 0.9, i as f32 * 0.4), 1.7)).collect();
        let detail = detail(6.7, std::slice::from_ref(&line)).unwrap();
        for (at, half) in line.into_iter().filter(|(at, _)| at.distance(shore) < 4.0) {
            for aside in (-10..=10).map(|i| Vec2::new(-0.4, 0.9).normalize() * (i as f32 * 0.1 * half)) {
                assert_eq!(detail.shift(at + aside, 0.0, 1.0), (0.0, Vec2::ZERO), "{}", at + aside);
            }
        }
        assert!(
            places().all(|at| detail.shift(at, REACH, 1.0).0 == 0.0 && detail.shift(at, -REACH - 1.0, 1.0).0 == 0.0)
        );
    }

    #[test]
    fn slopes_are_those_of_the_heights() {
        let detail = detail(6.7, &[]).unwrap();
        for at in places().step_by(17) {
            const STEP: f32 = 0.01;
            let height = |at: Vec2| detail.shift(at, 0.0, 1.0).0;
            let [east, south] =
                [Vec2::X, Vec2::Y].map(|way| (height(at + way * STEP) - height(at - way * STEP)) / (2.0 * STEP));
            let rise = detail.shift(at, 0.0, 1.0).1;
            assert!((rise - Vec2::new(east, south)).length() < 0.05, "{at}: {rise}, not {east}, {south}");
        }
    }
}
