//! The refusal of words that nobody wants to read. They are known by hashes, so that neither the source nor the program has a list of them:
//! of the words of two open lists (`www/scripts/words.mjs`), those that made-up names have been seen to hold.

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

/// The least length of fragments, and the greatest.
const SHORTEST: usize = 4;
const LONGEST: usize = 12;

/// Returns `true` if a word holds a refused fragment, or is one of the words for winding rivers.
pub(super) fn is_refused(word: &str) -> bool {
    let folded = folded(word);
    let starts = 0..(folded.len() + 1).saturating_sub(SHORTEST);
    let holds = |start: usize| {
        let ends = start + SHORTEST..=folded.len().min(start + LONGEST);
        ends.into_iter().any(|end| HASHES.binary_search(&hash(&folded[start..end])).is_ok())
    };
    is_winding_word(&folded) || starts.into_iter().any(holds)
}

/// English words that would make a river or a place disgusting, as in *Foul Water*. Longer words may hold them.
const FOUL: [&str; 42] = [
    "acid", "bile", "bilge", "drool", "dung", "filth", "foul", "gore", "grime", "hell", "kill", "lice", "louse",
    "maggot", "manure", "mould", "muck", "offal", "ooze", "pest", "plague", "poison", "pox", "puke", "pus", "putrid",
    "reek", "rot", "scab", "scum", "septic", "sewer", "slime", "slum", "smut", "snot", "spit", "stench", "stink",
    "urine", "vermin", "vomit",
];

/// Returns `true` for a foul word.
pub(super) fn is_foul(word: &str) -> bool {
    let folded = folded(word);
    FOUL.iter().any(|foul| foul.as_bytes() == folded)
}

/// Returns a word as it is read: in lower-case ASCII letters, without accents.
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

/// Returns the hash of a text by FNV-1a (Fowler, Noll, Vo; 32 bit).
fn hash(text: &[u8]) -> u32 {
    text.iter().fold(0x811c_9dc5, |hash, &byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

#[cfg(test)]
#[allow(clippy::disallowed_types, reason = "the order of a set of hashes is never read")]
mod tests {
    use std::collections::{BTreeSet, HashSet};
    use std::fs;
    use std::ops::Range;
    use std::path::Path;

    use super::super::language::Language;
    use super::super::word::Words;
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
    fn foul_words_are_told_from_those_that_hold_them() {
        assert!(is_foul("Foul") && is_foul("slime"));
        assert!(!is_foul("Foulden") && !is_foul("Budapest") && !is_foul(""));
    }

    #[test]
    fn hashes_are_sorted_and_distinct() {
        let text = std::str::from_utf8(REFUSED).unwrap();
        let hashes: Vec<u32> = text.lines().map(|line| u32::from_str_radix(line, 16).unwrap()).collect();
        assert_eq!(hashes, HASHES);
        assert!(hashes.is_sorted_by(|a, b| a < b));
    }

    /// Returns the hash of a text by FNV-1a of 64 bits.
    fn long_hash(text: &[u8]) -> u64 {
        text.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }

    /// Returns the fragments of some words that `tests/listed.txt` has.
    fn held(listed: &HashSet<u64>, words: impl Iterator<Item = String>) -> BTreeSet<Vec<u8>> {
        let mut found = BTreeSet::new();
        for word in words.map(|word| folded(&word)) {
            for length in SHORTEST..=LONGEST.min(word.len()) {
                let fragments = word.windows(length).filter(|fragment| listed.contains(&long_hash(fragment)));
                found.extend(fragments.map(<[u8]>::to_vec));
            }
        }
        found
    }

    /// Returns the first words of each of some languages.
    fn words(languages: Range<u32>, of_each: u64) -> impl Iterator<Item = String> {
        languages.flat_map(move |language| {
            let words = Words::new(Language::new(&format!("seed {language}"), 0), "");
            let great = words
                .great((0..of_each as u32 / 4).map(|identity| (identity, 20 + u64::from(identity) % 80)).collect());
            let places: Vec<String> = (0..of_each / 8).map(|number| words.place(number)).collect();
            let others = (0..of_each / 2).map(move |number| words.other(number * number));
            great.into_iter().map(|(_, word)| word).chain(places).chain(others)
        })
    }

    /// Reads the hashes of all listed words; `None` in the crate as it is published, which does without them.
    fn listed() -> Option<HashSet<u64>> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        root.join("www").exists().then(|| {
            let text = fs::read_to_string(root.join("tests/listed.txt")).unwrap();
            text.lines().map(|line| u64::from_str_radix(line, 16).unwrap()).collect()
        })
    }

    #[test]
    fn fragments_are_found_wherever_they_stand_in_a_word() {
        let listed = [&b"lend"[..], b"dell", b"dellend", b"lle"].map(long_hash).into();
        let found = held(&listed, ["Dellendar", "\u{de}ilendis", "D\u{e1}lennor"].map(String::from).into_iter());
        assert_eq!(found.into_iter().collect::<Vec<_>>(), [&b"dell"[..], b"dellend", b"lend"]);
    }

    /// Refuses what it finds from then on if `RIVERSEED_REFRESH=1` is set, and fails.
    #[test]
    fn of_a_million_words_in_twenty_thousand_languages_none_holds_a_listed_one() {
        let Some(listed) = listed() else { return };
        let found = held(&listed, words(0..20_000, 60));
        if std::env::var_os("RIVERSEED_REFRESH").is_some() {
            let refused: BTreeSet<u32> = HASHES.into_iter().chain(found.iter().map(|word| hash(word))).collect();
            let text: String = refused.into_iter().map(|hash| format!("{hash:08x}\n")).collect();
            fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/src/annotate/names/refused.txt"), text).unwrap();
        }
        assert!(found.is_empty(), "{} fragments: run with RIVERSEED_REFRESH=1 until there are none", found.len());
    }

    #[test]
    fn a_hash_never_changes() {
        assert_eq!(hash(b"foobar"), 0xbf9c_f968);
    }
}
