//! The name of the country, which is the map's title: the seed if it can be a name, else a made-up word; and the line under it.

use crate::annotate::glyph::{capital, is_letter, lacking};
use crate::recipe::is_hidden;

/// The greatest number of characters of a seed that is a name and can stand on the map.
const LONGEST: usize = 24;

/// Returns the name that a seed is: letters and figures that the type has, with spaces, `&`, full stops, apostrophes and hyphens between them;
/// or any text with letters that the type lacks, which then stands where others than ours are used. `None` for any other seed. Words
/// without a capital get one: `new zealand` is `New Zealand`, and `isle of man` is `Isle of Man`.
pub(super) fn country(seed: &str) -> Option<String> {
    if is_of_another_script(seed) {
        return Some(seed.trim().into());
    }
    let is_sign = |sign: char| sign == ' ' || matches!(sign, '&' | '.' | '-') || is_apostrophe(sign);
    let is_name = seed.chars().any(is_letter) && seed.chars().all(|sign| is_letter(sign) || is_sign(sign));
    let fits = seed.trim().chars().count() <= LONGEST;
    let words = || (0..).zip(seed.split_whitespace()).map(|(i, word)| as_name(word, i == 0));
    (is_name && fits).then(|| words().collect::<Vec<_>>().join(" "))
}

/// Returns `true` if the type lacks letters of a text that people can see.
fn is_of_another_script(text: &str) -> bool {
    lacking(text).next().is_some() && !text.chars().any(is_hidden)
}

/// Returns the words of a name that can stand on the map: those of which the type has every letter.
pub(crate) fn on_map(name: &str) -> String {
    let words = name.split_whitespace().filter(|word| lacking(word).next().is_none());
    words.collect::<Vec<_>>().join(" ")
}

/// The line under a title that is the country's name.
const RIVERS: &str = "and its rivers";

/// Writes the line under a title. It tells the word that the map grew from, if the title does not; empty if the type lacks a letter of it.
pub(super) fn subtitle(title: &str, seed: &str) -> String {
    const LONGEST: usize = 40;
    let seed = seed.trim();
    let is_said = country(seed).is_some_and(|country| country == title);
    if lacking(seed).next().is_some() {
        return String::new();
    }
    if is_said || seed.is_empty() {
        return RIVERS.into();
    }
    if seed.chars().count() > LONGEST {
        return String::new();
    }
    let kind = match seed {
        _ if seed.chars().all(|letter| letter.is_ascii_digit()) => "number",
        _ if seed.contains(' ') => "words",
        _ => "word",
    };
    format!("from the {kind} {seed}")
}

fn is_alphabetic(letter: char) -> bool {
    is_letter(letter) && !letter.is_ascii_digit()
}

fn is_apostrophe(letter: char) -> bool {
    matches!(letter, '\'' | '\u{2019}')
}

/// Writes a word as names have it: unchanged if it has a capital, or if it is one that names have in small letters; else with a capital.
fn as_name(word: &str, is_first: bool) -> String {
    const SMALL: [&str; 12] = ["of", "the", "and", "de", "la", "le", "du", "des", "di", "da", "von", "am"];
    let has_capital = word.chars().any(|letter| capital(letter) == letter && is_alphabetic(letter));
    if has_capital || (!is_first && SMALL.contains(&word)) {
        return word.into();
    }
    let mut name = String::new();
    for (i, letter) in (0..).zip(word.chars()) {
        // O'Brien and Saint-Malo, but King's.
        let begins = i == 0 || name.ends_with('-') || (i == 2 && name.ends_with(is_apostrophe));
        name.push(if begins { capital(letter) } else { letter });
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_of_letters_is_a_name_and_any_other_is_none() {
        let names = [
            ("tay", "Tay"),
            ("new zealand", "New Zealand"),
            ("isle of man", "Isle of Man"),
            ("the low country", "The Low Country"),
            ("McKay", "McKay"),
            (" o'brien", "O'Brien"),
            ("saint-malo", "Saint-Malo"),
            ("king's lynn", "King's Lynn"),
            ("\u{e5}land", "\u{c5}land"),
            ("\u{159}\u{ed}p", "\u{158}\u{ed}p"),
            ("ab", "Ab"),
            ("a", "A"),
            ("anna & tom", "Anna & Tom"),
            ("Anna & Tom", "Anna & Tom"),
            ("2026", "2026"),
            ("Haus 7", "Haus 7"),
            ("tay2", "Tay2"),
            ("st. john's", "St. John's"),
            ("one two three four", "One Two Three Four"),
            ("a--b-", "A--B-"),
            // In other scripts as it is, of whatever length.
            (" \u{9577}\u{6c5f}", "\u{9577}\u{6c5f}"),
            ("\u{646}\u{64e}\u{647}\u{631} nile", "\u{646}\u{64e}\u{647}\u{631} nile"),
            ("Nguy\u{1ec5}n", "Nguy\u{1ec5}n"),
        ];
        for (seed, name) in names {
            assert_eq!(country(seed).as_deref(), Some(name));
        }
        let long = "a".repeat(25);
        for seed in ["", "  ", "-", "& .", "why?", "a/b", "a_b", "a\u{202e}b", &long] {
            assert_eq!(country(seed), None, "{seed}");
        }
    }

    #[test]
    fn words_with_letters_that_the_type_lacks_do_not_stand_on_the_map() {
        assert_eq!(on_map("Tokyo \u{6771}\u{4eac}"), "Tokyo");
        assert_eq!(on_map("Nguy\u{1ec5}n"), "");
        assert_eq!(on_map("Anna & Tom"), "Anna & Tom");
    }

    #[test]
    fn the_line_under_a_title_tells_the_word_unless_the_title_does() {
        assert_eq!(subtitle("Tay", "tay"), "and its rivers");
        assert_eq!(subtitle("Home", "tay"), "from the word tay");
        assert_eq!(subtitle("Anna & Tom", "anna & tom"), "and its rivers");
        assert_eq!(subtitle("Dellen", "42"), "from the number 42");
        assert_eq!(subtitle("Dellen", "why? why?"), "from the words why? why?");
        assert_eq!(subtitle("Dellen", "\u{6771}\u{4eac}"), "");
        assert_eq!(subtitle("Dellen", ""), "and its rivers");
        assert_eq!(subtitle("Dellen", &"a ".repeat(21)), "");
    }
}
