//! Words that nobody wants to read. They are known by hashes, so that neither the source nor the program has a list of them; the hashes are made
//! by `www/scripts/words.mjs` from two open lists, of those fragments that names have been seen to hold.

use super::kinds::is_winding_word;
use super::language::CAPITALS;

/// Hashes of folded fragments of four letters and more, ascending: a line of eight hexadecimal digits each.
const REFUSED: &[u8] = include_bytes!("refused.txt");
const LINE: usize = 9;
static HASHES: [u32; REFUSED.len() / LINE] = hashes();

const fn hashes() -> [u32; REFUSED.len() / LINE] {
    let mut hashes = [0; REFUSED.len() / LINE];
    let mut i = 0;
    while i < REFUSED.len() {
        let digit = REFUSED[i] as u32;
        // '0' to '9', then 'a' to 'f'; the end of the line is none.
        if digit > b'\n' as u32 {
            let value = if digit < b'a' as u32 { digit - b'0' as u32 } else { digit - b'a' as u32 + 10 };
            hashes[i / LINE] = hashes[i / LINE] << 4 | value;
        }
        i += 1;
    }
    hashes
}

/// The lengths of fragments.
const SHORTEST: usize = 4;
const LONGEST: usize = 12;

/// Whether a word holds a refused fragment, or is one of the words for winding rivers.
pub(super) fn is_refused(word: &str) -> bool {
    let folded = folded(word);
    let starts = 0..(folded.len() + 1).saturating_sub(SHORTEST);
    let holds = |start: usize| {
        let ends = start + SHORTEST..=folded.len().min(start + LONGEST);
        ends.into_iter().any(|end| HASHES.binary_search(&hash(&folded[start..end])).is_ok())
    };
    is_winding_word(&folded) || starts.into_iter().any(holds)
}

/// Lower-case ASCII letters as they are read: without accents.
fn folded(word: &str) -> Vec<u8> {
    let mut folded = Vec::new();
    let small = |letter: char| {
        let other = CAPITALS.iter().find(|(_, capital)| *capital == letter);
        other.map_or(letter.to_ascii_lowercase(), |(small, _)| *small)
    };
    for c in word.chars().map(small) {
        match c {
            'á' | 'ā' | 'ä' => folded.push(b'a'),
            'æ' => folded.extend(b"ae"),
            'š' => folded.push(b's'),
            'č' => folded.push(b'c'),
            'ž' => folded.push(b'z'),
            'ñ' => folded.push(b'n'),
            'þ' => folded.extend(b"th"),
            c => folded.extend(u8::try_from(c).ok().filter(u8::is_ascii_lowercase)),
        }
    }
    folded
}

/// FNV-1a (Fowler, Noll, Vo; 32 bit).
fn hash(text: &[u8]) -> u32 {
    text.iter().fold(0x811c_9dc5, |hash, &byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn accents_are_read_as_their_letters() {
        assert_eq!(folded("Þáčæñš"), b"thacaens");
    }

    #[test]
    fn words_for_winding_rivers_are_refused() {
        assert!(is_refused("Links") && is_refused("Ouroboros") && !is_refused("Kauri"));
    }

    #[test]
    fn hashes_are_sorted_and_distinct() {
        let text = std::str::from_utf8(REFUSED).unwrap();
        let hashes: Vec<u32> = text.lines().map(|line| u32::from_str_radix(line, 16).unwrap()).collect();
        assert_eq!(hashes, HASHES);
        assert!(hashes.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn a_hash_never_changes() {
        assert_eq!(hash(b"foobar"), 0xbf9c_f968);
    }
}
