//! The keys of the parameters: their names in code, and the kind of value that each takes.

/// The kind of value that a key takes. The table of parameters does not compile unless its rows agree.
#[derive(Clone, Copy)]
pub(super) enum KeyKind {
    Text,
    Integer,
    Number,
    Choice,
    Sides,
    Outline,
}

/// Declares the keys in the order of the table, each with its kind. The keys of numbers and those of whole numbers become
/// types of their own, too, so that nobody can read a number by the key of a word.
macro_rules! keys {
    ($($Key:ident: $Kind:ident,)+) => {
        /// A parameter's key: the index of its row in the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[expect(missing_docs, reason = "each key is explained by its row of the table")]
        #[non_exhaustive]
        pub enum Key {
            $($Key,)+
        }

        /// The number of parameters.
        pub(super) const COUNT: usize = [$(Key::$Key),+].len();

        /// The kind of each.
        pub(super) const KINDS: [KeyKind; COUNT] = [$(KeyKind::$Kind),+];

        keys!(@sort [] [] $($Key: $Kind,)+);
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
        #[expect(missing_docs, reason = "each key is explained by its row of the table")]
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

keys! {
    Seed: Text,
    Edition: Integer,
    Aspect: Number,
    Land: Choice,
    Outline: Outline,
    Sea: Number,
    Drowning: Number,
    Roughness: Number,
    Mouths: Integer,
    MouthSpacing: Number,
    Sides: Sides,
    Shores: Sides,
    Growth: Choice,
    Sensitivity: Integer,
    Attractors: Integer,
    Scatter: Choice,
    Reach: Number,
    Kill: Number,
    Step: Number,
    Momentum: Number,
    Curl: Number,
    Stretch: Integer,
    Valleys: Number,
    ValleySpacing: Number,
    Concavity: Number,
    Captures: Integer,
    Hardness: Number,
    HardnessScale: Number,
    Bending: Number,
    BendingVariation: Number,
    Pattern: Choice,
    Strike: Integer,
    CenterX: Integer,
    CenterY: Integer,
    Fall: Number,
    ChannelArea: Integer,
    HeadVariation: Number,
    Trim: Number,
    TrimVariation: Number,
    TributarySpacing: Number,
    Courses: Choice,
    Simplify: Number,
    Width: Number,
    BankVariation: Number,
    Meander: Choice,
    MeanderRounds: Integer,
    MeanderStrength: Number,
    MeanderMix: Number,
    MeanderElsewhere: Number,
    GreatRivers: Integer,
    FlatShare: Number,
    Neck: Number,
    Oxbows: Number,
    Clearance: Number,
    Taper: Number,
    Mountains: Number,
    Plains: Number,
    Rills: Number,
    Shade: Number,
    Style: Choice,
    Labels: Choice,
    LabelSize: Number,
    Language: Integer,
    Names: Text,
    Cartouche: Choice,
    Woods: Number,
    Hills: Number,
}
