//! The paper's presets are its patterns, whatever the table's defaults are.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use riverseed::grow::{Colonize, GrowthSettings};
use riverseed::land::Land;
use riverseed::prune::{Trim, trim};
use riverseed::recipe::preset::{PRESETS, Preset};
use riverseed::recipe::{Key, NumberKey, Recipe, link, table::TABLE};
use riverseed::tree::Hydrology;

/// The keys that a preset leaves to its user: the land, its mouths, the fineness of the network, and its looks.
const LEFT: [Key; 33] = [
    Key::Seed,
    Key::Edition,
    Key::Aspect,
    Key::Span,
    Key::Land,
    Key::Sea,
    Key::Roughness,
    Key::Mouths,
    Key::MouthSpacing,
    Key::Labels,
    Key::LabelSize,
    Key::Language,
    Key::Names,
    Key::Cartouche,
    Key::Woods,
    Key::Hills,
    Key::Shores,
    Key::Attractors,
    Key::Width,
    Key::BankVariation,
    Key::Deltas,
    Key::Waves,
    Key::Mountains,
    Key::Plains,
    Key::Lakes,
    Key::Rills,
    Key::Shade,
    Key::Warmth,
    Key::Rain,
    Key::Ground,
    Key::RainShadow,
    Key::Wind,
    Key::Style,
];

/// The trimmed trees on a plain rectangle: FNV-1a (64 bits) of the words of all places and parents.
const TREES: [(&str, u64); 6] = [
    ("original", 0x9e6e_11f9_9c5d_0f2a),
    ("momentum", 0xed3a_8eba_23cd_b8f2),
    ("curl", 0xb5d4_d288_1256_cc05),
    ("trimmed-original", 0xbde3_d948_7072_d1e9),
    ("trimmed-momentum", 0x200d_5dcd_b1ec_7874),
    ("trimmed-curl", 0xc47c_1a37_4404_7974),
];
const GROUND: &str = "country=usual&seed=kauri&aspect=1.5&land=rectangle&sides=s&mouths=3&attractors=6000";

fn tree(recipe: &Recipe) -> u64 {
    let settings = GrowthSettings::of(recipe);
    let threshold = Trim::new(recipe.number(NumberKey::Trim), settings.step, false);
    let mut growth = Colonize::new(settings).unwrap();
    while growth.tick() {}
    let trimmed = trim(growth.tree(), &Hydrology::of(growth.tree()), threshold).tree;
    let places = trimmed.at.iter().flat_map(|at| [at.x.to_bits(), at.y.to_bits()]);
    let bytes = places.chain(trimmed.parent.iter().copied()).flat_map(u32::to_le_bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

fn names(preset: &Preset, key: Key) -> bool {
    preset.values.iter().any(|(named, _)| *named == key)
}

#[test]
fn every_preset_grows_the_tree_that_it_grew_at_first() {
    let grown = PRESETS.iter().map(|preset| {
        let recipe = link::read(&format!("{GROUND}&preset={}", preset.name)).unwrap();
        (preset.name, tree(&recipe))
    });
    assert_eq!(grown.collect::<Vec<_>>(), TREES);
}

#[test]
fn presets_name_all_that_they_do_not_leave_to_their_user() {
    for preset in PRESETS {
        let recipe = link::read(&format!("land=island&preset={}", preset.name)).unwrap();
        for key in TABLE.iter().map(|parameter| parameter.key) {
            let is_idle = recipe.inactive_reason(key, Land::kind_of(&recipe)).is_some();
            assert!(names(preset, key) || LEFT.contains(&key) || is_idle, "{} rests on {key:?}", preset.name);
            assert!(!(names(preset, key) && LEFT.contains(&key)), "{} takes {key:?} away", preset.name);
        }
    }
}
