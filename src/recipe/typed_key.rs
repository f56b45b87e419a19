//! The keys of the parameters that are numbers, by which they are read as numbers.

use super::key::{COUNT, Key};
use super::parameter::Kind;
use super::table::TABLE;

/// Declares the keys of one kind, each with the number that it has among all keys.
macro_rules! keys_of {
    ($(#[$about:meta])* $Keys:ident of $Kind:ident { $($Key:ident,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[expect(missing_docs, reason = "each key is explained by its row of the table")]
        #[non_exhaustive]
        pub enum $Keys {
            $($Key = Key::$Key as isize,)+
        }

        impl From<$Keys> for Key {
            fn from(key: $Keys) -> Self {
                match key {
                    $($Keys::$Key => Self::$Key,)+
                }
            }
        }

        /// Compiles only if these are all rows of their kind.
        const _: () = {
            let (mut row, mut others) = (0, 0);
            while row < COUNT {
                others += matches!(TABLE[row].kind, Kind::$Kind { .. }) as usize;
                row += 1;
            }
            $(
                assert!(
                    matches!(TABLE[Key::$Key as usize].kind, Kind::$Kind { .. }),
                    concat!(stringify!($Key), " is of another kind in the table")
                );
                others -= 1;
            )+
            assert!(others == 0, concat!("The table has more parameters of this kind than ", stringify!($Keys)));
        };
    };
}

keys_of! {
    /// The key of a parameter that is a number.
    NumberKey of Number {
        Aspect,
        Sea,
        Roughness,
        MouthSpacing,
        Reach,
        Kill,
        Step,
        Momentum,
        Curl,
        Valleys,
        ValleySpacing,
        Concavity,
        Hardness,
        HardnessScale,
        Bending,
        Trim,
        Simplify,
        Width,
        BankVariation,
        MeanderStrength,
        MeanderMix,
        MeanderElsewhere,
        FlatShare,
        Neck,
        Clearance,
        Taper,
        Mountains,
        Plains,
        Shade,
        LabelSize,
        Woods,
        Hills,
    }
}

keys_of! {
    /// The key of a parameter that is a whole number.
    IntegerKey of Integer {
        Edition,
        Mouths,
        Sensitivity,
        Attractors,
        Stretch,
        Captures,
        ChannelArea,
        MeanderRounds,
        GreatRivers,
        Language,
    }
}
