//! Small letters, for texts in which case does not count.

/// Returns the small letter of a capital of the alphabets that seeds are typed in most: Latin (Latin-1, Extended-A and Vietnamese), Greek and
/// Cyrillic. Any other character is its own. The standard library's tables of all letters would weigh twenty times as much; these rules
/// agree with them for every letter that has one, but for `İ`, whose small letter is two characters, and `ẞ`.
pub(crate) fn small(letter: char) -> char {
    let code = u32::from(letter);
    let by = match letter {
        '×' => 0,
        'A'..='Z' | 'À'..='Þ' | 'Α'..='Ρ' | 'Σ'..='Ϋ' | 'А'..='Я' => 32,
        'Ѐ'..='Џ' => 80,
        'Ÿ' => return 'ÿ',
        // In pairs, the capital first: at odd places in these, and at even ones after them.
        'Ĺ'..='ň' | 'Ź'..='ž' => code % 2,
        'İ' | 'ı' | 'ĸ' | 'ŉ' => 0,
        'Ā'..='ŷ' | 'Ḁ'..='ẕ' | 'Ạ'..='ỿ' | 'Ѡ'..='ҁ' | 'Ҋ'..='ҿ' | 'Ӑ'..='ԯ' => 1 - code % 2,
        'Ά' => 38,
        'Έ'..='Ί' => 37,
        'Ό' => 64,
        'Ύ' | 'Ώ' => 63,
        _ => 0,
    };
    char::from_u32(code + by).unwrap_or(letter)
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "what the standard library says is what is tested")]
mod tests {
    use super::*;

    /// Letters whose case counts although the standard library knows a small one.
    fn is_left(letter: char) -> bool {
        !matches!(letter, '\0'..='\u{17f}' | 'Ά'..='Ϋ' | 'Ѐ'..='ԯ' | 'Ḁ'..='ỿ')
            || matches!(letter, 'İ' | 'ẞ' | 'Ӏ'..='ӎ')
    }

    #[test]
    fn small_letters_are_those_of_unicode() {
        for letter in (0..=0x10_ffff).filter_map(char::from_u32) {
            let expected = if is_left(letter) { letter } else { letter.to_lowercase().next().unwrap() };
            assert_eq!(small(letter), expected, "{letter} {:x}", u32::from(letter));
            assert_eq!(small(small(letter)), small(letter));
        }
    }
}
