//! The layers of a GeoPackage and their columns.

use crate::gis::lakes;

/// A layer.
pub struct Layer {
    pub name: &'static str,
    pub description: &'static str,
    pub geometry: &'static str,
    /// `true` if places have heights.
    pub has_heights: bool,
    pub kinds: Kinds,
    pub columns: &'static [Column],
}

/// The kinds of features in a layer.
pub enum Kinds {
    One(&'static str),
    /// All that have no layer of their own.
    Places,
}

/// A column.
pub struct Column {
    pub name: &'static str,
    /// The property in GeoJSON that it holds.
    pub property: &'static str,
    pub of: Of,
}

/// The values of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    Whole,
    Real,
    Text,
    /// A length, which the property has in units.
    Metres,
    /// An area, which the property has in square units.
    SquareMetres,
}

impl Of {
    /// Returns the type in SQL.
    pub const fn sql(self) -> &'static str {
        match self {
            Self::Whole => "INTEGER",
            Self::Real | Self::Metres | Self::SquareMetres => "REAL",
            Self::Text => "TEXT",
        }
    }
}

impl Kinds {
    /// Returns `true` if features of a kind are in the layer.
    pub fn holds(&self, kind: &str) -> bool {
        match self {
            Self::One(own) => *own == kind,
            Self::Places => !LAYERS.iter().any(|layer| matches!(layer.kinds, Kinds::One(own) if own == kind)),
        }
    }
}

const fn column(name: &'static str, of: Of) -> Column {
    Column { name, property: name, of }
}

const fn whole(name: &'static str) -> Column {
    column(name, Of::Whole)
}

/// The layers, from the ground up.
pub static LAYERS: [Layer; 8] = [
    Layer {
        name: "land",
        description: "The pieces of land, the largest first; lakes at the sea's level are holes.",
        geometry: "POLYGON",
        has_heights: false,
        kinds: Kinds::One("land"),
        columns: &[whole("number")],
    },
    Layer {
        name: "lakes",
        description: "The lakes at the sea's level, with the islands in them as holes.",
        geometry: "POLYGON",
        has_heights: false,
        kinds: Kinds::One(lakes::KIND),
        columns: &[whole("number"), whole("land"), column("name", Of::Text)],
    },
    Layer {
        name: "basins",
        description: "The basins of the rivers that reach the sea.",
        geometry: "MULTIPOLYGON",
        has_heights: false,
        kinds: Kinds::One("basin"),
        columns: &[whole("number"), whole("mouth"), Column { name: "area_m2", property: "area", of: Of::SquareMetres }],
    },
    Layer {
        name: "oxbow_lakes",
        description: "The lakes that rivers have left.",
        geometry: "POLYGON",
        has_heights: false,
        kinds: Kinds::One("oxbow"),
        columns: &[whole("number"), whole("river"), whole("born")],
    },
    Layer {
        name: "rivers",
        description: "The rivers, source first, with heights in metres over the sea that never rise downstream.",
        geometry: "LINESTRING",
        has_heights: true,
        kinds: Kinds::One("river"),
        columns: &[
            whole("number"),
            whole("parent"),
            whole("mouth"),
            whole("order"),
            whole("magnitude"),
            whole("discharge"),
            Column { name: "length_m", property: "length", of: Of::Metres },
            column("sinuosity", Of::Real),
            column("name", Of::Text),
            column("kind_name", Of::Text),
        ],
    },
    Layer {
        name: "reaches",
        description: "The meandering stretches of great rivers that have a name of their own.",
        geometry: "LINESTRING",
        has_heights: false,
        kinds: Kinds::One("reach"),
        columns: &[whole("number"), whole("river"), column("reach_name", Of::Text)],
    },
    Layer {
        name: "ridges",
        description: "The ridges of the recipe.",
        geometry: "LINESTRING",
        has_heights: false,
        kinds: Kinds::One("ridge"),
        columns: &[whole("number")],
    },
    Layer {
        name: "places",
        description: "A point in the midst of each place that has a name.",
        geometry: "POINT",
        has_heights: false,
        kinds: Kinds::Places,
        columns: &[column("kind", Of::Text), whole("number"), column("name", Of::Text)],
    },
];
