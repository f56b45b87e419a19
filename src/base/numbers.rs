//! Lists of whole numbers as bytes, or as text.
//!
//! A digit of a number has seven bits in bytes and five in text, the lowest first; one more bit says that others follow. Signed numbers are
//! 0, −1, 1, −2 … as 0, 1, 2, 3 …; a list begins with its length. Digits of text are those of base64url.

/// The digits of base64url.
pub(crate) const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// The bits that a digit of text adds to a number.
const TEXT_BITS: u32 = 5;

/// Reads numbers. Beyond the end everything is 0.
pub(crate) struct Reader<'a> {
    digits: &'a [u8],
    /// How many bits of a number a digit has.
    bits: u32,
}

impl<'a> Reader<'a> {
    /// Starts with the first of some bytes.
    pub fn of_bytes(digits: &'a [u8]) -> Self {
        Self { digits, bits: 7 }
    }

    /// Starts with the first digit of a text; `None` if it has others.
    pub fn of_text(text: &'a str) -> Option<Self> {
        let digits = text.as_bytes();
        digits.iter().all(|&digit| value_of(digit).is_some()).then_some(Self { digits, bits: TEXT_BITS })
    }

    /// Returns what is left.
    pub fn left(&self) -> &'a [u8] {
        self.digits
    }

    fn digit(&mut self) -> u32 {
        let digit = self.digits.split_off_first().copied();
        let value = if self.bits == TEXT_BITS { digit.and_then(value_of) } else { digit.map(u32::from) };
        value.unwrap_or(0)
    }

    /// Reads a number.
    pub fn whole(&mut self) -> u32 {
        let (mut number, mut shift, more) = (0, 0, 1 << self.bits);
        loop {
            let digit = self.digit();
            number |= (digit % more).wrapping_shl(shift);
            shift += self.bits;
            if digit < more {
                return number;
            }
        }
    }

    /// Reads a signed number.
    pub fn signed(&mut self) -> i32 {
        let number = self.whole();
        (number >> 1) as i32 ^ -((number & 1) as i32)
    }

    /// Reads so many answers, or fewer where there are no more.
    pub fn answers(&mut self, count: usize) -> Vec<bool> {
        let a_digit = self.bits as usize + 1;
        let digits = count.div_ceil(a_digit).min(self.digits.len());
        let values: Vec<u32> = (0..digits).map(|_| self.digit()).collect();
        (0..count.min(digits * a_digit)).map(|i| values[i / a_digit] >> (i % a_digit) & 1 == 1).collect()
    }

    /// Reads a list, which ends with the digits at the latest: whoever wrote them, it has no more items than they are.
    pub fn list<T>(&mut self, mut item: impl FnMut(&mut Self) -> T) -> Vec<T> {
        (0..self.whole()).map_while(|_| (!self.digits.is_empty()).then(|| item(self))).collect()
    }
}

/// Writes numbers as text.
#[derive(Default)]
pub(crate) struct Writer(pub String);

impl Writer {
    fn digit(&mut self, value: u32) {
        self.0.push(char::from(DIGITS[(value & 63) as usize]));
    }

    /// Writes a number.
    pub fn whole(&mut self, mut number: u32) {
        let more = 1 << TEXT_BITS;
        while number >= more {
            self.digit(number % more + more);
            number >>= TEXT_BITS;
        }
        self.digit(number);
    }

    /// Writes a signed number.
    pub fn signed(&mut self, number: i32) {
        self.whole(((number << 1) ^ (number >> 31)) as u32);
    }

    /// Writes answers, whose number the reader knows.
    pub fn answers(&mut self, answers: &[bool]) {
        for answers in answers.chunks(TEXT_BITS as usize + 1) {
            self.digit(answers.iter().rev().fold(0, |bits, answer| bits << 1 | u32::from(*answer)));
        }
    }

    /// Writes a list.
    pub fn list<T>(&mut self, items: &[T], mut write: impl FnMut(&mut Self, &T)) {
        self.whole(items.len() as u32);
        items.iter().for_each(|item| write(self, item));
    }
}

/// Returns the value of a digit; `None` if it is none.
#[inline(never)] // its copies would weigh a kilobyte
pub(crate) fn value_of(digit: u8) -> Option<u32> {
    DIGITS.iter().position(|&d| d == digit).map(|value| value as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn numbers_come_out_as_they_were_put_in(wholes: Vec<u32>, signed: Vec<i32>, answers: Vec<bool>) {
            let mut writer = Writer::default();
            writer.list(&wholes, |writer, whole| writer.whole(*whole));
            writer.answers(&answers);
            writer.list(&signed, |writer, signed| writer.signed(*signed));
            let mut reader = Reader::of_text(&writer.0).unwrap();
            prop_assert_eq!(reader.list(Reader::whole), wholes);
            prop_assert_eq!(reader.answers(answers.len()), answers);
            prop_assert_eq!(reader.list(Reader::signed), signed);
            prop_assert!(reader.left().is_empty());
        }

        #[test]
        fn only_digits_are_text(text in "[-_A-Za-z0-9]{0,20}", other in "\\PC{0,20}") {
            prop_assert!(Reader::of_text(&text).is_some());
            prop_assert_eq!(Reader::of_text(&other).is_some(), other.bytes().all(|digit| DIGITS.contains(&digit)));
        }

        #[test]
        fn a_list_is_no_longer_than_its_digits(bytes: Vec<u8>) {
            let mut reader = Reader::of_bytes(&bytes);
            let items = reader.list(|reader| (reader.list(Reader::whole).len(), reader.answers(usize::MAX).len()));
            prop_assert!(items.len() <= bytes.len());
        }
    }
}
