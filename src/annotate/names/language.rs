//! Made-up languages: each seed has one, so that the names of a map sound alike.
//!
//! After Martin O'Leary, *Generating naming languages* (2015): a small set of sounds, the orders in which they may stand, and spelling. A
//! language takes its sounds from one of twelve families, and has habits of spelling. `syllables.rs` makes words of them.

use super::sounds::{fits, is_vowel, rime};
use crate::base::random::{ItemHash, Purpose, Seed};

/// The lists of a family: onsets, first vowels, later vowels, medials, open tails, closed tails, endings with a meaning, rimes of
/// words of one syllable. Vowels stand in lists of vowels and at the beginning of tails and rimes, consonants elsewhere, so a word can be
/// split in one way. None is close to any one real language.
const FAMILIES: [&str; 12] = [
    "h sk st br b d k r v th f n sv l|a e o i u ei|a e i o|ld nd rl rv st n l v rn lm d r nn|a e ey|en ar und is|wen dal mark gard|aur eyn arv orl ulv eyl",
    "t k v h z l m r s p d n f|a ie u e o ai|a e i u|rk rn lv l r n m zn rt v lt nd s|a i o|en is ur at|dol vir mesk kam|aar uld iev erl oirn",
    "d br sw th b l m g w gl p f n|e o i a u ea|i e o a|ll nn ng mb rv lt n l r d s lg|a ey o|en or ed ith|wick bray dun vell|aun eoth ilm orv uin",
    "g gw t k d r m n b dr tr l h|e u a i o oe|i a o e|rch n r l nn th dd rn ld ll m|i o a|ar eth ol und an|vath gen mor bach|oer uch enn arth oul ild",
    "sh y k t m n d z kh r b s|a u o i e ai|a o u i|zr md r n l sh m b z rz nd mn|a u i|ad im ar et|kesh baz mun dir|aid urz oum irn azh",
    "ts v m p pl z n gr dr b st h l|o e a i u ae|a o e i|vl rg sn v l n r m tr dr st lm|a o e|in ek or an|mir vol ben dask|orv aen ust imn oel",
    "w n k t l p s m b f z ch|a o i e u aa|a i o u|mb nd n l z nz r m s t lw k|a o i u|an el um|wai bei zum dou|aan oul imb oa",
    "p t k h l m n w r kw s v|a e i u o ua|a i u o|lk n m r l k p t h nn s v|a i o u|en ul as|wai tei hou mar|oa uin iul aen",
    "l f n s th v m r g d h gl|i e a o u ai|i a e o|ndr rl ll nn rn st th n l r d v m|a e ia|en or is ath|dor vel mir gond|iel aur eth aen oirn",
    "gr kr dr b z r g t br d m v|u o a i e ou|a u i o|rz zg lg nd rb ndr mb g r n l z d|a u i|ek ur osh an|dak gul bol muz|ourn arz olg urz aum",
    "kl v l m n f pr d h bl s r|o i e a u eo|e o i a|lv st rn ft nt pl n l r s v m d|a e o ia|en is ur|fel mor din vast|eol aun ulv oin erl",
    "tl k ch m p h t n w z kw s|a i o e u ia|i a o e|tl lp n tz sht l k m p t nk z|a i o e|an il ek|wap tum kosh met|oal itz iak uan",
];
/// The numbers of onsets, first vowels, later vowels, medials, tails, endings and rimes that a language takes from its family.
const SIZES: [usize; 8] = [12, 5, 4, 12, 4, 3, 3, 5];

/// Consonants that may stand before that of an ending.
const LINKS: [&str; 3] = ["", "l", "r"];

/// The spellings of sounds, each sound first as words are made of it. Longer ones stand before those that they contain.
const HABITS: [[&str; 3]; 10] = [
    ["sh", "š", "sc"],
    ["ch", "č", "tj"],
    ["zh", "ž", "j"],
    ["th", "þ", "dh"],
    ["ng", "ñ", "ng"],
    ["aa", "á", "ā"],
    ["ae", "ä", "æ"],
    ["k", "c", "k"],
    ["y", "j", "y"],
    ["w", "v", "w"],
];

/// The capitals of small letters that no ASCII is: those that words of a language may have.
pub(super) const CAPITALS: [(char, char); 9] =
    [('á', 'Á'), ('ā', 'Ā'), ('ä', 'Ä'), ('æ', 'Æ'), ('š', 'Š'), ('č', 'Č'), ('ž', 'Ž'), ('ñ', 'Ñ'), ('þ', 'Þ')];

/// A language: the sounds that its words are made of, and how it puts names together.
#[derive(Clone, Debug)]
pub(super) struct Language {
    /// Consonants that a word begins with.
    pub onsets: Vec<String>,
    /// Vowels of a word's first syllable.
    pub nuclei: Vec<String>,
    /// Vowels of the syllables between the first and the last.
    pub inner: Vec<String>,
    /// Consonants between vowels.
    pub medials: Vec<String>,
    /// Closes of words, from the last consonants before its last vowel: plain closes, and endings with a meaning.
    pub closes: [Vec<String>; 2],
    /// Rests of words of one syllable, after the onset.
    pub rimes: Vec<String>,
    /// The order of its words.
    pub chance: ItemHash,
    /// The number that chooses its forms of names of each kind.
    pub manner: u32,
    /// The number of words, of sixteen, that have each pattern: an onset or none, with a plain close or with one that has a meaning.
    pub weights: [u32; 4],
}

/// The purposes of a language's chances.
const FAMILY: u32 = 0;
const ORDER: u32 = 1;
const HABIT: u32 = 2;
const MANNER: u32 = 3;
const WEIGHT: u32 = 4;

impl Language {
    /// Makes the seed's own language, or the language of a number, which is the same for all seeds. Numbers go through the families in
    /// turn.
    pub fn new(seed: &str, number: u32) -> Self {
        let seed = if number == 0 { Seed::from_text(seed) } else { Seed::from_text(&format!("language {number}")) };
        let chance = seed.item_hash(Purpose::Names);
        let family = if number == 0 { chance.bits([FAMILY, 0, 0]) } else { number - 1 };
        let family = FAMILIES[family as usize % FAMILIES.len()];
        let mut lists: [Vec<String>; 8] = Default::default();
        for ((i, list), entries) in (0..).zip(&mut lists).zip(family.split('|')) {
            *list = entries.split(' ').map(String::from).collect();
            shuffle(list, |item| chance.bits([ORDER, i, item]));
            list.truncate(SIZES[i as usize]);
        }
        let [onsets, nuclei, inner, medials, open, closed, endings, rimes] = lists;
        let tails: Vec<String> = open.into_iter().chain(closed).collect();
        let mut lists = [onsets, nuclei, inner, medials, tails, endings, rimes];
        for (i, [sound, one, other]) in (0..).zip(HABITS) {
            match chance.bits([HABIT, i, 0]) % 3 {
                0 => {}
                1 => spell(&mut lists, sound, one),
                _ => spell(&mut lists, sound, other),
            }
        }
        let [onsets, nuclei, inner, medials, tails, endings, rimes] = lists;
        let closes = [plain_closes(&medials, &tails, &endings), meant_closes(&endings)];
        let [vowel_first, meant] = [0, 1].map(|i| 2 + chance.bits([WEIGHT, i, 0]) % 3);
        let weights = [16 - vowel_first - meant - 1, vowel_first, meant, 1];
        Self { onsets, nuclei, inner, medials, closes, rimes, chance, manner: chance.bits([MANNER, 0, 0]), weights }
    }
}

/// Joins each medial with each tail, but for those that could be read as an ending with a meaning.
fn plain_closes(medials: &[String], tails: &[String], endings: &[String]) -> Vec<String> {
    let is_plain = |tail: &&String| endings.iter().all(|ending| rime(ending) != tail.as_str());
    let of_tail = |tail: &String| {
        let fitting = medials.iter().filter(|medial| fits(medial, tail.trim_start_matches(is_vowel)));
        fitting.map(|medial| format!("{medial}{tail}")).collect::<Vec<_>>()
    };
    tails.iter().filter(is_plain).flat_map(of_tail).collect()
}

fn meant_closes(endings: &[String]) -> Vec<String> {
    let of_ending = |ending: &String| {
        let fitting = LINKS.into_iter().filter(|link| link.is_empty() || fits(link, ending));
        fitting.map(|link| format!("{link}{ending}")).collect::<Vec<_>>()
    };
    endings.iter().flat_map(of_ending).collect()
}

/// Shuffles a list (Fisher and Yates).
fn shuffle(list: &mut [String], bits: impl Fn(u32) -> u32) {
    for last in (1..list.len()).rev() {
        list.swap(last, bits(last as u32) as usize % (last + 1));
    }
}

/// Spells a sound another way; but not if two entries of a list would then be alike, or a letter would double that is never doubled.
fn spell(lists: &mut [Vec<String>; 7], sound: &str, spelling: &str) {
    const NEVER: [&str; 4] = ["vv", "jj", "ij", "cs"];
    let spelled = lists.clone().map(|list| list.iter().map(|entry| entry.replace(sound, spelling)).collect::<Vec<_>>());
    let is_clear = |list: &Vec<String>| {
        let is_good = |entry: &String| !NEVER.iter().any(|never| entry.contains(never));
        (0..list.len()).all(|i| !list[..i].contains(&list[i]) && is_good(&list[i]))
    };
    if spelled.iter().all(is_clear) {
        *lists = spelled;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the lists of a language, those of vowels last.
    fn lists(language: &Language) -> Vec<&Vec<String>> {
        let Language { onsets, nuclei, inner, medials, closes: [plain, meant], rimes, .. } = language;
        vec![onsets, medials, plain, meant, rimes, nuclei, inner]
    }

    #[test]
    fn lists_are_full_and_no_two_entries_alike_and_vowels_stand_apart() {
        for number in 1..=999 {
            let language = Language::new("", number);
            for (i, list) in lists(&language).into_iter().enumerate() {
                let mut distinct = list.clone();
                distinct.sort();
                distinct.dedup();
                assert!(distinct.len() == list.len() && list.len() >= 3, "{list:?}");
                let is_all = |is_vowels: bool| list.iter().all(|entry| entry.chars().all(|c| is_vowel(c) == is_vowels));
                assert!(i >= 2 || is_all(false), "{list:?}");
                assert!(i < 5 || is_all(true), "{list:?}");
            }
            let [plain, meant] = language.closes.each_ref().map(|closes| closes.iter().map(|close| rime(close)));
            let plain: Vec<&str> = plain.collect();
            assert!(
                meant.into_iter().all(|rime| !plain.contains(&rime)),
                "{number}: a word could be split in two ways"
            );
            assert_eq!(language.weights.iter().sum::<u32>(), 16);
        }
    }

    #[test]
    fn a_numbered_language_is_the_same_for_all_seeds_and_the_seed_s_own_is_not() {
        assert_eq!(Language::new("kauri", 7).closes, Language::new("rimu", 7).closes);
        assert_ne!(Language::new("kauri", 0).closes, Language::new("rimu", 0).closes);
    }

    #[test]
    fn twelve_languages_are_of_twelve_families() {
        let rimes: std::collections::BTreeSet<String> = (1..=12)
            .map(|number| Language::new("", number).nuclei.concat() + &Language::new("", number).medials.concat())
            .collect();
        assert_eq!(rimes.len(), 12);
    }
}
