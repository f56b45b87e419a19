//! The text of own names: `12.Silver Water_m12.The Old Man_214._t.Home`. An entry is a mark, which names a thing on the
//! map, then a full stop and the name; underscores separate entries. An empty name removes the generated one.
//!
//! A mark rests on what a thing is and where it lies, never on its rank, so it stays when a slider moves: a river's is the number of a
//! square of the map through which it runs, that of a place the number of the cell in which its midst lies. If neither is there any more,
//! the mark goes to the nearest thing of its kind.

use std::fmt;

use thiserror::Error;

use super::hidden::{is_hidden, shown};

/// The greatest length of the text and of one name, and the greatest number of entries.
const LONGEST: usize = 1200;
const LONGEST_NAME: usize = 40;
const MOST: usize = 40;

/// A thing on the map that an own name is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Mark {
    /// A river, by its [identity](crate::annotate::names::RiverName::identity).
    River(u32),
    /// The stretch where a river meanders, by the river's identity.
    Reach(u32),
    /// A sea, by the cell of its midst.
    Sea(u32),
    /// A lake, by the cell of its midst.
    Lake(u32),
    /// An island, by the cell of its midst; 0 is the main land.
    Island(u32),
    /// A bay or gulf, by the cell of its midst.
    Bay(u32),
    /// A cape, by the cell of its tip.
    Cape(u32),
    /// A strait, by the cell of its midst.
    Strait(u32),
    /// A range of mountains or hills, by the cell of its midst.
    Range(u32),
    /// The map.
    Title,
}

impl Mark {
    fn parse(text: &str) -> Option<Self> {
        let number = |text: &str| {
            let is_plain = text == "0" || !text.starts_with(['0', '+']);
            text.parse().ok().filter(|_| is_plain)
        };
        match text.split_at_checked(1)? {
            ("t", "") => Some(Self::Title),
            ("m", rest) => number(rest).map(Self::Reach),
            ("s", rest) => number(rest).map(Self::Sea),
            ("l", rest) => number(rest).map(Self::Lake),
            ("i", rest) => number(rest).map(Self::Island),
            ("b", rest) => number(rest).map(Self::Bay),
            ("c", rest) => number(rest).map(Self::Cape),
            ("n", rest) => number(rest).map(Self::Strait),
            ("h", rest) => number(rest).map(Self::Range),
            _ => number(text).map(Self::River),
        }
    }
}

impl fmt::Display for Mark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::River(number) => write!(f, "{number}"),
            Self::Reach(number) => write!(f, "m{number}"),
            Self::Sea(number) => write!(f, "s{number}"),
            Self::Lake(number) => write!(f, "l{number}"),
            Self::Island(number) => write!(f, "i{number}"),
            Self::Bay(number) => write!(f, "b{number}"),
            Self::Cape(number) => write!(f, "c{number}"),
            Self::Strait(number) => write!(f, "n{number}"),
            Self::Range(number) => write!(f, "h{number}"),
            Self::Title => write!(f, "t"),
        }
    }
}

/// The reason why a text is not a list of names.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NamesError {
    /// It is too long.
    #[error("the text has {length} characters, at most {LONGEST} are allowed")]
    TooLong {
        /// Its length in characters.
        length: usize,
    },
    /// It has too many entries.
    #[error("there are {count} names, at most {MOST} are allowed")]
    TooMany {
        /// Their number.
        count: usize,
    },
    /// The text before the full stop is not a mark.
    #[error(
        "'{mark}' is not a mark: expected a river's number, m and a river's number, a letter and a place's number (s sea, l lake, i island, b bay or gulf, c cape, n strait, h range), or t, then a full stop"
    )]
    Mark {
        /// The text before the full stop.
        mark: String,
    },
    /// A mark is given twice.
    #[error("'{mark}' is named more than once")]
    Repeated {
        /// The mark.
        mark: Mark,
    },
    /// A name is too long.
    #[error("the name of '{mark}' has {length} characters, at most {LONGEST_NAME} are allowed")]
    LongName {
        /// The mark.
        mark: Mark,
        /// Its length in characters.
        length: usize,
    },
    /// A control character, or one that changes the direction of text.
    #[error("the text holds a character that cannot be shown")]
    NotText,
}

impl NamesError {
    /// Says what is used in place of what was wrong, as a message ends.
    pub(super) fn correction(&self) -> &'static str {
        match self {
            Self::TooLong { .. } => "the rest is left out",
            Self::TooMany { .. } => "the first 40 are used",
            Self::Repeated { .. } => "the first is used",
            Self::LongName { .. } => "its beginning is used",
            Self::Mark { .. } | Self::NotText => "it is left out",
        }
    }
}

/// Own names, in the order in which they were given.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnNames {
    entries: Vec<(Mark, String)>,
}

impl OwnNames {
    /// Reads a text strictly.
    ///
    /// # Errors
    /// Names the first fault and its entry.
    pub fn parse(text: &str) -> Result<Self, NamesError> {
        let (names, mut faults) = Self::corrected(text);
        if faults.is_empty() { Ok(names) } else { Err(faults.swap_remove(0)) }
    }

    /// Reads a text leniently, as [`corrected`](Self::corrected) does, and passes over its faults.
    pub fn readable(text: &str) -> Self {
        Self::corrected(text).0
    }

    /// Reads as many names as there are, and returns the faults of the others, each by itself: what cannot be shown, is no name or is one
    /// too many is left out, and what is too long is cut.
    #[inline(never)] // one copy
    pub fn corrected(text: &str) -> (Self, Vec<NamesError>) {
        let (mut names, mut faults) = (Self::default(), Vec::new());
        let (mut kept, mut length, mut has_hidden) = (String::new(), 0, false);
        for c in text.chars() {
            length += 1;
            match is_hidden(c) {
                true => has_hidden = true,
                false if length <= LONGEST => kept.push(c),
                false => {}
            }
        }
        if length > LONGEST {
            faults.push(NamesError::TooLong { length });
        }
        if has_hidden {
            faults.push(NamesError::NotText);
        }
        let count = entries(&kept).count();
        if count > MOST {
            faults.push(NamesError::TooMany { count });
        }
        for entry in entries(&kept).take(MOST) {
            if let Err(fault) = names.add(entry) {
                faults.push(fault);
            }
        }
        (names, faults)
    }

    /// Adds the name of an entry, cut where it is too long.
    fn add(&mut self, entry: &str) -> Result<(), NamesError> {
        let (mark, name) = entry.split_once('.').unwrap_or((entry, ""));
        let known = Mark::parse(mark.trim()).filter(|_| entry.contains('.'));
        let mark = known.ok_or_else(|| NamesError::Mark { mark: shown(mark) })?;
        if self.get(mark).is_some() {
            return Err(NamesError::Repeated { mark });
        }
        let name = name.trim();
        let end = name.char_indices().nth(LONGEST_NAME).map(|(end, _)| end);
        let kept = end.and_then(|end| name.get(..end)).unwrap_or(name);
        self.entries.push((mark, kept.trim_end().into()));
        match end {
            Some(_) => Err(NamesError::LongName { mark, length: name.chars().count() }),
            None => Ok(()),
        }
    }

    /// Returns these names with one of them replaced, added or, for `None`, removed.
    ///
    /// # Errors
    /// Refuses a name that is too long, one name too many, and an invalid mark.
    pub fn with(&self, mark: &str, name: Option<&str>) -> Result<Self, NamesError> {
        let wrong = || NamesError::Mark { mark: shown(mark) };
        let mark = Mark::parse(mark).ok_or_else(wrong)?;
        let others = Self { entries: self.entries.iter().filter(|(named, _)| *named != mark).cloned().collect() };
        let entry = name.map(|name| format!("{mark}.{}", name.replace('_', " ")));
        let entries: Vec<String> = [others.to_string()].into_iter().chain(entry).collect();
        Self::parse(&entries.join("_"))
    }

    /// Returns the own name of a thing; an empty one removes the generated name.
    pub fn get(&self, mark: Mark) -> Option<&str> {
        self.entries.iter().find(|(named, _)| *named == mark).map(|(_, name)| name.as_str())
    }

    /// Returns the things that have an own name.
    pub fn marks(&self) -> impl Iterator<Item = Mark> {
        self.entries.iter().map(|(mark, _)| *mark)
    }
}

impl fmt::Display for OwnNames {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (mark, name)) in self.entries.iter().enumerate() {
            write!(f, "{}{mark}.{name}", if i > 0 { "_" } else { "" })?;
        }
        Ok(())
    }
}

fn entries(text: &str) -> impl Iterator<Item = &str> {
    text.split('_').map(str::trim).filter(|entry| !entry.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        OwnNames::parse(text).unwrap_err().to_string()
    }

    #[test]
    fn entries_are_read_and_written_alike() {
        let text = "0.Silver Water_m0.The Old Man. Again_214._s0.Sea of Glass_l3.x_i0.y_b41.v_c5.w_n6.u_h7.s_t.z";
        let names = OwnNames::parse(text).unwrap();
        assert_eq!(names.to_string(), text);
        assert_eq!(names.get(Mark::Reach(0)), Some("The Old Man. Again"));
        assert_eq!((names.get(Mark::River(214)), names.get(Mark::River(1))), (Some(""), None));
        assert_eq!(OwnNames::parse(" _0. Silver _ ").unwrap().to_string(), "0.Silver");
    }

    #[test]
    fn what_is_wrong_is_refused_by_name() {
        assert!(error("x3.y").starts_with("'x3' is not a mark: expected a river's number, m and a river's number"));
        assert!(error("12").starts_with("'12' is not a mark"));
        assert!(error("007.Bond").starts_with("'007' is not a mark") && error("+7.x").starts_with("'+7'"));
        assert_eq!(error("1.a_1.b"), "'1' is named more than once");
        assert_eq!(
            error(&format!("m1.{}", "é".repeat(41))),
            "the name of 'm1' has 41 characters, at most 40 are allowed"
        );
        assert_eq!(error(&"x".repeat(1201)), "the text has 1201 characters, at most 1200 are allowed");
        assert_eq!(
            error(&(0..41).map(|i| format!("{i}.a_")).collect::<String>()),
            "there are 41 names, at most 40 are allowed"
        );
        let unseen = ['\u{ad}', '\u{34f}', '\u{61c}', '\u{180e}', '\u{feff}', '\u{fffd}', '\u{fffe}', '\u{ffff}'];
        let ends = [('\0', '\u{1f}'), ('\u{7f}', '\u{9f}'), ('\u{200b}', '\u{200f}'), ('\u{2028}', '\u{202e}')];
        let more = [('\u{2060}', '\u{206f}'), ('\u{e0000}', '\u{e007f}')];
        let ranges = ends.into_iter().chain(more).flat_map(|(first, last)| first..=last);
        for hidden in unseen.into_iter().chain(ranges) {
            assert_eq!(error(&format!("1.a{hidden}b")), "the text holds a character that cannot be shown");
        }
        for seen in ['\u{ac}', '\u{301}', '\u{200a}', '\u{2010}', '\u{2027}', '\u{2070}', '\u{fffc}', '\u{1f30a}'] {
            assert!(OwnNames::parse(&format!("1.a{seen}b")).is_ok(), "{seen:?}");
        }
    }

    #[test]
    fn lenient_reading_keeps_what_can_be_read() {
        let names = OwnNames::readable("x3.y_1.a\u{202e}b_2_1.again_t.Home");
        assert_eq!(names.to_string(), "1.ab_t.Home");
        let many = (0..99).map(|i| format!("{i}.a_")).collect::<String>();
        assert_eq!(OwnNames::readable(&many).marks().count(), MOST);
        assert_eq!(OwnNames::readable(&format!("5.{}_6.b", "é ".repeat(30))).to_string().chars().count(), 45);
    }

    #[test]
    fn one_name_is_changed_added_or_taken_away_and_the_others_stay() {
        let own = OwnNames::readable("0.Silver Water_t.Home");
        let with = |mark: &str, name: Option<&str>| own.with(mark, name).map(|own| own.to_string());
        assert_eq!(with("0", Some("Old_Man")).as_deref(), Ok("t.Home_0.Old Man"));
        assert_eq!(with("m0", Some("")).as_deref(), Ok("0.Silver Water_t.Home_m0."));
        assert_eq!(with("t", None).as_deref(), Ok("0.Silver Water"));
        assert_eq!(OwnNames::default().with("5", None).map(|own| own.to_string()).as_deref(), Ok(""));
        assert!(matches!(with("x1", Some("a")), Err(NamesError::Mark { .. })));
        assert!(matches!(with("1", Some(&"a".repeat(41))), Err(NamesError::LongName { .. })));
        assert_eq!(with("1", Some("a\u{202e}b")), Err(NamesError::NotText));
    }
}
