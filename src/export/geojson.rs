//! GeoJSON (RFC 7946): a line a river, a polygon a lake, with what is known of them as properties.
//!
//! The domain lies around the null meridian and the equator, a unit being a hundredth of a degree (some 1.1 km), north up;
//! degrees are rounded to five places, heights to whole metres above the sea. A tributary's last position is one of its
//! parent's, to the digit.

use glam::Vec2;

use super::banks::{Banks, Width};
use super::value::Value;
use super::{ExportError, rivers};
use crate::domain::Domain;
use crate::network::{NONE, Network, hydrology};
use crate::recipe::link;
use crate::session::Session;

/// A session's rivers as they are: a feature collection, ready to be written.
///
/// # Errors
/// If there are no rivers yet, or the memory is not to be had.
pub fn collection(session: &Session) -> Result<Value<'_>, ExportError> {
    const BYTES_A_VERTEX: usize = 16;
    let network = rivers(session, BYTES_A_VERTEX)?;
    let parameters = session.network_parameters();
    let elevations = hydrology::elevations(network, parameters.everything);
    let features = Features { network, domain: parameters.domain, elevations };
    let lakes: Vec<(u32, Vec<Vec2>)> = (0..)
        .zip(&network.oxbows)
        .filter_map(|(id, oxbow)| Some((id, Banks::of_lake(oxbow, Width::Own { more: 0.0 }).simple_ring()?)))
        .collect();
    let count = network.rivers.len();
    let all = count + lakes.len();
    let feature = move |i: usize| match lakes.get(i.wrapping_sub(count)) {
        Some((id, ring)) => features.lake(*id, ring),
        None => features.river(i as u32),
    };
    Ok(Value::Object(vec![
        ("type", Value::Text("FeatureCollection")),
        // The link of the recipe.
        ("riverseed", Value::Owned(link::write(session.recipe()))),
        ("features", Value::list(all, feature)),
    ]))
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

struct Features<'a> {
    network: &'a Network,
    domain: Domain,
    elevations: Vec<f32>,
}

impl<'a> Features<'a> {
    fn river(&self, id: u32) -> Value<'a> {
        let (network, river) = (self.network, &self.network.rivers[id as usize]);
        let junction = (river.joins != NONE).then_some(river.joins as usize);
        let mut line: Vec<[f64; 3]> = river.own().chain(junction).map(|vertex| self.position(vertex)).collect();
        if let [only] = line[..] {
            line.push(only); // A line has two positions at least.
        }
        let line = Value::list(line.len(), move |i| Value::doubles(line[i].to_vec()));
        let properties = vec![
            ("kind", Value::Text("river")),
            ("id", Value::whole(id)),
            ("parent", Value::unless(river.parent, NONE)),
            ("mouth", Value::whole(self.mouth(id))),
            ("order", Value::whole(river.order.into())),
            ("magnitude", Value::whole(river.magnitude)),
            ("discharge", Value::whole(network.discharge(river))),
            ("length", Value::Double(rounded(network.length(river), 100.0, 100.0))),
            ("sinuosity", Value::Double(rounded(network.sinuosity(river), 1000.0, 1000.0))),
        ];
        feature(format!("river-{id}"), "LineString", line, properties)
    }

    fn lake(&self, id: u32, ring: &[Vec2]) -> Value<'a> {
        let oxbow = &self.network.oxbows[id as usize];
        let ring: Vec<[f64; 2]> = ring.iter().map(|&at| self.degrees(at)).collect();
        let properties = vec![
            ("kind", Value::Text("oxbow")),
            ("id", Value::whole(id)),
            ("river", Value::whole(oxbow.river)),
            ("born", Value::whole(oxbow.born)),
        ];
        let rings = Value::list(1, move |_| {
            let ring = ring.clone();
            Value::list(ring.len(), move |i| Value::doubles(ring[i].to_vec()))
        });
        feature(format!("oxbow-{id}"), "Polygon", rings, properties)
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

fn feature<'a>(
    id: String,
    kind: &'static str,
    coordinates: Value<'a>,
    properties: Vec<(&'static str, Value<'a>)>,
) -> Value<'a> {
    let geometry = vec![("type", Value::Text(kind)), ("coordinates", coordinates)];
    Value::Object(vec![
        ("type", Value::Text("Feature")),
        ("id", Value::Owned(id)),
        ("geometry", Value::Object(geometry)),
        ("properties", Value::Object(properties)),
    ])
}

/// A number to so many parts, written in a unit that has so many of them.
fn rounded(x: f32, parts: f64, to_unit: f64) -> f64 {
    // Adding 0 takes the sign off it.
    (f64::from(x) * parts).round() / to_unit + 0.0
}
