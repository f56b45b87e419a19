//! Words as ways through a language's sounds: `onset? vowel (medial vowel)ⁿ close`. Vowels and consonants take turns, so a spelling splits
//! in one way; and consonants that are hard to say after each other are not counted, so a number picks one of the others.

use super::language::Language;
use super::sounds::fits;

/// Words of one pattern: with an onset or beginning with a vowel, each with a plain close or with an ending that has a meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Series(pub usize);

impl Series {
    pub const COUNT: usize = 4;

    fn begins_with_a_vowel(self) -> bool {
        self.0 & 1 == 1
    }

    fn closes(self, language: &Language) -> &[String] {
        &language.closes[self.0 >> 1]
    }
}

/// The most pairs of medial and vowel before a word's close.
pub(super) const LONGEST: usize = 9;

/// The numbers of words of each series and length.
#[derive(Clone, Debug)]
pub(super) struct Syllables {
    /// The numbers of ends of words that may follow a medial and a vowel: for each kind of close, number of pairs and medial.
    after: [[Vec<u64>; LONGEST]; 2],
    /// The numbers of all words, for each series and number of pairs.
    counts: [[u64; LONGEST]; Series::COUNT],
}

impl Syllables {
    pub fn of(language: &Language) -> Self {
        let mut this = Self { after: Default::default(), counts: [[0; LONGEST]; Series::COUNT] };
        for pairs in 0..LONGEST {
            for series in (0..Series::COUNT).map(Series) {
                if !series.begins_with_a_vowel() {
                    let after = language.medials.iter().map(|medial| this.ends(language, series, pairs, medial));
                    let after = after.collect();
                    this.after[series.0 >> 1][pairs] = after;
                }
            }
            for series in (0..Series::COUNT).map(Series) {
                let ends = onsets(language, series).map(|onset| this.ends(language, series, pairs, onset));
                this.counts[series.0][pairs] = ends.sum::<u64>() * language.nuclei.len() as u64;
            }
        }
        this
    }

    /// Returns the number of words of a series with `pairs` pairs of medial and vowel.
    pub fn count(&self, series: Series, pairs: usize) -> u64 {
        self.counts[series.0][pairs]
    }

    /// Counts the ends of words, with `pairs` pairs of medial and vowel, that may follow a group of consonants and a vowel.
    fn ends(&self, language: &Language, series: Series, pairs: usize, before: &str) -> u64 {
        let Some(shorter) = pairs.checked_sub(1) else {
            return series.closes(language).iter().filter(|close| fits(before, close)).count() as u64;
        };
        let after = language.medials.iter().zip(&self.after[series.0 >> 1][shorter]);
        let fitting = after.filter(|(medial, _)| fits(before, medial));
        fitting.map(|(_, ends)| ends * language.inner.len() as u64).sum()
    }

    /// Returns the word of a number below [`count`](Self::count), in small letters.
    pub fn word(&self, language: &Language, series: Series, pairs: usize, mut number: u64) -> String {
        let (mut word, mut before) = (String::new(), "");
        for onset in onsets(language, series) {
            let words = self.ends(language, series, pairs, onset) * language.nuclei.len() as u64;
            if number < words {
                before = onset;
                break;
            }
            number -= words;
        }
        word.push_str(before);
        word.push_str(digit(&language.nuclei, &mut number));
        for shorter in (0..pairs).rev() {
            let after = language.medials.iter().zip(&self.after[series.0 >> 1][shorter]);
            for (medial, ends) in after.filter(|(medial, _)| fits(before, medial)) {
                let words = ends * language.inner.len() as u64;
                if number < words {
                    before = medial;
                    break;
                }
                number -= words;
            }
            word.push_str(before);
            word.push_str(digit(&language.inner, &mut number));
        }
        let mut fitting = series.closes(language).iter().filter(|close| fits(before, close));
        word + fitting.nth(number as usize).map_or("", String::as_str)
    }
}

fn onsets(language: &Language, series: Series) -> impl Iterator<Item = &str> {
    let none = series.begins_with_a_vowel().then_some("");
    let onsets = if none.is_some() { &[][..] } else { &language.onsets };
    none.into_iter().chain(onsets.iter().map(String::as_str))
}

/// Takes the last digit from a number, to the base of a list's length. Returns the entry of that digit.
fn digit<'a>(list: &'a [String], number: &mut u64) -> &'a str {
    let count = list.len().max(1) as u64;
    let digit = *number % count;
    *number /= count;
    list.get(digit as usize).map_or("", String::as_str)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_number_below_the_count_has_a_word_of_its_own_and_neighbours_fit() {
        for number in [1, 5, 8, 10] {
            let language = Language::new("", number);
            let syllables = Syllables::of(&language);
            for (series, pairs) in [(0, 0), (1, 0), (2, 0), (3, 0), (1, 1), (3, 1)] {
                let count = syllables.count(Series(series), pairs);
                let words = (0..count).map(|i| syllables.word(&language, Series(series), pairs, i));
                let words: BTreeSet<String> = words.collect();
                assert_eq!(words.len() as u64, count, "language {number}, series {series}");
                let is_hard = |word: &&String| {
                    ["vurv", "grerg", "drurd", "momm", "bamb", "rara"].iter().any(|hard| word.contains(hard))
                };
                assert_eq!(words.iter().find(is_hard), None);
            }
        }
    }
}
