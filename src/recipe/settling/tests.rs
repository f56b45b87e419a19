use super::*;
use crate::recipe::Parameter;
use crate::recipe::link;

fn read(text: &str) -> Recipe {
    link::read(text).unwrap()
}

fn decided() -> impl Iterator<Item = Key> {
    TABLE.iter().map(|row| row.key).filter(|key| is_decided(*key))
}

/// Returns words that nobody chose.
fn words(count: u32) -> impl Iterator<Item = String> {
    (0..count).map(|i| format!("word {i}"))
}

/// Lists all items of the table of countries: keys and what is drawn for them, with the row's name.
fn items() -> Vec<(&'static str, &'static str)> {
    let rows = COUNTRIES.iter().map(|country| (country.name, country.draws));
    let climates = country::CLIMATES.iter().copied();
    let texts = rows.chain(climates).chain([("common", country::COMMON), ("own", country::OWN_DRAWS)]);
    texts.flat_map(|(name, draws)| draws.split_ascii_whitespace().map(move |item| (name, item))).collect()
}

#[test]
fn every_item_of_every_row_can_be_read() {
    for (row, item) in items() {
        let is_spread = !item.contains('=');
        let (keys, from) =
            if is_spread { item.split_at(item.find('~').unwrap()) } else { item.split_once('=').unwrap() };
        let keys: Vec<_> =
            keys.split(',').map(|key| Key::from_name(key).unwrap_or_else(|| panic!("{row}: {item}"))).collect();
        for alternative in from.split('|') {
            let values: Vec<_> = if keys.len() > 1 { alternative.split(',').collect() } else { vec![alternative] };
            assert_eq!(values.len(), keys.len(), "{row}: {item}");
            for (key, value) in keys.iter().zip(values) {
                assert!(is_decided(*key), "{row}: {item}");
                let (value, spread) = value.split_once('~').unwrap_or((value, "0"));
                let (spread, least) = spread.split_once('>').unwrap_or((spread, "0"));
                assert!(least.parse::<f32>().is_ok(), "{row}: {item}");
                assert!(spread.parse::<f32>().is_ok_and(|spread| spread < 1.0), "{row}: {item}");
                assert_eq!(value.is_empty(), is_spread, "{row}: {item}");
                for end in value.split(':').filter(|end| !end.is_empty()) {
                    assert!(key.parameter().parse(end).is_ok(), "{row}: {item}");
                }
            }
        }
    }
}

#[test]
fn what_is_decided_is_what_rows_draw() {
    let is_drawn = |key: Key| {
        items().iter().any(|(_, item)| {
            let keys = item.split(['=', '~']).next().unwrap();
            keys.split(',').any(|name| name == key.parameter().name)
        })
    };
    for Parameter { key, name, .. } in &TABLE {
        assert_eq!(is_decided(*key), is_drawn(*key), "{name}");
    }
}

#[test]
fn countries_have_climates_and_names_of_their_own() {
    for (i, country) in COUNTRIES.iter().enumerate() {
        let climates: Vec<_> = country.climates.split(' ').collect();
        assert!(
            climates.iter().all(|name| country::CLIMATES.iter().any(|(other, _)| other == name)),
            "{}",
            country.name
        );
        assert!(COUNTRIES[..i].iter().all(|other| other.name != country.name && other.label != country.label));
        assert!(country.weight > 0 && country.help.ends_with('.'));
    }
}

#[test]
fn words_spread_over_the_rows_by_weight() {
    const WORDS: u32 = 3000;
    let drawn: Vec<_> = words(WORDS).map(|word| read(&format!("seed={word}")).country()).collect();
    let all: u32 = COUNTRIES.iter().map(|country| country.weight).sum();
    for country in &COUNTRIES {
        let count = drawn.iter().filter(|name| **name == country.name).count() as f32;
        let expected = (WORDS * country.weight) as f32 / all as f32;
        assert!((count - expected).abs() < 4.0 * expected.sqrt(), "{}: {count}, expected {expected}", country.name);
    }
}

#[test]
fn a_row_that_goes_gives_up_its_own_words_alone() {
    let winner = |word: &str, without: &str| {
        let chance = read(&format!("seed={word}")).chance();
        let rows = COUNTRIES.iter().filter(|country| country.name != without);
        rows.max_by_key(|country| country.best_ticket(chance)).unwrap().name
    };
    for word in words(300) {
        let before = winner(&word, "");
        assert!(before == "coast" || winner(&word, "coast") == before, "{word}");
    }
}

#[test]
fn naming_the_value_that_is_drawn_changes_nothing() {
    for word in words(40) {
        let drawn = read(&format!("seed={word}"));
        // A marsh that somebody names as a Brownian tree is one like the document's.
        let is_marsh = drawn.country() == "marsh";
        for key in decided().filter(|key| !(is_marsh && *key == Key::Growth)) {
            let mut named = drawn.clone();
            named.put(key, drawn.value(key).clone());
            assert!(named.is_named(key) && named.first_difference(&drawn).is_none(), "{word}: {key:?}");
            named.set(key, "auto").unwrap();
            assert_eq!(named, drawn, "{word}: {key:?}");
        }
        let name = drawn.country();
        assert_eq!(read(&format!("seed={word}&country={name}")).first_difference(&drawn), Some(Stage::Paint));
    }
}

#[test]
fn what_a_link_names_wins_and_moves_nothing_else() {
    let rivers = [Key::Width, Key::Trim, Key::Mountains, Key::Sea];
    for word in words(20) {
        let drawn = read(&format!("seed={word}"));
        let named = read(&format!("width=9.5&seed={word}&trim=77&sea=0.31&mountains=0.9"));
        assert!(drawn.differs_in(&named, &[&rivers[..], &[Key::Attractors]].concat()), "{word}");
        assert_eq!(rivers.map(|key| key.parameter().text_of(named.value(key))), ["9.5", "77", "0.9", "0.31"]);
        assert_eq!(read(&named.to_string()), named);
    }
}

#[test]
fn a_word_is_drawn_among_the_rows_that_agree_with_what_is_named() {
    for word in words(60) {
        for (named, key, value) in [
            ("land=basin", "land", "basin"),
            ("pattern=trellis", "pattern", "trellis"),
            ("growth=brownian", "growth", "brownian"),
        ] {
            let recipe = read(&format!("seed={word}&{named}"));
            let key = Key::from_name(key).unwrap();
            assert_eq!(key.parameter().text_of(recipe.value(key)), value);
        }
        let island = country::find(read(&format!("seed={word}&land=island")).country()).unwrap();
        assert!(island.draws.contains("land=island"), "{}", island.name);
        let folded = read(&format!("seed={word}&pattern=trellis&land=continent")).country();
        assert!(["folded-hills", "fjords"].contains(&folded), "{folded}");
        assert_eq!(read(&format!("seed={word}&land=rectangle")).country(), country::OWN);
    }
}

#[test]
fn ways_of_growing_from_the_documents_have_usual_rivers() {
    let usual = read("country=usual");
    for word in words(40) {
        let grown = read(&format!("seed={word}&growth=colonize"));
        // But for how many attractors an element may grow.
        for key in decided().filter(|key| !matches!(key, Key::Growth | Key::Attractors)) {
            let is_river = matches!(key.parameter().stage, Stage::Grow | Stage::Prune | Stage::Shape);
            assert!(!is_river || grown.value(key) == usual.value(key), "{word}: {key:?}");
        }
        assert_ne!(grown.country(), country::USUAL);
    }
}

#[test]
fn the_usual_country_is_the_same_for_every_word() {
    for word in words(20) {
        let recipe = read(&format!("seed={word}&country=usual"));
        for row in TABLE.iter().filter(|row| !matches!(row.key, Key::Seed | Key::Country)) {
            assert_eq!(*recipe.value(row.key), row.default_value(), "{}", row.name);
        }
    }
}

#[test]
fn no_country_has_more_parcels_than_a_widget_may_draw() {
    use crate::recipe::reading::{ReadOptions, read_given};
    for word in words(400) {
        let options = ReadOptions { widget: true, dark: false };
        let reading = read_given(&format!("seed={word}"), "", options);
        assert_eq!((reading.recipe, reading.notices), (read(&format!("seed={word}")), vec![]), "{word}");
    }
}

/// Returns what words draw for a key in a country.
fn drawn(country: &str, key: Key) -> Vec<f32> {
    let number = |word| match read(&format!("seed={word}&country={country}")).value(key) {
        Value::Number(number) => number.to_f64() as f32,
        Value::Integer(integer) => *integer as f32,
        other => panic!("{other:?} is no number"),
    };
    words(600).map(number).collect()
}

/// Returns the mean and the standard deviation.
fn spread(values: &[f32]) -> [f32; 2] {
    let mean = values.iter().sum::<f32>() / values.len() as f32;
    let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f32>() / values.len() as f32;
    [mean, variance.sqrt()]
}

#[test]
fn values_lie_about_their_middle_as_far_as_the_row_says() {
    for (key, middle, deviation) in
        [(Key::Bending, 1.2, 0.3), (Key::Mountains, 2.0, 0.25), (Key::Valleys, 0.35, 0.4), (Key::Span, 95.0, 0.35)]
    {
        let logarithms: Vec<f32> = drawn("island", key).iter().map(|value| libm::logf(value / middle)).collect();
        let [mean, found] = spread(&logarithms);
        assert!(mean.abs() < 0.05 && (found / deviation - 1.0).abs() < 0.15, "{key:?}: {mean} ± {found}");
        assert!(logarithms.iter().all(|logarithm| logarithm.abs() < 2.0 * deviation + 0.04), "{key:?}");
    }
    let seas = drawn("island", Key::Sea);
    assert!(seas.iter().all(|sea| (0.63..=0.75).contains(sea)) && spread(&seas)[1] > 0.03, "{seas:?}");
}

#[test]
fn each_key_has_a_chance_of_its_own() {
    let keys = [Key::Bending, Key::Hardness, Key::Valleys, Key::Mountains, Key::Sea, Key::Drowning];
    let all: Vec<Vec<f32>> = keys.map(|key| drawn("island", key)).into();
    for (i, one) in all.iter().enumerate() {
        for (j, other) in all[..i].iter().enumerate() {
            let ([mean, deviation], [other_mean, other_deviation]) = (spread(one), spread(other));
            let together: f32 = one.iter().zip(other).map(|(a, b)| (a - mean) * (b - other_mean)).sum();
            let correlation = together / (one.len() as f32 * deviation * other_deviation);
            assert!(correlation.abs() < 0.15, "{:?} and {:?}: {correlation}", keys[i], keys[j]);
        }
    }
}

#[test]
fn the_least_is_kept_and_what_is_one_of_some_is_exactly_that() {
    let falls = drawn("island", Key::Fall);
    assert!(falls.iter().all(|fall| *fall >= 0.2) && falls.contains(&0.2) && falls.iter().any(|fall| *fall > 0.25));
    let mut hardness = drawn("fjords", Key::Hardness);
    hardness.sort_by(f32::total_cmp);
    hardness.dedup();
    assert_eq!(hardness, [0.9, 1.0, 1.1, 1.3]);
}
