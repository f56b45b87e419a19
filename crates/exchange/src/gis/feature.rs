//! A feature of a map: its shape and its properties, with places in metres.

use riverseed::export::Json;

/// A place: metres east and north of the map's centre, and metres over the sea where that is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub east: f64,
    pub north: f64,
    pub height: Option<f64>,
}

/// The shape of a feature.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    Point(Place),
    Line(Vec<Place>),
    Polygon(Vec<Vec<Place>>),
    MultiPolygon(Vec<Vec<Vec<Place>>>),
}

/// A river, a lake, a piece of land and so on.
pub struct Feature<'a> {
    pub shape: Shape,
    pub properties: Vec<(&'static str, Json<'a>)>,
}

impl<'a> Feature<'a> {
    /// Returns the value of a property.
    pub fn property(&self, name: &str) -> Option<&Json<'a>> {
        self.properties.iter().find(|(own, _)| *own == name).map(|(_, value)| value)
    }

    /// Returns the kind of the feature, such as `river`.
    pub fn kind(&self) -> &str {
        match self.property("kind") {
            Some(Json::Text(kind)) => kind,
            Some(Json::Owned(kind)) => kind,
            _ => "",
        }
    }
}
