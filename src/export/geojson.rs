//! GeoJSON (RFC 7946): a line a river, a polygon a lake, with what is known of them as properties.
//!
//! The domain lies around the null meridian and the equator, a unit being a hundredth of a degree (some 1.1 km), north up;
//! degrees are rounded to five places, heights to whole metres above the sea. A tributary's last position is one of its
//! parent's, to the digit.

use glam::Vec2;
use serde::{Serialize, Serializer};

use super::banks::{Banks, Width};
use super::{ExportError, rivers};
use crate::domain::Domain;
use crate::network::{NONE, Network, Oxbow, River, hydrology};
use crate::recipe::link;
use crate::session::Session;

/// A session's rivers as they are: a feature collection, ready to be written.
///
/// # Errors
/// If there are no rivers yet, or the memory is not to be had.
pub fn collection(session: &Session) -> Result<impl Serialize + '_, ExportError> {
    const BYTES_A_VERTEX: usize = 16;
    let network = rivers(session, BYTES_A_VERTEX)?;
    let parameters = session.network_parameters();
    let elevations = hydrology::elevations(network, parameters.everything);
    let features = Features { network, domain: parameters.domain, elevations };
    Ok(Collection { kind: "FeatureCollection", riverseed: link::write(session.recipe()), features })
}

/// Writes the rivers of a session.
///
/// # Errors
/// If there are no rivers yet, or the memory is not to be had; and those of the writer.
#[cfg(feature = "json")]
pub fn write(out: impl std::io::Write, session: &Session) -> std::io::Result<()> {
    let collection = collection(session).map_err(std::io::Error::other)?;
    Ok(serde_json::to_writer(out, &collection)?)
}

#[derive(Serialize)]
struct Collection<'a> {
    #[serde(rename = "type")]
    kind: &'static str,
    /// The link of the recipe.
    riverseed: String,
    features: Features<'a>,
}

/// The features, made one by one as they are written.
struct Features<'a> {
    network: &'a Network,
    domain: Domain,
    elevations: Vec<f32>,
}

#[derive(Serialize)]
struct Feature {
    #[serde(rename = "type")]
    kind: &'static str,
    id: String,
    geometry: Geometry,
    properties: Properties,
}

#[derive(Serialize)]
#[serde(tag = "type", content = "coordinates")]
enum Geometry {
    /// Longitude, latitude, height.
    LineString(Vec<[f64; 3]>),
    Polygon([Vec<[f64; 2]>; 1]),
}

#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Properties {
    River {
        id: u32,
        /// The river it joins; null if it reaches the sea.
        parent: Option<u32>,
        /// The river in whose mouth its water reaches the sea.
        mouth: u32,
        order: u8,
        magnitude: u32,
        discharge: u32,
        /// In domain units.
        length: f64,
        sinuosity: f64,
    },
    Oxbow {
        id: u32,
        /// The river that left it, and in which round.
        river: u32,
        born: u32,
    },
}

impl Serialize for Features<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rivers = (0..).zip(&self.network.rivers).map(|(id, river)| self.river(id, river));
        let lakes = (0..).zip(&self.network.oxbows).filter_map(|(id, oxbow)| self.lake(id, oxbow));
        serializer.collect_seq(rivers.chain(lakes))
    }
}

impl Features<'_> {
    fn river(&self, id: u32, river: &River) -> Feature {
        let network = self.network;
        let junction = (river.joins != NONE).then_some(river.joins as usize);
        let mut line: Vec<[f64; 3]> = river.own().chain(junction).map(|vertex| self.position(vertex)).collect();
        if let [only] = line[..] {
            line.push(only); // A line has two positions at least.
        }
        let properties = Properties::River {
            id,
            parent: (river.parent != NONE).then_some(river.parent),
            mouth: self.mouth(id),
            order: river.order,
            magnitude: river.magnitude,
            discharge: network.discharge(river),
            length: rounded(network.length(river), 100.0, 100.0),
            sinuosity: rounded(network.sinuosity(river), 1000.0, 1000.0),
        };
        Feature { kind: "Feature", id: format!("river-{id}"), geometry: Geometry::LineString(line), properties }
    }

    fn lake(&self, id: u32, oxbow: &Oxbow) -> Option<Feature> {
        let Banks { left, right } = Banks::of_lake(oxbow, Width::Own { more: 0.0 }).forward();
        // The right bank first: counterclockwise where north is up. Both banks share their ends.
        let mut ring: Vec<[f64; 2]> =
            right.iter().chain(left.iter().rev().skip(1)).map(|&at| self.degrees(at)).collect();
        ring.dedup();
        let properties = Properties::Oxbow { id, river: oxbow.river, born: oxbow.born };
        (ring.len() > 3).then(|| Feature {
            kind: "Feature",
            id: format!("oxbow-{id}"),
            geometry: Geometry::Polygon([ring]),
            properties,
        })
    }

    /// The river in whose mouth a river's water reaches the sea.
    fn mouth(&self, mut id: u32) -> u32 {
        while let Some(river) = self.network.rivers.get(id as usize).filter(|river| river.parent != NONE) {
            id = river.parent;
        }
        id
    }

    fn position(&self, vertex: usize) -> [f64; 3] {
        const METRES_A_UNIT: f32 = 1113.2;
        let [east, north] = self.degrees(self.network.vertices[vertex].at);
        [east, north, rounded(self.elevations[vertex] * METRES_A_UNIT, 1.0, 1.0)]
    }

    fn degrees(&self, at: Vec2) -> [f64; 2] {
        let from_middle = at - self.domain.size * 0.5;
        // A thousandth of a unit is a hundred-thousandth of a degree.
        [from_middle.x, -from_middle.y].map(|x| rounded(x, 1000.0, 100_000.0))
    }
}

/// A number to so many parts, written in a unit that has so many of them.
fn rounded(x: f32, parts: f64, to_unit: f64) -> f64 {
    // Adding 0 takes the sign off it.
    (f64::from(x) * parts).round() / to_unit + 0.0
}
