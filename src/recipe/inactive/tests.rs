use super::*;
use crate::land::Land;
use crate::recipe::link;
use crate::recipe::table::TABLE;

fn reason(link: &str, key: Key) -> Option<&'static str> {
    let recipe = link::read(link).unwrap();
    recipe.inactive_reason(key, Land::kind_of(&recipe))
}

#[test]
fn what_does_something_has_no_reason_not_to() {
    for (link, key) in [
        ("land=valley", Key::Sides),
        ("land=island", Key::Shores),
        ("land=continent", Key::Sides),
        ("land=drawn&outline=.MzMzzMMzzMzM", Key::Outline),
        ("meander-rounds=0", Key::MeanderRounds),
        ("great-rivers=0", Key::Taper),
        ("style=skeleton", Key::Width),
        ("growth=colonize&curl=0.5", Key::Stretch),
        ("growth=colonize&valleys=0", Key::Scatter),
        ("growth=colonize&valleys=0.3", Key::ValleySpacing),
        ("growth=drainage&hardness=0.1", Key::HardnessScale),
        ("growth=drainage&bending=0.1", Key::BendingVariation),
        ("growth=drainage&pattern=trellis", Key::Strike),
        ("growth=drainage&pattern=annular", Key::CenterY),
        ("growth=drainage&pattern=deranged&valleys=0", Key::ValleySpacing),
        ("growth=colonize&pattern=parallel", Key::Valleys),
        ("growth=drainage&land=island", Key::MouthSpacing),
        ("growth=drainage&land=valley", Key::Drowning),
        ("labels=none", Key::Labels),
        ("labels=none&cartouche=plain", Key::LabelSize),
        ("labels=few&cartouche=none", Key::LabelSize),
        ("style=ink&land=rectangle", Key::Woods),
        ("style=ink&land=rectangle", Key::Hills),
        ("style=survey", Key::Woods),
        ("style=parchment", Key::Hills),
        ("style=ink-wash", Key::Hills),
        ("style=parchment", Key::Warmth),
        ("style=night", Key::Ground),
        ("style=night&rain-shadow=0.3", Key::Wind),
        ("style=ink&woods=0.2", Key::Warmth),
        ("style=survey&woods=0.2", Key::RainShadow),
    ] {
        assert_eq!(reason(link, key), None, "{link}");
    }
}

/// A recipe in which nearly every parameter has an effect, whatever the defaults are.
const LIVELY: &str = "country=usual&land=rectangle&growth=colonize&valleys=0.3&curl=0.5&courses=smooth&meander=bend&meander-rounds=60&meander-strength=0.5&great-rivers=3&meander-elsewhere=0.3&labels=some&style=basins&trim=20&deltas=0.5";

const NO_COAST: (&str, &str) =
    ("sea drowning roughness mouth-spacing shores deltas waves", "the whole rectangle is land, so there is no coast");
const DRAWN_MOUTHS: &str = "the drawing determines where rivers begin";
const NOT_DRAWN: (&str, &str) = ("outline", "the land is not drawn");
const NO_SENSITIVITY: (&str, &str) = ("sensitivity", "only Brownian trees use it");
const NOT_DRAINING: (&str, &str) = (
    "drowning concavity captures hardness hardness-scale bending bending-variation pattern strike center-x center-y fall channel-area head-variation",
    "only drainage uses it",
);
/// The same where a lake or a gulf has its place.
const WITH_A_PLACE: (&str, &str) = (
    "drowning concavity captures hardness hardness-scale bending bending-variation pattern strike fall channel-area head-variation",
    "only drainage uses it",
);
const NO_STRIKE: (&str, &str) = ("strike", "this pattern has no strike");
const NO_CENTER: (&str, &str) = ("center-x center-y", "this pattern has no centre");
const IN_CELLS: (&str, &str) = ("scatter", "with valleys, attractors lie in cells of the map");
const NOT_COLONIZING: (&str, &str) =
    ("scatter reach kill step momentum curl stretch", "only space colonization uses it");
const BROWNIAN: (&str, &str) =
    ("mouths mouth-spacing shores attractors valleys valley-spacing", "Brownian trees do not use it");
const NO_LONGER_SHAPED: &str = "simplify meander meander-rounds meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper";
const NO_RELIEF: (&str, &str) = ("shade rain-shadow wind", "this style shows no relief");
const NO_HEIGHTS: (&str, &str) =
    ("mountains plains rills", "this style shows no relief, though files of heights have it");
const NO_LAKES: (&str, &str) = ("lakes", "the skeleton shows rivers alone, though files have lakes");
const NO_CLIMATE: (&str, &str) =
    ("warmth rain rain-shadow wind ground", "this style has the same colours in every climate");
const EVEN_RAIN: (&str, &str) = ("wind", "rain falls evenly");
const NO_WOODS: (&str, &str) = ("woods", "this style shows no woods");
const NO_HILLS: (&str, &str) = ("hills", "this style shows no hills");
const RELIEF_ITSELF: (&str, &str) = ("hills", "this style shows the relief itself, without signs for hills");
const RECTANGULAR: &[(&str, &str)] = &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_CLIMATE];

/// Values that are set over the lively recipe, and the keys without effect in the result, each with its reason.
const EXPECTED: &[(&str, &[(&str, &str)])] = &[
    ("", RECTANGULAR),
    ("land=drawn&outline=", RECTANGULAR),
    // A drawing without sea, with and without a lake too small to be seen; and one with hardly any land.
    ("land=drawn&outline=.AAAA__AA____AA__", RECTANGULAR),
    ("land=drawn&outline=.AAAA__AA____AA__.gAgAgBgAgBgB", RECTANGULAR),
    ("land=drawn&outline=.gAgAhhgAgAhh", RECTANGULAR),
    (
        "land=drawn&outline=.MzMzzMMzzMzM",
        &[
            ("sea drowning sides", "the drawing determines where the sea is"),
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            NO_CLIMATE,
        ],
    ),
    (
        "land=island&deltas=0",
        &[
            ("sides", "this land has the sea all around it"),
            NOT_DRAWN,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            NO_CLIMATE,
            ("waves", "rivers carry no sediment"),
        ],
    ),
    (
        "land=island",
        &[
            ("sides", "this land has the sea all around it"),
            NOT_DRAWN,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            NO_CLIMATE,
        ],
    ),
    (
        "land=drawn&outline=.MzMzzMMzzMzM...gAgA",
        &[
            ("sea drowning", "the drawing determines where the sea is"),
            ("sides mouths mouth-spacing shores", DRAWN_MOUTHS),
            NO_SENSITIVITY,
            NO_CLIMATE,
            NOT_DRAINING,
            IN_CELLS,
        ],
    ),
    (
        "land=drawn&outline=...gAgA",
        &[NO_COAST, ("sides mouths", DRAWN_MOUTHS), NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_CLIMATE],
    ),
    // A drawing that is not used as land gives no mouths either.
    (
        "land=island&outline=...gAgA",
        &[
            ("sides", "this land has the sea all around it"),
            NOT_DRAWN,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            NO_CLIMATE,
        ],
    ),
    (
        "land=archipelago",
        &[
            ("sides", "this land has the sea all around it"),
            NOT_DRAWN,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            NO_CLIMATE,
        ],
    ),
    (
        "land=twins",
        &[
            ("sides", "this land has the sea all around it"),
            NOT_DRAWN,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            NO_CLIMATE,
        ],
    ),
    ("land=continent", &[NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_CLIMATE]),
    ("land=valley", &[NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_CLIMATE]),
    (
        "land=basin",
        &[
            ("sides", "rivers flow to the lake in the middle"),
            NOT_DRAWN,
            NO_SENSITIVITY,
            WITH_A_PLACE,
            IN_CELLS,
            NO_CLIMATE,
        ],
    ),
    (
        "land=gulf",
        &[
            ("sides", "rivers flow to the gulf in the middle"),
            NOT_DRAWN,
            NO_SENSITIVITY,
            WITH_A_PLACE,
            IN_CELLS,
            NO_CLIMATE,
        ],
    ),
    ("land=continent&growth=brownian", &[NOT_DRAWN, NO_CLIMATE, NOT_DRAINING, BROWNIAN, NOT_COLONIZING]),
    ("growth=brownian", &[NO_COAST, NOT_DRAWN, NO_CLIMATE, NOT_DRAINING, BROWNIAN, NOT_COLONIZING]),
    (
        "curl=0",
        &[NO_COAST, NOT_DRAWN, NO_CLIMATE, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, ("stretch", "there is no curl")],
    ),
    (
        "meander=none",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            (
                "meander-rounds meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                STILL,
            ),
        ],
    ),
    (
        "meander-rounds=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            (
                "meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                STILL,
            ),
        ],
    ),
    (
        "great-rivers=0&meander-elsewhere=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            ("meander-strength meander-mix neck oxbows clearance taper", STILL),
            ("flat-share", "there are no great rivers"),
        ],
    ),
    (
        "great-rivers=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            ("flat-share", "there are no great rivers"),
        ],
    ),
    ("meander-elsewhere=0", RECTANGULAR),
    (
        "meander-strength=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            ("meander-mix", "bends do not move"),
        ],
    ),
    (
        "meander=flow",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            ("meander-mix", "only bends that grow outward use it"),
        ],
    ),
    (
        "courses=grown",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            (NO_LONGER_SHAPED, "rivers keep the steps of their tree"),
        ],
    ),
    (
        "courses=grown&meander=none&great-rivers=0&meander-elsewhere=0&style=skeleton",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_RELIEF,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            (NO_LONGER_SHAPED, "rivers keep the steps of their tree"),
            ("width bank-variation", "the skeleton is one pixel wide everywhere"),
            NO_LAKES,
            NO_HEIGHTS,
            NO_WOODS,
            NO_HILLS,
        ],
    ),
    ("style=ink", &[NO_COAST, NOT_DRAWN, NO_RELIEF, NO_CLIMATE, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_HEIGHTS]),
    (
        "style=skeleton",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_RELIEF,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            NO_LAKES,
            NO_HEIGHTS,
            NO_WOODS,
            NO_HILLS,
        ],
    ),
    ("style=atlas", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, RELIEF_ITSELF, EVEN_RAIN]),
    ("style=orbit", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_WOODS, RELIEF_ITSELF, EVEN_RAIN]),
    (
        "style=skeleton&meander-rounds=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_RELIEF,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            (
                "meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                STILL,
            ),
            ("width bank-variation", "the skeleton is one pixel wide everywhere"),
            NO_LAKES,
            NO_HEIGHTS,
            NO_WOODS,
            NO_HILLS,
        ],
    ),
    (
        "style=skeleton&meander=none",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_RELIEF,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            (
                "meander-rounds meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                STILL,
            ),
            ("width bank-variation", "the skeleton is one pixel wide everywhere"),
            NO_LAKES,
            NO_HEIGHTS,
            NO_WOODS,
            NO_HILLS,
        ],
    ),
    ("growth=drainage", &[NO_COAST, NOT_DRAWN, NO_CLIMATE, NO_SENSITIVITY, NOT_COLONIZING, NO_STRIKE, NO_CENTER]),
    (
        "growth=drainage&pattern=parallel&bending=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_COLONIZING,
            NO_CENTER,
            ("valleys", "the pattern determines the valleys"),
            ("valley-spacing", "there are no valleys"),
            ("bending-variation", "courses are not bent"),
        ],
    ),
    (
        "growth=drainage&pattern=deranged",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_COLONIZING,
            NO_STRIKE,
            NO_CENTER,
            ("valleys", "the pattern determines the valleys"),
        ],
    ),
    (
        "trim=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_DRAINING,
            IN_CELLS,
            ("trim-variation", "nothing is trimmed"),
        ],
    ),
    (
        "growth=drainage&land=island",
        &[
            ("sides", "this land has the sea all around it"),
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_COLONIZING,
            NO_STRIKE,
            NO_CENTER,
        ],
    ),
    (
        "valleys=0",
        &[NO_COAST, NOT_DRAWN, NO_CLIMATE, NO_SENSITIVITY, NOT_DRAINING, ("valley-spacing", "there are no valleys")],
    ),
    (
        "growth=drainage&valleys=0&hardness=0",
        &[
            NO_COAST,
            NOT_DRAWN,
            NO_CLIMATE,
            NO_SENSITIVITY,
            NOT_COLONIZING,
            NO_STRIKE,
            NO_CENTER,
            ("valley-spacing", "there are no valleys"),
            ("hardness-scale", "all ground is equally hard"),
        ],
    ),
];

#[test]
fn letters_have_a_size_where_there_are_letters() {
    for link in ["labels=none", "labels=none&cartouche=auto", "labels=none&cartouche=none"] {
        assert_eq!(reason(link, Key::LabelSize), Some("there are no labels"), "{link}");
    }
}

#[test]
fn each_kind_of_recipe_has_its_idle_keys_and_no_others() {
    for (over, expected) in EXPECTED {
        let lively = link::pairs(LIVELY).unwrap().into_iter();
        let over = link::pairs(over).unwrap();
        let kept = lively.filter(|(key, _)| over.iter().all(|(other, _)| other != key));
        let recipe = link::apply(Recipe::default(), &kept.chain(over.clone()).collect::<Vec<_>>()).unwrap();
        for parameter in &TABLE {
            let names = |(keys, _): &&(&str, &str)| keys.split(' ').any(|key| key == parameter.name);
            let reason = expected.iter().find(names).map(|(_, reason)| *reason);
            assert_eq!(
                recipe.inactive_reason(parameter.key, Land::kind_of(&recipe)),
                reason,
                "{} with {over:?}",
                parameter.name
            );
        }
    }
}
