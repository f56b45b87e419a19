//! GeoJSON (RFC 7946): a line for each river and each branch of one, a polygon for each lake and delta, with their data as properties.
//!
//! Every feature has a `key`, its place in the list, counted from 1: a number that no other has, whatever its kind, as vector
//! tiles keep it. `bbox` is the map's own frame, that of its picture.
//!
//! The domain lies around the null meridian and the equator, with north up, as wide as the recipe's span. Degrees are rounded to a
//! thousandth of a unit or less, heights to whole metres above the sea. A tributary's last position is
//! one of its parent's, to the digit. Lakes are valid as written, after rounding: rings run counterclockwise and
//! neither cross nor touch themselves. A lake whose banks cross is made narrower or shorter; one narrower than the last
//! decimal place is left out.

use glam::Vec2;

use super::data::{Json, Members};
use super::degrees::DegreeGrid;
use super::names::{self, Feature as Named};
use super::polygons::{Polygon, inside_out, is_in, polygons};
use super::rings::GridPoint;
use super::{ExportError, rivers};
use crate::analyse::statistics::Drained;
use crate::annotate::names::Names;
use crate::deltas::{Delta, Distributary};
use crate::domain::Domain;
use crate::lakes::Lake;
use crate::land::SmoothedDistance;
use crate::map::Map;
use crate::network::Banks;
use crate::network::{NONE, Network, hydrology};
use crate::recipe::link;
use crate::relief::{CELL_SIZE, Flow, Relief};
use crate::scale::MapScale;

/// Makes a feature collection of a map's rivers and the land around them, ready to be written.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn collection(map: &Map) -> Result<Json<'_>, ExportError> {
    named(map, Names::of(map))
}

/// Makes the collection without names; digests of maps without names use it.
pub(crate) fn unnamed(map: &Map) -> Result<Json<'_>, ExportError> {
    named(map, Names::default())
}

fn named(map: &Map, names: Names) -> Result<Json<'_>, ExportError> {
    const BYTES_A_VERTEX: usize = 16;
    let network = rivers(map, BYTES_A_VERTEX)?;
    let relief = map.make_relief()?;
    let surface = map.lakes().surface(&relief);
    // If a river passes another one's bend, its cell may be lower than the cells below it.
    let elevations = hydrology::upward(network, |i, below| surface[relief.cell(network.vertices[i].at)].max(below));
    let (domain, scale) = (map.domain(), map.scale());
    let grid = DegreeGrid::of(domain.size, &scale);
    let features = Features { network, domain, scale, grid, drained: Drained::of(map), elevations, names };
    let ground = Ground::new(map, &features, &relief)?;
    let mut oxbows = Vec::new();
    for (id, oxbow) in (0..).zip(&network.oxbows) {
        if let Some(ring) = Banks::of_lake(oxbow, 0.0).simple_ring(|at| grid.steps(at)) {
            oxbows.push((id, ring));
        }
    }
    let parts = [
        (Part::River, network.rivers.len()),
        (Part::Oxbow, oxbows.len()),
        (Part::Basin, ground.basins.len()),
        (Part::Land, ground.land.len()),
        (Part::Water, ground.water.len()),
        (Part::Lake, ground.lakes.len()),
        (Part::Delta, ground.deltas.len()),
        (Part::Distributary, map.deltas().distributaries.len()),
        (Part::Ridge, map.land().map_or(0, |land| land.ridges().len())),
        (Part::Named, features.named()),
    ];
    let mut collection = Members::default();
    collection.text("type", "FeatureCollection").owned("riverseed", link::write_for_file(map.recipe()));
    collection.value("bbox", Json::doubles(features.frame()));
    names::title(&mut collection, &features.names);
    let feature = move |i: usize| {
        let (part, at) = part(&parts, i);
        let feature = match part {
            Part::River => features.river(at as u32),
            Part::Oxbow => features.oxbow(oxbows[at].0, &oxbows[at].1),
            Part::Basin => ground.basin(at, &features),
            Part::Land => ground.land(at, grid),
            Part::Water => ground.water(at, &features),
            Part::Lake => ground.lake(at, map, &features),
            Part::Delta => ground.delta(at, map, &features),
            Part::Distributary => features.distributary(&map.deltas().distributaries[at]),
            Part::Ridge => features.ridge(map, at),
            Part::Named => features.name(at),
        };
        feature.with_key(i as u32 + 1)
    };
    let all = parts.iter().map(|(_, count)| count).sum();
    collection.value("features", Json::list(all, feature));
    Ok(collection.into())
}

/// Writes the rivers of a map.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
#[cfg(feature = "json")]
pub fn write(out: impl std::io::Write, map: &Map) -> std::io::Result<()> {
    let collection = collection(map).map_err(std::io::Error::other)?;
    Ok(serde_json::to_writer(out, &collection)?)
}

/// The parts of a collection, in the order in which they are written.
#[derive(Clone, Copy)]
enum Part {
    River,
    Oxbow,
    Basin,
    Land,
    Water,
    Lake,
    Delta,
    Distributary,
    Ridge,
    Named,
}

/// Finds the part that feature `i` of all is in, and its place there.
fn part(parts: &[(Part, usize)], mut i: usize) -> (Part, usize) {
    for &(part, count) in parts {
        if i < count {
            return (part, i);
        }
        i -= count;
    }
    (Part::Named, i)
}

struct Features<'a> {
    network: &'a Network,
    domain: Domain,
    scale: MapScale,
    grid: DegreeGrid,
    drained: Drained,
    elevations: Vec<f32>,
    names: Names,
}

impl<'a> Features<'a> {
    /// Returns the number of features for names that do not belong to a river.
    fn named(&self) -> usize {
        self.names.reaches.len() + self.names.places.len()
    }

    fn name(&self, i: usize) -> Feature<'a> {
        match names::feature(&self.names, i) {
            Named::Line(id, course, properties) => {
                let line = positions(course.iter().map(|at| self.degrees(*at)).collect());
                Feature { id, shape: "LineString", coordinates: line, properties }
            }
            Named::Point(id, at, properties) => {
                Feature { id, shape: "Point", coordinates: Json::doubles(self.degrees(at).to_vec()), properties }
            }
        }
    }

    /// Returns the western, southern, eastern and northern border of the map.
    fn frame(&self) -> Vec<f64> {
        let size = self.domain.size;
        [Vec2::new(0.0, size.y), Vec2::new(size.x, 0.0)].into_iter().flat_map(|corner| self.degrees(corner)).collect()
    }

    fn river(&self, id: u32) -> Feature<'a> {
        let (network, river) = (self.network, &self.network.rivers[id as usize]);
        let junction = (river.junction != NONE).then_some(river.junction as usize);
        let mut line: Vec<[f64; 3]> =
            river.vertex_range().chain(junction).map(|vertex| self.position(vertex)).collect();
        if let [only] = line[..] {
            line.push(only); // A line has two positions at least.
        }
        let mut properties = Members::default();
        properties
            .text("kind", "river")
            .whole("number", id)
            .unless("parent", river.parent, NONE)
            .whole("mouth", self.mouth(id))
            .whole("order", river.order.into())
            .whole("magnitude", river.magnitude)
            .whole("discharge", network.discharge(river))
            .double("length_m", self.scale.metres(network.length(river)).round())
            .double("width_m", rounded(self.drained.river_width(network.discharge(river)) as f32, 100.0, 100.0))
            .double("sinuosity", rounded(network.sinuosity(river), 1000.0, 1000.0));
        names::river_feature(&mut properties, self.names.rivers.get(id as usize));
        Feature { id: format!("river-{id}"), shape: "LineString", coordinates: positions(line), properties }
    }

    fn distributary(&self, branch: &Distributary) -> Feature<'a> {
        let mut properties = Members::default();
        properties.text("kind", "distributary").whole("number", branch.id).whole("river", branch.river);
        match branch.parent {
            Some(parent) => properties.whole("parent", parent),
            None => properties.value("parent", Json::Null),
        };
        properties.double("share", rounded(branch.share, 1000.0, 1000.0));
        let line = branch.line.iter().map(|place| self.degrees(place.at)).collect();
        let id = format!("distributary-{}", branch.id);
        Feature { id, shape: "LineString", coordinates: positions(line), properties }
    }

    fn ridge(&self, map: &Map, i: usize) -> Feature<'a> {
        let line = map.land().and_then(|land| land.ridges().get(i)).map_or(&[][..], Vec::as_slice);
        let mut properties = Members::default();
        properties.text("kind", "ridge").whole("number", i as u32);
        let line = line.iter().map(|at| self.degrees(*at)).collect();
        Feature { id: format!("ridge-{i}"), shape: "LineString", coordinates: positions(line), properties }
    }

    fn oxbow(&self, id: u32, ring: &[GridPoint]) -> Feature<'a> {
        let oxbow = &self.network.oxbows[id as usize];
        let ring: Vec<[f64; 2]> = ring.iter().map(|at| self.grid.degrees(*at)).collect();
        let mut properties = Members::default();
        properties.text("kind", "oxbow").whole("number", id).whole("river", oxbow.river).whole("born", oxbow.born);
        let rings = Json::list(1, move |_| positions(ring.clone()));
        Feature { id: format!("oxbow-{id}"), shape: "Polygon", coordinates: rings, properties }
    }

    /// Returns the number of the river through whose mouth a river's water reaches the sea.
    fn mouth(&self, mut id: u32) -> u32 {
        while let Some(river) = self.network.rivers.get(id as usize).filter(|river| river.parent != NONE) {
            id = river.parent;
        }
        id
    }

    fn position(&self, vertex: usize) -> [f64; 3] {
        let [east, north] = self.degrees(self.network.vertices[vertex].at);
        [east, north, rounded(self.elevations[vertex] * self.scale.metres_up, 1.0, 1.0)]
    }

    fn degrees(&self, at: Vec2) -> [f64; 2] {
        self.grid.degrees(self.grid.steps(at))
    }
}

/// The land around the rivers, as polygons.
struct Ground {
    /// The connected pieces of land.
    land: Vec<Polygon>,
    /// The lakes at the sea's level, which are the holes of the land, with the islands in them as holes.
    water: Vec<Polygon>,
    /// The lakes along rivers, each with its index among those of the map.
    lakes: Vec<(usize, Polygon)>,
    /// The parts of the land that rivers have built, each with the index of its delta among those of the map.
    deltas: Vec<(usize, Vec<Polygon>)>,
    /// For each basin with a cell: its number, the river at whose mouth it ends, its area in square units, and its
    /// parts.
    basins: Vec<(u32, u32, f32, Vec<Polygon>)>,
}

impl Ground {
    fn new(map: &Map, features: &Features, relief: &Relief) -> Result<Self, ExportError> {
        // North is up here, so the left side of a line stays the left side.
        let on_grid = |rings: Vec<Vec<Vec2>>| {
            polygons(rings.into_iter().map(|ring| ring.into_iter().map(|at| features.grid.steps(at)).collect()))
        };
        let size = map.domain().size;
        let land = match map.land() {
            Some(land) => SmoothedDistance::of(land.coast_distance()).rings_above(0.0),
            None => vec![vec![Vec2::ZERO, Vec2::new(0.0, size.y), size, Vec2::new(size.x, 0.0)]],
        };
        let flow = Flow::new(relief, features.network, &map.relief_settings())?;
        let mut areas = vec![0.0; flow.mouths.len() + 1];
        flow.basins.iter().for_each(|&basin| areas[basin as usize] += CELL_SIZE * CELL_SIZE);
        let basins = (1..).zip(&flow.mouths).zip(flow.basin_rings(&relief.grid()));
        let basins = basins.map(|((number, &mouth), rings)| (number, mouth, areas[number as usize], on_grid(rings)));
        let (land, basins) = (on_grid(land), basins.filter(|basin| !basin.3.is_empty()).collect());
        // A lake narrower than the last decimal place somewhere is more than one polygon, of which the first is the largest.
        let lake = |(i, lake): (usize, &Lake)| Some((i, on_grid(lake.rings.clone()).into_iter().next()?));
        let lakes = map.lakes().list.iter().enumerate().filter_map(lake).collect();
        let delta = |(i, delta): (usize, &Delta)| (i, on_grid(delta.rings.clone()));
        let deltas = map.deltas().list.iter().enumerate().map(delta).filter(|(_, parts)| !parts.is_empty()).collect();
        Ok(Self { water: inside_out(&land), lakes, land, deltas, basins })
    }

    fn land<'a>(&self, i: usize, grid: DegreeGrid) -> Feature<'a> {
        let mut properties = Members::default();
        properties.text("kind", "land").whole("number", i as u32);
        let coordinates = parts(self.land[i].clone(), grid);
        Feature { id: format!("land-{i}"), shape: "Polygon", coordinates, properties }
    }

    fn water<'a>(&self, i: usize, features: &Features<'a>) -> Feature<'a> {
        let lake = &self.water[i];
        let is_around = |land: &Polygon| land[1..].iter().any(|hole| hole.contains(&lake[0][0]));
        let land = self.land.iter().position(is_around).unwrap_or_default();
        let is_here = |at: Vec2| is_in(&lake[0], features.grid.steps(at));
        let mut properties = Members::default();
        properties.text("kind", "water").whole("number", i as u32).whole("land", land as u32);
        names::lake(&mut properties, &features.names, is_here);
        Feature {
            id: format!("water-{i}"),
            shape: "Polygon",
            coordinates: parts(lake.clone(), features.grid),
            properties,
        }
    }

    /// Writes a lake along rivers, numbered after those at the sea's level.
    fn lake<'a>(&self, i: usize, map: &Map, features: &Features<'a>) -> Feature<'a> {
        let ((id, polygon), scale) = (&self.lakes[i], features.scale);
        let (lake, number) = (&map.lakes().list[*id], self.water.len() + i);
        let is_here = |at: Vec2| map.lakes().at(at) == Some(*id);
        let mut properties = Members::default();
        properties
            .text("kind", "water")
            .whole("number", number as u32)
            .whole("lake", *id as u32)
            .whole("river", lake.outlet.river)
            .double("level_m", rounded(lake.level * scale.metres_up, 1.0, 1.0))
            .double("depth_m", rounded(lake.depth * scale.metres_up, 1.0, 1.0))
            .double("area_m2", scale.square_metres(lake.area.into()).round());
        names::lake(&mut properties, &features.names, is_here);
        let coordinates = parts(polygon.clone(), features.grid);
        Feature { id: format!("water-{number}"), shape: "Polygon", coordinates, properties }
    }

    fn delta<'a>(&self, i: usize, map: &Map, features: &Features<'a>) -> Feature<'a> {
        let (id, polygons) = self.deltas[i].clone();
        let delta = &map.deltas().list[id];
        let mut properties = Members::default();
        properties.text("kind", "delta").whole("number", id as u32).whole("river", delta.river);
        properties.double("area_m2", features.scale.square_metres(delta.area.into()).round());
        let grid = features.grid;
        let coordinates = Json::list(polygons.len(), move |i| parts(polygons[i].clone(), grid));
        Feature { id: format!("delta-{id}"), shape: "MultiPolygon", coordinates, properties }
    }

    fn basin<'a>(&self, i: usize, features: &Features<'a>) -> Feature<'a> {
        let (grid, scale) = (features.grid, features.scale);
        let (number, mouth, area, polygons) = self.basins[i].clone();
        let mut properties = Members::default();
        properties.text("kind", "basin").whole("number", number).whole("mouth", mouth);
        properties.double("area_m2", scale.square_metres(area.into()).round());
        let coordinates = Json::list(polygons.len(), move |i| parts(polygons[i].clone(), grid));
        Feature { id: format!("basin-{number}"), shape: "MultiPolygon", coordinates, properties }
    }
}

/// Writes the rings of a polygon as lists of degrees.
fn parts<'a>(polygon: Polygon, grid: DegreeGrid) -> Json<'a> {
    let count = polygon.len();
    let ring = move |i: usize| positions(polygon[i].iter().map(|at: &GridPoint| grid.degrees(*at)).collect());
    Json::list(count, ring)
}

fn positions<'a, const N: usize>(line: Vec<[f64; N]>) -> Json<'a> {
    Json::list(line.len(), move |i| Json::doubles(line[i].to_vec()))
}

/// A feature before it has its key.
struct Feature<'a> {
    id: String,
    /// The type of its geometry.
    shape: &'static str,
    coordinates: Json<'a>,
    properties: Members<'a>,
}

impl<'a> Feature<'a> {
    fn with_key(self, key: u32) -> Json<'a> {
        let Self { id, shape, coordinates, mut properties } = self;
        properties.whole("key", key);
        let mut geometry = Members::default();
        geometry.text("type", shape).value("coordinates", coordinates);
        let mut feature = Members::default();
        feature.text("type", "Feature").owned("id", id).object("geometry", geometry).object("properties", properties);
        feature.into()
    }
}

/// Rounds a number to a fraction of its unit, and converts it to another unit.
fn rounded(x: f32, parts: f64, to_unit: f64) -> f64 {
    // Adding 0 turns −0 into 0.
    (f64::from(x) * parts).round() / to_unit + 0.0
}
