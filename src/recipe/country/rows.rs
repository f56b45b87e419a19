//! The rows of the table of countries, and the climates that they draw from. `settling/draws.rs` explains the language of the
//! draws.

use super::Country;
use crate::recipe::Style;

/// The number of rows.
pub(in crate::recipe) const COUNT: usize = 34;

/// Draws of every country, unless its row says otherwise. `fall` is 0.2 at least: below that, neighbouring rivers run side by side without
/// joining. Few points are removed, so that courses keep their small turns, as rivers on maps do.
pub(in crate::recipe) const COMMON: &str = "attractors=12500~0.2 bending~0.3 bending-variation~0.25 channel-area~0.3 trim~0.15 \
    tributary-spacing~0.25 head-variation~0.35 valleys~0.4 valley-spacing~0.2 hardness~0.35 hardness-scale~0.2 fall~0.35>0.2 \
    width~0.08 meander-rounds~0.3 meander-elsewhere=0.14~0.4 simplify=10 rills~0.15 lakes=0.1:0.3 \
    deltas=0.3:0.5 waves=0.2:0.6";

/// Draws about the usual values, for land that is in no row: the rectangle, and what somebody has drawn.
pub(in crate::recipe) const OWN: &str = "attractors~0.25 bending~0.4 bending-variation~0.3 channel-area~0.5 trim~0.4 \
    tributary-spacing~0.35 head-variation~0.4 valleys~0.5 hardness~0.5 fall~0.6>0.2 simplify=20:75 lakes=0:0.3";

/// The draws of each climate.
pub(in crate::recipe) static CLIMATES: &[(&str, &str)] = &[
    ("temperate", "warmth=0.35:0.7 rain=0.3:0.7 rain-shadow=0.3:0.7"),
    ("wet", "warmth=0.55:0.9 rain=0.8:1 rain-shadow=0.3:0.7 woods=0|0|0.15:0.35"),
    ("dry", "warmth=0.6:0.9 rain=0:0.15 rain-shadow=0.2:0.7"),
    ("cold", "warmth=0:0.16 rain=0.4:0.7 rain-shadow=0.2:0.6"),
    ("volcanic", "ground=lava warmth=0.45:0.65 rain=0.35:0.75 rain-shadow=0.3:0.8"),
];

/// The table of countries. A new row takes only the words that it wins, and a weight counts against those of all others.
pub static COUNTRIES: [Country; COUNT] = [
    Country {
        name: "island",
        label: "Island",
        help: "One island with bays and islets, all its rivers on their way to the sea.",
        weight: 8,
        climates: "temperate temperate temperate wet cold dry",
        draws: "span=95~0.35 land=island sea=0.63:0.75 drowning=0.1:0.5 roughness=0.8:1 bending=1.2 hardness=1 hardness-scale=46 \
           fall=0.2 valleys=0.35 channel-area=6 trim=24 width=24 meander-rounds=40 flat-share=0.4 great-rivers=5 \
           mountains=2~0.25 plains=60:200",
        style: None,
    },
    Country {
        name: "low-island",
        label: "Low island",
        help: "A low island without mountains, where rivers wind.",
        weight: 4,
        climates: "temperate wet wet cold cold",
        draws: "span=70~0.35 land=island sea=0.6:0.72 drowning=0.15:0.6 roughness=0.9 bending=1.3 hardness=0.8 fall=0.2 \
           channel-area=6 trim=24 width=26 meander-rounds=64 flat-share=0.6 great-rivers=6 mountains=0.3:0.8 \
           plains=250 rills=0.4",
        style: None,
    },
    Country {
        name: "tilted-island",
        label: "Tilted island",
        help: "An island with one long flank, down which rivers run side by side.",
        weight: 4,
        climates: "temperate temperate dry wet",
        draws: "span=110~0.35 land=island sea=0.6:0.7 pattern=parallel drowning=0.1:0.4 roughness=1 bending=2 fall=0.2 hardness=0.8 \
           channel-area=6 trim=26 width=26 meander-rounds=48 flat-share=0.4 great-rivers=5 mountains=1.6~0.3 \
           plains=120",
        style: None,
    },
    Country {
        name: "peaked-island",
        label: "Peaked island",
        help: "An island with one summit, from which rivers run to all sides.",
        weight: 3,
        climates: "temperate wet dry volcanic",
        draws: "span=90~0.35 land=island sea=0.62:0.74 pattern=radial center-x=28:72 center-y=30:70 drowning=0.15:0.5 roughness=1 \
           bending=1.4 hardness=0.6 channel-area=6 trim=24 width=24 meander-rounds=40 flat-share=0.3 \
           mountains=1.6:3.4 plains=110",
        style: None,
    },
    Country {
        name: "volcano",
        label: "Volcano",
        help: "Rivers run down a steep cone on all sides.",
        weight: 3,
        climates: "volcanic",
        draws: "lakes=0:0.1 span=35~0.4 land=island sea=0.64:0.76 pattern=radial drowning=0.03 roughness=0.35:0.7 bending=1 channel-area=8 \
           trim=30 width=22 meander-rounds=10 mountains=3:4 plains=20:90 rills=0.9",
        style: None,
    },
    Country {
        name: "crescent",
        label: "Crescent",
        help: "An island bent round a bay.",
        weight: 3,
        climates: "volcanic temperate dry",
        draws: "span=30~0.4 land=crescent sea=0.7:0.8 drowning=0.1:0.7 hardness=0.8 bending=1.2 channel-area=6 trim=22 width=22 \
           meander-rounds=30 mountains=2.6~0.25 plains=60",
        style: None,
    },
    Country {
        name: "twin-islands",
        label: "Twin islands",
        help: "Two islands face to face.",
        weight: 3,
        climates: "temperate temperate wet dry",
        draws: "span=75~0.35 land=twins sea=0.64:0.74 drowning=0.2:0.8 hardness=0.9 bending=1.2 channel-area=6 trim=24 width=24 meander-rounds=40 \
           flat-share=0.4 mountains=2~0.35",
        style: None,
    },
    Country {
        name: "long-island",
        label: "Long island",
        help: "One long, narrow island with short rivers.",
        weight: 3,
        climates: "temperate temperate wet cold",
        draws: "span=120~0.35 land=long sea=0.76:0.8 drowning=0.3:0.85 hardness=0.9 bending=1.2 channel-area=6 trim=22 width=24 meander-rounds=40 \
           flat-share=0.4 mountains=1.8~0.35",
        style: None,
    },
    Country {
        name: "arms",
        label: "Island with arms",
        help: "Long peninsulas that reach out from one middle.",
        weight: 2,
        climates: "wet wet temperate dry",
        draws: "span=180~0.35 land=arms sea=0.7:0.78 drowning=0.2:0.8 hardness=0.8 bending=1.2 channel-area=6 trim=22 width=24 meander-rounds=40 \
           flat-share=0.4 mountains=1.8~0.35",
        style: None,
    },
    Country {
        name: "archipelago",
        label: "Archipelago",
        help: "Many islands, each with rivers of its own.",
        weight: 6,
        climates: "temperate temperate wet wet cold",
        draws: "span=65~0.35 land=archipelago sea=0.74:0.8 drowning=0.3:0.8 roughness=1 bending=1.2 channel-area=5 trim=20 width=22 \
           meander-rounds=30 mountains=1.8~0.4 plains=100",
        style: None,
    },
    Country {
        name: "skerries",
        label: "Skerries",
        help: "More sea than land: islets and rocks with short streams.",
        weight: 3,
        climates: "cold cold temperate",
        draws: "deltas=0:0.15 lakes=0.2:0.5 span=16~0.4 land=archipelago sea=0.68:0.78 drowning=0.85:1 roughness=1 pattern=deranged hardness=1.2 \
           hardness-scale=14 valley-spacing=12 bending=1.2 channel-area=5 trim=18 width=16 meander-rounds=12 \
           mountains=0.35:0.9 plains=100",
        style: None,
    },
    Country {
        name: "skerry-coast",
        label: "Coast with skerries",
        help: "A low coast of bare rock, broken into islets.",
        weight: 3,
        climates: "cold cold temperate",
        draws: "deltas=0:0.2 lakes=0.3:0.6 span=40~0.4 land=continent sides=n|e|s|w|se|sw sea=0.45:0.6 drowning=0.85:1 roughness=1 pattern=deranged \
           hardness=1.2 hardness-scale=16 bending=1.4 channel-area=5 trim=20 width=18 meander-rounds=12 \
           mountains=0.35:0.9 plains=150",
        style: None,
    },
    Country {
        name: "coast",
        label: "Coast",
        help: "Land with the sea along one or two of its sides.",
        weight: 7,
        climates: "temperate temperate temperate wet dry cold",
        draws: "span=190~0.35 land=continent sides=n|e|s|w|ne|se|sw|nw sea=0.28:0.48 drowning=0.1:0.45 roughness=0.95 bending=1.8 \
           channel-area=5 trim=24 width=24 meander-rounds=40 flat-share=0.4 great-rivers=5 mountains=1.6~0.3 \
           plains=60:250",
        style: None,
    },
    Country {
        name: "ria-coast",
        label: "Coast with rias",
        help: "A coast whose valleys the sea has drowned.",
        weight: 4,
        climates: "temperate temperate wet",
        draws: "deltas=0.1:0.3 span=60~0.35 land=continent sides=e|s|w|se|sw sea=0.33:0.48 drowning=0.6:0.95 roughness=1 bending=1.8 channel-area=5 \
           trim=24 width=24 meander-rounds=40 flat-share=0.4 captures=12 mountains=0.6:1.2 plains=250",
        style: None,
    },
    Country {
        name: "fjords",
        label: "Fjords",
        help: "A steep coast with long inlets between mountains.",
        weight: 5,
        climates: "cold",
        draws: "deltas=0:0.2 lakes=0.3:0.5 span=110~0.35 land=continent sea=0.36:0.48 drowning=1 roughness=1 bending=1.8 channel-area=5 trim=24 width=20 \
           meander-rounds=20 mountains=2.8:4 plains=0 \
           sides,strike,pattern,hardness=w,80,trellis,1.3|e,100,trellis,1.3|n,172,trellis,1.3|w,0,dendritic,1|e,0,dendritic,1|s,0,dendritic,1.1|n,0,dendritic,0.9",
        style: None,
    },
    Country {
        name: "peninsula",
        label: "Peninsula",
        help: "Land with the sea on three sides.",
        weight: 6,
        climates: "temperate temperate wet dry cold",
        draws: "span=140~0.35 land=continent sides=esw|nes|nws|new sea=0.45:0.6 drowning=0.15:0.5 roughness=1 bending=1.6 \
           channel-area=5 trim=24 width=24 meander-rounds=40 flat-share=0.4 great-rivers=5 mountains=1.6~0.4 \
           plains=120",
        style: None,
    },
    Country {
        name: "straits",
        label: "Straits",
        help: "Land with the sea on two opposite sides, or on all four.",
        weight: 4,
        climates: "temperate temperate dry wet",
        draws: "span=120~0.35 land=continent sides=ns|ew|nesw sea=0.42:0.58 drowning=0.15:0.6 roughness=1 bending=1.6 channel-area=5 \
           trim=24 width=22 meander-rounds=40 flat-share=0.4 mountains=1.4~0.4 plains=120",
        style: None,
    },
    Country {
        name: "great-river",
        label: "Great river",
        help: "One river drains nearly all of the land.",
        weight: 7,
        climates: "wet wet temperate temperate dry",
        draws: "deltas=0.5:0.7 lakes=0.05:0.2 span=480~0.3 land=continent sides=n|e|e|s|w|w mouths=1 sea=0.12:0.24 drowning=0.12 roughness=0.9 bending=2 \
           concavity=0.6 channel-area=7 trim=28 width=26 meander-rounds=56 flat-share=0.5 great-rivers=6 \
           mountains=1.6~0.35 plains=120:350 \
           pattern,captures,valleys,fall=dendritic,20,0.4,0.25|dendritic,20,0.5,0.2|centripetal,6,0.2,0.3",
        style: None,
    },
    Country {
        name: "low-country",
        label: "Low country",
        help: "A green plain with broad rivers.",
        weight: 6,
        climates: "wet wet temperate temperate",
        draws: "deltas=0.45:0.65 span=180~0.35 land=continent sides=n|e|s|w|sw|nw|se mouths=0|3|4|6 mouth-spacing=250 sea=0.15:0.35 drowning=0.15 \
           roughness=0.9 bending=2 captures=12 channel-area=7 trim=28 width=26 meander-rounds=45 flat-share=0.5 \
           great-rivers=5 mountains=0.2:0.45 plains=400 rills=0.1:0.35 fall=0.2 shade=0.35",
        style: None,
    },
    Country {
        name: "old-river",
        label: "Old river",
        help: "Few rivers, wide and old: loops, cut necks and oxbow lakes.",
        weight: 3,
        climates: "wet temperate",
        draws: "lakes=0 span=60~0.3 land=valley sides=e|w|s|n mouths=1 sea=0.12 drowning=0 roughness=0.5 attractors=5000 bending=1 \
           bending-variation=0 channel-area=20 width=30 meander-rounds=120 great-rivers=5 flat-share=0.6 neck=2.5 \
           oxbows=1 mountains=0.3:1 plains=400",
        style: Some(Style::PastCourses),
    },
    Country {
        name: "alps",
        label: "Alps",
        help: "High mountains with rivers in deep valleys.",
        weight: 5,
        climates: "cold cold temperate wet",
        draws: "span=150~0.3 land=continent sides=n|e|s|w|sw|se captures=12 sea=0.1:0.3 drowning=0.24 roughness=1 bending=1.6 \
           channel-area=7 trim=26 width=22 meander-rounds=30 flat-share=0.25 mountains=3:4 plains=10:60 rills=1 \
           shade=0.55",
        style: None,
    },
    Country {
        name: "plateau",
        label: "Plateau",
        help: "A high plain that rivers cut into.",
        weight: 4,
        climates: "dry dry dry temperate",
        draws: "span=300~0.3 land=continent sides=n|e|s|w captures=12 sea=0.12:0.3 drowning=0.1 roughness=0.8 bending=1.6 \
           channel-area=12 trim=32 width=20 meander-rounds=30 flat-share=0.2 mountains=2:3.2 plains=0 \
           rills=0.05:0.25 shade=0.6 fall=0.25",
        style: None,
    },
    Country {
        name: "lakeland",
        label: "Lakeland",
        help: "A lake, and rivers that run to it from all around.",
        weight: 5,
        climates: "temperate temperate cold cold wet",
        draws: "lakes=0.7 span=110~0.35 land=basin sea=0.08:0.24 drowning=0.3:0.9 roughness=1 bending=1.6 channel-area=6 trim=24 width=24 \
           meander-rounds=40 flat-share=0.3 mountains=1.3~0.4 plains=80",
        style: None,
    },
    Country {
        name: "inland-sea",
        label: "Inland sea",
        help: "A sea in the midst of the land, with inlets.",
        weight: 3,
        climates: "temperate dry wet",
        draws: "span=380~0.35 land=basin sea=0.24:0.38 drowning=0.75:1 roughness=1 hardness=1 bending=1.6 channel-area=6 trim=24 \
           width=26 meander-rounds=40 flat-share=0.4 mountains=1.5~0.4 plains=120",
        style: None,
    },
    Country {
        name: "gulf",
        label: "Gulf",
        help: "Land around a sea that one strait joins to the ocean.",
        weight: 2,
        climates: "dry temperate temperate",
        draws: "span=320~0.35 land=gulf sea=0.2:0.3 drowning=0.6:1 hardness=1 bending=1.6 channel-area=6 trim=24 width=26 meander-rounds=40 \
           flat-share=0.4 mountains=1.5~0.35",
        style: None,
    },
    Country {
        name: "closed-basin",
        label: "Closed basin",
        help: "Rivers run to a lake without an outlet, in a dry climate.",
        weight: 3,
        climates: "dry",
        draws: "lakes=0 span=300~0.35 land=basin sea=0.06:0.16 drowning=0.3 roughness=0.8 bending=2.2 channel-area=12 trim=32 width=16 \
           meander-rounds=20 mountains=0.8:2 plains=300 rills=0.4 \
           pattern,hardness,center-x=centripetal,0.9,35|centripetal,0.9,64|dendritic,0.6,50",
        style: None,
    },
    Country {
        name: "folded-hills",
        label: "Folded hills",
        help: "Long rivers between ridges, with short ones down their flanks.",
        weight: 4,
        climates: "temperate temperate wet",
        draws: "span=160~0.35 land=continent sea=0.12:0.3 drowning=0.24 roughness=0.9 pattern=trellis attractors=10000 bending=1.4 \
           channel-area=6 trim=24 width=20 meander-rounds=16 mountains=1:2.4 plains=80 \
           sides,strike=e,16|e,170|w,10|w,165|s,80|s,100|n,75|n,105",
        style: None,
    },
    Country {
        name: "jointed-rock",
        label: "Jointed rock",
        help: "Rivers that turn at right angles, along cracks.",
        weight: 2,
        climates: "dry cold temperate",
        draws: "span=90~0.35 land=continent sides=n|e|s|w sea=0.15:0.35 drowning=0.4 roughness=0.9 pattern=rectangular \
           attractors=10000 bending=0.9 channel-area=7 trim=26 width=20 meander-rounds=8 mountains=1.5~0.4 plains=60",
        style: None,
    },
    Country {
        name: "worn-dome",
        label: "Worn dome",
        help: "Rivers in arcs around a dome of hard and soft beds.",
        weight: 2,
        climates: "temperate dry",
        draws: "span=180~0.35 land=continent sides=n|e|s|w|sw|se sea=0.15:0.4 drowning=0.24 roughness=0.9 pattern=annular bending=2 \
           hardness=0.9 channel-area=8 trim=30 width=20 meander-rounds=14 mountains=0.8:1.8 plains=120",
        style: None,
    },
    Country {
        name: "even-slope",
        label: "Even slope",
        help: "Rivers side by side down an even plain.",
        weight: 3,
        climates: "dry temperate temperate",
        draws: "span=200~0.35 land=continent sides=n|e|s|w sea=0.15:0.3 drowning=0.2 roughness=0.8 pattern=parallel hardness=0.7 \
           attractors=10000 bending=1.8 channel-area=7 trim=28 width=18 meander-rounds=20 mountains=0.4:1.1 \
           plains=300 rills=0.35",
        style: None,
    },
    Country {
        name: "young-land",
        label: "Young land",
        help: "Rivers without order, as ice leaves them.",
        weight: 3,
        climates: "cold cold temperate",
        draws: "lakes=0.6 span=130~0.35 land=continent sides=n|e|s|w|se sea=0.25:0.42 drowning=0.6 roughness=1 pattern=deranged attractors=10000 \
           bending=1.8 channel-area=6 trim=24 width=20 meander-rounds=20 mountains=0.4:1.1 plains=150",
        style: None,
    },
    Country {
        name: "desert",
        label: "Desert",
        help: "Few rivers, far apart, in dry country.",
        weight: 4,
        climates: "dry",
        draws: "lakes=0 span=420~0.3 land=continent sides=n|e|s|w sea=0.15:0.35 drowning=0.08 roughness=0.8 attractors=9000 bending=2 \
           channel-area=20 trim=40 width=14 meander-rounds=30 mountains=0.7:2 plains=350 rills=0.3 fall=0.6",
        style: None,
    },
    Country {
        name: "rainforest",
        label: "Rainforest",
        help: "Water everywhere: a fine network of broad rivers.",
        weight: 4,
        climates: "wet",
        draws: "deltas=0.5:0.7 lakes=0.05:0.15 span=360~0.3 land=continent sides=n|e|e|s|w mouths=0|2|3 mouth-spacing=300 captures=8 concavity=0.6 sea=0.12:0.25 \
           drowning=0.2 roughness=0.9 attractors=14000:19000 bending=2 channel-area=5 trim=22 width=28 \
           meander-rounds=48 flat-share=0.6 great-rivers=6 mountains=0.5:1.2 plains=350 fall=0.2",
        style: None,
    },
    Country {
        name: "marsh",
        label: "Marsh",
        help: "A low island where streams wander everywhere: a Brownian tree.",
        weight: 2,
        climates: "wet",
        draws: "lakes=0.2:0.5 span=45~0.35 land=island growth=brownian sensitivity=12 sea=0.42:0.6 drowning=0.3 roughness=0.9 width=24 trim=26 \
           meander-rounds=30 mountains=0.2 plains=400 rills=0.1",
        style: None,
    },
];
