//! The parameter table: the one place where a parameter is named, ranged, explained and given its default.
//!
//! Links, attributes, command-line options, JSON, the page's controls and `docs/parameters.md` all come from here.
//! Keys are added freely and never renamed: a shared link holds them.
//!
//! The file is long because it is one table: split by groups, its rows could not be read in their order.

use super::choice::{Cartouche, Choice, CourseShape, GrowthMethod, Labels, LandKind, MeanderModel, Scatter, Style};
use super::key::{COUNT, KINDS, Key, KeyKind};
use super::parameter::{Kind, Parameter, Stage};
use super::value::{Decimal, Sides};

/// All parameters, in the order in which links and tables list them; row `i` is that of the key numbered `i`.
pub static TABLE: [Parameter; COUNT] = {
    use Stage::{Grow, Land, Name, Paint, Prune, Relief, Shape};
    const fn number(min: f64, max: f64, step: f64, default: f64) -> Kind {
        let (min, max) = (Decimal::new(min), Decimal::new(max));
        Kind::Number { min, max, step: Decimal::new(step), default: Decimal::new(default) }
    }
    explained([
        Parameter {
            key: Key::Seed,
            name: "seed",
            label: "Seed",
            help: "The word that the rivers grow from: any text.",
            unit: "",
            group: "Seed",
            stage: Land,
            logarithmic: false,
            kind: Kind::Text { longest: 64, default: "kauri" },
        },
        Parameter {
            key: Key::Edition,
            name: "edition",
            label: "Edition",
            help: "The set of algorithms that draws the recipe. Once an edition is released, its pictures never change.",
            unit: "",
            group: "Seed",
            stage: Land,
            logarithmic: false,
            kind: Kind::Integer { min: super::EDITION, max: super::EDITION, default: super::EDITION },
        },
        Parameter {
            key: Key::Aspect,
            name: "aspect",
            label: "Aspect",
            help: "Width of the map over its height. The area is always a million square units.",
            unit: "",
            group: "Land",
            stage: Land,
            logarithmic: true,
            kind: number(0.25, 4.0, 0.01, 1.6),
        },
        Parameter {
            key: Key::Land,
            name: "land",
            label: "Land",
            help: "The shape of the land that rivers run through.",
            unit: "",
            group: "Land",
            stage: Land,
            logarithmic: false,
            kind: Kind::Choice { choices: LandKind::WORDS },
        },
        Parameter {
            key: Key::Outline,
            name: "outline",
            label: "Outline",
            help: "The coasts, ridges and rivers of a drawn land. Without a coast, the whole rectangle is land.",
            unit: "",
            group: "Land",
            stage: Land,
            logarithmic: false,
            kind: Kind::Outline,
        },
        Parameter {
            key: Key::Sea,
            name: "sea",
            label: "Sea",
            help: "Share of the map that is water. No effect if the land is drawn or is the whole rectangle.",
            unit: "",
            group: "Land",
            stage: Land,
            logarithmic: false,
            kind: number(0.1, 0.8, 0.01, 0.55),
        },
        Parameter {
            key: Key::Roughness,
            name: "roughness",
            label: "Roughness",
            help: "Irregularity of coasts and ridges: 0 for smooth lines, 1 for wild ones.",
            unit: "",
            group: "Land",
            stage: Land,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 1.0),
        },
        Parameter {
            key: Key::Mouths,
            name: "mouths",
            label: "River mouths",
            help: "Number of rivers that reach the sea. A lake has three times as many, and every larger island has at least one. 0: automatic (8; with drainage, every outlet).",
            unit: "",
            group: "Land",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 0, max: 64, default: 0 },
        },
        Parameter {
            key: Key::MouthSpacing,
            name: "mouth-spacing",
            label: "Distance between mouths",
            help: "Minimum distance between river mouths along a coast. A large distance means fewer mouths.",
            unit: "units",
            group: "Land",
            stage: Grow,
            logarithmic: false,
            kind: number(0.0, 400.0, 5.0, 0.0),
        },
        Parameter {
            key: Key::Sides,
            name: "sides",
            label: "Sea on",
            help: "Sides of the map where the sea is. Applies to the rectangle, a coast and a valley; the water of other lands is fixed.",
            unit: "",
            group: "Land",
            stage: Land,
            logarithmic: false,
            kind: Kind::Sides { default: Sides::SOUTH },
        },
        Parameter {
            key: Key::Shores,
            name: "shores",
            label: "Mouths on",
            help: "Directions in which river mouths may lie, seen from the middle of the coast.",
            unit: "",
            group: "Land",
            stage: Grow,
            logarithmic: false,
            kind: Kind::Sides { default: Sides::ALL },
        },
        Parameter {
            key: Key::Growth,
            name: "growth",
            label: "Growth",
            help: "Growth method: water drains the land, attractors pull rivers (space colonization), or wandering particles form a Brownian tree.",
            unit: "",
            group: "Growth",
            stage: Grow,
            logarithmic: false,
            kind: Kind::Choice { choices: GrowthMethod::WORDS },
        },
        Parameter {
            key: Key::Sensitivity,
            name: "sensitivity",
            label: "Sensitivity",
            help: "Smallest step of a Brownian tree: about the distance between neighbouring streams.",
            unit: "units",
            group: "Growth",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 8, max: 64, default: 16 },
        },
        Parameter {
            key: Key::Attractors,
            name: "attractors",
            label: "Attractors",
            help: "Number of attractors; with drainage, of land parcels. More make a finer network.",
            unit: "",
            group: "Growth",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 100, max: 1_000_000, default: 20_000 },
        },
        Parameter {
            key: Key::Scatter,
            name: "scatter",
            label: "Scatter",
            help: "Placement of attractors: at random, or one in each cell of a grid, which makes an even network.",
            unit: "",
            group: "Growth",
            stage: Grow,
            logarithmic: false,
            kind: Kind::Choice { choices: Scatter::WORDS },
        },
        Parameter {
            key: Key::Reach,
            name: "reach",
            label: "Reach",
            help: "Distance from which attractors pull. Small: winding rivers. Large: straight ones.",
            unit: "spacings",
            group: "Growth",
            stage: Grow,
            logarithmic: true,
            kind: number(2.1, 12.0, 0.05, 2.3),
        },
        Parameter {
            key: Key::Kill,
            name: "kill",
            label: "Kill distance",
            help: "Attractors are removed once a river comes this close. Smaller values make many short streams.",
            unit: "spacings",
            group: "Growth",
            stage: Grow,
            logarithmic: false,
            kind: number(0.5, 1.4, 0.05, 1.1),
        },
        Parameter {
            key: Key::Step,
            name: "step",
            label: "Step",
            help: "Length by which a river grows in one tick.",
            unit: "spacings",
            group: "Growth",
            stage: Grow,
            logarithmic: false,
            kind: number(0.2, 1.2, 0.01, 0.38),
        },
        Parameter {
            key: Key::Momentum,
            name: "momentum",
            label: "Momentum",
            help: "Exaggerates each turn by subtracting this share of the previous direction. Rivers zigzag from 0.5 on.",
            unit: "",
            group: "Bends",
            stage: Grow,
            logarithmic: false,
            kind: number(0.0, 0.9, 0.01, 0.0),
        },
        Parameter {
            key: Key::Curl,
            name: "curl",
            label: "Curl",
            help: "Maximum random turn of each step. The side alternates every 'stretch' nodes; with valleys it is random, from place to place.",
            unit: "radians",
            group: "Bends",
            stage: Grow,
            logarithmic: false,
            kind: number(0.0, 2.0, 0.01, 0.7),
        },
        Parameter {
            key: Key::Stretch,
            name: "stretch",
            label: "Stretch",
            help: "Number of nodes for which a river curls to one side before it turns to the other; with valleys, how large the places are that have a side of their own.",
            unit: "nodes",
            group: "Bends",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 1, max: 64, default: 8 },
        },
        Parameter {
            key: Key::Valleys,
            name: "valleys",
            label: "Valleys",
            help: "Influence of deep valleys on where water goes: 0 for calm, map-like networks, 1 for wild ones. At 0, space colonization is as in the paper.",
            unit: "",
            group: "Drainage",
            stage: Grow,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.2),
        },
        Parameter {
            key: Key::ValleySpacing,
            name: "valley-spacing",
            label: "Distance between valleys",
            help: "Approximate distance between large valleys.",
            unit: "spacings",
            group: "Drainage",
            stage: Grow,
            logarithmic: true,
            kind: number(4.0, 60.0, 0.5, 32.0),
        },
        Parameter {
            key: Key::Concavity,
            name: "concavity",
            label: "Concavity",
            help: "Rate at which rivers flatten downstream. The flatter large rivers are, the more water they draw.",
            unit: "",
            group: "Drainage",
            stage: Grow,
            logarithmic: false,
            kind: number(0.2, 0.8, 0.01, 0.5),
        },
        Parameter {
            key: Key::Captures,
            name: "captures",
            label: "Rounds of capture",
            help: "Number of rounds in which streams capture one another before they settle.",
            unit: "rounds",
            group: "Drainage",
            stage: Grow,
            logarithmic: false,
            kind: Kind::Integer { min: 0, max: 24, default: 5 },
        },
        Parameter {
            key: Key::Hardness,
            name: "hardness",
            label: "Hardness",
            help: "Contrast between hard and soft ground. Rivers avoid hard ground.",
            unit: "",
            group: "Drainage",
            stage: Grow,
            logarithmic: false,
            kind: number(0.0, 1.5, 0.01, 0.5),
        },
        Parameter {
            key: Key::HardnessScale,
            name: "hardness-scale",
            label: "Size of hard ground",
            help: "Approximate distance between areas of hard ground.",
            unit: "spacings",
            group: "Drainage",
            stage: Grow,
            logarithmic: true,
            kind: number(8.0, 60.0, 0.5, 36.0),
        },
        Parameter {
            key: Key::Bending,
            name: "bending",
            label: "Bending",
            help: "Distance by which courses are bent, at all scales.",
            unit: "spacings",
            group: "Drainage",
            stage: Grow,
            logarithmic: false,
            kind: number(0.0, 4.0, 0.05, 2.0),
        },
        Parameter {
            key: Key::ChannelArea,
            name: "channel-area",
            label: "Channel area",
            help: "Number of parcels that must drain before a river begins. Smaller areas make a denser network.",
            unit: "parcels",
            group: "Drainage",
            stage: Prune,
            logarithmic: true,
            kind: Kind::Integer { min: 1, max: 60, default: 6 },
        },
        Parameter {
            key: Key::Trim,
            name: "trim",
            label: "Trim",
            help: "Side branches shorter than this are removed. The longest branch of every fork stays.",
            unit: "units",
            group: "Finish",
            stage: Prune,
            logarithmic: false,
            kind: number(0.0, 400.0, 1.0, 22.0),
        },
        Parameter {
            key: Key::Courses,
            name: "courses",
            label: "Courses",
            help: "The lines that rivers follow: smooth, or the tree's own steps with every sharp turn.",
            unit: "",
            group: "Rivers",
            stage: Shape,
            logarithmic: false,
            kind: Kind::Choice { choices: CourseShape::WORDS },
        },
        Parameter {
            key: Key::Simplify,
            name: "simplify",
            label: "Simplify",
            help: "Share of each course's points to remove, the least important first. Confluences stay.",
            unit: "%",
            group: "Rivers",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 95.0, 1.0, 35.0),
        },
        Parameter {
            key: Key::Width,
            name: "width",
            label: "Width",
            help: "Width of a river that would drain the whole map. Other widths follow the square root of discharge.",
            unit: "units",
            group: "Rivers",
            stage: Shape,
            logarithmic: true,
            kind: number(1.0, 40.0, 0.5, 16.0),
        },
        Parameter {
            key: Key::BankVariation,
            name: "bank-variation",
            label: "Uneven banks",
            help: "Variation of the width along a river, as a share of the width. The two banks vary independently.",
            unit: "",
            group: "Rivers",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 0.5, 0.01, 0.15),
        },
        Parameter {
            key: Key::Meander,
            name: "meander",
            label: "Meanders",
            help: "Model of meandering: each bend moves by its own curvature, by the curvature upstream as well, or not at all.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: Kind::Choice { choices: MeanderModel::WORDS },
        },
        Parameter {
            key: Key::MeanderRounds,
            name: "meander-rounds",
            label: "Meander time",
            help: "Duration of meandering. Bends grow, necks are cut off, and oxbow lakes stay behind.",
            unit: "rounds",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: Kind::Integer { min: 0, max: 400, default: 18 },
        },
        Parameter {
            key: Key::MeanderStrength,
            name: "meander-strength",
            label: "Strength",
            help: "Distance that bends move in each round.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.6),
        },
        Parameter {
            key: Key::MeanderMix,
            name: "meander-mix",
            label: "Outward or downstream",
            help: "Direction in which bends move: 1 is outward only, 0 is downstream only.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.6),
        },
        Parameter {
            key: Key::MeanderElsewhere,
            name: "meander-elsewhere",
            label: "Meandering of other rivers",
            help: "Amount of meandering of all other rivers, which varies from place to place.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.3),
        },
        Parameter {
            key: Key::GreatRivers,
            name: "great-rivers",
            label: "Great rivers",
            help: "Number of rivers that meander fully where they are flat.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: Kind::Integer { min: 0, max: 16, default: 3 },
        },
        Parameter {
            key: Key::FlatShare,
            name: "flat-share",
            label: "Flat share",
            help: "Share of all river length that counts as flat, the flattest first. The great rivers meander fully there.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.2),
        },
        Parameter {
            key: Key::Neck,
            name: "neck",
            label: "Neck",
            help: "Distance between the two limbs of a loop at which the river cuts through.",
            unit: "widths",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(1.0, 4.0, 0.1, 1.5),
        },
        Parameter {
            key: Key::Oxbows,
            name: "oxbows",
            label: "Oxbow lakes",
            help: "How long oxbow lakes last: 0 leaves none, 1 all that are cut off. Rivers that come back take them.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.5),
        },
        Parameter {
            key: Key::Clearance,
            name: "clearance",
            label: "Clearance",
            help: "Distance that the banks of two rivers keep from each other. Bends that come closer stop moving.",
            unit: "spacings",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.15),
        },
        Parameter {
            key: Key::Taper,
            name: "taper",
            label: "Taper",
            help: "Distance from sources, mouths and confluences over which meandering sets in.",
            unit: "widths",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(1.0, 20.0, 0.5, 6.0),
        },
        Parameter {
            key: Key::Mountains,
            name: "mountains",
            label: "Mountains",
            help: "Steepness of the land far from the sea. Rivers stay where they are.",
            unit: "",
            group: "Relief",
            stage: Relief,
            logarithmic: false,
            kind: number(0.2, 4.0, 0.1, 1.5),
        },
        Parameter {
            key: Key::Plains,
            name: "plains",
            label: "Plains",
            help: "Distance from the coast over which slopes steepen: plains by the sea, mountains behind.",
            unit: "units",
            group: "Relief",
            stage: Relief,
            logarithmic: false,
            kind: number(0.0, 400.0, 5.0, 200.0),
        },
        Parameter {
            key: Key::Shade,
            name: "shade",
            label: "Shade",
            help: "Exaggeration of slopes in shading.",
            unit: "",
            group: "Relief",
            stage: Paint,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.05, 0.45),
        },
        Parameter {
            key: Key::Style,
            name: "style",
            label: "Style",
            help: "Style of the picture. All but ink, skeleton, past-courses and dark show relief, once the rivers are finished.",
            unit: "",
            group: "Finish",
            stage: Paint,
            logarithmic: false,
            kind: Kind::Choice { choices: Style::WORDS },
        },
        Parameter {
            key: Key::Labels,
            name: "labels",
            label: "Labels",
            help: "Share of the land that names may cover, the greatest rivers first. Labels include spot heights and a grid in survey, a legend in blueprint and a seal in ink wash.",
            unit: "",
            group: "Names",
            stage: Name,
            logarithmic: false,
            kind: Kind::Choice { choices: Labels::WORDS },
        },
        Parameter {
            key: Key::LabelSize,
            name: "label-size",
            label: "Size of letters",
            help: "Scale of label text. Larger text leaves room for fewer labels.",
            unit: "",
            group: "Names",
            stage: Name,
            logarithmic: true,
            kind: number(0.5, 2.0, 0.05, 1.0),
        },
        Parameter {
            key: Key::Language,
            name: "language",
            label: "Language",
            help: "The made-up language of names. 0 is the seed's own; any other number is the same language for all seeds.",
            unit: "",
            group: "Names",
            stage: Name,
            logarithmic: false,
            kind: Kind::Integer { min: 0, max: 999, default: 0 },
        },
        Parameter {
            key: Key::Names,
            name: "names",
            label: "Own names",
            help: "Your own names for up to 12 things, such as 12.Silver Water_t.Home.",
            unit: "",
            group: "Names",
            stage: Name,
            logarithmic: false,
            kind: Kind::Text { longest: 400, default: "" },
        },
        Parameter {
            key: Key::Cartouche,
            name: "cartouche",
            label: "Cartouche",
            help: "The map's title in a corner, with the seed under it.",
            unit: "",
            group: "Names",
            stage: Name,
            logarithmic: false,
            kind: Kind::Choice { choices: Cartouche::WORDS },
        },
        Parameter {
            key: Key::Woods,
            name: "woods",
            label: "Woods",
            help: "Share of the land that is wooded. Trees keep clear of rivers and names.",
            unit: "",
            group: "Scenery",
            stage: Name,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.0),
        },
        Parameter {
            key: Key::Hills,
            name: "hills",
            label: "Hills",
            help: "Density of hills on divides and, in the style basins, on high land. Shown in the styles ink, dark, basins and past-courses.",
            unit: "",
            group: "Scenery",
            stage: Name,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.0),
        },
    ])
};

/// Compiles only if each row stands at the place of its key and has that key's kind.
const _: () = {
    let mut row = 0;
    while row < COUNT {
        assert!(TABLE[row].key as usize == row, "a row of the table is not at the place of its key");
        let is_of_its_kind = match TABLE[row].kind {
            Kind::Text { .. } => matches!(KINDS[row], KeyKind::Text),
            Kind::Integer { .. } => matches!(KINDS[row], KeyKind::Integer),
            Kind::Number { .. } => matches!(KINDS[row], KeyKind::Number),
            Kind::Choice { .. } => matches!(KINDS[row], KeyKind::Choice),
            Kind::Sides { .. } => matches!(KINDS[row], KeyKind::Sides),
            Kind::Outline => matches!(KINDS[row], KeyKind::Outline),
        };
        assert!(is_of_its_kind, "a key is of another kind than its row of the table");
        row += 1;
    }
};

/// The rows, without the words that only a page of controls shows where there is none.
const fn explained(mut rows: [Parameter; COUNT]) -> [Parameter; COUNT] {
    let mut row = 0;
    while row < COUNT {
        if !cfg!(feature = "texts") {
            (rows[row].label, rows[row].help, rows[row].group) = ("", "", "");
        }
        row += 1;
    }
    rows
}

impl Key {
    /// The row of this key.
    pub fn parameter(self) -> &'static Parameter {
        &TABLE[self as usize]
    }

    /// Finds a key by its name in links.
    pub fn from_name(name: &str) -> Option<Self> {
        TABLE.iter().find(|parameter| parameter.name == name).map(|parameter| parameter.key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::RecipeError;

    #[test]
    fn rows_stand_in_the_order_of_their_keys() {
        for (i, parameter) in TABLE.iter().enumerate() {
            assert_eq!(parameter.key as usize, i, "{}", parameter.name);
            assert_eq!(Key::from_name(parameter.name), Some(parameter.key));
        }
    }

    #[test]
    fn every_default_is_in_its_range_and_reads_back() {
        for parameter in &TABLE {
            let value = parameter.default_value();
            assert!(parameter.accepts(&value), "{}", parameter.name);
            assert_eq!(parameter.parse(&parameter.text_of(&value)), Ok(value), "{}", parameter.name);
        }
    }

    #[test]
    fn numbers_are_refused_by_name_and_range() {
        let reach = Key::Reach.parameter();
        for text in ["NaN", "inf", "-inf", "", "two", "1,5", "0x3"] {
            assert!(matches!(reach.parse(text), Err(RecipeError::NotANumber { key: "reach", .. })), "{text}");
        }
        assert_eq!(reach.parse("99").map_err(|e| e.to_string()), Err("reach: 99 is not between 2.1 and 12".into()));
        assert!(matches!(Key::Mouths.parameter().parse("2.5"), Err(RecipeError::NotWhole { .. })));
    }
}
