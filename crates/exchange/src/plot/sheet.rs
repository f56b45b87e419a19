//! Sheets of paper, and the place of a map on one.

use riverseed::domain::Domain;
use riverseed::glam::{DVec2, Vec2};

/// A sheet of paper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sheet {
    /// 148 by 210 mm.
    A5,
    /// 210 by 297 mm.
    #[default]
    A4,
    /// 297 by 420 mm.
    A3,
    /// 420 by 594 mm.
    A2,
    /// 594 by 841 mm.
    A1,
    /// 8.5 by 11 inches.
    Letter,
}

impl Sheet {
    /// All sheets, the smallest first.
    pub const ALL: [Self; 6] = [Self::A5, Self::A4, Self::Letter, Self::A3, Self::A2, Self::A1];

    /// Returns the name of a sheet, in small letters.
    pub fn name(self) -> &'static str {
        self.row().0
    }

    /// Finds the sheet with this name; `None` if there is none.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|sheet| sheet.name() == name)
    }

    /// Returns the name of a sheet, and its shorter and its longer side in millimetres.
    const fn row(self) -> (&'static str, [f64; 2]) {
        match self {
            Self::A5 => ("a5", [148.0, 210.0]),
            Self::A4 => ("a4", [210.0, 297.0]),
            Self::A3 => ("a3", [297.0, 420.0]),
            Self::A2 => ("a2", [420.0, 594.0]),
            Self::A1 => ("a1", [594.0, 841.0]),
            Self::Letter => ("letter", [215.9, 279.4]),
        }
    }
}

/// The least distance of a map from the edges of its sheet, in millimetres: machines hold the paper there.
pub const MARGIN: f64 = 10.0;

/// The place of a map in the middle of a sheet that lies or stands as the map does.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Width and height of the sheet, in millimetres.
    pub sheet: DVec2,
    /// The north-western and the south-eastern corner of the map, in millimetres from the sheet's north-western one.
    pub frame: [DVec2; 2],
    millimetres_a_unit: f64,
}

impl Placed {
    /// Places a map, as large as the margins allow.
    pub fn on(sheet: Sheet, domain: &Domain) -> Self {
        let (_, [shorter, longer]) = sheet.row();
        let map = domain.size.as_dvec2();
        let sheet = if map.x < map.y { DVec2::new(shorter, longer) } else { DVec2::new(longer, shorter) };
        let millimetres_a_unit = ((sheet - 2.0 * MARGIN) / map).min_element();
        let corner = (sheet - map * millimetres_a_unit) * 0.5;
        Self { sheet, frame: [corner, sheet - corner], millimetres_a_unit }
    }

    /// Converts a place of the map from units to millimetres on the sheet.
    pub fn at(&self, place: Vec2) -> DVec2 {
        self.frame[0] + place.as_dvec2() * self.millimetres_a_unit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_lies_or_stands_as_its_map_does_and_keeps_its_margins() {
        for sheet in Sheet::ALL {
            assert_eq!(Sheet::named(sheet.name()), Some(sheet));
            for aspect in [0.25, 0.7, 1.0, 1.5, 4.0] {
                let placed = Placed::on(sheet, &Domain::with_aspect(aspect));
                let [corner, opposite] = placed.frame;
                assert_eq!(placed.sheet.x < placed.sheet.y, aspect < 1.0);
                assert!((corner.min_element() - MARGIN).abs() < 1e-9, "{corner}");
                assert!(((opposite - corner) - (placed.sheet - 2.0 * corner)).length() < 1e-9);
            }
        }
    }
}
