//! Presets: named sets of values. A preset is not a parameter: a link that names one is written without it.

use super::key::Key;
use super::texts::explained;

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
}

/// Returns the values of a pattern from the paper, from its momentum, curl, stretch and trim. They cover everything
/// that shapes a tree, so that no default of the table shows through, and nothing that the tree grows on: land, mouths,
/// number of attractors, looks. Only in a link of its own is a preset of the usual country; on a map that is there, the page leaves that
/// as it is.
const fn pattern(momentum: Text, curl: Text, stretch: Text, trim: Text) -> [(Key, Text); 16] {
    [
        (Key::Country, "usual"),
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
pub static PRESETS: &[Preset] = &all([
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

/// Empties labels and help texts in a build without texts.
const fn all<const COUNT: usize>(mut presets: [Preset; COUNT]) -> [Preset; COUNT] {
    let mut i = 0;
    while i < COUNT {
        presets[i].label = explained(presets[i].label);
        presets[i].help = explained(presets[i].help);
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
