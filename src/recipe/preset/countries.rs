//! The countries that the page offers to begin with.

use super::{Preset, Text};
use crate::recipe::{Key, Style};

/// A kind of country: its land and its rivers. All countries set the same keys, so that choosing one leaves no trace of
/// another.
#[derive(Clone, Copy)]
struct Country {
    aspect: Text,
    land: Text,
    sea: Text,
    drowning: Text,
    roughness: Text,
    sides: Text,
    growth: Text,
    attractors: Text,
    sensitivity: Text,
    bending: Text,
    bending_variation: Text,
    pattern: Text,
    strike: Text,
    fall: Text,
    channel_area: Text,
    width: Text,
    rounds: Text,
    great_rivers: Text,
    flat_share: Text,
    neck: Text,
    oxbows: Text,
}

/// The values that most countries share.
const USUAL: Country = Country {
    aspect: "1.6",
    land: "island",
    sea: "0",
    drowning: "0.24",
    roughness: "1",
    sides: "s",
    growth: "drainage",
    attractors: "20000",
    sensitivity: "16",
    bending: "2.2",
    bending_variation: "1",
    pattern: "dendritic",
    strike: "0",
    fall: "0.35",
    channel_area: "3",
    width: "16",
    rounds: "18",
    great_rivers: "3",
    flat_share: "0.2",
    neck: "1.5",
    oxbows: "0.5",
};

impl Country {
    const fn values(self) -> [(Key, Text); 24] {
        [
            (Key::Aspect, self.aspect),
            (Key::Land, self.land),
            (Key::Sea, self.sea),
            (Key::Drowning, self.drowning),
            (Key::Roughness, self.roughness),
            (Key::Sides, self.sides),
            (Key::Growth, self.growth),
            (Key::Attractors, self.attractors),
            (Key::Sensitivity, self.sensitivity),
            (Key::Bending, self.bending),
            (Key::BendingVariation, self.bending_variation),
            (Key::Pattern, self.pattern),
            (Key::Strike, self.strike),
            (Key::CenterX, "0"),
            (Key::CenterY, "0"),
            (Key::Fall, self.fall),
            (Key::ChannelArea, self.channel_area),
            (Key::Mouths, "0"),
            (Key::Width, self.width),
            (Key::MeanderRounds, self.rounds),
            (Key::GreatRivers, self.great_rivers),
            (Key::FlatShare, self.flat_share),
            (Key::Neck, self.neck),
            (Key::Oxbows, self.oxbows),
        ]
    }
}

/// Countries that the page offers to begin with.
pub static COUNTRIES: &[Preset] = &[
    Preset {
        name: "island",
        label: "Island",
        help: "One island with bays and islets, all its rivers on their way to the sea.",
        values: &USUAL.values(),
        style: None,
    },
    Preset {
        name: "archipelago",
        label: "Archipelago",
        help: "Many islands, each with rivers of its own.",
        values: &Country { land: "archipelago", width: "14", ..USUAL }.values(),
        style: None,
    },
    Preset {
        name: "coast",
        label: "Coast",
        help: "Land with the sea to the south and west.",
        values: &Country { land: "continent", roughness: "0.9", sides: "sw", width: "18", rounds: "30", ..USUAL }
            .values(),
        style: None,
    },
    Preset {
        name: "great-valley",
        label: "Great valley",
        help: "A broad valley between two ridges, and one great river.",
        values: &Country {
            aspect: "1.3",
            land: "valley",
            roughness: "0.7",
            attractors: "18000",
            channel_area: "4",
            width: "20",
            rounds: "40",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "lakeland",
        label: "Lakeland",
        help: "A lake in the middle, and rivers that run inward.",
        values: &Country { aspect: "1.3", land: "basin", attractors: "18000", rounds: "24", ..USUAL }.values(),
        style: None,
    },
    Preset {
        name: "banner",
        label: "Banner",
        help: "A coast three times as wide as it is high, for the head of a page.",
        values: &Country { aspect: "3", land: "continent", roughness: "0.8", rounds: "24", ..USUAL }.values(),
        style: None,
    },
    Preset {
        name: "poster",
        label: "Poster",
        help: "An island on end, for a wall or a phone.",
        values: &Country { aspect: "0.7", rounds: "24", ..USUAL }.values(),
        style: None,
    },
    Preset {
        name: "old-river",
        label: "Old river",
        help: "Few rivers, wide and old: loops, cut necks and oxbow lakes.",
        values: &Country {
            aspect: "2",
            land: "valley",
            drowning: "0",
            roughness: "0.5",
            attractors: "5000",
            // Loops grow of even bends.
            bending: "1",
            bending_variation: "0",
            channel_area: "20",
            width: "26",
            rounds: "120",
            great_rivers: "5",
            flat_share: "0.6",
            neck: "2.5",
            oxbows: "1",
            ..USUAL
        }
        .values(),
        style: Some(Style::PastCourses),
    },
    Preset {
        name: "marsh",
        label: "Marsh",
        help: "A Brownian tree: streams that wander everywhere.",
        values: &Country { sea: "0.6", roughness: "0.6", growth: "brownian", sensitivity: "11", width: "18", ..USUAL }
            .values(),
        style: None,
    },
    Preset {
        name: "desert",
        label: "Desert",
        help: "Few rivers, far apart, that join at narrow angles.",
        values: &Country {
            land: "continent",
            drowning: "0.1",
            roughness: "0.8",
            attractors: "12000",
            fall: "0.8",
            channel_area: "40",
            width: "12",
            rounds: "40",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "rainforest",
        label: "Rainforest",
        help: "Water everywhere: the finest network.",
        values: &Country {
            land: "continent",
            sea: "0.3",
            roughness: "0.8",
            sides: "e",
            attractors: "45000",
            fall: "0.2",
            width: "24",
            rounds: "40",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "skerries",
        label: "Skerries",
        help: "More sea than land: islets and rocks with short streams.",
        values: &Country { land: "archipelago", sea: "0.8", drowning: "0.6", width: "10", rounds: "12", ..USUAL }
            .values(),
        style: None,
    },
    Preset {
        name: "volcano",
        label: "Volcano",
        help: "Rivers run down a cone on all sides: a radial pattern.",
        values: &Country {
            aspect: "1.2",
            sea: "0.6",
            drowning: "0",
            roughness: "0.6",
            pattern: "radial",
            channel_area: "5",
            width: "12",
            rounds: "10",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "even-slope",
        label: "Even slope",
        help: "Rivers side by side down an even plain: a parallel pattern.",
        values: &Country {
            land: "continent",
            sea: "0.2",
            roughness: "0.7",
            attractors: "14000",
            pattern: "parallel",
            width: "12",
            rounds: "12",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "folded-hills",
        label: "Folded hills",
        help: "Long rivers between ridges, with short ones down their flanks: a trellis.",
        values: &Country {
            land: "continent",
            sea: "0.2",
            roughness: "0.8",
            sides: "e",
            attractors: "12000",
            pattern: "trellis",
            strike: "16",
            channel_area: "5",
            rounds: "12",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "jointed-rock",
        label: "Jointed rock",
        help: "Rivers that turn at right angles, along cracks: a rectangular pattern.",
        values: &Country {
            land: "continent",
            sea: "0.2",
            roughness: "0.8",
            attractors: "12000",
            pattern: "rectangular",
            channel_area: "5",
            rounds: "8",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "worn-dome",
        label: "Worn dome",
        help: "Arcs around a dome of hard and soft beds: an annular pattern.",
        values: &Country {
            aspect: "1.2",
            sea: "0.55",
            roughness: "0.7",
            pattern: "annular",
            channel_area: "5",
            width: "12",
            rounds: "10",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "closed-basin",
        label: "Closed basin",
        help: "Rivers run to a lake from all around: a centripetal pattern.",
        values: &Country {
            aspect: "1.2",
            land: "basin",
            sea: "0.1",
            roughness: "0.8",
            pattern: "centripetal",
            channel_area: "5",
            width: "14",
            rounds: "12",
            ..USUAL
        }
        .values(),
        style: None,
    },
    Preset {
        name: "young-land",
        label: "Young land",
        help: "Rivers without order, as ice leaves them: a deranged pattern.",
        values: &Country {
            land: "continent",
            sea: "0.3",
            attractors: "12000",
            pattern: "deranged",
            channel_area: "5",
            width: "14",
            rounds: "12",
            ..USUAL
        }
        .values(),
        style: None,
    },
];
