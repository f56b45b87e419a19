//! Names as words: the wasm module that makes names hands them to the one that writes files.

use super::{Names, PlaceKind, PlaceName, ReachName, RiverName};
use crate::land::Region;
use crate::words::{Reader, Writer, point};

impl Names {
    /// All names, to be handed to another module, which is not told what cells places have.
    pub fn to_words(&self) -> Vec<u32> {
        let mut words = Writer::default();
        words.count(self.rivers.len());
        for RiverName { identity, name, short, kind } in &self.rivers {
            words.some(&[*identity]);
            [name, short, kind].into_iter().for_each(|text| words.text(text));
        }
        words.count(self.reaches.len());
        for ReachName { river, identity, name, course } in &self.reaches {
            words.some(&[*river, *identity]);
            words.text(name);
            words.points(course);
        }
        words.count(self.places.len());
        for PlaceName { kind, number, name, at, .. } in &self.places {
            words.some(&[*kind as u32, *number, at.x.to_bits(), at.y.to_bits()]);
            words.text(name);
        }
        words.text(&self.title);
        words.0
    }

    /// The names of such words; `None` if they are something else.
    pub fn from_words(words: &[u32]) -> Option<Self> {
        let words = &mut Reader(words);
        let rivers = list(words, |words| {
            let ([identity], name, short, kind) = (words.some()?, words.text()?, words.text()?, words.text()?);
            Some(RiverName { identity, name, short, kind })
        })?;
        let reaches = list(words, |words| {
            let ([river, identity], name, course) = (words.some()?, words.text()?, words.points()?);
            Some(ReachName { river, identity, name, course })
        })?;
        let places = list(words, |words| {
            let ([kind, number, x, y], name) = (words.some()?, words.text()?);
            let kind = *[PlaceKind::Sea, PlaceKind::Lake, PlaceKind::Island].get(kind as usize)?;
            Some(PlaceName { kind, number, name, at: point([x, y]), region: Region::default() })
        })?;
        Some(Self { rivers, reaches, places, title: words.text()? })
    }
}

fn list<T>(words: &mut Reader<'_>, mut item: impl FnMut(&mut Reader<'_>) -> Option<T>) -> Option<Vec<T>> {
    let [count] = words.some()?;
    (0..count).map(|_| item(words)).collect()
}
