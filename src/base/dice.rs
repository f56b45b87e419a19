//! Fresh seeds: turns random bits into a pronounceable word. It only makes new seed texts and never affects a picture.

/// Spells 64 random bits as a word of three or four syllables. Not all bits are used.
pub fn word(bits: u64) -> String {
    const ONSETS: [&str; 16] = ["b", "d", "f", "h", "k", "l", "m", "n", "p", "r", "s", "t", "v", "w", "sh", "tr"];
    const VOWELS: [&str; 8] = ["a", "e", "i", "o", "u", "ai", "au", "ia"];
    let syllables = 3 + (bits >> 60 & 1);
    (0..syllables)
        .map(|i| {
            let bits = bits >> (8 * i);
            [ONSETS[(bits & 15) as usize], VOWELS[(bits >> 4 & 7) as usize]].concat()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_short_and_plain() {
        for bits in [0, u64::MAX, 0x1234_5678_9abc_def0] {
            let word = word(bits);
            assert!((6..=16).contains(&word.len()) && word.bytes().all(|b| b.is_ascii_lowercase()), "{word}");
        }
    }
}
