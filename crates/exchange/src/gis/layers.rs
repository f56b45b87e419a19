//! The layers of a map and their columns: those of a GeoPackage, and the kinds of features in GeoJSON. Documents have their table
//! from here.

/// A layer.
pub struct Layer {
    /// The name in a GeoPackage.
    pub name: &'static str,
    /// What it holds, as a sentence.
    pub description: &'static str,
    /// The type of its shapes in SQL.
    pub geometry: &'static str,
    /// `true` if places have heights.
    pub has_heights: bool,
    /// The kinds of GeoJSON's features that are in it.
    pub kinds: &'static [&'static str],
    /// Its columns, without the shape.
    pub columns: &'static [Column],
}

/// A column.
pub struct Column {
    /// Its name, and that of the property in GeoJSON.
    pub name: &'static str,
    /// What its values are.
    pub of: Of,
    /// What it says, for documents.
    pub help: &'static str,
}

/// The values of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// A whole number.
    Whole,
    /// A number.
    Real,
    /// A text.
    Text,
}

impl Of {
    /// Returns the type in SQL.
    pub const fn sql(self) -> &'static str {
        match self {
            Self::Whole => "INTEGER",
            Self::Real => "REAL",
            Self::Text => "TEXT",
        }
    }
}

const fn column(name: &'static str, of: Of, help: &'static str) -> Column {
    Column { name, of, help }
}

const fn whole(name: &'static str, help: &'static str) -> Column {
    column(name, Of::Whole, help)
}

const fn real(name: &'static str, help: &'static str) -> Column {
    column(name, Of::Real, help)
}

/// The column that every layer has.
pub const KEY: Column = whole("key", "no other feature of the map has the same, of whatever kind");

/// The layers, from the ground up.
pub static LAYERS: [Layer; 11] = [
    Layer {
        name: "land",
        description: "The pieces of land, the largest first; lakes at the sea's level are holes.",
        geometry: "POLYGON",
        has_heights: false,
        kinds: &["land"],
        columns: &[whole("number", "counted from 0"), KEY],
    },
    Layer {
        name: "lakes",
        description: "The lakes at the sea's level, the largest first, then those along rivers, with the islands in them as holes.",
        geometry: "POLYGON",
        has_heights: false,
        kinds: &["water"],
        columns: &[
            whole("number", "counted from 0"),
            whole("land", "the piece of land that it is a hole of, null if it lies along a river"),
            whole("lake", "the `id` of the JSON form, null if it lies at the sea's level"),
            whole("river", "the river that runs out of it, null if it lies at the sea's level"),
            real("level_m", "the height of its water over the sea, null if it lies at the sea's level"),
            real("depth_m", "its greatest depth, null if it lies at the sea's level"),
            real("area_m2", "its area, null if it lies at the sea's level"),
            column("name", Of::Text, "its name, null if it has none"),
            KEY,
        ],
    },
    Layer {
        name: "deltas",
        description: "The land that rivers have built into the sea, which is part of the land.",
        geometry: "MULTIPOLYGON",
        has_heights: false,
        kinds: &["delta"],
        columns: &[
            whole("number", "its place in the JSON form"),
            whole("river", "the river that built it"),
            real("area_m2", "its area"),
            KEY,
        ],
    },
    Layer {
        name: "basins",
        description: "The basins of the rivers that reach the sea.",
        geometry: "MULTIPOLYGON",
        has_heights: false,
        kinds: &["basin"],
        columns: &[
            whole("number", "as in the raster of basins"),
            whole("mouth", "the river at whose mouth it ends"),
            real("area_m2", "its area"),
            KEY,
        ],
    },
    Layer {
        name: "oxbow_lakes",
        description: "The lakes that rivers have left.",
        geometry: "POLYGON",
        has_heights: false,
        kinds: &["oxbow"],
        columns: &[
            whole("number", "the `id` of the JSON form"),
            whole("river", "the river that left it"),
            whole("born", "the round of meandering in which it was cut off"),
            KEY,
        ],
    },
    Layer {
        name: "distributaries",
        description: "The branches of rivers in their deltas, each from where it begins.",
        geometry: "LINESTRING",
        has_heights: false,
        kinds: &["distributary"],
        columns: &[
            whole("number", "the `id` of the JSON form"),
            whole("river", "the river that divides"),
            whole("parent", "the branch that it is one of the two arms of, null if it begins where the river divides"),
            real("share", "the share of the river's water that it carries"),
            KEY,
        ],
    },
    Layer {
        name: "rivers",
        description: "The rivers, source first, with heights in metres over the sea that never rise downstream.",
        geometry: "LINESTRING",
        has_heights: true,
        kinds: &["river"],
        columns: &[
            whole("number", "what `parent`, `mouth` and `river` refer to: the `id` of the JSON form"),
            whole("parent", "the river that it joins, null if it reaches the sea"),
            whole("mouth", "the river through whose mouth its water reaches the sea"),
            whole("order", "Strahler's order at its end"),
            whole("magnitude", "Shreve's magnitude at its end"),
            whole("discharge", "what it drains, at its end"),
            real("length_m", "its length"),
            real("width_m", "how wide a river of nature is that drains as much land, at its end"),
            real("sinuosity", "length over the straight distance from source to end"),
            column("name", Of::Text, "its name, null if the recipe takes it away"),
            column("kind_name", Of::Text, "what kind of river the name says, such as `River`, `Beck` or `Fork`"),
            KEY,
        ],
    },
    Layer {
        name: "segments",
        description: "The rivers cut at their confluences: a graph whose pieces are the river systems.",
        geometry: "LINESTRING",
        has_heights: true,
        kinds: &["segment"],
        columns: &[
            whole("number", "counted from 1"),
            whole("from_node", "the source or confluence at which it begins"),
            whole("to_node", "the confluence or mouth at which it ends"),
            whole("next", "the segment downstream, 0 at the sea"),
            whole("river", "the river that it is a part of"),
            whole("order", "Strahler's order"),
            whole("magnitude", "Shreve's magnitude: the number of sources upstream"),
            whole("discharge", "what it drains, at its end"),
            whole("lateral", "how much of its discharge comes from no segment"),
            real("length_m", "its length"),
            real("width_m", "how wide a river of nature is that drains as much land, at its end"),
            real("area_m2", "the area of its catchment, with all that lies upstream"),
            KEY,
        ],
    },
    Layer {
        name: "reaches",
        description: "The meandering stretches of great rivers that have a name of their own.",
        geometry: "LINESTRING",
        has_heights: false,
        kinds: &["reach"],
        columns: &[
            whole("number", "that of its river"),
            whole("river", "the river that it is a part of"),
            column("reach_name", Of::Text, "its name"),
            KEY,
        ],
    },
    Layer {
        name: "ridges",
        description: "The ridges of the recipe.",
        geometry: "LINESTRING",
        has_heights: false,
        kinds: &["ridge"],
        columns: &[whole("number", "counted from 0"), KEY],
    },
    Layer {
        name: "places",
        description: "A point in the midst of each place that has a name.",
        geometry: "POINT",
        has_heights: false,
        kinds: &["sea", "gulf", "lake", "island", "bay", "cape", "strait", "range"],
        columns: &[
            column("kind", Of::Text, "what it is"),
            whole("number", "one that the place keeps; no two of a kind have the same"),
            column("name", Of::Text, "its name, null if the recipe takes it away"),
            KEY,
        ],
    },
];
