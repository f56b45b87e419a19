//! The coordinates of geographic information systems: metres east and north of the map's centre.
//!
//! The map lies nowhere on Earth, so its system is an engineering one: a plane with a unit and two axes, and no datum. Tools that
//! know no such system can have another, in which the map's centre is the origin: a projected one, or none at all.

use std::fmt;
use std::str::FromStr;

use riverseed::domain::Domain;
use riverseed::export::degrees::METRES_A_DEGREE;
use riverseed::glam::Vec2;
use riverseed::scale::MapScale;
use thiserror::Error;

/// The name of the map's own system.
pub const NAME: &str = "Riverseed map, metres from its centre";

/// The number of the map's own system in a GeoPackage: the first that belongs to no authority.
pub const NUMBER: i32 = 100_000;

/// The number in a GeoPackage of a plane that says nothing of itself.
const UNDEFINED: i32 = -1;

/// The coordinate system that a file says it has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Crs {
    /// The map's own, a plane in metres without a datum.
    #[default]
    Own,
    /// No system: bare numbers.
    Unknown,
    /// A projected system in metres, by its number in the EPSG dataset.
    Epsg(Projected),
}

/// A projected system in metres whose definition is known here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Projected(u16);

/// The reason why a text names no coordinate system.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "must be none, or EPSG: and the number of a projected system in metres: 32601 to 32660 or 32701 to 32760 (UTM, north and \
     south), 3395 (World Mercator), 3857 (Web Mercator) or 6933 (equal area)"
)]
pub struct UnknownCrs;

impl FromStr for Crs {
    type Err = UnknownCrs;

    fn from_str(text: &str) -> Result<Self, UnknownCrs> {
        let text = text.to_ascii_lowercase();
        if text == "none" {
            return Ok(Self::Unknown);
        }
        let digits = text.strip_prefix("epsg:").filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()));
        let projected = digits.and_then(|digits| digits.parse().ok()).map(Projected);
        projected.filter(|projected| projected.definition().is_some()).map(Self::Epsg).ok_or(UnknownCrs)
    }
}

impl fmt::Display for Crs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Own => f.write_str(NAME),
            Self::Unknown => f.write_str("none"),
            Self::Epsg(Projected(number)) => write!(f, "EPSG:{number}"),
        }
    }
}

impl Crs {
    /// Returns the number of the system in a GeoPackage.
    pub fn number(self) -> i32 {
        match self {
            Self::Own => NUMBER,
            Self::Unknown => UNDEFINED,
            Self::Epsg(Projected(number)) => number.into(),
        }
    }

    /// Writes the row of the system in a GeoPackage: its name, its organization and its definition as well-known text of the first
    /// version, which all readers know. `None` if every GeoPackage has the row.
    pub fn row(self) -> Option<(String, &'static str, String)> {
        match self {
            Self::Own => {
                let definition =
                    format!(r#"LOCAL_CS["{NAME}",UNIT["metre",1],AXIS["Easting",EAST],AXIS["Northing",NORTH]]"#);
                Some((NAME.into(), "NONE", definition))
            }
            Self::Unknown => None,
            Self::Epsg(projected) => projected.definition().map(|(name, definition)| (name, "EPSG", definition)),
        }
    }
}

impl Projected {
    /// Returns the number in the EPSG dataset.
    pub fn number(self) -> u16 {
        self.0
    }

    /// Writes the name and the definition.
    fn definition(self) -> Option<(String, String)> {
        let (name, projection, more) = match self.0 {
            code @ (32_601..=32_660 | 32_701..=32_760) => {
                let (zone, is_south) = (code % 100, code > 32_700);
                let letter = if is_south { 'S' } else { 'N' };
                let parameters = [
                    ("latitude_of_origin", "0".into()),
                    ("central_meridian", (i32::from(zone) * 6 - 183).to_string()),
                    ("scale_factor", "0.9996".into()),
                    ("false_easting", "500000".into()),
                    ("false_northing", if is_south { "10000000" } else { "0" }.into()),
                ];
                (format!("WGS 84 / UTM zone {zone}{letter}"), "Transverse_Mercator", parameters.to_vec())
            }
            3395 => ("WGS 84 / World Mercator".into(), "Mercator_1SP", mercator()),
            3857 => ("WGS 84 / Pseudo-Mercator".into(), "Mercator_1SP", mercator()),
            6933 => {
                let parameters = [("standard_parallel_1", "30".into()), ("central_meridian", "0".into())];
                let parameters = parameters.into_iter().chain(no_offset()).collect();
                ("WGS 84 / NSIDC EASE-Grid 2.0 Global".into(), "Cylindrical_Equal_Area", parameters)
            }
            _ => return None,
        };
        let parameters: Vec<String> =
            more.iter().map(|(name, value): &(&str, String)| format!(r#"PARAMETER["{name}",{value}],"#)).collect();
        // Web Mercator takes the ellipsoid for a sphere, which only this says.
        let sphere = if self.0 == 3857 {
            r#"EXTENSION["PROJ4","+proj=merc +a=6378137 +b=6378137 +lat_ts=0 +lon_0=0 +x_0=0 +y_0=0 +k=1 +units=m +nadgrids=@null +wktext +no_defs"],"#
        } else {
            ""
        };
        let definition = format!(
            r#"PROJCS["{name}",{WGS_84},PROJECTION["{projection}"],{}UNIT["metre",1,AUTHORITY["EPSG","9001"]],AXIS["Easting",EAST],AXIS["Northing",NORTH],{sphere}AUTHORITY["EPSG","{}"]]"#,
            parameters.concat(),
            self.0,
        );
        Some((name, definition))
    }
}

const WGS_84: &str = r#"GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AUTHORITY["EPSG","4326"]]"#;

fn mercator() -> Vec<(&'static str, String)> {
    [("central_meridian", "0".into()), ("scale_factor", "1".into())].into_iter().chain(no_offset()).collect()
}

fn no_offset() -> [(&'static str, String); 2] {
    ["false_easting", "false_northing"].map(|name| (name, "0".into()))
}

/// Converts GeoJSON's degrees to metres.
pub fn metres_of_degrees(degrees: f64) -> f64 {
    degrees * METRES_A_DEGREE + 0.0
}

/// Converts a place of the map in units, south down, to metres east and north of its centre.
pub fn place(domain: &Domain, scale: &MapScale, at: Vec2) -> [f64; 2] {
    let half = domain.size.as_dvec2() * 0.5;
    let from_centre = (at.as_dvec2() - half) * scale.metres_a_unit;
    [from_centre.x, -from_centre.y]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn system_is_none_or_a_projected_one_in_metres() {
        assert_eq!("none".parse(), Ok(Crs::Unknown));
        for code in (32_601..=32_660).chain(32_701..=32_760).chain([3395, 3857, 6933]) {
            let crs: Crs = format!("EPSG:{code}").parse().unwrap();
            assert_eq!((crs, crs.number()), (Crs::Epsg(Projected(code)), code.into()));
            assert_eq!(crs.to_string().to_lowercase().parse(), Ok(crs));
            let (name, organization, definition) = crs.row().unwrap();
            assert_eq!(organization, "EPSG");
            assert!(definition.starts_with(&format!("PROJCS[\"{name}\",")), "{definition}");
            assert!(definition.ends_with(&format!("AUTHORITY[\"EPSG\",\"{code}\"]]")), "{definition}");
        }
        for text in
            ["", "32633", "EPSG:", "EPSG:4326", "EPSG:32600", "EPSG:32661", "EPSG:+32633", "EPSG:99932633", "own"]
        {
            assert_eq!(text.parse::<Crs>(), Err(UnknownCrs), "{text}");
        }
    }
}
