//! The table of measures: their names, their meaning, and the values of natural rivers.

use super::Measures;

/// One of the measures.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Measure {
    /// Its name in JSON.
    pub name: &'static str,
    /// Its label.
    pub label: &'static str,
    /// A one-line explanation.
    pub help: &'static str,
    /// Its unit; empty if it is a pure number.
    pub unit: &'static str,
    /// Number of significant decimal places.
    pub places: usize,
    /// The values of natural rivers; `None` if they cannot be compared with a map's.
    pub nature: Option<Nature>,
    /// Its value; `None` if the network is too small.
    pub value: fn(&Measures) -> Option<f64>,
}

/// The values of a measure in nature.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Nature {
    /// The median, if it is known.
    pub median: Option<f64>,
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub most: f64,
    /// The source of the values.
    pub source: &'static str,
}

/// Median and range over the river basins that growth was compared with.
const fn basins(median: f64, least: f64, most: f64) -> Option<Nature> {
    Some(Nature { median: Some(median), least, most, source: "11 river basins" })
}

/// All measures.
pub static TABLE: [Measure; 13] = [
    Measure {
        name: "bifurcation-ratio",
        label: "Bifurcation ratio",
        help: "Horton's: how many times as many streams there are of each order as of the next",
        unit: "",
        places: 2,
        nature: basins(4.1, 3.5, 5.2),
        value: |measures| measures.bifurcation_ratio,
    },
    Measure {
        name: "length-ratio",
        label: "Length ratio",
        help: "Horton's: how many times as long streams are as those of the order below",
        unit: "",
        places: 2,
        nature: basins(2.0, 1.3, 2.5),
        value: |measures| measures.length_ratio,
    },
    Measure {
        name: "tokunaga-t1",
        label: "Tokunaga's T1",
        help: "how many side branches of the order below its own a stream has",
        unit: "",
        places: 2,
        nature: basins(1.1, 0.8, 2.0),
        value: |measures| measures.tokunaga_t1,
    },
    Measure {
        name: "tokunaga-c",
        label: "Tokunaga's c",
        help: "by what factor side branches grow in number with each order that they are lower",
        unit: "",
        places: 2,
        nature: basins(2.9, 1.8, 3.3),
        value: |measures| measures.tokunaga_c,
    },
    Measure {
        name: "hack-exponent",
        label: "Hack's exponent",
        help: "the power of a basin's area that the length of its longest river grows by",
        unit: "",
        places: 2,
        nature: basins(0.67, 0.54, 0.69),
        value: |measures| measures.hack_exponent,
    },
    Measure {
        name: "sinuosity",
        label: "Sinuosity",
        help: "length over the straight line from source to end: the median of rivers of order 2 and higher",
        unit: "",
        places: 2,
        nature: basins(1.32, 1.21, 1.54),
        value: |measures| measures.sinuosity,
    },
    Measure {
        name: "drainage-density",
        label: "Drainage density",
        help: "length of river per area of land",
        unit: "per unit",
        places: 4,
        nature: None,
        value: |measures| Some(measures.drainage_density),
    },
    Measure {
        name: "density-per-spacing",
        label: "Density per spacing",
        help: "the same times a spacing",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| Some(measures.density_per_spacing),
    },
    Measure {
        name: "junction-angle",
        label: "Junction angle",
        help: "the mean angle between two rivers above their junction, three spacings upstream",
        unit: "degrees",
        places: 0,
        nature: Some(Nature {
            median: None,
            least: 45.0,
            most: 72.0,
            source: "dry to wet land: Seybold and others 2017",
        }),
        value: |measures| measures.junction_angles.map(|angles| angles.mean),
    },
    Measure {
        name: "junction-angle-spread",
        label: "Spread of the angles",
        help: "the standard deviation of these angles",
        unit: "degrees",
        places: 0,
        nature: None,
        value: |measures| measures.junction_angles.map(|angles| angles.spread),
    },
    Measure {
        name: "umbrellas",
        label: "Umbrellas",
        help: "trunks of similar size that meet within three widths of a mouth",
        unit: "trunks",
        places: 0,
        nature: None,
        value: |measures| Some(measures.umbrellas.into()),
    },
    Measure {
        name: "parallels",
        label: "Parallels",
        help: "length of pairs of rivers side by side, nearer than two spacings, for more than ten",
        unit: "units",
        places: 0,
        nature: None,
        value: |measures| Some(measures.parallels),
    },
    Measure {
        name: "along-coast",
        label: "Along the coast",
        help: "length of river within a spacing of a coast, but for its way into the sea",
        unit: "units",
        places: 0,
        nature: None,
        value: |measures| Some(measures.along_coast),
    },
];
