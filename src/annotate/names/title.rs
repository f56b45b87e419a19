//! The name of the country, which is the map's title: the seed if it can be a name, else a made-up word; and the line under it.

use crate::annotate::glyph::{capital, is_letter, lacking};

/// The greatest numbers of characters and of words of a seed that is a name.
const LONGEST: usize = 24;
const MOST_WORDS: usize = 3;

/// Returns the name that a seed is: one to three words of letters that the type has, with apostrophes and hyphens between them. `None` for
/// any other seed. Words without a capital get one: `new zealand` is `New Zealand`, and `isle of man` is `Isle of Man`.
pub(super) fn country(seed: &str) -> Option<String> {
    let words: Vec<&str> = seed.split_whitespace().collect();
    let letters = seed.chars().filter(|&letter| is_alphabetic(letter)).count();
    let fits = (1..=MOST_WORDS).contains(&words.len()) && seed.chars().count() <= LONGEST && letters >= 2;
    let is_name = fits && words.iter().all(|word| is_word(word));
    is_name.then(|| (0..).zip(words).map(|(i, word)| as_name(word, i == 0)).collect::<Vec<_>>().join(" "))
}

/// The line under a title that is the country's name.
const RIVERS: &str = "and its rivers";

/// Writes the line under a title. It tells the word that the map grew from, if the title does not; empty if the type lacks a letter of it.
pub(super) fn subtitle(title: &str, seed: &str) -> String {
    const LONGEST: usize = 40;
    let seed = seed.trim();
    let is_said = country(seed).is_some_and(|country| country == title);
    if is_said || seed.is_empty() {
        return RIVERS.into();
    }
    if seed.chars().count() > LONGEST || lacking(seed).next().is_some() {
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

/// Returns `true` if a word consists of letters with single apostrophes and hyphens between them. It may end with an apostrophe.
fn is_word(word: &str) -> bool {
    let mut parts = word.strip_suffix(is_apostrophe).unwrap_or(word).split(|c| is_apostrophe(c) || c == '-');
    parts.all(|part| !part.is_empty() && part.chars().all(is_alphabetic)) && lacking(word).next().is_none()
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
        ];
        for (seed, name) in names {
            assert_eq!(country(seed).as_deref(), Some(name));
        }
        let long = "a".repeat(25);
        for seed in
            ["", "a", "42", "tay2", "a-", "-ab", "a--b", "one two three four", "tay!", "\u{6771}\u{4eac}", "''", &long]
        {
            assert_eq!(country(seed), None, "{seed}");
        }
    }

    #[test]
    fn the_line_under_a_title_tells_the_word_unless_the_title_does() {
        assert_eq!(subtitle("Tay", "tay"), "and its rivers");
        assert_eq!(subtitle("Home", "tay"), "from the word tay");
        assert_eq!(subtitle("Dellen", "42"), "from the number 42");
        assert_eq!(subtitle("Dellen", "one two three four"), "from the words one two three four");
        assert_eq!(subtitle("Dellen", "\u{6771}\u{4eac}"), "");
        assert_eq!(subtitle("Dellen", ""), "and its rivers");
        assert_eq!(subtitle("Dellen", &"a ".repeat(21)), "");
    }
}
