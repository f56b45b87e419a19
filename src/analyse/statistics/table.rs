//! The table of measures: their names, their meaning, and the values of natural rivers.

use super::Measures;
use crate::scale::MapScale;

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

impl Measure {
    /// Returns its value as it is told, and the unit of that: lengths are in kilometres.
    pub fn told(&self, measures: &Measures, scale: &MapScale) -> (Option<f64>, &'static str) {
        let (value, kilometres) = ((self.value)(measures), scale.metres_a_unit / 1000.0);
        match self.unit {
            "units" => (value.map(|units| units * kilometres), "km"),
            "per unit" => (value.map(|per_unit| per_unit / kilometres), "km per km\u{b2}"),
            unit => (value, unit),
        }
    }
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

impl Nature {
    /// Returns `true` if a value lies in nature's range, whose ends belong to it.
    pub fn holds(&self, value: f64) -> bool {
        (self.least..=self.most).contains(&value)
    }
}

/// Median and range over the river basins that growth was compared with.
const fn basins(median: f64, least: f64, most: f64) -> Option<Nature> {
    Some(Nature { median: Some(median), least, most, source: "11 river basins" })
}

/// Median and range over eight dozens of pieces of the world's maps, each dozen measured like a map.
const fn pieces(median: f64, least: f64, most: f64) -> Option<Nature> {
    Some(Nature { median: Some(median), least, most, source: "96 pieces of the world's maps, by the dozen" })
}

/// All measures.
pub static TABLE: [Measure; 36] = [
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
        name: "area-exponent",
        label: "Exponent of areas",
        help: "the power by which places of the greatest basin become rarer the more land drains to them",
        unit: "",
        places: 2,
        nature: Some(Nature { median: None, least: 0.40, most: 0.46, source: "Rodriguez-Iturbe and others 1992" }),
        value: |measures| measures.area_exponent,
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
        name: "upstream-bends",
        label: "Bends that lean upstream",
        help: "the share of bends longer than 1.5 times their chord that curve most upstream of their middle",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.bends.upstream,
    },
    Measure {
        name: "wavelength-spread",
        label: "Spread of wavelengths",
        help: "the standard deviation of the logarithm of the wavelengths of the greatest rivers' bends",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.bends.wavelength_spread,
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
    Measure {
        name: "tributary-angle",
        label: "Tributary angle",
        help: "the median angle at which rivers of order 1 join others, measured in the same way",
        unit: "degrees",
        places: 0,
        nature: None,
        value: |measures| measures.tributary_angle,
    },
    Measure {
        name: "junction-spacing",
        label: "Junction spacing",
        help: "length of river per junction, over the mean distance of lines",
        unit: "",
        places: 2,
        nature: pieces(4.01, 3.03, 5.23),
        value: |measures| measures.look.junction_spacing,
    },
    Measure {
        name: "nearest-line",
        label: "Nearest line",
        help: "the mean cosine of twice the angle to the nearest other line: 1 for parallels, -1 for combs",
        unit: "",
        places: 2,
        nature: pieces(-0.02, -0.14, 0.15),
        value: |measures| measures.look.nearest_line,
    },
    Measure {
        name: "turn-kurtosis",
        label: "Kurtosis of turns",
        help: "3 where all bends are alike, higher where straight reaches change with elbows",
        unit: "",
        places: 1,
        nature: pieces(4.1, 3.8, 4.6),
        value: |measures| measures.look.turn_kurtosis,
    },
    Measure {
        name: "turn-autocorrelation",
        label: "Autocorrelation of turns",
        help: "how turns go with those half a line distance farther: -1 if each is undone, 0 if they have nothing in common",
        unit: "",
        places: 2,
        nature: pieces(-0.01, -0.09, 0.0),
        value: |measures| measures.look.turn_autocorrelation,
    },
    Measure {
        name: "gap-variation",
        label: "Unevenness of gaps",
        help: "distances of land from the nearest line: standard deviation over mean",
        unit: "",
        places: 3,
        nature: pieces(0.748, 0.729, 0.769),
        value: |measures| measures.look.gap_variation,
    },
    Measure {
        name: "anisotropy",
        label: "Grain of pieces",
        help: "how far the lines of a small piece of the map run in one direction, from 0 to 1",
        unit: "",
        places: 2,
        nature: pieces(0.32, 0.18, 0.39),
        value: |measures| measures.look.anisotropy,
    },
    Measure {
        name: "knots",
        label: "Knots",
        help: "places with three rivers or more within a spacing that do not join there",
        unit: "per 1,000 spacings",
        places: 1,
        nature: None,
        value: |measures| measures.knots,
    },
    Measure {
        name: "hooks",
        label: "Hooks",
        help: "the share of brooks of order 1 that turn by over 120 degrees within two and a half spacings",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.hooks,
    },
    Measure {
        name: "beside",
        label: "Beside the valley",
        help: "the share of length whose bed lies above the ground beside it, by over 1 % of the summit",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.beside,
    },
    Measure {
        name: "grain",
        label: "Grain",
        help: "how far all lines run in one direction, either way, from 0 to 1",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.directions.map(|of| of.grain),
    },
    Measure {
        name: "cross-grain",
        label: "Cross-grain",
        help: "the same for two directions at right angles",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.directions.map(|of| of.cross_grain),
    },
    Measure {
        name: "flow",
        label: "Common flow",
        help: "how far all water runs one way, from 0 to 1",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.directions.map(|of| of.flow),
    },
    Measure {
        name: "direction-entropy",
        label: "Entropy of directions",
        help: "how evenly directions are spread, from 0 to 1 if all are alike",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.directions.map(|of| of.entropy),
    },
    Measure {
        name: "radial",
        label: "Radial",
        help: "how far rivers run to or from the middle: 0.5 for any directions, 1 for spokes",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.directions.map(|of| of.radial),
    },
    Measure {
        name: "outward",
        label: "Outward",
        help: "how far water runs away from the middle, from -1 to 1",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.directions.map(|of| of.outward),
    },
    Measure {
        name: "coast-dimension",
        label: "Dimension of coasts",
        help: "by what power boxes along the coasts become more as they become smaller, from 64 units to 4",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.waters.coast_dimension,
    },
    Measure {
        name: "lake-share",
        label: "Share under lakes",
        help: "the share of the land that is under lakes along rivers",
        unit: "",
        places: 3,
        nature: None,
        value: |measures| Some(measures.waters.lake_share),
    },
    Measure {
        name: "lake-exponent",
        label: "Exponent of lakes",
        help: "the power by which lakes along rivers become rarer the larger they are",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.waters.lake_exponent,
    },
    Measure {
        name: "deltas",
        label: "Great mouths with a delta",
        help: "the share that have a delta, of the twelve greatest mouths at least a twelfth as wide as the widest",
        unit: "",
        places: 2,
        nature: None,
        value: |measures| measures.waters.deltas,
    },
];
