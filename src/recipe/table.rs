//! The parameter table: the one place where a parameter is named, ranged, explained and given its default.
//!
//! Links, attributes, command-line options, JSON, the page's controls and the README's table all come from here.
//! Keys are added freely and never renamed: a shared link holds them.

use super::error::{RecipeError, shown};
use super::outline::Outline;
use super::value::{Decimal, Sides, Value};

/// The stages that parameters belong to, in the order in which they run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Shaping the land.
    Land,
    /// Growing the tree.
    Grow,
    /// Trimming it.
    Prune,
    /// Drawing it.
    Paint,
}

impl Stage {
    /// The stage's name, lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Land => "land",
            Self::Grow => "grow",
            Self::Prune => "prune",
            Self::Paint => "paint",
        }
    }
}

/// A parameter's place in the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each key is explained by its row of the table")]
pub enum Key {
    Seed,
    Edition,
    Aspect,
    Land,
    Outline,
    Sea,
    Rough,
    Mouths,
    Apart,
    Sides,
    Growth,
    Sensitivity,
    Attractors,
    Scatter,
    Reach,
    Kill,
    Step,
    Momentum,
    Curl,
    Stretch,
    Trim,
    Width,
    Style,
}

/// How many parameters there are.
pub(super) const COUNT: usize = Key::Style as usize + 1;

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

/// What values a parameter takes, and its default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Text of at most `longest` characters.
    Text {
        /// The most characters.
        longest: usize,
        /// The value when nothing is given.
        default: &'static str,
    },
    /// A whole number.
    Integer {
        /// The least.
        min: u32,
        /// The most.
        max: u32,
        /// The value when nothing is given.
        default: u32,
    },
    /// A number.
    Number {
        /// The least.
        min: Decimal,
        /// The most.
        max: Decimal,
        /// The step of a slider; any number between is allowed all the same.
        step: Decimal,
        /// The value when nothing is given.
        default: Decimal,
    },
    /// One word of a list; the first is the default.
    Choice {
        /// Words and what they are called on screen.
        choices: &'static [(&'static str, &'static str)],
    },
    /// Some sides of the domain.
    Sides {
        /// The value when nothing is given.
        default: Sides,
    },
    /// A drawn land; nothing is drawn by default.
    Outline,
}

/// A row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The key that code uses.
    pub key: Key,
    /// The key that links, attributes, options and JSON use.
    pub name: &'static str,
    /// What the page calls it.
    pub label: &'static str,
    /// One line that says what it does.
    pub help: &'static str,
    /// The unit of its numbers; empty for plain numbers.
    pub unit: &'static str,
    /// The heading it stands under on the page.
    pub group: &'static str,
    /// The stage that has to run again when it changes.
    pub stage: Stage,
    /// Whether a slider should be logarithmic.
    pub logarithmic: bool,
    /// Its values and its default.
    pub kind: Kind,
}

/// All parameters, in the order in which links and tables list them; row `i` is that of the key numbered `i`.
pub static TABLE: [Parameter; COUNT] = {
    use Stage::{Grow, Land, Paint, Prune};
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
            kind: number(0.25, 4.0, 0.01, 1.5),
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
            kind: Kind::Choice {
                choices: &[
                    ("rectangle", "the whole rectangle"),
                    ("island", "an island"),
                    ("continent", "a coast"),
                    ("archipelago", "an archipelago"),
                    ("valley", "a valley between ridges"),
                    ("basin", "around a lake"),
                    ("drawn", "drawn by hand"),
                ],
            },
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
            kind: number(0.1, 0.8, 0.01, 0.5),
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
            kind: number(0.0, 1.0, 0.01, 0.5),
        },
        Parameter {
            key: Key::Mouths,
            name: "mouths",
            label: "River mouths",
            help: "How many rivers reach the sea; their basins meet without gaps.",
            unit: "",
            group: "Land",
            stage: Grow,
            logarithmic: true,
            kind: Kind::Integer { min: 1, max: 64, default: 3 },
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
            key: Key::Growth,
            name: "growth",
            label: "Growth",
            help: "How rivers grow: drawn on by attractors, or as a Brownian tree of wandering particles.",
            unit: "",
            group: "Growth",
            stage: Grow,
            logarithmic: false,
            kind: Kind::Choice { choices: &[("colonize", "space colonization"), ("brownian", "Brownian tree")] },
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
            kind: Kind::Choice { choices: &[("random", "at random"), ("grid", "on a jittered grid")] },
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
            kind: number(0.0, 2.0, 0.01, 0.0),
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
            kind: Kind::Integer { min: 0, max: 60, default: 4 },
        },
        Parameter {
            key: Key::Width,
            name: "width",
            label: "Width",
            help: "Width of a river that drains the whole domain; others have the square root of their share.",
            unit: "units",
            group: "Finish",
            stage: Paint,
            logarithmic: true,
            kind: number(1.0, 40.0, 0.5, 14.0),
        },
        Parameter {
            key: Key::Style,
            name: "style",
            label: "Style",
            help: "Ink on paper, the bare skeleton one pixel wide, or a coloured map.",
            unit: "",
            group: "Finish",
            stage: Paint,
            logarithmic: false,
            kind: Kind::Choice { choices: &[("ink", "ink"), ("skeleton", "skeleton"), ("map", "map")] },
        },
    ]
};

impl Parameter {
    /// The value when nothing is given.
    pub fn default_value(&self) -> Value {
        match self.kind {
            Kind::Text { default, .. } => Value::Text(default.into()),
            Kind::Integer { default, .. } => Value::Integer(default),
            Kind::Number { default, .. } => Value::Number(default),
            Kind::Choice { .. } => Value::Choice(0),
            Kind::Sides { default } => Value::Sides(default),
            Kind::Outline => Value::Outline(Outline::default()),
        }
    }

    /// Whether a value is of this parameter's kind and in its range.
    pub fn accepts(&self, value: &Value) -> bool {
        match (self.kind, value) {
            (Kind::Text { longest, .. }, Value::Text(text)) => text.chars().count() <= longest,
            (Kind::Integer { min, max, .. }, Value::Integer(n)) => (min..=max).contains(n),
            (Kind::Number { min, max, .. }, Value::Number(x)) => (min..=max).contains(x),
            (Kind::Choice { choices }, Value::Choice(index)) => *index < choices.len(),
            (Kind::Sides { .. }, Value::Sides(_)) | (Kind::Outline, Value::Outline(_)) => true,
            _ => false,
        }
    }

    /// A value's text, which [`parse`](Self::parse) reads back to the same value.
    pub fn text_of(&self, value: &Value) -> String {
        match (self.kind, value) {
            (_, Value::Text(text)) => text.clone(),
            (_, Value::Integer(n)) => n.to_string(),
            (_, Value::Number(x)) => x.to_string(),
            (Kind::Choice { choices }, Value::Choice(index)) => {
                choices.get(*index).map_or_else(String::new, |(word, _)| (*word).into())
            }
            (_, Value::Choice(index)) => index.to_string(),
            (_, Value::Sides(sides)) => sides.to_string(),
            (_, Value::Outline(outline)) => outline.to_string(),
        }
    }

    /// Reads a value from its text.
    ///
    /// # Errors
    /// Names the key, the text and what is allowed.
    pub fn parse(&self, text: &str) -> Result<Value, RecipeError> {
        match self.kind {
            Kind::Text { longest, .. } => self.parse_text(text, longest),
            Kind::Integer { min, max, .. } => self.parse_integer(text, min, max),
            Kind::Number { min, max, .. } => self.parse_number(text, min, max),
            Kind::Choice { choices } => choices
                .iter()
                .position(|(word, _)| *word == text)
                .map(Value::Choice)
                .ok_or_else(|| self.unknown_choice(text)),
            Kind::Sides { .. } => Sides::parse(text).map(Value::Sides).ok_or_else(|| self.unknown_choice(text)),
            Kind::Outline => Outline::parse(text.trim())
                .map(Value::Outline)
                .map_err(|reason| RecipeError::Outline { key: self.name, reason }),
        }
    }

    fn parse_text(&self, text: &str, longest: usize) -> Result<Value, RecipeError> {
        let text = text.trim();
        let length = text.chars().count();
        if length > longest {
            return Err(RecipeError::TooLong { key: self.name, length, max: longest });
        }
        if text.chars().any(|c| c.is_control() || c == char::REPLACEMENT_CHARACTER) {
            return Err(RecipeError::NotText { key: self.name });
        }
        Ok(Value::Text(text.into()))
    }

    fn parse_integer(&self, text: &str, min: u32, max: u32) -> Result<Value, RecipeError> {
        let number = self.decimal(text)?;
        if !number.is_whole() {
            return Err(RecipeError::NotWhole { key: self.name, value: shown(text) });
        }
        if self.key == Key::Edition && number != Decimal::whole(super::EDITION) {
            return Err(RecipeError::UnknownEdition { value: shown(text), known: super::EDITION });
        }
        self.within(number, text, Decimal::whole(min), Decimal::whole(max)).map(|number| Value::Integer(number.round()))
    }

    fn parse_number(&self, text: &str, min: Decimal, max: Decimal) -> Result<Value, RecipeError> {
        self.within(self.decimal(text)?, text, min, max).map(Value::Number)
    }

    fn decimal(&self, text: &str) -> Result<Decimal, RecipeError> {
        Decimal::parse(text.trim()).ok_or_else(|| RecipeError::NotANumber { key: self.name, value: shown(text) })
    }

    fn within(&self, number: Decimal, text: &str, min: Decimal, max: Decimal) -> Result<Decimal, RecipeError> {
        if (min..=max).contains(&number) {
            Ok(number)
        } else {
            Err(RecipeError::OutOfRange { key: self.name, value: shown(text), min, max })
        }
    }

    fn unknown_choice(&self, text: &str) -> RecipeError {
        let choices = match self.kind {
            Kind::Choice { choices } => choices.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(", "),
            _ => "the sides n, e, s, w, each once".into(),
        };
        RecipeError::UnknownChoice { key: self.name, value: shown(text), choices }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
