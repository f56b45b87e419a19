//! Names on the wire: the wasm module that makes names hands them to the one that writes files.

use super::{Names, PlaceKind, PlaceName, ReachName, RiverName};
use crate::base::wire::{Reader, Writer, point};

impl Names {
    /// Writes all names as numbers, for [`Names::from_wire`] in another module of the same build.
    pub fn to_wire(&self) -> Vec<u32> {
        let mut data = Writer::default();
        data.count(self.rivers.len());
        for RiverName { identity, name, short, kind } in &self.rivers {
            data.push(&[*identity]);
            [name, short, kind].into_iter().for_each(|text| data.text(text));
        }
        data.count(self.reaches.len());
        for ReachName { river, identity, name, course } in &self.reaches {
            data.push(&[*river, *identity]);
            data.text(name);
            data.points(course);
        }
        data.count(self.places.len());
        for PlaceName { kind, number, name, at } in &self.places {
            data.push(&[*kind as u32, *number, at.x.to_bits(), at.y.to_bits()]);
            data.text(name);
        }
        data.text(&self.title);
        data.0
    }

    /// The names of such a message; `None` if it is something else.
    pub fn from_wire(data: &[u32]) -> Option<Self> {
        let mut data = Reader(data);
        let rivers = data.several(|data| {
            let ([identity], name, short, kind) = (data.take()?, data.text()?, data.text()?, data.text()?);
            Some(RiverName { identity, name, short, kind })
        })?;
        let reaches = data.several(|data| {
            let ([river, identity], name, course) = (data.take()?, data.text()?, data.points()?);
            Some(ReachName { river, identity, name, course })
        })?;
        let places = data.several(|data| {
            let ([kind, number, x, y], name) = (data.take()?, data.text()?);
            let kind = *[PlaceKind::Sea, PlaceKind::Lake, PlaceKind::Island].get(kind as usize)?;
            Some(PlaceName { kind, number, name, at: point([x, y]) })
        })?;
        Some(Self { rivers, reaches, places, title: data.text()? })
    }
}
