//! Presets: named sets of values. A preset is not a parameter: a link that names one is written without it.

use super::choice::Style;
use super::key::Key;

/// A named set of values. Parameters that it leaves out keep their defaults.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Preset {
    /// The name in links.
    pub name: &'static str,
    /// The name on the page.
    pub label: &'static str,
    /// One line on its looks and uses.
    pub help: &'static str,
    /// Keys, each with its value as text.
    pub values: &'static [(Key, &'static str)],
    /// The style that is best on such a map, if it needs one: beside that style the page offers this country.
    pub style: Option<Style>,
}

/// The values of a pattern from the paper, from its momentum, curl, stretch and trim. They cover everything that shapes
/// a tree, so that no default of the table shows through, and nothing that the tree grows on: land, mouths, number of
/// attractors, looks.
const fn pattern(momentum: Text, curl: Text, stretch: Text, trim: Text) -> [(Key, Text); 15] {
    [
        (Key::Growth, "colonize"),
        (Key::Scatter, "random"),
        (Key::Reach, "2.3"),
        (Key::Kill, "1.1"),
        (Key::Step, "0.38"),
        (Key::Momentum, momentum),
        (Key::Curl, curl),
        (Key::Stretch, stretch),
        (Key::Valleys, "0"),
        (Key::Trim, trim),
        (Key::TrimVariation, "0"),
        (Key::TributarySpacing, "0"),
        // The paper's trees are shown as they grew.
        (Key::Courses, "grown"),
        (Key::Simplify, "0"),
        (Key::Meander, "none"),
    ]
}

type Text = &'static str;

/// The six variants of the paper (section 4.4): the plain procedure, momentum and curl, each as grown and trimmed.
pub static PRESETS: &[Preset] = &explained([
    Preset {
        name: "original",
        label: "Original",
        help: "Space colonization as it is, with all its short side branches. Suits veins and roots.",
        values: &pattern("0", "0", "8", "0"),
        style: None,
    },
    Preset {
        name: "momentum",
        label: "Momentum",
        help: "Every turn exaggerated: more curves, and here and there a zigzag. Suits restless rivers.",
        values: &pattern("0.45", "0", "8", "0"),
        style: None,
    },
    Preset {
        name: "curl",
        label: "Curl",
        help: "Stretches turned left and right at random: winding, complex, busy at its ends. Suits tangled country.",
        values: &pattern("0", "0.9", "7", "0"),
        style: None,
    },
    Preset {
        name: "trimmed-original",
        label: "Trimmed original",
        help: "The plain procedure without its short side branches. Suits calm, schematic maps.",
        values: &pattern("0", "0", "8", "29"),
        style: None,
    },
    Preset {
        name: "trimmed-momentum",
        label: "Trimmed momentum",
        help: "Exaggerated turns without short side branches. Suits rugged country.",
        values: &pattern("0.45", "0", "8", "29"),
        style: None,
    },
    Preset {
        name: "trimmed-curl",
        label: "Trimmed curl",
        help: "Winding rivers without short side branches: what people took for real ones. Suits natural maps.",
        values: &pattern("0", "0.9", "7", "29"),
        style: None,
    },
]);

/// The values of a kind of country: its land and its rivers. All countries set the same keys, so that choosing one
/// leaves no trace of another.
const fn country(land: [Text; 5], growth: [Text; 4], rivers: [Text; 3]) -> [(Key, Text); 16] {
    old_country(land, growth, rivers, DEFAULT_BENDS)
}

/// The values of great rivers, flat share, neck and oxbow lakes in most countries: the defaults.
const DEFAULT_BENDS: [Text; 4] = ["3", "0.2", "1.5", "0.5"];

/// The same with the ways in which rivers bend.
const fn old_country(land: [Text; 5], growth: [Text; 4], rivers: [Text; 3], bends: [Text; 4]) -> [(Key, Text); 16] {
    let ([aspect, land, sea, roughness, sides], [growth, attractors, sensitivity, channel_area]) = (land, growth);
    let [mouths, width, rounds] = rivers;
    let [great_rivers, flat_share, neck, oxbows] = bends;
    [
        (Key::Aspect, aspect),
        (Key::Land, land),
        (Key::Sea, sea),
        (Key::Roughness, roughness),
        (Key::Sides, sides),
        (Key::Growth, growth),
        (Key::Attractors, attractors),
        (Key::Sensitivity, sensitivity),
        (Key::ChannelArea, channel_area),
        (Key::Mouths, mouths),
        (Key::Width, width),
        (Key::MeanderRounds, rounds),
        (Key::GreatRivers, great_rivers),
        (Key::FlatShare, flat_share),
        (Key::Neck, neck),
        (Key::Oxbows, oxbows),
    ]
}

/// Countries that the page offers to begin with.
pub static COUNTRIES: &[Preset] = &[
    Preset {
        name: "island",
        label: "Island",
        help: "One island with bays and islets, all its rivers on their way to the sea.",
        values: &country(["1.6", "island", "0.55", "1", "s"], ["drainage", "20000", "16", "6"], ["0", "16", "18"]),
        style: None,
    },
    Preset {
        name: "archipelago",
        label: "Archipelago",
        help: "Many islands, each with rivers of its own.",
        values: &country(["1.6", "archipelago", "0.65", "1", "s"], ["drainage", "26000", "16", "5"], ["0", "14", "18"]),
        style: None,
    },
    Preset {
        name: "coast",
        label: "Coast",
        help: "Land with the sea to the south and west.",
        values: &country(["1.6", "continent", "0.4", "0.9", "sw"], ["drainage", "20000", "16", "6"], ["0", "18", "30"]),
        style: None,
    },
    Preset {
        name: "great-valley",
        label: "Great valley",
        help: "A broad valley between two ridges, and one great river.",
        values: &country(["1.3", "valley", "0.15", "0.7", "s"], ["drainage", "18000", "16", "8"], ["0", "20", "40"]),
        style: None,
    },
    Preset {
        name: "lakeland",
        label: "Lakeland",
        help: "A lake in the middle, and rivers that run inward.",
        values: &country(["1.3", "basin", "0.25", "1", "s"], ["drainage", "18000", "16", "6"], ["0", "16", "24"]),
        style: None,
    },
    Preset {
        name: "banner",
        label: "Banner",
        help: "A coast three times as wide as it is high, for the head of a page.",
        values: &country(["3", "continent", "0.35", "0.8", "s"], ["drainage", "20000", "16", "6"], ["0", "16", "24"]),
        style: None,
    },
    Preset {
        name: "poster",
        label: "Poster",
        help: "An island on end, for a wall or a phone.",
        values: &country(["0.7", "island", "0.5", "1", "s"], ["drainage", "30000", "16", "5"], ["0", "16", "24"]),
        style: None,
    },
    Preset {
        name: "old-river",
        label: "Old river",
        help: "Few rivers, wide and old: loops, cut necks and oxbow lakes.",
        values: &old_country(
            ["2", "valley", "0.15", "0.5", "s"],
            ["drainage", "5000", "16", "20"],
            ["0", "26", "120"],
            ["5", "0.6", "2.5", "1"],
        ),
        style: Some(Style::PastCourses),
    },
    Preset {
        name: "marsh",
        label: "Marsh",
        help: "A Brownian tree: streams that wander everywhere.",
        values: &country(["1.6", "island", "0.45", "0.6", "s"], ["brownian", "20000", "11", "6"], ["0", "18", "18"]),
        style: None,
    },
    Preset {
        name: "desert",
        label: "Desert",
        help: "Few rivers, far apart.",
        values: &country(
            ["1.6", "continent", "0.35", "0.8", "s"],
            ["drainage", "12000", "16", "40"],
            ["0", "12", "40"],
        ),
        style: None,
    },
    Preset {
        name: "rainforest",
        label: "Rainforest",
        help: "Water everywhere: the finest network.",
        values: &country(["1.6", "continent", "0.3", "0.8", "e"], ["drainage", "60000", "16", "3"], ["0", "24", "40"]),
        style: None,
    },
    Preset {
        name: "skerries",
        label: "Skerries",
        help: "More sea than land: islets and rocks with short streams.",
        values: &country(["1.6", "archipelago", "0.8", "1", "s"], ["drainage", "30000", "16", "4"], ["0", "10", "12"]),
        style: None,
    },
];

/// Empties labels and help texts unless the feature `texts` is on.
const fn explained<const COUNT: usize>(mut presets: [Preset; COUNT]) -> [Preset; COUNT] {
    let mut i = 0;
    while i < COUNT && !cfg!(feature = "texts") {
        (presets[i].label, presets[i].help) = ("", "");
        i += 1;
    }
    presets
}

/// Finds a preset by its name in links.
pub fn find(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_holds_valid_values() {
        for preset in PRESETS.iter().chain(COUNTRIES) {
            for (key, text) in preset.values {
                assert!(key.parameter().parse(text).is_ok(), "{}: {key:?}", preset.name);
            }
        }
    }

    #[test]
    fn a_style_is_best_on_one_country_at_most() {
        let best: Vec<_> = COUNTRIES.iter().filter_map(|country| Some((country.style?, country.name))).collect();
        assert_eq!(best, [(Style::PastCourses, "old-river")]);
    }
}
