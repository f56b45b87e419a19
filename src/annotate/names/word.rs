//! Words by number. They are not drawn but counted: of all words of a pattern a number has one, and different numbers have different words.
//! No list of words in use is kept; only great rivers, of which there are few, make way for each other.

use super::filter::{is_foul, is_refused};
use super::language::{CAPITALS, Language};
use super::sounds::{fits, is_vowel};
use super::syllables::{LONGEST, Series, Syllables};
use crate::annotate::glyph::capitals;

/// A language with its words counted.
#[derive(Clone, Debug)]
pub(super) struct Words {
    pub language: Language,
    syllables: Syllables,
    /// A word that nothing else may have, in small letters: the name of the land.
    taken: String,
}

/// The groups that share the words of a language: none has a word that another might have.
#[derive(Clone, Copy)]
enum Share {
    Great,
    Place,
    Other,
}

impl Share {
    /// Returns the first eighth of all words that this group may have, and the one after its last.
    fn eighths(self) -> [u64; 2] {
        match self {
            Self::Great => [0, 1],
            Self::Place => [1, 2],
            Self::Other => [2, 8],
        }
    }
}

impl Words {
    pub fn new(language: Language, land: &str) -> Self {
        Self { syllables: Syllables::of(&language), taken: capitals(land), language }
    }

    /// Returns the word of something that is neither a great river nor a place.
    pub fn other(&self, number: u64) -> String {
        self.counted(Share::Other, number)
    }

    /// Returns the word of a place.
    pub fn place(&self, number: u64) -> String {
        self.counted(Share::Place, number)
    }

    /// Chooses the words of great rivers, given by their numbers and thousandths of all water, the greatest first: words of one syllable or
    /// two, the shorter the greater the river. A river whose word a greater one has takes its next; one that finds none is left out.
    pub fn great(&self, rivers: Vec<(u32, u64)>) -> Vec<(u32, String)> {
        let mut used: Vec<String> = Vec::new();
        let word = |(number, thousandths)| {
            let mut own = (0..TRIES).map(|attempt| self.short(number, attempt, thousandths));
            let free = own.find(|word| self.is_fit(word) && !used.contains(word))?;
            used.push(free.clone());
            Some((number, capitalized(&free)))
        };
        rivers.into_iter().filter_map(word).collect()
    }

    /// Returns one of the words for a great river.
    fn short(&self, number: u32, attempt: u32, thousandths: u64) -> String {
        /// The share of words of one syllable, in eighths, among rivers with at least so many thousandths of all water.
        const ONE: [(u64, u32); 3] = [(80, 5), (40, 3), (20, 1)];
        let bits = |item| self.language.chance.bits([number, attempt, GREAT + item]);
        let eighths = ONE.iter().find(|(least, _)| thousandths >= *least).map_or(0, |(_, eighths)| *eighths);
        let list = |list: &[String], item| list.get(bits(item) as usize % list.len().max(1)).cloned();
        if bits(0) % 8 < eighths {
            let (onset, rime) = (list(&self.language.onsets, 1).unwrap_or_default(), list(&self.language.rimes, 2));
            let rime = rime.unwrap_or_default();
            let coda = rime.trim_start_matches(is_vowel);
            return if fits(&onset, coda) { onset + &rime } else { String::new() };
        }
        // Endings with a meaning make words longer.
        let series = if bits(1) % 16 < self.language.weights[1] * 2 { Series(1) } else { Series(0) };
        let [_, end] = Share::Great.eighths().map(|eighth| self.syllables.count(series, 0) * eighth / 8);
        self.spell(series, 0, u64::from(bits(2)) % end.max(1))
    }

    /// Returns the word of a number: words of two syllables come first, then those of three, then four. A word that nobody wants to read is
    /// replaced by that of the same number with a syllable more. The numbers of words with that many syllables of their own begin where
    /// those of shorter words end, so a stand-in meets no other word.
    fn counted(&self, share: Share, number: u64) -> String {
        let (series, rank) = self.series(number);
        let size = |pairs| {
            let [from, to] = share.eighths().map(|eighth| self.syllables.count(series, pairs) * eighth / 8);
            (from, to - from)
        };
        let pairs = (0..LONGEST).filter(|&pairs| rank < size(pairs).1);
        let mut words = pairs.map(|pairs| self.spell(series, pairs, size(pairs).0 + rank));
        let longest = || self.spell(series, LONGEST - 1, size(LONGEST - 1).0 + rank);
        // A word of ten vowels is as good as any.
        capitalized(&words.find(|word| self.is_fit(word)).unwrap_or_else(longest))
    }

    /// Returns the series of a number, and its place among the numbers of that series: of sixteen numbers some are of each.
    fn series(&self, number: u64) -> (Series, u64) {
        let (group, mut slot) = (number / 16, number * 7 % 16);
        for (series, &weight) in self.language.weights.iter().enumerate() {
            if slot < u64::from(weight) {
                return (Series(series), group * u64::from(weight) + slot);
            }
            slot -= u64::from(weight);
        }
        (Series(0), group)
    }

    fn spell(&self, series: Series, pairs: usize, number: u64) -> String {
        let number =
            permuted(&self.language, number, self.syllables.count(series, pairs), (series.0 * LONGEST + pairs) as u32);
        self.syllables.word(&self.language, series, pairs, number)
    }

    fn is_fit(&self, word: &str) -> bool {
        !word.is_empty() && !is_refused(word) && !is_foul(word) && capitals(word) != self.taken
    }
}

/// The greatest number of words that a great river tries.
const TRIES: u32 = 64;

/// Exchanges a number for another below the same count, so that no two get the same: four rounds of a Feistel network (Luby and Rackoff
/// 1988) on the next power of four, walked until the result is below the count (Black and Rogaway 2002).
fn permuted(language: &Language, number: u64, count: u64, key: u32) -> u64 {
    const ROUNDS: u32 = 4;
    if number >= count {
        return number;
    }
    let half = (1..32).find(|half| 1u64 << (2 * half) >= count).unwrap_or(32);
    let mask = (1u64 << half) - 1;
    let mut number = number;
    loop {
        for round in 0..ROUNDS {
            let (left, right) = (number >> half, number & mask);
            let key = u64::from(language.chance.bits([right as u32, round, KEYS + key]));
            number = right << half | (left ^ key & mask);
        }
        if number < count {
            return number;
        }
    }
}

/// The first items of the chances of words, and of great rivers.
const KEYS: u32 = 1 << 16;
const GREAT: u32 = 1 << 17;

pub(super) fn capitalized(word: &str) -> String {
    let capital = |letter: char| {
        let other = CAPITALS.iter().find(|(small, _)| *small == letter);
        other.map_or(letter.to_ascii_uppercase(), |(_, capital)| *capital)
    };
    let mut letters = word.chars();
    letters.next().map(capital).into_iter().chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::super::sounds::is_vowel;
    use std::collections::BTreeSet;

    use super::*;

    fn words_of(number: u32) -> Words {
        Words::new(Language::new("", number), "")
    }

    /// Returns the words of great rivers, places and others on a map with many of each.
    fn all(words: &Words, others: u64) -> Vec<String> {
        let great = words.great((0..120).map(|identity| (identity * 7, 200 / (u64::from(identity) / 6 + 1))).collect());
        let places = (0..120).map(|number| words.place(number));
        great
            .into_iter()
            .map(|(_, word)| word)
            .chain(places)
            .chain((0..others).map(|number| words.other(number)))
            .collect()
    }

    #[test]
    fn different_numbers_give_different_words() {
        for (number, others) in [(0, 200_000)].into_iter().chain((1..=300).map(|number| (number, 2000))) {
            let all = all(&words_of(number), others);
            let distinct: BTreeSet<&String> = all.iter().collect();
            assert_eq!(distinct.len(), all.len(), "language {number}");
            assert!(all.iter().all(|word| !word.is_empty()));
        }
    }

    /// Returns two hundred words of a language, as many of each kind as on a map.
    fn some(number: u32) -> Vec<String> {
        let words = words_of(number);
        let great = words.great((0..40).map(|identity| (identity * 7, 200 / (u64::from(identity) / 4 + 1))).collect());
        let others = (0..130).map(|number| words.other(number * 71));
        great.into_iter().map(|(_, word)| word).chain(others).chain((0..30).map(|number| words.place(number))).collect()
    }

    #[test]
    fn words_end_and_begin_in_vowels_and_are_short_often_enough() {
        let percent = |words: &[String], is_so: fn(&str) -> bool| {
            words.iter().filter(|word| is_so(word)).count() * 100 / words.len()
        };
        let of: Vec<usize> = (1..=12).map(|number| percent(&some(number), |word| word.ends_with(is_vowel))).collect();
        assert!(of.iter().filter(|share| (30..=60).contains(*share)).count() >= 5, "{of:?}");
        let all: Vec<String> = (1..=12).flat_map(some).collect();
        let shares = [
            percent(&all, |word| word.ends_with(is_vowel)),
            percent(&all, |word| word.chars().count() <= 4),
            percent(&all, |word| word.to_lowercase().starts_with(is_vowel)),
        ];
        assert!(shares[0] >= 25 && shares[1] >= 7 && shares[2] >= 7, "{shares:?}");
    }

    #[test]
    fn great_rivers_have_short_words_and_the_greatest_often_one_syllable() {
        let syllables = |word: &str| {
            let small = word.to_lowercase();
            let begins = small.chars().zip(std::iter::once('-').chain(small.chars()));
            begins.filter(|(letter, before)| is_vowel(*letter) && !is_vowel(*before)).count()
        };
        let words: Vec<Words> = (1..=60).map(words_of).collect();
        let of = |thousandths| {
            words.iter().flat_map(move |words| words.great(vec![(5, thousandths)]).into_iter().map(|(_, word)| word))
        };
        let short = |thousandths| of(thousandths).filter(|word| syllables(word) == 1).count();
        assert!(of(300).chain(of(20)).all(|word| (1..=2).contains(&syllables(&word))));
        assert!(short(300) >= 20 && short(300) > short(40) && short(40) > short(20), "{} {}", short(300), short(20));
        let longer = words.iter().flat_map(|words| (0..40).map(|number| words.other(number * 300)));
        assert!(
            longer.clone().all(|word| syllables(&word) >= 2) && longer.map(|word| syllables(&word)).max() >= Some(3)
        );
    }

    #[test]
    fn of_two_great_rivers_with_one_word_the_smaller_has_another() {
        for number in 1..=200 {
            let words = words_of(number);
            let all = words.great((0..90).map(|identity| (identity, 100)).collect());
            let is_own = |named: &&(u32, String)| words.great(vec![(named.0, 100)]) == [(*named).clone()];
            let alone = all.iter().filter(is_own).count();
            assert!(all.first().is_some_and(|named| is_own(&named)), "the greatest gives way to none");
            assert!(alone >= 45, "{alone}");
        }
    }

    #[test]
    fn no_word_is_the_land_s() {
        let taken = words_of(3).other(5);
        let words = Words::new(Language::new("", 3), &taken);
        assert_ne!(words.other(5), taken);
        assert!(all(&words, 3000).iter().all(|word| *word != taken));
    }

    #[test]
    fn numbers_are_permuted() {
        let language = Language::new("kauri", 0);
        let all: BTreeSet<u64> = (0..1000).map(|number| permuted(&language, number, 1000, 1)).collect();
        assert_eq!((all.len(), all.last()), (1000, Some(&999)));
        assert!((0..1000).filter(|&number| permuted(&language, number, 1000, 1) == number).count() < 12);
    }

    #[test]
    fn great_numbers_have_words_too() {
        let words = words_of(1);
        for number in [u64::from(u32::MAX), u64::from(u32::MAX) * 8] {
            assert!((4..24).contains(&words.other(number).chars().count()));
        }
    }

    #[test]
    #[ignore = "prints words for a person to read"]
    fn words_to_read() {
        for number in 1..=12 {
            println!("\n{number}: {}", some(number).join(" "));
        }
    }
}
