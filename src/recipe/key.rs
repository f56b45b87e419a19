//! The keys of the parameters, in the order of their rows. Those of numbers and those of whole numbers are types of their own, too,
//! so that nobody can read a number by the key of a word.

use super::rows::rows;

/// Declares the keys.
macro_rules! keys {
    ($($group:literal {$(
        $(#[doc = $help:literal])+
        $Key:ident = $name:literal, $label:literal: $stage:ident, $Kind:ident $range:tt
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

        keys!(@sort [] [] $($($Key: $Kind,)+)+);
    };

    (@sort [$($number:ident)*] [$($integer:ident)*] $Key:ident: Number, $($rest:tt)*) => {
        keys!(@sort [$($number)* $Key] [$($integer)*] $($rest)*);
    };
    (@sort [$($number:ident)*] [$($integer:ident)*] $Key:ident: Integer, $($rest:tt)*) => {
        keys!(@sort [$($number)*] [$($integer)* $Key] $($rest)*);
    };
    (@sort [$($number:ident)*] [$($integer:ident)*] $Key:ident: $Kind:ident, $($rest:tt)*) => {
        keys!(@sort [$($number)*] [$($integer)*] $($rest)*);
    };
    (@sort [$($number:ident)*] [$($integer:ident)*]) => {
        keys! {
            @typed
            /// The key of a parameter that is a number.
            NumberKey { $($number,)* }
        }
        keys! {
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

rows!(keys);
