//! Initials: the first letters of a text's words, as capitals, of those that the type has.

use super::table::{Face, Typeface};

/// Returns the first letters or figures of the first words of a text, two at most, as capitals. Words without any that the type has are
/// passed over.
pub fn initials(text: &str) -> String {
    let initial = |word: &str| word.chars().find(|&letter| is_letter(letter)).map(capital);
    text.split(is_between_words).filter_map(initial).take(2).collect()
}

/// Returns a text in capitals, as far as the type has them.
pub fn capitals(text: &str) -> String {
    text.chars().map(|letter| if is_letter(letter) { capital(letter) } else { letter }).collect()
}

fn is_between_words(letter: char) -> bool {
    letter.is_ascii_whitespace()
        || letter.is_ascii_punctuation()
        || matches!(letter, '\u{80}'..='\u{bf}' | '\u{2000}'..='\u{206f}')
}

/// Returns `true` for a letter or a figure that the type has.
pub fn is_letter(letter: char) -> bool {
    let is_one = letter.is_ascii_alphanumeric() || (letter >= '\u{c0}' && letter != '×' && letter != '÷');
    is_one && Typeface::of(Face::Italic).glyph(letter.into()).is_some_and(|glyph| !glyph.contours.is_empty())
}

/// Returns the capital of a letter of Latin-1 or Latin Extended-A; the letter itself where the type has none. The standard library's tables
/// of all letters would be ten times as large as this module.
pub fn capital(letter: char) -> char {
    let code = u32::from(letter);
    let capital = match letter {
        'a'..='z' | 'à'..='þ' => code - 32,
        'ÿ' => 0x178,
        'ß' | 'ſ' => u32::from('S'),
        'ı' => u32::from('I'),
        // Capitals come before their small letters, at even places, and from here on at odd ones.
        'Ĺ'..='ň' | 'Ź'..='ž' => code - (code + 1) % 2,
        'Ā'..='ķ' | 'Ŋ'..='ŷ' => code - code % 2,
        _ => code,
    };
    char::from_u32(capital).filter(|&capital| is_letter(capital)).unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn initials_are_capitals_of_the_first_two_words_that_have_one() {
        let of = [
            ("kauri", "K"),
            ("the blue river", "TB"),
            ("42", "4"),
            ("hello-world", "HW"),
            ("\u{1f30a} tide", "T"),
            ("\u{1f30a}tide", "T"),
            ("נהר", ""),
            ("שלום kauri", "K"),
            ("日本 3rd", "3"),
            ("", ""),
            ("  ,;  ", ""),
            ("\u{202e}abc def", "AD"),
        ];
        for (text, expected) in of {
            assert_eq!(initials(text), expected, "{text}");
        }
    }

    #[test]
    fn a_text_in_capitals_keeps_what_has_none() {
        assert_eq!(capitals("Isle of Þórs-ey 3"), "ISLE OF ÞÓRS-EY 3");
        assert_eq!(capitals("日本"), "日本");
    }

    /// Checks that small letters of both blocks have the capitals of Unicode, where the type has those.
    #[test]
    fn capitals_are_those_of_unicode() {
        for letter in ('\u{21}'..='\u{17f}').filter(|&letter| is_letter(letter)) {
            let usual: Vec<char> = letter.to_uppercase().collect();
            let expected = if letter == 'ŉ' { letter } else { usual[0] };
            assert_eq!(capital(letter), if is_letter(expected) { expected } else { letter }, "{letter}");
        }
    }
}
