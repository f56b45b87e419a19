//! A drawn land as a value: coasts, ridges and rivers on a fine grid, and their text.
//!
//! The text needs no escaping in a link. A coast is a dot followed by its points, a ridge two dots, a river three. A
//! point is four characters of base64url: two for its distance from the western border and two for its distance from
//! the northern one, in 4095ths of the domain.

use std::fmt;

use glam::Vec2;
use thiserror::Error;

use crate::base::numbers::{DIGITS, value_of};

/// The greatest length of an outline's text, in characters.
pub const LONGEST: usize = 1000;

/// Characters of a point.
const POINT: usize = 4;

/// A point of the domain, in 4095ths of its width and height: 0 and 4095 are its borders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GridPoint {
    x: u16,
    y: u16,
}

impl GridPoint {
    /// The coordinate of the far border.
    const LAST: u16 = 4095;

    /// Finds the grid point nearest to fractions of the domain's width and height. Points outside are moved to the
    /// border.
    pub fn nearest(fraction: Vec2) -> Self {
        let snap = |x: f32| (x.clamp(0.0, 1.0) * f32::from(Self::LAST)).round() as u16;
        Self { x: snap(fraction.x), y: snap(fraction.y) }
    }

    /// Returns the point as fractions of the domain's width and height.
    pub fn fraction(self) -> Vec2 {
        Vec2::new(f32::from(self.x), f32::from(self.y)) / f32::from(Self::LAST)
    }

    fn parse(digits: &[u8]) -> Option<Self> {
        let &[a, b, c, d] = digits else { return None };
        let value = |high: u8, low: u8| Some((value_of(high)? << 6 | value_of(low)?) as u16);
        Some(Self { x: value(a, b)?, y: value(c, d)? })
    }

    fn write(self, text: &mut String) {
        let digit = |value: u16| char::from(DIGITS[usize::from(value & 63)]);
        text.extend([self.x >> 6, self.x, self.y >> 6, self.y].map(digit));
    }
}

/// The kind of a line of an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LineKind {
    /// A closed line between land and water.
    Coast,
    /// An open line that no river crosses.
    Ridge,
    /// The course of a river, from its mouth. The mouth alone is enough.
    River,
}

impl LineKind {
    /// Returns the smallest number of points that a line of this kind has.
    pub const fn fewest(self) -> usize {
        match self {
            Self::Coast => 3,
            Self::Ridge => 2,
            Self::River => 1,
        }
    }

    const fn mark(self) -> &'static str {
        match self {
            Self::Coast => ".",
            Self::Ridge => "..",
            Self::River => "...",
        }
    }

    /// Returns the number of characters of a line with this many points.
    pub(crate) const fn length_of(self, points: usize) -> usize {
        self.mark().len() + points * POINT
    }
}

impl fmt::Display for LineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Coast => "coast",
            Self::Ridge => "ridge",
            Self::River => "river",
        })
    }
}

/// The reason why a text is not an outline.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// The text is longer than any outline's.
    #[error("the text has {length} characters, at most {LONGEST} are allowed")]
    TooLong {
        /// Its length in characters.
        length: usize,
    },
    /// The first character is not a dot.
    #[error("character 1 is not the dot that begins a coast")]
    NoBeginning,
    /// A character that does not occur in outlines.
    #[error("character {at} is not one of A to Z, a to z, 0 to 9, - and _")]
    BadCharacter {
        /// Its position, counted from 1.
        at: usize,
    },
    /// A line whose last point is incomplete.
    #[error("the {kind} that begins at character {at} ends within a point: a point has four characters")]
    BrokenPoint {
        /// The kind of line.
        kind: LineKind,
        /// The position of its first character, counted from 1.
        at: usize,
    },
    /// A line with too few points.
    #[error("the {kind} that begins at character {at} has too few points: {points}, at least {} are needed", kind.fewest())]
    TooFew {
        /// The kind of line.
        kind: LineKind,
        /// The position of its first character, counted from 1.
        at: usize,
        /// Its number of points.
        points: usize,
    },
    /// Ridges but no coasts.
    #[error("there are ridges but no coast")]
    NoCoast,
}

/// A drawn land: coasts, ridges and rivers. Coasts may cross and nest: land is what lies within an odd number of them.
/// Without coasts the whole domain is land, and there are no ridges.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    coasts: Vec<Vec<GridPoint>>,
    ridges: Vec<Vec<GridPoint>>,
    rivers: Vec<Vec<GridPoint>>,
}

impl Outline {
    /// Makes an outline from its lines. Each needs enough points, and the text of all must not be too long.
    ///
    /// # Errors
    /// Returns the errors of [`parse`](Self::parse), with the position of the fault in the text.
    pub fn new(
        coasts: Vec<Vec<GridPoint>>,
        ridges: Vec<Vec<GridPoint>>,
        rivers: Vec<Vec<GridPoint>>,
    ) -> Result<Self, OutlineError> {
        let this = Self { coasts, ridges, rivers };
        Self::parse(&this.to_string())
    }

    /// Reads an outline. An empty text is an empty outline.
    ///
    /// # Errors
    /// Names the fault and its position.
    pub fn parse(text: &str) -> Result<Self, OutlineError> {
        let length = text.chars().count();
        if length > LONGEST {
            return Err(OutlineError::TooLong { length });
        }
        if let Some(at) = text.chars().position(|c| c != '.' && !(c.is_ascii() && DIGITS.contains(&(c as u8)))) {
            return Err(OutlineError::BadCharacter { at: at + 1 });
        }
        let mut outline = Self::default();
        let mut rest = text.as_bytes();
        while !rest.is_empty() {
            rest = outline.take_line(rest, text.len() - rest.len() + 1)?;
        }
        if outline.coasts.is_empty() && !outline.ridges.is_empty() {
            return Err(OutlineError::NoCoast);
        }
        Ok(outline)
    }

    /// Reads the line at the start of `text` and returns the rest. `at` is its position in the whole.
    fn take_line<'a>(&mut self, text: &'a [u8], at: usize) -> Result<&'a [u8], OutlineError> {
        let kinds = [LineKind::River, LineKind::Ridge, LineKind::Coast].into_iter();
        let mut begun = kinds.filter_map(|kind| Some((kind, text.strip_prefix(kind.mark().as_bytes())?)));
        let (kind, line) = begun.next().ok_or(OutlineError::NoBeginning)?;
        let (digits, rest) = line.split_at(line.iter().position(|&c| c == b'.').unwrap_or(line.len()));
        if digits.is_empty() && !rest.is_empty() {
            return Err(OutlineError::BadCharacter { at: at + kind.length_of(0) });
        }
        if digits.len() % POINT != 0 {
            return Err(OutlineError::BrokenPoint { kind, at });
        }
        let points: Vec<GridPoint> = digits.chunks(POINT).filter_map(GridPoint::parse).collect();
        if points.len() < kind.fewest() {
            return Err(OutlineError::TooFew { kind, at, points: points.len() });
        }
        match kind {
            LineKind::Coast => self.coasts.push(points),
            LineKind::Ridge => self.ridges.push(points),
            LineKind::River => self.rivers.push(points),
        }
        Ok(rest)
    }

    /// Returns `true` if nothing is drawn.
    pub fn is_empty(&self) -> bool {
        self.coasts.is_empty() && self.rivers.is_empty()
    }

    /// Returns the closed lines between land and water. Each has three points or more; the last is joined to the first.
    pub fn coasts(&self) -> &[Vec<GridPoint>] {
        &self.coasts
    }

    /// Returns the lines that no river crosses. Each has two points or more.
    pub fn ridges(&self) -> &[Vec<GridPoint>] {
        &self.ridges
    }

    /// Returns the drawn courses of rivers, each from its mouth. Each has one point or more.
    pub fn rivers(&self) -> &[Vec<GridPoint>] {
        &self.rivers
    }
}

impl fmt::Display for Outline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = String::new();
        let rivers = (LineKind::River, &self.rivers);
        for (kind, lines) in [(LineKind::Coast, &self.coasts), (LineKind::Ridge, &self.ridges), rivers] {
            for line in lines {
                text.push_str(kind.mark());
                line.iter().for_each(|point| point.write(&mut text));
            }
        }
        f.write_str(&text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    fn lines(fewest: usize, most: usize) -> impl Strategy<Value = Vec<Vec<GridPoint>>> {
        let point = (0..=GridPoint::LAST, 0..=GridPoint::LAST).prop_map(|(x, y)| GridPoint { x, y });
        proptest::collection::vec(proptest::collection::vec(point, fewest..30), 1..=most)
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn every_outline_reads_back_and_needs_no_escaping(
            coasts in lines(3, 3), ridges in lines(2, 3), rivers in lines(1, 2),
        ) {
            let outline = Outline::new(coasts, ridges, rivers).unwrap();
            let text = outline.to_string();
            prop_assert_eq!(Outline::parse(&text), Ok(outline));
            prop_assert_eq!(form_urlencoded::byte_serialize(text.as_bytes()).collect::<String>(), text);
        }

        #[test]
        fn any_text_is_read_or_refused(text in "[.A-Ca_\u{20ac} ]{0,40}") {
            if let Ok(outline) = Outline::parse(&text) {
                prop_assert_eq!(Outline::parse(&outline.to_string()), Ok(outline));
            }
        }

        #[test]
        fn fractions_come_back_exactly(x in 0..=GridPoint::LAST, y in 0..=GridPoint::LAST) {
            let point = GridPoint { x, y };
            prop_assert_eq!(GridPoint::nearest(point.fraction()), point);
        }
    }

    #[test]
    fn errors_say_what_and_where() {
        let error = |text: &str| Outline::parse(text).unwrap_err().to_string();
        assert_eq!(error("AAAA"), "character 1 is not the dot that begins a coast");
        assert!(error(".AAAAB%BB").starts_with("character 7 is not one of A to Z"));
        assert!(error(".AAAABBBBCCC").starts_with("the coast that begins at character 1 ends within a point"));
        let short = ".AAAABBBBCCCC..AAAA";
        assert_eq!(error(short), "the ridge that begins at character 14 has too few points: 1, at least 2 are needed");
        assert_eq!(error("..AAAABBBB"), "there are ridges but no coast");
        assert!(error(&".A".repeat(600)).contains("1200 characters, at most 1000"));
        assert!(error(".AAAABBBBCCCC....AAAA").starts_with("character 17 is not one of A to Z"));
        assert!(error("........").starts_with("character 4 is not one of A to Z"));
        assert!(error("...").starts_with("the river that begins at character 1 has too few points: 0, at least 1"));
        assert!(error(".AAAABBBBCCCC...AAA").starts_with("the river that begins at character 14 ends within a point"));
        assert_eq!(error("..AAAABBBB...AAAA"), "there are ridges but no coast");
        assert!(error(".AAAABBBBCCCC..").contains("at character 14 has too few points: 0"));
        assert_eq!(Outline::parse(""), Ok(Outline::default()));
    }
}
