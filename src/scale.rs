//! The scale of a map: the one place that says how large things are in kilometres and metres.
//!
//! A recipe's `span` is how many kilometres its map is wide. Everything else follows from it: what a unit is on the ground, what a unit of
//! height is, and how wide a river is that drains so much land. Nothing drawn depends on it but what tells a size.

use crate::domain::Domain;
use crate::recipe::{NumberKey, Recipe};

/// The metres of a unit of height on a map of the usual span. Pictures of all spans colour heights by these, or small countries would be
/// all of one colour.
pub const USUAL_METRES: f32 = 25.0;
/// The span on which a unit of height has these metres, in kilometres.
const USUAL_SPAN: f32 = 200.0;
/// The exponent of the span in heights: mountains of a country ten times as wide are two and a half times as high.
const RISE: f32 = 0.4;

/// The real sizes of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapScale {
    /// The metres of a unit on the ground.
    pub metres_a_unit: f64,
    /// The metres of a unit of height, to a centimetre.
    pub metres_up: f32,
}

impl MapScale {
    /// Returns the scale of a recipe's map.
    pub fn of(recipe: &Recipe) -> Self {
        let span = recipe.number(NumberKey::Span);
        let metres_up = USUAL_METRES * libm::powf(span / USUAL_SPAN, RISE);
        Self {
            metres_a_unit: f64::from(span) * 1000.0 / f64::from(Domain::of(recipe).size.x),
            metres_up: (metres_up * 100.0).round() / 100.0,
        }
    }

    /// Converts a length from units to metres.
    pub fn metres(&self, units: f32) -> f64 {
        f64::from(units) * self.metres_a_unit
    }

    /// Converts an area from square units to square metres.
    pub fn square_metres(&self, square_units: f64) -> f64 {
        square_units * self.metres_a_unit * self.metres_a_unit
    }

    /// Converts a length from units to kilometres.
    pub fn kilometres(&self, units: f32) -> f32 {
        (self.metres(units) / 1000.0) as f32
    }

    /// Converts an area from square units to square kilometres.
    pub fn square_kilometres(&self, square_units: f64) -> f64 {
        self.square_metres(square_units) / 1e6
    }

    /// Converts a length from kilometres to units.
    pub fn units(&self, kilometres: f32) -> f32 {
        (f64::from(kilometres) * 1000.0 / self.metres_a_unit) as f32
    }
}

/// Returns the width of a river that drains so many square kilometres, in metres: 7.2 √Q for a mean discharge of Q m³/s (Moody and Troutman
/// 2002, Earth Surface Processes and Landforms 27, 1251-1266), with the mean runoff of all land, 299 mm a year (Fekete, Vörösmarty and
/// Grabs 2002, Global Biogeochemical Cycles 16).
pub fn river_width(square_kilometres: f64) -> f64 {
    /// Cubic metres a second of a square kilometre.
    const RUNOFF: f64 = 0.009_475;
    7.2 * (square_kilometres.max(0.0) * RUNOFF).sqrt()
}

/// Returns the greatest of 1, 2, 5, 10, 20 … kilometres that is no longer than a length; 1 if none is.
pub fn round_length(kilometres: f32) -> f32 {
    let (mut round, mut steps) = (1.0f32, [2.0, 2.5, 2.0].into_iter().cycle());
    // Longer than any map.
    while round < 1e5 {
        let next = round * steps.next().unwrap_or(2.0);
        if next > kilometres {
            break;
        }
        round = next;
    }
    round
}

/// Writes a number of kilometres: whole ones, and below ten with a decimal place.
pub fn figures(kilometres: f32) -> String {
    let tenths = (kilometres * 10.0 + 0.5) as u32;
    // (Printing floats would weigh a fifth of a page's download.)
    if tenths < 100 && !tenths.is_multiple_of(10) {
        format!("{}.{}", tenths / 10, tenths % 10)
    } else {
        ((kilometres + 0.5) as u32).to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(link: &str) -> MapScale {
        MapScale::of(&format!("country=usual&{link}").parse().unwrap())
    }

    #[test]
    fn a_map_is_as_wide_as_its_span_whatever_its_shape() {
        for span in ["10", "37.5", "200", "5000"] {
            for aspect in ["0.25", "1", "1.6", "4"] {
                let recipe: Recipe = format!("span={span}&aspect={aspect}").parse().unwrap();
                let (scale, size) = (MapScale::of(&recipe), Domain::of(&recipe).size);
                let (span, height): (f32, f32) = (span.parse().unwrap(), size.y / size.x);
                assert!((scale.kilometres(size.x) / span - 1.0).abs() < 1e-6, "{recipe:?}");
                assert!((scale.units(span) / size.x - 1.0).abs() < 1e-6);
                let area = scale.square_kilometres(f64::from(size.x) * f64::from(size.y));
                assert!((area as f32 / (span * span * height) - 1.0).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn heights_rise_with_the_span_to_the_power_of_two_fifths() {
        let up = ["10", "33", "115", "200", "480", "5000"].map(|span| scale(&format!("span={span}")).metres_up);
        assert_eq!(up, [7.54, 12.16, 20.04, 25.0, 35.48, 90.6]);
        assert_eq!(scale("").metres_up, USUAL_METRES);
        assert_eq!(scale("span=480&aspect=0.5").metres_up, 35.48);
    }

    #[test]
    fn widths_of_rivers_are_those_of_the_world() {
        // A brook, the Thames at Teddington, the Rhine at Emmerich, the Mississippi: between half and twice as wide.
        for (area, width) in [(10.0, 3.0), (9_950.0, 70.0), (160_000.0, 330.0), (2_980_000.0, 1_000.0)] {
            assert!((0.5..=2.0).contains(&(river_width(area) / width)), "{area}: {}", river_width(area));
        }
        assert_eq!(river_width(-1.0), 0.0);
    }

    #[test]
    fn round_lengths_are_ones_twos_and_fives() {
        let lengths = [0.0, 1.0, 1.9, 2.0, 4.9, 5.0, 9.9, 10.0, 33.2, 199.0, 200.0, 830.0, 4_999.0];
        let round = [1.0, 1.0, 1.0, 2.0, 2.0, 5.0, 5.0, 10.0, 20.0, 100.0, 200.0, 500.0, 2_000.0];
        assert_eq!(lengths.map(round_length), round);
        assert!(round_length(f32::INFINITY).is_finite() && round_length(f32::NAN).is_finite());
    }

    #[test]
    fn short_lengths_have_a_decimal_place() {
        let lengths = [0.0, 0.04, 0.25, 1.0, 2.5, 9.94, 9.96, 10.4, 41.5, 1_234.5];
        assert_eq!(lengths.map(figures), ["0", "0", "0.3", "1", "2.5", "9.9", "10", "10", "42", "1235"]);
    }
}
