//! The seeds of many maps: the lines of a list, or a range of numbers.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::str::FromStr;
use std::sync::Arc;

use riverseed::recipe::{Key, Value};

use super::super::{Failure, Say};

/// The greatest length of a list, in bytes.
const LONGEST_LIST: u64 = 256 << 20;
/// The greatest number of seeds in a list.
const MOST_LISTED: usize = 10_000_000;
/// The greatest number of seeds in a range.
const MOST_IN_RANGE: u64 = 1_000_000_000;

/// Seeds in order, without repeats.
#[derive(Debug)]
pub struct Seeds {
    seeds: Kind,
    /// The number of lines in the list that are not seeds.
    pub faults: u64,
}

#[derive(Debug)]
enum Kind {
    Range { first: u64, count: u64 },
    List(Vec<Arc<str>>),
}

impl Seeds {
    /// Reads the value of `--seeds`: `FROM..TO`, a file, or `-` for standard input.
    ///
    /// # Errors
    /// Fails for a range or a list with no seeds or too many, and for a file that cannot be read.
    pub fn read(source: &OsStr, say: Say<'_>) -> Result<Self, Failure> {
        let name = source.to_string_lossy();
        let refused = |reason: String| Failure::Seeds { seeds: name.clone().into_owned(), reason };
        if let Some(range) = range(&name) {
            let (first, count) = range.map_err(|reason| refused(reason.into()))?;
            return Ok(Self { seeds: Kind::Range { first, count }, faults: 0 });
        }
        let list = if name == "-" {
            List::read(io::stdin().lock(), MOST_LISTED, &name, say)
        } else {
            File::open(source).and_then(|file| List::read(BufReader::new(file), MOST_LISTED, &name, say))
        };
        let list = list.map_err(Failure::file(Path::new(source)))?;
        list.finish(&name, say).map_err(refused)
    }

    /// Counts the seeds in a shard.
    pub fn count(&self, shard: Shard) -> u64 {
        let all = match &self.seeds {
            Kind::Range { count, .. } => *count,
            Kind::List(seeds) => seeds.len() as u64,
        };
        // The third of four shards of 10 has the places 2 and 6.
        all.saturating_sub(shard.index).div_ceil(shard.count)
    }

    /// Returns the seed in a place of a shard; `None` beyond the last.
    pub fn get(&self, shard: Shard, place: u64) -> Option<Cow<'_, str>> {
        let place = place.checked_mul(shard.count)?.checked_add(shard.index)?;
        match &self.seeds {
            Kind::Range { first, count } => (place < *count).then(|| (first + place).to_string().into()),
            Kind::List(seeds) => seeds.get(usize::try_from(place).ok()?).map(|seed| Cow::from(&**seed)),
        }
    }
}

/// Reads the first number and the count of a range; `None` if the text is not a range.
fn range(text: &str) -> Option<Result<(u64, u64), &'static str>> {
    let (first, last) = text.split_once("..")?;
    let is_sign_or_digit = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | '=');
    text.chars().all(is_sign_or_digit).then(|| between(first, last))
}

fn between(first: &str, last: &str) -> Result<(u64, u64), &'static str> {
    let number = |text: &str| text.parse().ok().filter(|number: &u64| number.to_string() == text);
    let (Some(first), Some(last)) = (number(first), number(last)) else {
        return Err("a range is FROM..TO, whole numbers from 0 to 18446744073709551615, without leading zeros");
    };
    let count =
        last.checked_sub(first).ok_or("a range goes from the lesser number to the greater, which belongs to it")?;
    if count < MOST_IN_RANGE { Ok((first, count + 1)) } else { Err("a range holds at most 1000000000 seeds") }
}

/// A list while it is read.
#[derive(Default)]
struct List {
    seeds: Vec<Arc<str>>,
    /// The seeds as a set.
    known: BTreeSet<Arc<str>>,
    empty: u64,
    repeated: u64,
    faults: u64,
    /// The reason to refuse the whole list.
    refusal: Option<String>,
}

impl List {
    /// The number of faults that are reported; further ones are only counted.
    const FAULTS: u64 = 20;

    /// Reads a list of up to `most` seeds.
    fn read(source: impl BufRead, most: usize, name: &str, say: Say<'_>) -> io::Result<Self> {
        let too_long = || Some(format!("a list holds at most {most} seeds, in {} MB", LONGEST_LIST >> 20));
        let mut list = Self::default();
        let mut source = source.take(LONGEST_LIST + 1);
        let mut line = Vec::new();
        for number in 1u64.. {
            line.clear();
            if source.read_until(b'\n', &mut line)? == 0 {
                break;
            }
            if number == 1 && is_utf_16(&line) {
                list.refusal = Some("it is text in UTF-16, and a list is one in UTF-8".into());
                break;
            }
            // Some editors begin every file with a byte order mark.
            let text = line.strip_prefix("\u{feff}".as_bytes()).filter(|_| number == 1).unwrap_or(&line);
            if let Err(reason) = list.add(text) {
                list.faults += 1;
                if list.faults <= Self::FAULTS {
                    say(&format!("{name}: line {number}: {reason}"));
                }
            }
            if source.limit() == 0 || list.seeds.len() > most {
                list.refusal = too_long();
                break;
            }
        }
        Ok(list)
    }

    /// Adds a line. Its end, and spaces around it, are not part of the seed.
    fn add(&mut self, line: &[u8]) -> Result<(), String> {
        let text = str::from_utf8(line).map_err(|_| "the text is not UTF-8")?;
        let seed = match Key::Seed.parameter().parse(text.trim()) {
            Ok(Value::Text(seed)) => Arc::<str>::from(seed),
            Ok(_) => return Err("the line is no text".into()),
            Err(error) => return Err(error.to_string()),
        };
        if seed.is_empty() {
            self.empty += 1;
        } else if self.known.insert(Arc::clone(&seed)) {
            self.seeds.push(seed);
        } else {
            self.repeated += 1;
        }
        Ok(())
    }

    fn finish(self, name: &str, say: Say<'_>) -> Result<Seeds, String> {
        if let Some(refusal) = self.refusal {
            return Err(refusal);
        }
        let told = [
            (self.faults.saturating_sub(Self::FAULTS), "further lines are no seeds"),
            (self.empty, "empty lines are left out"),
            (self.repeated, "lines repeat a seed: each map is made once"),
        ];
        for (count, what) in told.iter().filter(|(count, _)| *count > 0) {
            say(&format!("{name}: {count} {what}"));
        }
        if self.seeds.is_empty() {
            return Err("there are no seeds in it".into());
        }
        Ok(Seeds { seeds: Kind::List(self.seeds), faults: self.faults })
    }
}

/// Returns `true` if a text begins with one of UTF-16's byte order marks.
fn is_utf_16(text: &[u8]) -> bool {
    text.starts_with(&[0xff, 0xfe]) || text.starts_with(&[0xfe, 0xff])
}

/// The share of seeds that a call renders: every `count`-th, beginning with the one at `index`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Default for Shard {
    fn default() -> Self {
        Self { index: 0, count: 1 }
    }
}

impl FromStr for Shard {
    type Err = &'static str;

    /// `I/N`, counted from 1.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const MOST: u64 = 1_000_000;
        let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse::<u64>().ok()?, n.parse::<u64>().ok()?)));
        match numbers {
            Some((i, count)) if (1..=count).contains(&i) && count <= MOST => Ok(Self { index: i - 1, count }),
            _ => Err("it has to be I/N, with I from 1 to N and N at most 1000000"),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;

    fn list(text: &[u8]) -> (Result<Seeds, String>, Vec<String>) {
        list_of(text, MOST_LISTED)
    }

    fn list_of(text: &[u8], most: usize) -> (Result<Seeds, String>, Vec<String>) {
        let said = RefCell::new(Vec::new());
        let say = |text: &str| said.borrow_mut().push(text.to_owned());
        let seeds = List::read(text, most, "list", &say).unwrap().finish("list", &say);
        (seeds, said.into_inner())
    }

    fn all(seeds: &Seeds, shard: Shard) -> Vec<String> {
        (0..).map_while(|place| seeds.get(shard, place)).map(Cow::into_owned).collect()
    }

    #[test]
    fn lines_are_seeds_whatever_ends_them() {
        let (seeds, said) = list("\u{feff}kea\r\n  te awa \r\n\nkea\n\u{101}\n   \nlast".as_bytes());
        assert_eq!(all(&seeds.unwrap(), Shard::default()), ["kea", "te awa", "\u{101}", "last"]);
        assert_eq!(said, ["list: 2 empty lines are left out", "list: 1 lines repeat a seed: each map is made once"]);
    }

    #[test]
    fn lines_that_are_no_seeds_are_named_and_the_rest_is_kept() {
        let long = "x".repeat(65);
        let (seeds, said) = list(&[b"\xffkea\n", long.as_bytes(), b"\nkea\na\0b\nkaka\n"].concat());
        let seeds = seeds.unwrap();
        assert_eq!((all(&seeds, Shard::default()), seeds.faults), (vec!["kea".into(), "kaka".into()], 3));
        assert_eq!(said[0], "list: line 1: the text is not UTF-8");
        assert!(said[1].starts_with("list: line 2: seed: ") && said[1].contains("64"), "{said:?}");
        assert!(said[2].starts_with("list: line 4: seed: "), "{said:?}");
        let (seeds, said) = list(&b"\xff\n".repeat(50));
        assert_eq!((seeds.unwrap_err().as_str(), said.len()), ("there are no seeds in it", 21));
        assert_eq!(said[20], "list: 30 further lines are no seeds");
    }

    #[test]
    fn lists_hold_as_many_seeds_as_is_said_and_no_more() {
        let refusal = "a list holds at most 3 seeds, in 256 MB";
        for text in ["a\nb\nc", "a\nb\nc\n", "a\nb\nc\n\nb\n"] {
            assert_eq!(list_of(text.as_bytes(), 3).0.unwrap().count(Shard::default()), 3, "{text:?}");
        }
        for text in ["a\nb\nc\nd", "a\nb\nc\nd\n", "a\nb\nc\nb\nd\n"] {
            assert_eq!(list_of(text.as_bytes(), 3).0.unwrap_err(), refusal, "{text:?}");
        }
    }

    #[test]
    fn list_in_utf_16_is_refused_with_one_word() {
        for text in [b"\xff\xfek\0\n\0", b"\xfe\xff\0k\0\n"] {
            let (seeds, said) = list(text);
            assert_eq!(seeds.unwrap_err(), "it is text in UTF-16, and a list is one in UTF-8");
            assert!(said.is_empty(), "{said:?}");
        }
    }

    #[test]
    fn ranges_hold_both_ends_and_name_what_is_wrong() {
        assert_eq!(range("1..10"), Some(Ok((1, 10))));
        assert_eq!(range("7..7"), Some(Ok((7, 1))));
        assert_eq!(range("18446744073709551615..18446744073709551615"), Some(Ok((u64::MAX, 1))));
        for (text, reason) in [
            ("10..1", "from the lesser"),
            ("1..", "FROM..TO"),
            ("..5", "FROM..TO"),
            ("-1..5", "FROM..TO"),
            ("1..=5", "FROM..TO"),
            ("01..5", "FROM..TO"),
            ("1..18446744073709551616", "FROM..TO"),
            ("1..1000000001", "at most"),
            ("0..18446744073709551615", "at most"),
        ] {
            assert!(range(text).unwrap().unwrap_err().contains(reason), "{text}");
        }
        for text in ["seeds.txt", "../seeds.txt", "-", "a..b"] {
            assert_eq!(range(text), None, "{text}");
        }
    }

    #[test]
    fn shards_share_all_seeds_out_and_no_seed_twice() {
        for count in 1..15 {
            let seeds = Seeds { seeds: Kind::Range { first: 3, count: 10 }, faults: 0 };
            let mut found = Vec::new();
            for i in 1..=count {
                let shard: Shard = format!("{i}/{count}").parse().unwrap();
                let own = all(&seeds, shard);
                assert_eq!(own.len() as u64, seeds.count(shard), "{i}/{count}");
                found.extend(own.into_iter().map(|seed| seed.parse::<u64>().unwrap()));
            }
            found.sort_unstable();
            assert_eq!(found, (3..13).collect::<Vec<_>>(), "{count}");
        }
        for text in ["0/4", "5/4", "1/0", "1", "a/b", "-1/4", "1/1000001", "1/2/3", ""] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }
}
