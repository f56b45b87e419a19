//! The form of the rows in the table of parameters, and all that is made of them.

/// Declares the parameters: groups with their headings, and in each its rows, a help text and then
///
/// ```text
/// Key = "name in links", "Label": Stage, Kind(range, default, logarithmic), in "unit", with MORE_HELP;
/// ```
///
/// `logarithmic`, unit and more help are optional. The keys of numbers and those of whole numbers become types of their own, too, so
/// that nobody can read a number by the key of a word.
macro_rules! parameters {
    ($($group:literal {$(
        $(#[doc = $help:literal])+
        $Key:ident = $name:literal, $label:literal: $stage:ident, $Kind:ident($($range:tt)*)
        $(, in $unit:literal)? $(, with $more:path)?;
    )+})+) => {
        /// A parameter's key: the index of its row in the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum Key {
            $($($(#[doc = $help])+ $Key,)+)+
        }

        /// The number of parameters.
        pub(super) const COUNT: usize = [$($(Key::$Key),+),+].len();

        /// All parameters, in the order in which links and tables list them; row `i` is that of the key numbered `i`.
        pub static TABLE: [Parameter; COUNT] = [$($(Parameter {
            key: Key::$Key,
            name: $name,
            label: explained($label),
            help: explained(parameters!(@help concat!($($help),+).trim_ascii() $(, $more)?)),
            unit: concat!($($unit)?),
            group: explained($group),
            stage: Stage::$stage,
            logarithmic: parameters!(@is_logarithmic $($range)*),
            kind: parameters!(@kind $Kind($($range)*)),
        }),+),+];

        parameters!(@sort [] [] $($($Key: $Kind,)+)+);
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

    (@sort [$($number:ident)*] [$($integer:ident)*] $Key:ident: Number, $($rest:tt)*) => {
        parameters!(@sort [$($number)* $Key] [$($integer)*] $($rest)*);
    };
    (@sort [$($number:ident)*] [$($integer:ident)*] $Key:ident: Integer, $($rest:tt)*) => {
        parameters!(@sort [$($number)*] [$($integer)* $Key] $($rest)*);
    };
    (@sort [$($number:ident)*] [$($integer:ident)*] $Key:ident: $Kind:ident, $($rest:tt)*) => {
        parameters!(@sort [$($number)*] [$($integer)*] $($rest)*);
    };
    (@sort [$($number:ident)*] [$($integer:ident)*]) => {
        parameters! {
            @typed
            /// The key of a parameter that is a number.
            NumberKey { $($number,)* }
        }
        parameters! {
            @typed
            /// The key of a parameter that is a whole number.
            IntegerKey { $($integer,)* }
        }
    };
    (@typed $(#[$about:meta])* $Keys:ident { $($Key:ident,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[expect(missing_docs, reason = "`Key` explains each")]
        #[non_exhaustive]
        pub enum $Keys {
            $($Key = Key::$Key as isize,)*
        }

        impl From<$Keys> for Key {
            fn from(key: $Keys) -> Self {
                match key {
                    $($Keys::$Key => Self::$Key,)*
                }
            }
        }
    };
}

pub(super) use parameters;
