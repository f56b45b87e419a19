//! The map's features, read from what GeoJSON is written from, with places in metres.

use std::io::Result;

use riverseed::Map;
use riverseed::export::Json;

use super::crs::metres_of_degrees;
use super::feature::{Feature, Place, Shape};
use super::geojson::{self as own, items, members, number};

/// The features of a map, with its link and title.
#[derive(Default)]
pub struct Collection<'a> {
    pub link: String,
    pub title: Option<String>,
    pub features: Vec<Feature<'a>>,
}

impl<'a> Collection<'a> {
    /// Reads the features of a map, segments among them.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn of(map: &'a Map) -> Result<Self> {
        let mut collection = Self::default();
        for (name, value) in members(own::collection(map, true, false)?) {
            match (name, value) {
                ("riverseed", value) => collection.link = text(value).unwrap_or_default(),
                ("title", value) => collection.title = text(value),
                ("features", value) => collection.features = items(value).into_iter().filter_map(feature).collect(),
                _ => {}
            }
        }
        Ok(collection)
    }
}

fn feature(feature: Json<'_>) -> Option<Feature<'_>> {
    let (mut shape, mut properties) = (None, Vec::new());
    for (name, value) in members(feature) {
        match name {
            "geometry" => shape = shape_of(value),
            "properties" => properties = members(value),
            _ => {}
        }
    }
    Some(Feature { shape: shape?, properties })
}

fn shape_of(geometry: Json<'_>) -> Option<Shape> {
    let (mut kind, mut coordinates) = (None, Json::Null);
    for (name, value) in members(geometry) {
        match name {
            "type" => kind = text(value),
            "coordinates" => coordinates = value,
            _ => {}
        }
    }
    match kind.as_deref() {
        Some("Point") => place(coordinates).map(Shape::Point),
        Some("LineString") => Some(Shape::Line(line(coordinates))),
        Some("Polygon") => Some(Shape::Polygon(rings(coordinates))),
        Some("MultiPolygon") => Some(Shape::MultiPolygon(items(coordinates).into_iter().map(rings).collect())),
        _ => None,
    }
}

fn rings(json: Json<'_>) -> Vec<Vec<Place>> {
    items(json).into_iter().map(line).collect()
}

fn line(json: Json<'_>) -> Vec<Place> {
    items(json).into_iter().filter_map(place).collect()
}

fn place(json: Json<'_>) -> Option<Place> {
    let numbers: Vec<f64> = items(json).iter().filter_map(number).collect();
    let [east, north] = [*numbers.first()?, *numbers.get(1)?].map(metres_of_degrees);
    Some(Place { east, north, height: numbers.get(2).copied() })
}

fn text(json: Json<'_>) -> Option<String> {
    match json {
        Json::Text(text) => Some(text.into()),
        Json::Owned(text) => Some(text),
        _ => None,
    }
}
