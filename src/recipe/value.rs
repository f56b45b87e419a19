//! The kinds of value that a parameter can have, and the text of each.

use std::fmt;

use super::outline::Outline;

/// The value of a parameter, of a [`Kind`](super::Kind). Exhaustive like that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// Free text.
    Text(String),
    /// A whole number.
    Integer(u32),
    /// A number.
    Number(Decimal),
    /// One of the parameter's words.
    Choice(&'static str),
    /// A set of sides of the domain.
    Sides(Sides),
    /// A drawn land.
    Outline(Outline),
}

/// A number with four decimal places, kept exactly: it is written digit for digit as it was read, and no link holds
/// 0.30000000000000004.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Decimal {
    ten_thousandths: i64,
}

impl Decimal {
    const PLACES: usize = 4;
    const ONE: i64 = 10_000;
    /// The largest number; larger ones are read as this one. All ranges lie far below it.
    const HUGE: i64 = 1_000_000_000_000_000;

    /// Rounds a number to the nearest decimal, for constants.
    pub const fn new(number: f64) -> Self {
        Self { ten_thousandths: (number * Self::ONE as f64 + 0.5) as i64 }
    }

    /// Converts a whole number.
    pub const fn whole(number: u32) -> Self {
        Self { ten_thousandths: number as i64 * Self::ONE }
    }

    /// Reads an optional sign and digits with an optional point; further places are rounded. `None` for anything else.
    /// Numbers beyond all ranges are read as some such number.
    pub fn parse(text: &str) -> Option<Self> {
        let (is_negative, digits) = match text.as_bytes() {
            [b'-', digits @ ..] => (true, digits),
            [b'+', digits @ ..] | digits => (false, digits),
        };
        let point = digits.iter().position(|&c| c == b'.').unwrap_or(digits.len());
        let (whole, fraction) = (&digits[..point], digits.get(point + 1..).unwrap_or(&[]));
        let is_digits = |digits: &[u8]| digits.iter().all(u8::is_ascii_digit);
        if whole.len() + fraction.len() == 0 || !is_digits(whole) || !is_digits(fraction) {
            return None;
        }
        let append = |number: i64, digit: u8| (number * 10 + i64::from(digit - b'0')).min(Self::HUGE);
        let whole = whole.iter().fold(0, |number, &digit| append(number, digit));
        let place = |i: usize| fraction.get(i).copied().unwrap_or(b'0');
        let kept = (0..Self::PLACES).fold(whole, |number, i| append(number, place(i)));
        let rounded = kept + i64::from(fraction.get(Self::PLACES).is_some_and(|&digit| digit >= b'5'));
        Some(Self { ten_thousandths: if is_negative { -rounded } else { rounded } })
    }

    /// Returns its multiple that is nearest to a number.
    pub(super) fn nearest_multiple(self, number: f64) -> Self {
        let step = self.ten_thousandths;
        let times = (number * Self::ONE as f64 / step as f64 + 0.5) as i64;
        Self { ten_thousandths: times * step }
    }

    /// Returns `true` if it has no decimal places.
    pub fn is_whole(self) -> bool {
        self.ten_thousandths % Self::ONE == 0
    }

    /// Rounds to the nearest whole number, halves up; negative numbers to 0.
    pub fn round(self) -> u32 {
        u32::try_from((self.ten_thousandths + Self::ONE / 2) / Self::ONE).unwrap_or(if self.ten_thousandths < 0 {
            0
        } else {
            u32::MAX
        })
    }

    /// Converts to the nearest floating-point number.
    pub fn to_f64(self) -> f64 {
        self.ten_thousandths as f64 / Self::ONE as f64
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.ten_thousandths < 0 { "-" } else { "" };
        let number = self.ten_thousandths.unsigned_abs();
        let (whole, mut fraction, mut places) = (number / Self::ONE as u64, number % Self::ONE as u64, Self::PLACES);
        while places > 0 && fraction.is_multiple_of(10) {
            fraction /= 10;
            places -= 1;
        }
        write!(f, "{sign}{whole}")?;
        if places > 0 { write!(f, ".{fraction:0places$}") } else { Ok(()) }
    }
}

/// A set of sides of the domain, never empty. Its text is the initials in the order n, e, s, w: `ns`, `nesw`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sides(u8);

impl Sides {
    /// The lower side alone.
    pub const SOUTH: Self = Self(0b0100);
    /// All four.
    pub const ALL: Self = Self(0b1111);
    const INITIALS: &str = "nesw";

    /// Reads initials in any order. `None` if the text is empty, repeats a side or has another letter.
    pub fn parse(text: &str) -> Option<Self> {
        let set = text.chars().try_fold(0u8, |set, initial| {
            let side = 1 << Self::INITIALS.find(initial.to_ascii_lowercase())?;
            (set & side == 0).then_some(set | side)
        })?;
        (set != 0).then_some(Self(set))
    }

    /// Returns `true` if the set contains the side with this initial.
    pub fn contains(self, initial: char) -> bool {
        Self::INITIALS.find(initial).is_some_and(|i| self.0 & 1 << i != 0)
    }

    /// Lists all fifteen sets of sides.
    pub fn all() -> impl Iterator<Item = Self> {
        (1..16).map(Self)
    }
}

impl fmt::Display for Sides {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Self::INITIALS.chars().filter(|&c| self.contains(c)).try_for_each(|c| write!(f, "{c}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_read_and_written_exactly() {
        let canonical = |text: &str| Decimal::parse(text).map(|decimal| decimal.to_string());
        for (text, expected) in [
            ("0.60", "0.6"),
            ("-0", "0"),
            ("+2.", "2"),
            (".5", "0.5"),
            ("-0.00015", "-0.0002"),
            ("0.30000000000000004", "0.3"),
            ("1000000", "1000000"),
        ] {
            assert_eq!(canonical(text).as_deref(), Some(expected), "{text}");
        }
        for text in ["", ".", "-", "NaN", "inf", "1e3", "1,5", "0x3", "1.2.3", "٣", " 1", "--1"] {
            assert_eq!(canonical(text), None, "{text:?}");
        }
        assert!(Decimal::parse(&"9".repeat(400)) > Some(Decimal::whole(u32::MAX)));
    }

    #[test]
    fn decimals_round_to_whole_numbers() {
        let round = |text: &str| Decimal::parse(text).map(Decimal::round);
        assert_eq!(
            [round("2.5"), round("2.4999"), round("-7"), round("9999999999")],
            [Some(3), Some(2), Some(0), Some(u32::MAX)]
        );
    }

    #[test]
    fn sides_are_spelled_in_one_order() {
        assert_eq!(Sides::parse("wN").map(|s| s.to_string()).as_deref(), Some("nw"));
        assert!(Sides::all().all(|s| Sides::parse(&s.to_string()) == Some(s)));
    }

    #[test]
    fn sides_refuse_nothing_twice_and_strangers() {
        for text in ["", "nn", "x", "n e", "ñ"] {
            assert_eq!(Sides::parse(text), None, "{text:?}");
        }
    }
}
