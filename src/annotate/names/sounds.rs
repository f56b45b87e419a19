//! Vowels and consonants, and the consonants that are easy to say after each other.

/// Returns `true` for the vowels that languages are spelled with.
pub(super) fn is_vowel(letter: char) -> bool {
    matches!(letter, 'a' | 'e' | 'i' | 'o' | 'u' | 'á' | 'ā' | 'ä' | 'æ')
}

/// Returns the consonants that a text begins with.
fn run(text: &str) -> &str {
    text.find(is_vowel).map_or(text, |end| &text[..end])
}

/// Returns the rest of a text after the consonants that it begins with.
pub(super) fn rime(text: &str) -> &str {
    &text[run(text).len()..]
}

/// Returns `true` if two groups of consonants with a vowel between them are easy to say: they share no letter but `n` (no `vurv`, `grerg`,
/// `drurd`).
pub(super) fn fits(first: &str, second: &str) -> bool {
    !run(second).chars().any(|letter| letter != 'n' && first.contains(letter))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_that_share_a_consonant_do_not_fit() {
        assert!(fits("v", "rn") && fits("nn", "n") && fits("", "st") && fits("st", ""));
        assert!(!fits("gr", "rg") && !fits("v", "v") && !fits("st", "t"));
        assert!(fits("r", "wen") && !fits("l", "l"));
    }

    #[test]
    fn a_rime_begins_with_a_vowel() {
        assert_eq!([rime("wen"), rime("lmark"), rime("aur"), rime("st")], ["en", "ark", "aur", ""]);
    }
}
