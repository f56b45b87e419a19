//! Words by number. They are not drawn but counted: a word is `initial vowel (medial vowel)ⁿ final`, vowels and consonants take turns, so a
//! spelling splits in one way, and different numbers give different words. No list of words in use is kept, and no name depends on
//! which others there are.

use super::filter::is_refused;
use super::language::{CAPITALS, Language, SIZES};

/// The word of a number: 15,840 words with two vowels come first, then those with three, then four. One that nobody wants to
/// read is replaced by that of the same number with a vowel more. The numbers that are due that many vowels anyhow begin where those of
/// shorter words end, so a stand-in meets no other word.
pub(super) fn word(language: &Language, number: u64) -> String {
    let initials = SIZES[0] as u64;
    // Neighbouring numbers begin with different letters.
    let (initial, rest) = ((number % initials) as usize, number / initials);
    let spelled = (1..).filter(|&pairs| rest < count(pairs)).map(|pairs| spell(language, initial, rest, pairs));
    // A word of a dozen vowels is as good as any.
    let word = spelled.take(LONGEST).find(|word| !is_refused(word));
    capitalized(&word.unwrap_or_else(|| spell(language, initial, rest, LONGEST as u32)))
}

/// The most pairs of medial and vowel.
const LONGEST: usize = 9;

/// How many words have so many pairs of medial and vowel, and one initial.
fn count(pairs: u32) -> u64 {
    let [_, vowels, medials, later, finals] = SIZES.map(|size| size as u64);
    (medials * later).pow(pairs) * vowels * finals
}

fn spell(language: &Language, initial: usize, rest: u64, pairs: u32) -> String {
    let mut number = permuted(language, rest, [initial as u32, pairs]);
    let mut digit = |list: usize| {
        let entries = &language.lists[list];
        let digit = (number % entries.len() as u64) as usize;
        number /= entries.len() as u64;
        entries[digit].as_str()
    };
    let mut word = [language.lists[0][initial].as_str(), digit(1)].concat();
    (0..pairs).for_each(|_| [2, 3].into_iter().for_each(|list| word.push_str(digit(list))));
    word + digit(4)
}

/// Another number below the same count, and no two have the same: four rounds of a Feistel network (Luby and Rackoff 1988) on the next
/// power of four, walked until they come back below the count (Black and Rogaway 2002).
/// Each initial has an order of its own, or neighbouring numbers would rhyme.
fn permuted(language: &Language, number: u64, [initial, pairs]: [u32; 2]) -> u64 {
    const ROUNDS: u32 = 4;
    let count = count(pairs);
    let half = (1..32).find(|half| 1u64 << (2 * half) >= count).unwrap_or(32);
    let mask = (1u64 << half) - 1;
    let mut number = number;
    loop {
        for round in 0..ROUNDS {
            let (left, right) = (number >> half, number & mask);
            let key = u64::from(language.chance.bits([right as u32, round, KEYS + pairs * INITIALS + initial]));
            number = right << half | (left ^ key & mask);
        }
        if number < count {
            return number;
        }
    }
}

/// Items from here on are those of words.
const KEYS: u32 = 1 << 16;
const INITIALS: u32 = SIZES[0] as u32;

fn capitalized(word: &str) -> String {
    let capital = |letter: char| {
        let other = CAPITALS.iter().find(|(small, _)| *small == letter);
        other.map_or(letter.to_ascii_uppercase(), |(_, capital)| *capital)
    };
    let mut letters = word.chars();
    letters.next().map(capital).into_iter().chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn different_numbers_give_different_words() {
        let language = Language::new("kauri", 0);
        let words: BTreeSet<String> = (0..200_000).map(|number| word(&language, number)).collect();
        assert_eq!(words.len(), 200_000);
        for number in 1..=300 {
            let language = Language::new("", number);
            let words: BTreeSet<String> = (0..300).map(|number| word(&language, number)).collect();
            assert_eq!(words.len(), 300, "language {number}");
        }
    }

    #[test]
    fn numbers_are_permuted() {
        let language = Language::new("kauri", 0);
        let all: BTreeSet<u64> = (0..count(1)).map(|number| permuted(&language, number, [0, 1])).collect();
        assert_eq!((all.len() as u64, all.last()), (count(1), Some(&(count(1) - 1))));
        let stay = (0..count(1)).filter(|&number| permuted(&language, number, [0, 1]) == number).count();
        assert!(stay < 10, "{stay}");
    }

    #[test]
    fn great_numbers_have_words_too() {
        let language = Language::new("kauri", 0);
        for number in [u64::from(u32::MAX), u64::from(u32::MAX) * 8 / 7 + 8] {
            assert!(word(&language, number).chars().count() < 24);
        }
    }

    #[test]
    fn neighbours_begin_and_end_differently() {
        let language = Language::new("kauri", 0);
        let words: Vec<String> = (0..11).map(|number| word(&language, number)).collect();
        let distinct = |of: fn(&str) -> String| words.iter().map(|word| of(word)).collect::<BTreeSet<_>>().len();
        let last_four = |word: &str| word.chars().rev().take(4).collect();
        assert!(distinct(|word| word.chars().take(2).collect()) > 8 && distinct(last_four) > 8, "{words:?}");
    }
}
