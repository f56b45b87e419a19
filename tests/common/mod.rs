//! Code that several test files share.
#![allow(dead_code, reason = "each test file uses its own part")]
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test fails by panicking")]

pub mod lands;
pub mod literal;
pub mod literal_ground;
pub mod pairs;
pub mod parts;
pub mod plain;
pub mod property;
pub mod shape;
pub mod svg_ids;
pub mod tier;
pub mod twin;
pub mod words;

use proptest::prelude::*;
use riverseed::Session;
use riverseed::recipe::{Choice, EDITION, Pattern, Recipe, Style, link};

/// Finishes the rivers of a link, with some parameters set differently.
pub fn finished(link: &str, over: &str) -> Session {
    let over = link::pairs(over).unwrap();
    let mut pairs = link::pairs(link).unwrap();
    pairs.retain(|(key, _)| over.iter().all(|(other, _)| other != key));
    pairs.extend(over);
    let mut session = Session::new(link::apply(Recipe::default(), &pairs).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// Returns the words of all styles of a kind.
pub fn styles(is_one: impl Fn(Style) -> bool) -> Vec<&'static str> {
    Style::ALL.iter().filter(|&&style| is_one(style)).map(|style| style.word().name).collect()
}

/// Outlines of random lines, most of which cross themselves and each other; some are empty or have only rivers.
pub fn random_outline() -> impl Strategy<Value = String> {
    let lines =
        "([.]([A-Za-z0-9_-]{4}){3,9}){1,3}([.]{2}([A-Za-z0-9_-]{4}){2,9}){0,2}([.]{3}([A-Za-z0-9_-]{4}){1,9}){0,2}";
    prop_oneof![2 => Just(String::new()), 4 => lines, 1 => "([.]{3}([A-Za-z0-9_-]{4}){1,9}){1,4}"]
}

/// Any escaped text that a seed may be; mostly a short word, which is easier to read in a failure.
fn random_seed() -> impl Strategy<Value = String> {
    let seed = prop_oneof![9 => "[a-z]{1,8}", 1 => "[^\\p{C}\u{fffd}]{0,64}"];
    seed.prop_map(|seed| form_urlencoded::byte_serialize(seed.as_bytes()).collect())
}

/// Space colonization; half of the links as in the paper.
fn colonize() -> impl Strategy<Value = String> {
    prop_oneof![
        Just("colonize&valleys=0".to_string()),
        (0.01f64..=1.0, 4.0f64..=60.0)
            .prop_map(|(valleys, spacing)| format!("colonize&valleys={valleys:.2}&valley-spacing={spacing:.1}")),
    ]
}

/// Drainage over all ranges.
fn drainage() -> impl Strategy<Value = String> {
    let valleys = (prop_oneof![Just(0.0), 0.0f64..=1.0], 4.0f64..=60.0, 0u32..=24, 0.2f64..=0.8);
    let ground = (0.0f64..=1.5, 8.0f64..=60.0, 0.0f64..=4.0, 1u32..=60);
    let zero_or = |most: f64| prop_oneof![Just(0.0), 0.0..=most];
    let pattern = prop_oneof![
        Just("dendritic"),
        proptest::sample::select(Pattern::WORDS.iter().map(|word| word.name).collect::<Vec<_>>())
    ];
    let places = (0u32..=180, 0u32..=100, 0u32..=100);
    let country = (pattern, places, zero_or(2.0), zero_or(1.0), zero_or(1.0)).prop_map(
        |(pattern, (strike, x, y), fall, bends, heads)| {
            format!(
                "&pattern={pattern}&strike={strike}&center-x={x}&center-y={y}&fall={fall:.2}&bending-variation={bends:.2}&head-variation={heads:.2}"
            )
        },
    );
    (valleys, ground, country).prop_map(
        |((valleys, spacing, captures, concavity), (hardness, scale, bending, area), country)| {
            format!(
                "drainage&valleys={valleys:.2}&valley-spacing={spacing:.1}&captures={captures}&concavity={concavity:.2}\
                 &hardness={hardness:.2}&hardness-scale={scale:.1}&bending={bending:.2}&channel-area={area}{country}"
            )
        },
    )
}

/// A style, in most cases in a climate other than the temperate.
fn style() -> impl Strategy<Value = String> {
    let styles = proptest::sample::select(Style::WORDS.iter().map(|word| word.name).collect::<Vec<_>>());
    let climate = prop_oneof![1 => Just((0.5, 0.5, 0.0)), 3 => (0.0f64..=1.0, 0.0f64..=1.0, 0.0f64..=1.0)];
    (styles, climate, any::<bool>()).prop_map(|(style, (warmth, rain, shadow), is_lava)| {
        let ground = if is_lava { "lava" } else { "soil" };
        format!("{style}&warmth={warmth:.2}&rain={rain:.2}&rain-shadow={shadow:.2}&ground={ground}")
    })
}

/// Links over all ranges, with up to this number of attractors.
pub fn random_link(most_attractors: u32) -> impl Strategy<Value = String> {
    // Half of them are on the plain rectangle, where more happens in a second.
    let lands = proptest::sample::select(lands::words_of_lands_with_a_coast());
    let land = (
        prop_oneof![Just("rectangle"), lands],
        (0.1f64..=0.8, prop_oneof![Just(0.0), 0.0f64..=1.0]),
        0.0f64..=1.0,
        random_outline(),
    );
    let ground = (0.25f64..=4.0, prop_oneof![1u32..=5, 1u32..=64], 1u32..16, 100..=most_attractors, any::<bool>());
    let procedure = prop_oneof![4 => colonize(), 1 => Just("brownian".to_string()), 4 => drainage()];
    let mouths = (prop_oneof![Just(0), 0..=400], prop_oneof![Just(15u32), 1u32..16]);
    // A sensitivity of 8 takes about fifty times as long as one of 40.
    let sensitivity = prop_oneof![39 => 40u32..=64, 1 => 8u32..40];
    let growth = (2.1f64..=12.0, 0.5f64..=1.4, 0.2f64..=1.2, procedure, sensitivity, mouths);
    let zero_or = |most: f64| prop_oneof![Just(0.0), 0.0..=most];
    let bends = (zero_or(0.9), zero_or(2.0), 1u32..=64);
    let trim = (prop_oneof![Just(0u32), 0u32..=60, 0u32..=400], zero_or(1.0), zero_or(6.0), zero_or(1.0), zero_or(1.0))
        .prop_map(|(trim, variation, spacing, rills, lakes)| {
            format!(
                "{trim}&trim-variation={variation:.2}&tributary-spacing={spacing:.2}&rills={rills:.2}&lakes={lakes:.2}"
            )
        });
    let finish = (trim, 1.0f64..=40.0, style());
    let meanders = (
        prop_oneof![3 => Just("bend"), 2 => Just("flow"), 1 => Just("none")],
        prop_oneof![4 => 0u32..=60, 1 => 0u32..=400],
    );
    let how = (0.0f64..=1.0, 0.0f64..=1.0, 0.0f64..=1.0, 0u32..=16, 0.0f64..=1.0);
    let guards = (1.0f64..=4.0, 0.0f64..=1.0, 1.0f64..=20.0);
    let courses = prop_oneof![3 => Just("smooth"), 1 => Just("grown")];
    let rivers = ((courses, 0u32..=95), 0.0f64..=0.5, meanders, how, guards).prop_map(rivers_link);
    let deltas =
        (zero_or(1.0), 0.0f64..=1.0).prop_map(|(deltas, waves)| format!("&deltas={deltas:.2}&waves={waves:.2}"));
    let edition = prop_oneof![Just(String::new()), Just(format!("&edition={EDITION}"))];
    let start = (random_seed(), edition);
    let last = (1.0f64..=3.7, deltas);
    (start, land, ground, growth, bends, finish, rivers, last).prop_map(|(start, land, ground, growth, bends, finish, rivers, (span, deltas))| {
        let span = libm::pow(10.0, span).clamp(10.0, 5000.0);
        let (seed, edition) = start;
        let (land, (sea, drowning), roughness, outline) = land;
        let (aspect, mouths, sides, attractors, grid) = ground;
        let (reach, kill, step, procedure, sensitivity, (mouth_spacing, shores)) = growth;
        let (momentum, curl, stretch) = bends;
        let (trim, width, style) = finish;
        let initials =
            |set: u32| "nesw".chars().enumerate().filter(|(i, _)| set >> i & 1 == 1).map(|(_, c)| c).collect::<String>();
        let (sides, shores) = (initials(sides), initials(shores));
        let scatter = if grid { "grid" } else { "random" };
        format!(
            "seed={seed}{edition}&growth={procedure}&sensitivity={sensitivity}&mouth-spacing={mouth_spacing}&shores={shores}&land={land}&outline={outline}&sea={sea:.3}&drowning={drowning:.2}&roughness={roughness:.3}&aspect={aspect:.3}&mouths={mouths}&sides={sides}&attractors={attractors}&scatter={scatter}\
             &reach={reach:.3}&kill={kill:.3}&step={step:.3}&momentum={momentum:.3}&curl={curl:.3}&stretch={stretch}\
             &trim={trim}&width={width:.2}&style={style}&span={span:.2}{rivers}{deltas}"
        )
    })
}

/// The parameters that turn a tree into rivers: their lines and simplification, uneven banks, the model and its rounds,
/// the strength of meandering, the distances between rivers.
type Rivers = ((&'static str, u32), f64, (&'static str, u32), (f64, f64, f64, u32, f64), (f64, f64, f64));

fn rivers_link(((courses, simplify), bank_variation, (meander, rounds), how, guards): Rivers) -> String {
    let (strength, mix, meander_elsewhere, great_rivers, flat_share) = how;
    let (neck, clearance, taper) = guards;
    format!(
        "&courses={courses}&simplify={simplify}&bank-variation={bank_variation:.3}&meander={meander}&meander-rounds={rounds}&meander-strength={strength:.3}\
         &meander-mix={mix:.3}&meander-elsewhere={meander_elsewhere:.3}&great-rivers={great_rivers}&flat-share={flat_share:.3}&neck={neck:.2}&clearance={clearance:.2}&taper={taper:.2}"
    )
}
