//! Fjords: where rock is hard, great valleys are troughs as ice leaves them, with a broad level floor between steep
//! walls. The sea fills them far inland as long and narrow inlets of even width.

use glam::Vec2;

use crate::base::geometry::{distance, smooth_step};

/// The trough of the great valley nearest to a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trough {
    /// The distance from the corner to the line of the valley's river, in units; infinite if no trough reaches the corner.
    far: f32,
    /// The area that drains through the valley there, in square units.
    area: f32,
}

/// The drained area from which on valleys are troughs, and that from which on troughs have their full width, in square units.
const AREAS: (f32, f32) = (800.0, 2500.0);

/// The hardness of the ground in which troughs begin, and in which they are complete.
const HARD: (f32, f32) = (0.1, 0.5);

/// Half the width of a floor, in units.
const WIDE: f32 = 6.0;

/// The distance over which a floor becomes a wall, in units: that between corners, so that coasts run smoothly between them.
const RIM: f32 = 4.0;

/// The distance from the rim over which walls become hillsides, in units.
const WALLS: f32 = 14.0;

impl Trough {
    /// The distance from a river up to which its valley may be a trough, in units.
    pub const REACH: f32 = WIDE + WALLS;

    /// No trough.
    pub const NONE: Self = Self { far: f32::INFINITY, area: 0.0 };

    /// Returns the trough along a segment of a river that drains an area, for a corner at `at`; `None` if the river is small.
    pub fn of(area: f32, from: Vec2, to: Vec2, at: Vec2) -> Option<Self> {
        if !Self::is_great(area) {
            return None;
        }
        let way = to - from;
        let share = ((at - from).dot(way) / way.length_squared().max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
        Some(Self { far: distance(from + way * share, at), area })
    }

    /// Returns `true` if valleys that drain an area may be troughs.
    pub fn is_great(area: f32) -> bool {
        area > AREAS.0
    }

    /// Returns the nearer of two troughs.
    pub fn or(self, other: Self) -> Self {
        if other.far < self.far { other } else { self }
    }

    /// Returns the steepness of a corner as a share of a hillside's; `usual` is its steepness without a trough, `flank`
    /// that of ground without a valley.
    pub fn steepness(self, usual: f32, flank: f32, hardness: f32) -> f32 {
        /// The steepness of a floor, as a share of a hillside's.
        const FLOOR: f32 = 0.004;
        /// The distance from a river up to which it may run through a corner, in units.
        const OWN: f32 = 3.0;
        if self.far >= Self::REACH || hardness <= HARD.0 {
            return usual;
        }
        let size = smooth(AREAS, self.area);
        let beyond = (self.far - WIDE * size).max(0.0);
        let wall = if beyond < RIM { flank } else { usual } * (2.0 - (beyond / WALLS).min(1.0));
        let trough = FLOOR + (wall - FLOOR) * (beyond / RIM).min(1.0);
        let trough = if self.far < OWN { trough.min(usual) } else { trough };
        usual + (trough - usual) * size * smooth(HARD, hardness)
    }
}

/// Rises smoothly from 0 to 1 as a value goes through a range.
fn smooth((from, to): (f32, f32), value: f32) -> f32 {
    smooth_step((value - from) / (to - from))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLANK: f32 = 1.15;

    fn trough(area: f32, far: f32) -> Trough {
        Trough::of(area, Vec2::ZERO, Vec2::new(10.0, 0.0), Vec2::new(5.0, far)).unwrap_or(Trough::NONE)
    }

    #[test]
    fn floors_are_level_and_walls_steep_in_hard_ground_alone() {
        let across = |area: f32, hardness: f32| {
            [0.0, 4.0, 5.9, 10.1, 16.0, 20.1].map(|far| trough(area, far).steepness(FLANK, FLANK, hardness))
        };
        let [middle, floor, rim, wall, higher, hillside] = across(3000.0, 1.0);
        assert!(middle < 0.01 && floor == middle && rim == middle, "{middle}, {floor}, {rim}");
        assert!(wall > 1.5 * FLANK && (FLANK..wall).contains(&higher) && hillside == FLANK, "{wall}, {higher}");
        assert_eq!(across(3000.0, 0.1), [FLANK; 6], "in usual ground");
        assert_eq!(across(700.0, 1.0), [FLANK; 6], "of a small river");
        let half = across(3000.0, 0.3);
        assert!(half[0] > 2.0 * middle && half[0] < FLANK, "{half:?}");
    }

    #[test]
    fn the_line_of_a_river_is_never_steeper_than_without_a_trough() {
        for area in [801.0, 1000.0, 1500.0, 9000.0] {
            for hardness in [0.2, 0.4, 2.0] {
                assert!(trough(area, 2.8).steepness(0.03, FLANK, hardness) <= 0.03, "{area}, {hardness}");
            }
        }
    }

    #[test]
    fn the_nearer_valley_counts() {
        let (near, far) = (trough(1000.0, 2.0), trough(9000.0, 3.0));
        assert_eq!((near.or(far), far.or(near), far.or(Trough::NONE)), (near, near, far));
        assert_eq!(Trough::of(9000.0, Vec2::ONE, Vec2::ONE, Vec2::ZERO).unwrap().far, distance(Vec2::ONE, Vec2::ZERO));
    }
}
