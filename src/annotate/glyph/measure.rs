//! A line of type: its letters and their places.

use super::table::{Face, Glyph, Typeface};

/// A letter in a line of type.
#[derive(Clone, Copy, Debug)]
pub struct Letter {
    /// Its outline and its advance.
    pub glyph: &'static Glyph,
    /// Its distance from the beginning of the line, in ems.
    pub at: f32,
}

/// Sets a text in a face, with kerning and with `tracking` ems more between any two letters. Returns its letters and its length in ems.
/// Characters that the face lacks are left out.
pub fn line_of(text: &str, face: Face, tracking: f32) -> (Vec<Letter>, f32) {
    let face = Typeface::of(face);
    let mut letters: Vec<Letter> = Vec::new();
    let mut end = 0.0;
    for glyph in text.chars().filter_map(|letter| face.glyph(letter.into())) {
        let between = letters.last().map_or(0.0, |before| tracking + face.kerning(before.glyph, glyph));
        letters.push(Letter { glyph, at: end + between });
        end += between + glyph.advance;
    }
    (letters, end)
}

/// Returns the characters of a text that no face has a letter for, as often as they occur.
pub fn lacking(text: &str) -> impl Iterator<Item = char> {
    // Both faces have the same letters.
    let face = Typeface::of(Face::Italic);
    text.chars().filter(|&letter| face.glyph(letter.into()).is_none())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_its_letters_advances_with_kerning_and_tracking() {
        let advance =
            |text: &str| Typeface::of(Face::Italic).glyph(text.chars().next().unwrap().into()).unwrap().advance;
        let (letters, length) = line_of("non", Face::Italic, 0.1);
        assert_eq!(letters.len(), 3);
        assert!((length - (2.0 * advance("n") + advance("o") + 0.2)).abs() < 1e-6);
        assert!((letters[2].at + advance("n") - length).abs() < 1e-6);
        assert!(line_of("Ty", Face::Italic, 0.0).1 < advance("T") + advance("y") - 0.05);
        assert_eq!(line_of("", Face::Italic, 0.1).1, 0.0);
        assert_eq!(line_of("n中o", Face::Italic, 0.1).0.len(), 2);
    }
}
