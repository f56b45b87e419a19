//! The glyphs of trees and hills: a silhouette, which hides what stands behind it, and the strokes of a pen.
//!
//! A glyph is drawn around its foot, the middle of its base, in sizes of its own: a tree's is its height, a hill's half of its width.
//! Light falls from the left.

use glam::Vec2;

use crate::annotate::glyph::Curve;

/// What a glyph shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// A tree with a round crown.
    Broadleaf,
    /// A tree with a pointed one.
    Conifer,
    /// A hill.
    Hill,
    /// A mountain.
    Mountain,
}

impl Feature {
    /// Whether it is a tree.
    pub fn is_tree(self) -> bool {
        matches!(self, Self::Broadleaf | Self::Conifer)
    }

    /// The numbers of its glyphs.
    pub fn shapes(self) -> std::ops::Range<u8> {
        match self {
            Self::Broadleaf => 0..3,
            Self::Conifer => 3..6,
            Self::Hill => 6..9,
            Self::Mountain => 9..12,
        }
    }
}

/// A line of a pen.
#[derive(Clone, Copy, Debug)]
pub struct PenStroke {
    /// Where it begins.
    pub start: Vec2,
    /// Where it runs from there.
    pub curves: &'static [Curve],
}

/// A glyph.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// What it shows.
    pub feature: Feature,
    /// What hides others: closed from its end to its start by a straight line.
    pub silhouette: PenStroke,
    /// Its outline.
    pub outline: &'static [PenStroke],
    /// Fainter strokes, on its dark side.
    pub shade: &'static [PenStroke],
}

/// All glyphs.
pub static SHAPES: [Shape; 12] = [
    tree(Feature::Broadleaf, &ROUND, &ROUND_SHADE),
    tree(Feature::Broadleaf, &LOBED, &LOBED_SHADE),
    tree(Feature::Broadleaf, &BROAD, &BROAD_SHADE),
    tree(Feature::Conifer, &SPIRE, &SPIRE_SHADE),
    tree(Feature::Conifer, &FIR, &FIR_SHADE),
    tree(Feature::Conifer, &STOUT, &STOUT_SHADE),
    hill(Feature::Hill, &HUMP, &HUMP_SHADE),
    hill(Feature::Hill, &LONG_HUMP, &LONG_HUMP_SHADE),
    hill(Feature::Hill, &TWIN_HUMP, &TWIN_HUMP_SHADE),
    hill(Feature::Mountain, &PEAK, &PEAK_SHADE),
    hill(Feature::Mountain, &SHOULDER, &SHOULDER_SHADE),
    hill(Feature::Mountain, &HORN, &HORN_SHADE),
];

/// The discs that a glyph lies within: how far their middles are above its foot, to the right of it, and their radii.
pub fn discs(feature: Feature) -> &'static [([f32; 2], f32)] {
    match feature {
        Feature::Broadleaf => &[([0.0, -0.56], 0.46), ([0.0, -0.1], 0.16)],
        Feature::Conifer => &[([0.0, -0.26], 0.34), ([0.0, -0.74], 0.28)],
        Feature::Hill => &[([-0.6, -0.16], 0.46), ([0.0, -0.36], 0.46), ([0.6, -0.16], 0.46)],
        Feature::Mountain => &[([-0.6, -0.2], 0.48), ([0.0, -0.72], 0.6), ([0.6, -0.2], 0.48), ([0.0, -0.2], 0.4)],
    }
}

const fn tree(feature: Feature, outline: &'static [PenStroke], shade: &'static [PenStroke]) -> Shape {
    Shape { feature, silhouette: outline[0], outline, shade }
}

const fn hill(feature: Feature, outline: &'static [PenStroke], shade: &'static [PenStroke]) -> Shape {
    Shape { feature, silhouette: outline[0], outline, shade }
}

const fn at(x: f32, y: f32) -> Vec2 {
    Vec2::new(x, y)
}

const fn line(start: Vec2, curves: &'static [Curve]) -> PenStroke {
    PenStroke { start, curves }
}

/// A straight stroke, or one bent a little.
macro_rules! dash {
    ($x:literal, $y:literal; $cx:literal, $cy:literal; $ex:literal, $ey:literal) => {
        line(at($x, $y), &[[at($cx, $cy), at($ex, $ey)]])
    };
}

// Round crowns, open on the left below, where the light is.
static ROUND: [PenStroke; 2] = [
    line(
        at(-0.34, -0.4),
        &[
            [at(-0.44, -0.62), at(-0.28, -0.8)],
            [at(-0.06, -1.02), at(0.18, -0.86)],
            [at(0.43, -0.76), at(0.36, -0.48)],
            [at(0.32, -0.2), at(0.03, -0.24)],
        ],
    ),
    dash!(0.0, -0.24; -0.02, -0.12; 0.0, 0.0),
];
static ROUND_SHADE: [PenStroke; 1] = [dash!(0.19, -0.66; 0.26, -0.5; 0.12, -0.38)];

static LOBED: [PenStroke; 2] = [
    line(
        at(-0.27, -0.32),
        &[
            [at(-0.45, -0.42), at(-0.33, -0.6)],
            [at(-0.42, -0.82), at(-0.14, -0.85)],
            [at(0.04, -1.06), at(0.2, -0.82)],
            [at(0.44, -0.78), at(0.34, -0.53)],
            [at(0.43, -0.24), at(0.06, -0.24)],
        ],
    ),
    dash!(0.01, -0.24; 0.03, -0.12; 0.0, 0.0),
];
static LOBED_SHADE: [PenStroke; 2] =
    [dash!(0.14, -0.68; 0.24, -0.64; 0.2, -0.52), dash!(0.22, -0.44; 0.2, -0.34; 0.08, -0.36)];

static BROAD: [PenStroke; 2] = [
    line(
        at(-0.4, -0.46),
        &[[at(-0.42, -0.76), at(-0.1, -0.84)], [at(0.3, -0.9), at(0.4, -0.58)], [at(0.44, -0.26), at(0.06, -0.22)]],
    ),
    dash!(-0.01, -0.23; 0.03, -0.12; 0.01, 0.0),
];
static BROAD_SHADE: [PenStroke; 1] = [dash!(0.23, -0.66; 0.29, -0.48; 0.12, -0.36)];

// Spires, open below.
static SPIRE: [PenStroke; 2] = [
    line(at(-0.23, -0.16), &[[at(-0.07, -0.5), at(0.0, -1.0)], [at(0.06, -0.5), at(0.23, -0.13)]]),
    dash!(0.0, -0.17; 0.0, -0.1; 0.0, 0.0),
];
static SPIRE_SHADE: [PenStroke; 2] =
    [dash!(0.02, -0.6; 0.06, -0.52; 0.07, -0.45), dash!(0.03, -0.38; 0.08, -0.28; 0.1, -0.2)];

static FIR: [PenStroke; 2] = [
    line(
        at(-0.26, -0.13),
        &[
            [at(-0.14, -0.25), at(-0.13, -0.45)],
            [at(-0.03, -0.66), at(0.01, -0.98)],
            [at(0.05, -0.66), at(0.15, -0.43)],
            [at(0.14, -0.26), at(0.26, -0.15)],
        ],
    ),
    dash!(0.01, -0.16; 0.0, -0.08; 0.0, 0.0),
];
static FIR_SHADE: [PenStroke; 2] =
    [dash!(0.03, -0.64; 0.06, -0.55; 0.06, -0.48), dash!(0.04, -0.36; 0.1, -0.27; 0.12, -0.2)];

static STOUT: [PenStroke; 2] = [
    line(at(-0.28, -0.14), &[[at(-0.16, -0.42), at(-0.01, -0.92)], [at(0.12, -0.42), at(0.27, -0.16)]]),
    dash!(0.0, -0.15; 0.01, -0.08; 0.01, 0.0),
];
static STOUT_SHADE: [PenStroke; 2] =
    [dash!(0.03, -0.58; 0.07, -0.48; 0.09, -0.4), dash!(0.04, -0.34; 0.1, -0.24; 0.13, -0.18)];

// Humps, with hatches down the right flank.
static HUMP: [PenStroke; 1] = [line(
    at(-1.0, 0.0),
    &[
        [at(-0.66, -0.08), at(-0.42, -0.4)],
        [at(-0.18, -0.74), at(0.04, -0.72)],
        [at(0.26, -0.7), at(0.48, -0.38)],
        [at(0.68, -0.08), at(0.98, 0.03)],
    ],
)];
static HUMP_SHADE: [PenStroke; 4] = [
    dash!(0.16, -0.61; 0.2, -0.46; 0.2, -0.3),
    dash!(0.32, -0.5; 0.38, -0.36; 0.4, -0.2),
    dash!(0.47, -0.32; 0.54, -0.2; 0.58, -0.09),
    dash!(0.64, -0.14; 0.7, -0.06; 0.76, 0.0),
];

static LONG_HUMP: [PenStroke; 1] = [line(
    at(-0.98, 0.03),
    &[
        [at(-0.7, -0.05), at(-0.5, -0.27)],
        [at(-0.28, -0.54), at(-0.06, -0.58)],
        [at(0.2, -0.62), at(0.46, -0.34)],
        [at(0.64, -0.13), at(1.0, -0.02)],
    ],
)];
static LONG_HUMP_SHADE: [PenStroke; 3] = [
    dash!(0.14, -0.49; 0.2, -0.36; 0.22, -0.24),
    dash!(0.34, -0.37; 0.4, -0.25; 0.43, -0.14),
    dash!(0.54, -0.2; 0.6, -0.11; 0.66, -0.04),
];

static TWIN_HUMP: [PenStroke; 2] = [
    line(
        at(-1.0, 0.02),
        &[
            [at(-0.78, -0.04), at(-0.62, -0.24)],
            [at(-0.44, -0.46), at(-0.3, -0.42)],
            [at(-0.08, -0.78), at(0.12, -0.7)],
            [at(0.34, -0.62), at(0.5, -0.32)],
            [at(0.66, -0.06), at(0.98, 0.0)],
        ],
    ),
    dash!(-0.3, -0.42; -0.2, -0.36; -0.14, -0.2),
];
static TWIN_HUMP_SHADE: [PenStroke; 3] = [
    dash!(0.2, -0.58; 0.26, -0.42; 0.26, -0.28),
    dash!(0.37, -0.42; 0.43, -0.28; 0.46, -0.16),
    dash!(0.55, -0.2; 0.61, -0.1; 0.68, -0.03),
];

// Peaks, with the edge between light and dark that runs down from the top.
static PEAK: [PenStroke; 2] = [
    line(
        at(-1.0, 0.0),
        &[
            [at(-0.72, -0.14), at(-0.5, -0.48)],
            [at(-0.34, -0.66), at(-0.22, -0.94)],
            [at(-0.1, -1.14), at(0.02, -1.26)],
            [at(0.14, -1.1), at(0.3, -0.86)],
            [at(0.44, -0.6), at(0.6, -0.42)],
            [at(0.78, -0.14), at(1.0, 0.0)],
        ],
    ),
    line(at(0.02, -1.26), &[[at(-0.04, -1.0), at(0.08, -0.84)], [at(0.12, -0.6), at(-0.02, -0.42)]]),
];
static PEAK_SHADE: [PenStroke; 4] = [
    dash!(0.16, -0.98; 0.18, -0.84; 0.16, -0.7),
    dash!(0.3, -0.78; 0.32, -0.6; 0.28, -0.44),
    dash!(0.46, -0.54; 0.48, -0.38; 0.44, -0.24),
    dash!(0.62, -0.32; 0.66, -0.2; 0.64, -0.1),
];

static SHOULDER: [PenStroke; 2] = [
    line(
        at(-1.0, 0.02),
        &[
            [at(-0.8, -0.12), at(-0.64, -0.42)],
            [at(-0.54, -0.6), at(-0.4, -0.6)],
            [at(-0.26, -0.8), at(-0.06, -1.14)],
            [at(0.1, -1.0), at(0.28, -0.74)],
            [at(0.46, -0.56), at(0.62, -0.34)],
            [at(0.8, -0.1), at(1.0, 0.0)],
        ],
    ),
    line(at(-0.06, -1.14), &[[at(-0.08, -0.92), at(0.02, -0.76)], [at(0.08, -0.56), at(-0.06, -0.36)]]),
];
static SHOULDER_SHADE: [PenStroke; 4] = [
    dash!(0.12, -0.88; 0.14, -0.74; 0.11, -0.6),
    dash!(0.28, -0.66; 0.3, -0.5; 0.26, -0.36),
    dash!(0.46, -0.46; 0.48, -0.32; 0.45, -0.2),
    dash!(0.64, -0.26; 0.68, -0.16; 0.66, -0.08),
];

static HORN: [PenStroke; 2] = [
    line(
        at(-0.98, 0.02),
        &[
            [at(-0.6, -0.22), at(-0.42, -0.54)],
            [at(-0.2, -0.86), at(0.08, -1.2)],
            [at(0.16, -1.0), at(0.32, -0.9)],
            [at(0.4, -0.56), at(0.58, -0.44)],
            [at(0.72, -0.12), at(1.0, 0.0)],
        ],
    ),
    line(at(0.08, -1.2), &[[at(0.0, -0.96), at(0.12, -0.78)], [at(0.18, -0.56), at(0.04, -0.34)]]),
];
static HORN_SHADE: [PenStroke; 3] = [
    dash!(0.26, -0.82; 0.26, -0.66; 0.22, -0.52),
    dash!(0.44, -0.56; 0.44, -0.4; 0.4, -0.28),
    dash!(0.6, -0.34; 0.64, -0.2; 0.62, -0.1),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::annotate::glyph::pieces_of;

    #[test]
    fn every_glyph_lies_within_its_discs_and_every_feature_has_its_own() {
        for (number, shape) in (0..).zip(&SHAPES) {
            assert!(shape.feature.shapes().contains(&number), "{number}");
            let is_covered = |at: Vec2| {
                discs(shape.feature).iter().any(|(middle, radius)| at.distance(Vec2::from(*middle)) <= *radius)
            };
            let strokes = [&shape.silhouette].into_iter().chain(shape.outline).chain(shape.shade);
            for stroke in strokes {
                pieces_of(
                    stroke.start,
                    stroke.curves,
                    |at| at * 100.0,
                    0.01,
                    |from, to| {
                        assert!(is_covered(from * 0.01) && is_covered(to * 0.01), "{number}: {from} to {to}");
                    },
                );
            }
        }
    }
}
