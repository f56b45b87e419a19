//! Presets: named sets of values. A preset is not another kind of parameter: a link that names one is written
//! without it.

use super::key::Key;

/// A named set of values; what it leaves out keeps its default.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// The name that links use.
    pub name: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// What it looks like and suits.
    pub help: &'static str,
    /// Keys and the text of their values.
    pub values: &'static [(Key, &'static str)],
}

/// A pattern of the paper: momentum, curl, its stretch, and trim. It names all that a tree's pattern rests on, so that no default
/// of the table shows through, and nothing of what it grows on: land, its mouths, how many attractors, looks.
const fn pattern(momentum: Text, curl: Text, stretch: Text, trim: Text) -> [(Key, Text); 13] {
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
        // Trees are shown as they have grown.
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
    },
    Preset {
        name: "momentum",
        label: "Momentum",
        help: "Every turn exaggerated: more curves, and here and there a zigzag. Suits restless rivers.",
        values: &pattern("0.45", "0", "8", "0"),
    },
    Preset {
        name: "curl",
        label: "Curl",
        help: "Stretches turned left and right at random: winding, complex, busy at its ends. Suits tangled country.",
        values: &pattern("0", "0.9", "7", "0"),
    },
    Preset {
        name: "trimmed-original",
        label: "Trimmed original",
        help: "The plain procedure without its short side branches. Suits calm, schematic maps.",
        values: &pattern("0", "0", "8", "29"),
    },
    Preset {
        name: "trimmed-momentum",
        label: "Trimmed momentum",
        help: "Exaggerated turns without short side branches. Suits rugged country.",
        values: &pattern("0.45", "0", "8", "29"),
    },
    Preset {
        name: "trimmed-curl",
        label: "Trimmed curl",
        help: "Winding rivers without short side branches: what people took for real ones. Suits natural maps.",
        values: &pattern("0", "0.9", "7", "29"),
    },
]);

/// The presets, without the words that only a page of controls shows where there is none.
const fn explained<const COUNT: usize>(mut presets: [Preset; COUNT]) -> [Preset; COUNT] {
    let mut i = 0;
    while i < COUNT && !cfg!(feature = "controls") {
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
        for preset in PRESETS {
            for (key, text) in preset.values {
                assert!(key.parameter().parse(text).is_ok(), "{}: {key:?}", preset.name);
            }
        }
    }
}
