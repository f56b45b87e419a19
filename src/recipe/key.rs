//! The keys of the parameters, by which code names them.

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
    Style,
}

/// How many parameters there are.
pub(super) const COUNT: usize = Key::Style as usize + 1;
