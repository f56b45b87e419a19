//! What nature says of our rivers: medians over maps of words that nothing was tuned for.

use std::sync::OnceLock;

use riverseed::analyse::statistics::{Measure, Measures, TABLE};
use riverseed::recipe::link;
use riverseed::session::Session;

use super::Repetition;
use super::words::WORDS;

/// Returns the median of a measure over twelve maps of the usual country, or nature's `least` or `most` value of it, in
/// ten-thousandths, as the bits of a signed number.
pub fn figure(measure: &str, which: &str) -> Option<Repetition> {
    let measure = TABLE.iter().find(|one| one.name == measure)?;
    let value = match which {
        "median" => median(measure)?,
        "least" => measure.nature?.least,
        "most" => measure.nature?.most,
        _ => return None,
    };
    Some(Box::new(move || (value * 10_000.0).round() as i32 as u32))
}

fn median(measure: &Measure) -> Option<f64> {
    static MAPS: OnceLock<Option<Vec<Measures>>> = OnceLock::new();
    let maps = MAPS.get_or_init(|| WORDS.iter().map(|word| measured(word)).collect()).as_ref()?;
    let mut values: Vec<f64> = maps.iter().filter_map(measure.value).collect();
    values.sort_by(f64::total_cmp);
    Some((values.get(values.len().checked_sub(1)? / 2)? + values.get(values.len() / 2)?) / 2.0)
}

fn measured(word: &str) -> Option<Measures> {
    let mut session = Session::new(link::read(&format!("country=usual&seed={word}")).ok()?).ok()?;
    Some(Measures::of(&session.finish().ok()?))
}
