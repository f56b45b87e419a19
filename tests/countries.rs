//! Maps of bare words: as the word decides, a country each.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use riverseed::Session;
use riverseed::analyse::statistics::Measures;
use riverseed::recipe::country::COUNTRIES;
use riverseed::recipe::link;

use crate::common::tier::{Tier, one_in, tiers};

/// Words that nobody tuned the table for.
const WORDS: &str = "Aldermoor Brightwater Casimir dragon Eleanor Fjordheim Gryphon hope Isolde Jupiter Kingsbridge lullaby \
                     Marrakesh Nightfall Ozymandias Pemberley quartz Rosalind Silverpine Tangerine Ulster Valkyrie \
                     Wintermute xylophone Yggdrasil Zanzibar cheese Oxford Tolkien happy ocean Prague 7 Lisboa Smaug Maria \
                     coffee Bergen thunder Ithaca";

fn words() -> impl Iterator<Item = &'static str> {
    WORDS.split_ascii_whitespace()
}

#[test]
fn forty_words_are_of_many_kinds() {
    let mut kinds: Vec<_> = words().map(|word| link::read(&format!("seed={word}")).unwrap().country()).collect();
    kinds.sort_unstable();
    kinds.dedup();
    assert!(kinds.len() >= 17, "{kinds:?}");
}

/// A rare row counts for less: e to the entropy of the weights.
#[test]
fn rows_count_as_at_least_thirty_as_their_words_do() {
    const MANY: u32 = 20_000;
    let name = |word: u32| link::read(&format!("seed=word+{word}")).unwrap().country();
    let drawn: Vec<_> = (0..MANY).map(name).collect();
    let share = |name: &str| drawn.iter().filter(|one| **one == name).count() as f64 / f64::from(MANY);
    let entropy: f64 = COUNTRIES.iter().map(|country| share(country.name)).map(|share| -share * libm::log(share)).sum();
    assert!(libm::exp(entropy) >= 30.0, "{}", libm::exp(entropy));
}

/// What a map shows at a glance.
struct Glance {
    rivers: usize,
    /// The width of the widest river, in units.
    widest: f32,
    /// The greatest river's share of all water.
    share: f32,
    /// The length of river along the coast, in units.
    along_coast: f64,
}

fn glance(word: &str) -> Glance {
    let mut session = Session::new(link::read(&format!("seed={word}")).unwrap()).unwrap();
    let map = session.finish().unwrap();
    let network = map.network();
    let widths = network.rivers.iter().flat_map(|river| network.course(river).map(|vertex| vertex.width()));
    let greatest = network.rivers.iter().map(|river| network.discharge(river)).max().unwrap();
    Glance {
        rivers: network.rivers.len(),
        widest: widths.fold(0.0, f32::max),
        share: greatest as f32 / session.growth().total_discharge() as f32,
        along_coast: Measures::of(&map).along_coast,
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The standard deviation over the mean.
fn variation(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / values.len() as f64;
    variance.sqrt() / mean
}

fn every_word_is_a_country_with_rivers_to_look_at() {
    let glances: Vec<Glance> = one_in(7, words()).map(glance).collect();
    let fewest = glances.iter().map(|glance| glance.rivers).min().unwrap();
    assert!(fewest >= 15, "{fewest} rivers");
    let of = |value: fn(&Glance) -> f64| glances.iter().map(value).collect::<Vec<f64>>();
    let widths = of(|glance| glance.widest.into());
    let width = median(widths.iter().copied());
    let share = median(glances.iter().map(|glance| glance.share.into()));
    let along_coast = median(glances.iter().map(|glance| glance.along_coast));
    println!("width {width:.2} ({:.2}), share {share:.3}, along the coast {along_coast:.1}", variation(&widths));
    // Of six words, one with a long coast makes the median: 135 as measured, and 25 of the other 34.
    let most_along_coast = if Tier::here() == Tier::Second { 35.0 } else { 150.0 };
    assert!(width >= 8.0 && share >= 0.13 && along_coast <= most_along_coast, "{width}, {share}, {along_coast}");
    let rivers = of(|glance| glance.rivers as f64);
    if Tier::here() == Tier::Second {
        assert!(variation(&widths) >= 0.4 && variation(&rivers) >= 0.25, "{widths:?}, {rivers:?}");
    }
}

tiers!(every_word_is_a_country_with_rivers_to_look_at);
