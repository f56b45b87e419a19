//! The mixtures of a style's colours from climate to climate.

use super::climate::Climate;
use super::look::Look;
use super::{Scheme, label_look, look_of, palette};
use crate::recipe::{Choice, GroundKind, Style};

/// The tints of *atlas* in the four climates as they were chosen by eye on forty maps, by height, and after them its water, shallows,
/// coast, rivers, letters, halo, shadow and light.
const CHOSEN: [([f32; 2], GroundKind, &str); 4] = [
    (
        [0.5, 1.0],
        GroundKind::Soil,
        "9cc890 a9d098 b9d8a2 c3d9a4 b6c898 a3b48c 929f84 989f92 c3cac8 eef2f2 84b4bd c4e4dc 2c5f60 17628a 0f3d4c eef3dc 0f2c3a fbf7c4",
    ),
    (
        [0.5, 0.0],
        GroundKind::Soil,
        "cfcf9e ded6a4 eedcac f0d39c e8bf88 d8a274 c28864 b48c78 cebaa8 ece2d8 7fb0c0 c8e6e2 4f5f68 1c628e 3a3036 faf0d6 3a2440 fff0c0",
    ),
    (
        [0.0, 0.5],
        GroundKind::Soil,
        "aebf98 bbc8a2 c9ceb0 d0cfba c8c6b8 c4c5c0 d4d9dc e8edf1 f6f9fb ffffff 8ba6ba d3e0e8 3f5468 35648f 1d3450 f4f6f4 1c2c50 fffdf0",
    ),
    (
        [0.5, 0.5],
        GroundKind::Lava,
        "98ba78 a5b87c aeae84 aa9c84 9c8c80 8a7f7c 7a7276 766f76 988e90 c8c0be 6fa0b4 bfe0e0 2c3f4c 0f4c78 1c2c44 f0ecdc 1a1a34 ffe8c0",
    ),
];

fn scheme(style: Style, [warmth, rain]: [f32; 2], ground: GroundKind) -> Scheme {
    Scheme { style, climate: Climate { warmth, rain, ground } }
}

/// Returns the red, green and blue of all colours of land and sea.
fn parts(Look { palette, labels, .. }: &Look) -> Vec<u8> {
    let tints = palette.relief.iter().flat_map(|relief| relief.tints.stops.map(|stop| stop.1));
    let others = [palette.plain, palette.deep, palette.shallows, palette.river, labels.ink, labels.panel];
    tints.chain(others).flatten().collect()
}

#[test]
fn an_atlas_has_the_chosen_colours_in_each_climate() {
    for (numbers, ground, chosen) in CHOSEN {
        let scheme = scheme(Style::Atlas, numbers, ground);
        let (palette, letters) = (palette(scheme), label_look(scheme));
        let tints = palette.relief.unwrap().tints;
        let others = [palette.deep, palette.shallows, palette.coast, palette.river, letters.ink, letters.panel];
        let all = tints.stops.map(|stop| stop.1).into_iter().chain(others).chain([tints.shadow, tints.highlight]);
        let all: Vec<String> = all.map(|[red, green, blue]| format!("{red:02x}{green:02x}{blue:02x}")).collect();
        assert_eq!(all.join(" "), chosen, "{scheme:?}");
    }
}

#[test]
fn a_mixture_of_nothing_is_the_style_itself() {
    for &style in Style::ALL {
        let temperate = format!("{:?}", look_of(style.into()));
        // It is mixed with shares of 0, since it does not get colder.
        assert_eq!(format!("{:?}", look_of(scheme(style, [0.7, 0.5], GroundKind::Soil))), temperate, "{style:?}");
        let is_alike = format!("{:?}", look_of(scheme(style, [0.1, 0.9], GroundKind::Lava))) == temperate;
        assert_eq!(is_alike, !style.has_climate(), "{style:?}");
    }
}

/// Colours move evenly from one ramp to another: each part of each rises or falls all the way, in small steps.
#[test]
fn colours_change_little_by_little_with_the_climate() {
    for &style in Style::ALL {
        for ground in GroundKind::ALL.iter().copied() {
            let at = |numbers| parts(&look_of(scheme(style, numbers, ground)));
            let ways: [&dyn Fn(f32) -> [f32; 2]; 4] =
                [&|way| [0.5, 0.5 - 0.5 * way], &|way| [0.5, 0.5 + 0.5 * way], &|way| [0.5 - 0.5 * way, 0.5], &|way| {
                    [0.5 - 0.5 * way, 0.9]
                }];
            for way in ways {
                let steps: Vec<Vec<u8>> = (0..=50).map(|step| at(way(step as f32 / 50.0))).collect();
                for part in 0..steps[0].len() {
                    let values: Vec<u8> = steps.iter().map(|step| step[part]).collect();
                    assert!(values.is_sorted() || values.is_sorted_by(|a, b| a >= b), "{style:?}: {values:?}");
                    assert!(values.windows(2).all(|pair| pair[0].abs_diff(pair[1]) <= 6), "{style:?}: {values:?}");
                }
            }
        }
    }
}
