//! The parameter table, made of the rows in `rows.rs`.

use super::EDITION;
use super::choice::{
    Cartouche, Choice, CourseShape, GroundKind, GrowthMethod, Labels, LandKind, MeanderModel, Pattern, Scatter,
};
use super::country::Country;
use super::key::{COUNT, Key};
use super::parameter::{Kind, Parameter, Stage};
use super::rows::rows;
use super::style::{self, Style};
use super::texts::{Written, explained};
use super::value::{Decimal, Sides};

/// Makes the table.
macro_rules! table {
    ($($group:literal {$(
        $(#[doc = $help:literal])+
        $Key:ident = $name:literal, $label:literal: $stage:ident, $Kind:ident($($range:tt)*)
        $(, in $unit:literal)? $(, with $more:path)?;
    )+})+) => {
        /// All parameters, in the order in which links and tables list them; row `i` is that of the key numbered `i`.
        pub static TABLE: [Parameter; COUNT] = [$($(Parameter {
            key: Key::$Key,
            name: $name,
            label: explained($label),
            help: explained(table!(@help concat!($($help),+).trim_ascii() $(, $more)?)),
            unit: concat!($($unit)?),
            group: explained($group),
            stage: Stage::$stage,
            logarithmic: table!(@is_logarithmic $($range)*),
            kind: table!(@kind $Kind($($range)*)),
        }),+),+];
    };

    (@help $help:expr) => { $help };
    (@help $help:expr, $more:path) => {{
        static TOGETHER: Written = Written::new().and($help).and(" ").and($more.text());
        TOGETHER.text()
    }};

    (@is_logarithmic $min:tt to $max:tt $(by $step:tt)?, default $default:tt, logarithmic) => { true };
    (@is_logarithmic $($other:tt)*) => { false };

    (@kind Text(to $longest:tt, default $default:tt)) => { Kind::Text { longest: $longest, default: $default } };
    (@kind Integer($min:tt to $max:tt, default $default:tt $(, logarithmic)?)) => {
        Kind::Integer { min: $min, max: $max, default: $default }
    };
    (@kind Number($min:tt to $max:tt by $step:tt, default $default:tt $(, logarithmic)?)) => {
        Kind::Number {
            min: Decimal::new($min),
            max: Decimal::new($max),
            step: Decimal::new($step),
            default: Decimal::new($default),
        }
    };
    (@kind Choice($Choice:ident)) => { Kind::Choice { choices: $Choice::WORDS, default: $Choice::DEFAULT } };
    (@kind Sides(default $default:ident)) => { Kind::Sides { default: Sides::$default } };
    (@kind Outline()) => { Kind::Outline };
}

rows!(table);

impl Key {
    /// Returns the row of this key.
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
