//! Ragged coasts: notches and headlands where a coast would run as if drawn with a ruler.
//!
//! The noise of a land's form leaves some coasts straight for long, above all where the ground falls evenly to the sea. What is
//! straight for more than a few waves gets waves of its own, from the noise of coasts' detail; all else stays as it is.

use glam::Vec2;

use super::cell::Cell;
use super::coast_distance::CoastDistance;
use super::kinds::Shape;
use crate::base::geometry::smooth_step;
use crate::base::gradient_noise::noise;
use crate::base::random::{ItemHash, Purpose};
use crate::base::work;

/// The distance from the coast within which heights change, in units.
const NEAR: f32 = 12.0;

/// Waves of the coast: the number of their noise, half their length and their height, in units.
const WAVES: [(u32, f32, f32); 2] = [(100, 15.0, 5.0), (101, 4.5, 3.2)];

/// The depth of notches about which waves rise and fall, in units.
const DEEP: f32 = 2.5;

/// The way in which straight coasts of a land are ragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ragged {
    hash: ItemHash,
    /// From 0, not at all, to 1.
    amount: f32,
}

impl Ragged {
    /// Makes the raggedness of a shape: the rougher its coasts are to be, the more.
    pub fn of(shape: &Shape) -> Self {
        /// The roughness from which on straight coasts are as ragged as can be.
        const ROUGH: f32 = 0.5;
        Self { hash: shape.seed.item_hash(Purpose::CoastDetail), amount: (shape.roughness / ROUGH).min(1.0) }
    }

    /// Bites notches into straight stretches of a [settled](CoastDistance::settled) coast. Land only shrinks: so no strait closes,
    /// and a river that ended at the coast still does.
    pub fn applied(&self, lattice: CoastDistance) -> CoastDistance {
        let mut heights = lattice.heights().to_vec();
        work::count(2 * heights.len());
        for (corner, height) in heights.iter_mut().enumerate().filter(|(_, height)| height.abs() < NEAR) {
            *height -= self.bite(&lattice, lattice.corner(corner), *height);
        }
        let bitten = lattice.with_heights_of(&heights);
        for pond in bitten.regions(Cell::Water) {
            if bitten.corners_of(&pond).all(|corner| lattice.heights()[corner] > 0.0) {
                bitten.corners_of(&pond).for_each(|corner| heights[corner] = lattice.heights()[corner]);
            }
        }
        lattice.with_heights_of(&heights)
    }

    /// Returns the depth of the notch at a place at a distance from the coast, in units. It is that of the nearest place on the
    /// coast, so heights still rise all the way inland.
    fn bite(&self, lattice: &CoastDistance, at: Vec2, distance: f32) -> f32 {
        let inland = inland(lattice, at);
        let coast = at - inland * distance;
        let share = self.amount * straightness(lattice, coast, inland) * (1.0 - distance.abs() / NEAR);
        if share <= 0.0 {
            return 0.0;
        }
        let wave = |&(number, half, high): &(u32, f32, f32)| high * noise(self.hash, number, coast / half).0;
        share * (DEEP + WAVES.iter().map(wave).sum::<f32>()).max(0.0)
    }
}

/// Returns the direction inland at a place, over so long a way that small waves of the coast do not turn it.
fn inland(lattice: &CoastDistance, at: Vec2) -> Vec2 {
    const STEP: f32 = 10.0;
    let rise = |axis: Vec2| lattice.height(at + axis * STEP) - lattice.height(at - axis * STEP);
    Vec2::new(rise(Vec2::X), rise(Vec2::Y)).normalize_or_zero()
}

/// Returns the share, from 0 to 1, to which the coast around a place on it is straight, with room to either side: where land or
/// water is narrow nothing may close.
fn straightness(lattice: &CoastDistance, coast: Vec2, inland: Vec2) -> f32 {
    /// The places along the coast that are looked at, in units from the nearest.
    const ALONG: [f32; 6] = [-21.0, -14.0, -7.0, 7.0, 14.0, 21.0];
    /// The distances of these places from the coast up to which it is straight, and from which on it is not, in units.
    const STRAIGHT: f32 = 2.5;
    const BENT: f32 = 5.0;
    /// The way to either side that is looked at, and the distances from the coast there of no room and of enough, in units.
    const ASIDE: f32 = 16.0;
    const ROOM: (f32, f32) = (7.0, 12.0);
    work::count(12);
    let off = ALONG.map(|along| lattice.height(coast + inland.perp() * along).abs()).into_iter().fold(0.0, f32::max);
    if off >= BENT {
        return 0.0;
    }
    let room = lattice.height(coast + inland * ASIDE).min(-lattice.height(coast - inland * ASIDE));
    smooth_step((BENT - off) / (BENT - STRAIGHT)) * smooth_step((room - ROOM.0) / (ROOM.1 - ROOM.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Seed;

    const SIZE: f32 = 400.0;

    /// Land whose distance from the coast a function gives.
    #[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
    fn land(distance: impl Fn(Vec2) -> f32) -> CoastDistance {
        let columns = (SIZE / CoastDistance::SPACING) as usize + 2;
        let at = |i: usize| Vec2::new((i % columns) as f32, (i / columns) as f32) * CoastDistance::SPACING;
        let heights = (0..columns * columns).map(|i| distance(at(i))).collect();
        CoastDistance::of_heights(Vec2::splat(SIZE), CoastDistance::SPACING, heights).unwrap()
    }

    fn ragged(amount: f32) -> Ragged {
        Ragged { hash: Seed::from_text("kauri").item_hash(Purpose::CoastDetail), amount }
    }

    /// The least and the greatest y at which water ends, seen from the north.
    fn coast(land: &CoastDistance) -> [f32; 2] {
        let shore = |x: i32| (0..800).map(|y| y as f32 * 0.5).find(|&y| land.height(Vec2::new(x as f32, y)) > 0.0);
        (20..380).filter_map(shore).fold([SIZE, 0.0], |[least, most], y| [y.min(least), y.max(most)])
    }

    #[test]
    fn a_straight_coast_gets_waves_and_a_smooth_one_that_is_asked_for_stays() {
        let straight = land(|at| at.y - 200.0);
        let [least, most] = coast(&ragged(1.0).applied(straight.clone()));
        assert!(most - least > 3.5 && most - least < 14.0, "{least} to {most}");
        assert_eq!(ragged(0.0).applied(straight.clone()), straight);
    }

    #[test]
    fn land_only_shrinks_and_no_pond_comes_to_be() {
        let straight = land(|at| at.y - 200.0);
        let after = ragged(1.0).applied(straight.clone());
        assert!(after.heights().iter().zip(straight.heights()).all(|(after, before)| after <= before));
        assert_eq!(after.regions(Cell::Water).len(), 1);
    }

    #[test]
    fn coasts_with_waves_of_their_own_and_narrow_waters_stay() {
        let bays = land(|at| at.y - 200.0 - 8.0 * libm::sinf(at.x / 8.0));
        let strait = land(|at| (at.y - 200.0).abs() - 4.0);
        for as_it_is in [strait, bays.settled()] {
            let after = ragged(1.0).applied(as_it_is.clone());
            let inner = |lattice: &CoastDistance| {
                (5..20)
                    .flat_map(|x| (5..36).map(move |y| Vec2::new(x as f32, y as f32) * 10.0))
                    .map(|at| lattice.height(at))
                    .sum::<f32>()
            };
            assert!((inner(&after) - inner(&as_it_is)).abs() < 20.0);
        }
    }
}
