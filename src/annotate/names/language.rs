//! Made-up languages: each seed has one, so that the names of a map sound alike.
//!
//! After Martin O'Leary, *Generating naming languages* (2015): a small set of sounds, the order they may stand in, and spelling. A language has five lists,
//! drawn from those of one of twelve families, and habits of spelling.

use crate::base::random::{ItemHash, Purpose, Seed};

/// How many entries a language has of each list: initials, first vowels, medials, later vowels, finals.
pub(super) const SIZES: [usize; 5] = [11, 5, 12, 4, 6];

/// Initials, first vowels, medials, later vowels, finals. Vowels stand in the lists of vowels only, and consonants in the others: a word
/// can be split in one way. None is close to any one real language.
const FAMILIES: [&str; 12] = [
    "h sk st b br g hr k r v f th sv n|a e i o u ei|ld nd rg lf rm st gr dr nn rr v lm|a e u i|r n d lm s ng rd m",
    "t k v h z l m r s y p d dr|a ie u e o aa|rk rn tt lv sk mr zn vr lt nk dz rg|a e i u|n r t m ks v nd",
    "d br sw th b l m g w gl p f n|e o i a u ea|ll sh ng kk mb dd rv lt nn th gg lb|e i o a|n m l g nd sk",
    "g gw t k d r m n b ch dr tr l|e u a i o oe|rch dd dr tr rn lch th nn gw mm rg ld|i a o u|r th g ch d n l",
    "z sh y k t m n d zh kh r b|a u o aa i e|zr md kh rz shk nz lb zh tr dv km rs|a u o i|d m r z sh k n",
    "ts v m p kl z n gr dv b st h|o e a i u ae|vl rg sn tv zm lk str pn dr br ch mn|a o e u|v k n sk r t l",
    "w n k t l p s ch m b f z|a o i e u aa|mb nd ng nz ld zw mp lw nk rb vw lz|a i o u|l n m r s k",
    "p t kw h l m n w r k f v|a e i u o ua|lk nw rh mr kl pw tw hl rv lm vr nh|a i u o|n m r l k sh",
    "l f n s th v m r g d h gl|i e a ai o u|lr rl lv ndr ll nn rn st nth ss ld vr|i a e o|l n r th s nd",
    "gr kr dr b z r g t br d m v|u o a i e ou|rg zg gr bz lg kk nd rb dg ng mb gb|a u o i|k g z r sh b d",
    "kl v l m n f pr j d h bl s gn|o i e a u eo|lv mst rn ft gn dl rsk nf mpr vl fl rdr|e o i a|l n s m v rd",
    "tl k ch m p h t n w z kw y|a i o e u ia|tl lp kp mn tz sht lk nk kt sh tp zl|i a o e|l k n sk m v",
];

/// How a sound may be spelled, as it is written above first. The longer stand before those that they are made of.
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

/// A language: the entries that its words are made of, and how it puts names together.
#[derive(Clone, Debug)]
pub(super) struct Language {
    /// Initials, first vowels, medials, later vowels, finals, spelled.
    pub lists: [Vec<String>; 5],
    /// The order of its words.
    pub chance: ItemHash,
    /// Which of some forms it uses of a kind of name.
    pub manner: u32,
}

/// What the chances of a language are of.
const FAMILY: u32 = 0;
const ORDER: u32 = 1;
const HABIT: u32 = 2;
const MANNER: u32 = 3;

impl Language {
    /// The seed's own language, or one by its number, which is the same for all seeds.
    pub fn new(seed: &str, number: u32) -> Self {
        let seed = if number == 0 { Seed::from_text(seed) } else { Seed::from_text(&format!("language {number}")) };
        let chance = seed.item_hash(Purpose::Names);
        let family = FAMILIES[chance.bits([FAMILY, 0, 0]) as usize % FAMILIES.len()];
        let mut lists: [Vec<String>; 5] = Default::default();
        for ((i, list), entries) in (0..).zip(&mut lists).zip(family.split('|')) {
            *list = entries.split(' ').map(String::from).collect();
            shuffle(list, |item| chance.bits([ORDER, i, item]));
            list.truncate(SIZES[i as usize]);
        }
        for (i, [sound, one, other]) in (0..).zip(HABITS) {
            match chance.bits([HABIT, i, 0]) % 3 {
                0 => {}
                1 => spell(&mut lists, sound, one),
                _ => spell(&mut lists, sound, other),
            }
        }
        Self { lists, chance, manner: chance.bits([MANNER, 0, 0]) }
    }
}

/// Shuffles a list (Fisher and Yates).
fn shuffle(list: &mut [String], bits: impl Fn(u32) -> u32) {
    for last in (1..list.len()).rev() {
        list.swap(last, bits(last as u32) as usize % (last + 1));
    }
}

/// Spells a sound another way; but not if two entries of a list would then be alike.
fn spell(lists: &mut [Vec<String>; 5], sound: &str, spelling: &str) {
    let spelled = lists.clone().map(|list| list.iter().map(|entry| entry.replace(sound, spelling)).collect::<Vec<_>>());
    let is_clear = |list: &Vec<String>| (1..list.len()).all(|i| !list[..i].contains(&list[i]));
    if spelled.iter().all(is_clear) {
        *lists = spelled;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VOWELS: &str = "aeiouáāäæ";

    #[test]
    fn lists_are_full_and_no_two_entries_alike_and_vowels_stand_apart() {
        for number in 1..=999 {
            let Language { lists, .. } = Language::new("", number);
            for (i, list) in lists.iter().enumerate() {
                let mut distinct = list.clone();
                distinct.sort();
                distinct.dedup();
                assert_eq!(distinct.len(), SIZES[i], "{list:?}");
                let is_of_vowels = i == 1 || i == 3;
                assert!(
                    list.iter().flat_map(|entry| entry.chars()).all(|c| VOWELS.contains(c) == is_of_vowels),
                    "{list:?}"
                );
            }
        }
    }

    #[test]
    fn a_numbered_language_is_the_same_for_all_seeds_and_the_seed_s_own_is_not() {
        assert_eq!(Language::new("kauri", 7).lists, Language::new("rimu", 7).lists);
        assert_ne!(Language::new("kauri", 0).lists, Language::new("rimu", 0).lists);
    }
}
