//! The keys of the parameters, their names in code.

use super::parameter::Kind;
use super::table::TABLE;

/// A parameter's key: the index of its row in the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each key is explained by its row of the table")]
#[non_exhaustive]
pub enum Key {
    Seed,
    Edition,
    Aspect,
    Land,
    Outline,
    Sea,
    Roughness,
    Mouths,
    MouthSpacing,
    Sides,
    Shores,
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
    Valleys,
    ValleySpacing,
    Concavity,
    Captures,
    Hardness,
    HardnessScale,
    Bending,
    ChannelArea,
    Trim,
    Courses,
    Simplify,
    Width,
    BankVariation,
    Meander,
    MeanderRounds,
    MeanderStrength,
    MeanderMix,
    MeanderElsewhere,
    GreatRivers,
    FlatShare,
    Neck,
    Clearance,
    Taper,
    Mountains,
    Plains,
    Shade,
    Style,
    Labels,
    LabelSize,
    Language,
    Names,
    Cartouche,
    Woods,
    Hills,
}

/// The number of parameters.
pub(super) const COUNT: usize = Key::Hills as usize + 1;

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
            assert!(others == 0, concat!("The table has more parameters than ", stringify!($Keys)));
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
