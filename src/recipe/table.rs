//! The parameter table: the one place where a parameter is named, ranged, explained and given its default.
//!
//! Links, attributes, command-line options, JSON, the page's controls and `docs/parameters.md` all come from here.
//! Keys are added freely and never renamed: a shared link holds them.

use super::choice::{Choice, GrowthMethod, LandKind, MeanderModel, Scatter, Style};
use super::key::{COUNT, Key};
use super::parameter::{Kind, Parameter, Stage};
use super::value::{Decimal, Sides};

/// All parameters, in the order in which links and tables list them; row `i` is that of the key numbered `i`.
pub static TABLE: [Parameter; COUNT] = {
    use Stage::{Grow, Land, Paint, Prune, Shape};
    const fn number(min: f64, max: f64, step: f64, default: f64) -> Kind {
        let (min, max) = (Decimal::new(min), Decimal::new(max));
        Kind::Number { min, max, step: Decimal::new(step), default: Decimal::new(default) }
    }
    [
        Parameter {
            key: Key::Seed,
            name: "seed",
            label: "Seed",
            help: "The word the river grows from: any text.",
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
            help: "The algorithm set the recipe was made for; its pictures never change once released.",
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
            help: "Width of the domain over its height; its area is always a million square units.",
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
            help: "The coasts and ridges of a drawn land; until there are any, it is the whole rectangle.",
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
            help: "The share of water, unless the land is the whole rectangle or drawn.",
            unit: "",
            group: "Land",
            stage: Land,
            logarithmic: false,
            kind: number(0.1, 0.8, 0.01, 0.6),
        },
        Parameter {
            key: Key::Rough,
            name: "rough",
            label: "Roughness",
            help: "How far coasts and ridges stray from their plain shape.",
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
            help: "How many rivers reach the sea; a lake has thrice as many, and each island of some size one. Their basins meet without gaps.",
            unit: "",
            group: "Land",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 1, max: 64, default: 8 },
        },
        Parameter {
            key: Key::Apart,
            name: "apart",
            label: "Mouths apart",
            help: "How far apart river mouths are at least, where they lie on a coast; so there may be fewer.",
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
            help: "The sides that rivers flow to: of the rectangle, a coast or a valley. Other lands have water of their own.",
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
            help: "Where on a coast river mouths lie, as seen from its middle.",
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
            help: "How rivers grow: drawn on by attractors, or as a Brownian tree of wandering particles.",
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
            help: "The least step of a Brownian tree, about the gap between its streams.",
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
            help: "Points that pull growth: more make a finer network.",
            unit: "",
            group: "Growth",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 100, max: 1_000_000, default: 6000 },
        },
        Parameter {
            key: Key::Scatter,
            name: "scatter",
            label: "Scatter",
            help: "How attractors lie: at random, or one somewhere in each cell of a grid, for an even network.",
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
            help: "How far an attractor pulls: small winds, large runs straight.",
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
            help: "An attractor is done with when a river comes this near: small makes many short streams.",
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
            help: "How far a river grows in one tick.",
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
            help: "Exaggerates each turn by taking this share of the last direction away; zigzags from 0.5 on.",
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
            help: "The most by which each step is turned aside, at random, left and right in turn.",
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
            help: "How many nodes a river curls to one side before it turns to the other.",
            unit: "nodes",
            group: "Bends",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 1, max: 64, default: 8 },
        },
        Parameter {
            key: Key::Trim,
            name: "trim",
            label: "Trim",
            help: "Side branches shorter than this go; a river's own ending stays.",
            unit: "nodes",
            group: "Finish",
            stage: Prune,
            logarithmic: false,
            kind: Kind::Integer { min: 0, max: 60, default: 7 },
        },
        Parameter {
            key: Key::Simplify,
            name: "simplify",
            label: "Simplify",
            help: "How many of a course's points go, the least important first; junctions stay.",
            unit: "%",
            group: "Rivers",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 95.0, 1.0, 60.0),
        },
        Parameter {
            key: Key::Width,
            name: "width",
            label: "Width",
            help: "Width of a river that drains the whole domain; others have the square root of their share.",
            unit: "units",
            group: "Rivers",
            stage: Shape,
            logarithmic: true,
            kind: number(1.0, 40.0, 0.5, 16.0),
        },
        Parameter {
            key: Key::Vary,
            name: "vary",
            label: "Uneven banks",
            help: "By what share of itself a river's width varies, each bank for itself.",
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
            help: "How rivers meander: each bend by its own curvature, or by that of the river upstream, or not at all.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: Kind::Choice { choices: MeanderModel::WORDS },
        },
        Parameter {
            key: Key::MeanderRounds,
            name: "meander-rounds",
            label: "Rounds",
            help: "How long rivers meander.",
            unit: "rounds",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: Kind::Integer { min: 0, max: 400, default: 36 },
        },
        Parameter {
            key: Key::MeanderStrength,
            name: "meander-strength",
            label: "Strength",
            help: "How far bends move in a round.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.6),
        },
        Parameter {
            key: Key::MeanderMix,
            name: "meander-mix",
            label: "Sideways",
            help: "How much of the way of a bend is outward; the rest is downstream.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.6),
        },
        Parameter {
            key: Key::Gentle,
            name: "gentle",
            label: "Gentle",
            help: "How much all rivers meander, here more and there less.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.3),
        },
        Parameter {
            key: Key::Great,
            name: "great",
            label: "Great rivers",
            help: "How many rivers meander fully, where they are flat.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: Kind::Integer { min: 0, max: 16, default: 3 },
        },
        Parameter {
            key: Key::Flat,
            name: "flat",
            label: "Flat",
            help: "The share of all rivers, the flattest, in which great ones meander fully.",
            unit: "",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(0.0, 1.0, 0.01, 0.25),
        },
        Parameter {
            key: Key::Neck,
            name: "neck",
            label: "Neck",
            help: "How near two limbs of a loop come before the river cuts through.",
            unit: "widths",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(1.0, 4.0, 0.1, 1.5),
        },
        Parameter {
            key: Key::Buffer,
            name: "buffer",
            label: "Buffer",
            help: "How far banks of two rivers stay apart: nearer, they move no more.",
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
            help: "Over which distance from sources, mouths and junctions meandering sets in.",
            unit: "widths",
            group: "Meanders",
            stage: Shape,
            logarithmic: false,
            kind: number(1.0, 20.0, 0.5, 6.0),
        },
        Parameter {
            key: Key::Style,
            name: "style",
            label: "Style",
            help: "Ink on paper, the bare skeleton one pixel wide, a coloured map, or light ink on dark paper.",
            unit: "",
            group: "Finish",
            stage: Paint,
            logarithmic: false,
            kind: Kind::Choice { choices: Style::WORDS },
        },
    ]
};

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
