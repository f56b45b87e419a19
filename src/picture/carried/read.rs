//! Carried letters, read: they come from anybody's page.

use super::rows::Row;
use super::{Carried, VERSION};
use crate::annotate::glyph::Typeface;
use crate::annotate::place::STEPS;
use crate::base::hash::Fnv1a;
use crate::base::numbers::Reader;

/// The most curves of a letter, and the farthest that it reaches, in ems.
const MOST_CURVES: usize = 1000;
const FARTHEST: f32 = 8.0;

impl Carried {
    /// Reads letters; `None` if the text is too long, damaged or something else.
    pub fn read(text: &str) -> Option<Self> {
        if text.len() > Self::LONGEST {
            return None;
        }
        let mut reader = Reader::of_text(text)?;
        (reader.whole() == checksum(reader.left()) && reader.whole() == VERSION).then_some(())?;
        let (rivers, keys) = (reader.whole(), reader.list(Reader::whole));
        let faces = [Typeface::unspaced(&mut reader), Typeface::unspaced(&mut reader)];
        faces.iter().all(is_sound).then_some(())?;
        let mut steps: Vec<Vec<Row>> = Vec::new();
        for _ in 0..STEPS {
            let before = steps.last().map_or(&[][..], |rows| rows);
            let rows = reader.list(|reader| Row::read(reader, before, &faces));
            steps.push(rows.into_iter().collect::<Option<_>>()?);
        }
        reader.left().is_empty().then_some(Self { rivers, keys, faces, steps })
    }
}

/// Returns the sum by which damage is seen.
pub(super) fn checksum(text: &[u8]) -> u32 {
    let mut hash = Fnv1a::new();
    hash.bytes(text);
    hash.folded()
}

/// Returns `true` if letters are as large as letters are, and no harder to paint.
fn is_sound(face: &Typeface) -> bool {
    let is_near = |at: glam::Vec2| at.abs().max_element() <= FARTHEST;
    face.glyphs().iter().all(|glyph| {
        let curves: usize = glyph.contours.iter().map(|(_, curves)| curves.len()).sum();
        curves <= MOST_CURVES && is_near(glyph.least) && is_near(glyph.most) && glyph.advance <= FARTHEST
    })
}
