//! The text of an SVG file, written piece by piece.
//!
//! Markup is fixed in this program's source, so [`Text::text`] takes nothing made at run time. A word from outside, in
//! a seed or a name, can be written in two ways, and both escape it: [`Text::escaped`] and [`Text::attribute`].
//!
//! The functions for its pieces are never inlined. `write!` would be simpler, but three times as much code to download.

use crate::paint::palette::Colour;

/// A text while it is written.
#[derive(Debug, Default)]
pub(super) struct Text {
    text: String,
    /// The number of the file that it belongs to.
    file: u32,
}

impl Text {
    /// Begins a text of a file. The number tells the file from others that stand in the same page.
    pub fn of(file: u32) -> Self {
        Self { text: String::new(), file }
    }

    /// Returns the text written so far.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// Returns the finished text.
    pub fn into_string(self) -> String {
        self.text
    }

    /// Appends the id of a part that the file refers to, which no other file in the page has.
    pub fn own(&mut self, name: &'static str) -> &mut Self {
        let file = self.file;
        self.text(name).text("-").whole(file)
    }

    /// Appends a reference to a part, as the value of an attribute.
    pub fn url(&mut self, name: &'static str) -> &mut Self {
        self.text("url(#").own(name).text(")")
    }

    /// Appends markup.
    pub fn text(&mut self, markup: &'static str) -> &mut Self {
        self.written(markup)
    }

    /// Appends the output of another `Text`, written here or in another module of the page.
    #[inline(never)]
    pub fn written(&mut self, markup: &str) -> &mut Self {
        self.text.push_str(markup);
        self
    }

    /// Appends a whole number.
    #[inline(never)]
    pub fn whole(&mut self, number: u32) -> &mut Self {
        const MOST_DIGITS: usize = 10;
        let (mut digits, mut rest) = ([b'0'; MOST_DIGITS], number);
        let mut first = MOST_DIGITS;
        while rest > 0 || first == MOST_DIGITS {
            first -= 1;
            digits[first] = b'0' + (rest % 10) as u8;
            rest /= 10;
        }
        digits[first..].iter().for_each(|&digit| self.text.push(char::from(digit)));
        self
    }

    /// Appends a number of hundredths as a decimal, as short as possible.
    #[inline(never)]
    pub fn hundredths(&mut self, hundredths: i32) -> &mut Self {
        if hundredths < 0 {
            self.text("-");
        }
        let (units, rest) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
        self.whole(units);
        if rest > 0 {
            self.text(".").whole(rest / 10);
            if !rest.is_multiple_of(10) {
                self.whole(rest % 10);
            }
        }
        self
    }

    /// Appends a length, 0 or more, rounded to hundredths.
    pub fn units(&mut self, units: f32) -> &mut Self {
        self.hundredths((units * 100.0 + 0.5) as i32)
    }

    /// Appends the attributes of a size, in units.
    pub fn sized(&mut self, size: glam::Vec2) -> &mut Self {
        self.text(" width=\"").units(size.x).text("\" height=\"").units(size.y).text("\"")
    }

    /// Appends a colour in hexadecimal digits.
    #[inline(never)]
    pub fn colour(&mut self, colour: Colour) -> &mut Self {
        self.text("#");
        for half in colour.into_iter().flat_map(|channel| [channel >> 4, channel & 15]) {
            self.text.push(char::from(b"0123456789abcdef"[usize::from(half)]));
        }
        self
    }

    /// Appends an attribute, escaped.
    pub fn attribute(&mut self, name: &'static str, value: &str) -> &mut Self {
        self.text(" ").text(name).text("=\"").escaped(value).text("\"")
    }

    /// Appends a text, escaped so that it neither begins an element nor ends an attribute; all attributes stand in
    /// double quotes. A character that XML cannot hold is replaced by U+FFFD.
    #[inline(never)]
    pub fn escaped(&mut self, text: &str) -> &mut Self {
        for c in text.chars() {
            match c {
                '&' => self.text.push_str("&amp;"),
                '<' => self.text.push_str("&lt;"),
                '>' => self.text.push_str("&gt;"),
                '"' => self.text.push_str("&quot;"),
                '\0'..='\u{1f}' | '\u{7f}'..='\u{9f}' | '\u{fffe}' | '\u{ffff}' => self.text.push('\u{fffd}'),
                c => self.text.push(c),
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_short_as_they_go() {
        for (hundredths, text) in [(0, "0"), (5, "0.05"), (-5, "-0.05"), (120, "1.2"), (-12345, "-123.45"), (700, "7")]
        {
            assert_eq!(Text::default().hundredths(hundredths).text, text);
        }
        assert_eq!(Text::default().whole(u32::MAX).text(" ").whole(0).text, format!("{} 0", u32::MAX));
    }

    #[test]
    fn a_text_neither_begins_an_element_nor_ends_an_attribute() {
        let word = "a\" b='c' <d>&e;]]>\n\t\0\u{85}\u{fffe}\u{ffff}\u{202e}";
        let escaped = "a&quot; b='c' &lt;d&gt;&amp;e;]]&gt;\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{202e}";
        assert_eq!(Text::default().escaped(word).text, escaped);
    }

    #[test]
    fn an_attribute_ends_where_its_value_ends() {
        assert_eq!(
            Text::default().attribute("aria-label", "\" onfocus=\"x").text,
            " aria-label=\"&quot; onfocus=&quot;x\""
        );
    }

    #[test]
    fn colours_are_as_css_has_them() {
        assert_eq!(Text::default().colour([0, 0x1f, 0xff]).text, "#001fff");
    }
}
