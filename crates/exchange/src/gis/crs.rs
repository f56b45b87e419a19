//! The coordinates of geographic information systems: metres east and north of the map's centre.
//!
//! The map lies nowhere on Earth, so its system is an engineering one: a plane with a unit and two axes, and no datum.

use riverseed::domain::Domain;
use riverseed::glam::Vec2;

/// The length of a unit of the map in metres, as the scale bar and GeoJSON have it: a hundredth of a degree of the
/// equator. Everything else here that depends on the scale takes it from here.
pub const METRES_A_UNIT: f64 = 1113.2;

/// The name of the system.
pub const NAME: &str = "Riverseed map, metres from its centre";

/// The number of the system in a GeoPackage: the first that belongs to no authority.
pub const NUMBER: i32 = 100_000;

/// Writes the system as well-known text of the first version, which all readers know.
pub fn well_known_text() -> String {
    format!(r#"LOCAL_CS["{NAME}",UNIT["metre",1],AXIS["Easting",EAST],AXIS["Northing",NORTH]]"#)
}

/// Converts GeoJSON's degrees to metres. A hundred-thousandth of a degree, its last digit, is a thousandth of a unit.
pub fn metres_of_degrees(degrees: f64) -> f64 {
    (degrees * 100_000.0).round() * (METRES_A_UNIT / 1000.0) + 0.0
}

/// Converts a place of the map in units, south down, to metres east and north of its centre.
pub fn place(domain: &Domain, at: Vec2) -> [f64; 2] {
    let half = domain.size.as_dvec2() * 0.5;
    let from_centre = (at.as_dvec2() - half) * METRES_A_UNIT;
    [from_centre.x, -from_centre.y]
}
