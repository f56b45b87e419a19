//! The costs of a label's shape and of the ink under it.

use glam::Vec2;

/// The cosine of 16 degrees, the most between two letters.
pub(super) const COS_TURN: f32 = 0.961_261_7;

/// The ink that samples have met.
#[derive(Default)]
pub struct Under {
    pub samples: f32,
    pub hits: f32,
    /// The sum of widths, in units.
    pub width: f32,
}

impl Under {
    pub fn take(&mut self, width: f32) {
        self.samples += 1.0;
        if width > 0.0 {
            self.hits += 1.0;
            self.width += width;
        }
    }
}

/// The turning of type from letter to letter.
#[derive(Default)]
pub struct Turns {
    before: Option<Vec2>,
    turn: Option<f32>,
    /// The sum of all turns, in radians.
    pub sum: f32,
    changes: f32,
}

impl Turns {
    /// Takes the next letter's direction; `None` if it is too far off that of the letter before.
    pub fn take(&mut self, along: Vec2) -> Option<()> {
        if let Some(before) = self.before.replace(along) {
            let (sine, cosine) = (before.perp_dot(along), before.dot(along));
            if cosine < COS_TURN {
                return None;
            }
            // The angle, for angles as small as these.
            let turn = sine * (1.0 + sine * sine / 6.0);
            self.sum += turn.abs();
            self.changes += self.turn.replace(turn).map_or(0.0, |before| (turn - before).abs());
        }
        Some(())
    }

    pub fn cost(&self) -> f32 {
        1.1 * self.sum + 1.2 * self.changes
    }
}

/// Returns how hard a direction is to read: 0 up to 25 degrees, and more if it falls than if it rises.
pub fn steepness(along: Vec2) -> f32 {
    let degrees = libm::atan2f(along.y, along.x).to_degrees();
    let falling = if degrees > 50.0 { 0.25 } else { 0.0 };
    let steep = (degrees.abs() - 25.0).max(0.0) / 65.0 + falling;
    steep * steep
}

#[cfg(test)]
mod tests {
    use super::*;

    fn along(degrees: f32) -> Vec2 {
        let radians = degrees.to_radians();
        Vec2::new(libm::cosf(radians), libm::sinf(radians))
    }

    fn cost(degrees: &[f32]) -> Option<f32> {
        let mut turns = Turns::default();
        degrees.iter().try_for_each(|&degrees| turns.take(along(degrees)))?;
        Some(turns.cost())
    }

    #[test]
    fn straight_type_costs_nothing_and_an_arc_less_than_a_wave() {
        assert!(cost(&[5.0; 6]).is_some_and(|cost| cost < 1e-3));
        let [arc, wave] = [[0.0, 8.0, 16.0, 24.0], [0.0, 8.0, 0.0, 8.0]].map(|degrees| cost(&degrees).unwrap());
        assert!((arc - 1.1 * 24.0f32.to_radians()).abs() < 1e-3 && wave > 2.0 * arc, "{arc}, {wave}");
    }

    #[test]
    fn no_two_letters_turn_by_more_than_16_degrees() {
        assert!(cost(&[0.0, 15.9]).is_some() && cost(&[0.0, 16.1]).is_none());
        assert!(cost(&[0.0, -16.1]).is_none() && cost(&[0.0, 180.0]).is_none());
    }

    #[test]
    fn steep_type_costs_more_if_it_falls() {
        assert_eq!([0.0, 20.0, -25.0].map(|degrees| steepness(along(degrees))), [0.0; 3]);
        assert!(steepness(along(-90.0)) > 0.9 && steepness(along(70.0)) > steepness(along(-70.0)));
    }
}
