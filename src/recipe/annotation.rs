//! The annotation that a recipe asks for: labels, a cartouche, woods and hills, as far as its style has them.

use super::Recipe;
use super::choice::{Cartouche, Labels};
use super::key::{Key, NumberKey};
use super::names::OwnNames;
use super::style::{Shown, Style};

impl Recipe {
    /// Returns how wooded the land is and how thickly hills stand, from 0 to 1: 0 in a style that does not draw them.
    pub fn scenery(&self) -> [f32; 2] {
        let style: Style = self.get();
        let shown = |key, is_shown: bool| if is_shown { self.number(key) } else { 0.0 };
        [shown(NumberKey::Woods, style.has_woods()), shown(NumberKey::Hills, style.has_hills())]
    }

    /// Returns the exaggeration of heights for light and shadow: less where hills are drawn, which show the relief in
    /// their own way.
    pub fn shade(&self) -> f32 {
        const GIVES_WAY: f32 = 0.85;
        let [_, hills] = self.scenery();
        self.number(NumberKey::Shade) * (1.0 - GIVES_WAY * hills)
    }

    /// Returns `true` if the map has woods or hills.
    pub fn has_scenery(&self) -> bool {
        self.scenery() != [0.0; 2]
    }

    /// Returns `true` if the map has labels that are no names.
    pub fn has_marks(&self) -> bool {
        self.get::<Labels>() != Labels::None && self.get::<Style>().has_marks()
    }

    /// Returns `true` if the map shows its title: as the cartouche says, and by itself if it has names.
    pub fn has_title(&self) -> bool {
        match self.get() {
            Cartouche::Auto => self.get::<Labels>() != Labels::None,
            Cartouche::None => false,
            Cartouche::Plain | Cartouche::Framed | Cartouche::Lengths | Cartouche::Profile => true,
        }
    }

    /// Returns `true` if the map is a sheet with a neat line in every style: its cartouche is framed, or a plate.
    pub(crate) fn is_sheet(&self) -> bool {
        matches!(self.get(), Cartouche::Framed | Cartouche::Lengths | Cartouche::Profile)
    }

    /// Returns `true` if the map has labels, a cartouche, woods or hills.
    pub fn is_annotated(&self) -> bool {
        self.get::<Labels>() != Labels::None || self.has_title() || self.has_scenery()
    }

    /// Returns the style, if it decides what the annotation consists of; `None` if that would be the same in any other.
    pub fn annotating_style(&self) -> Option<Style> {
        let style: Style = self.get();
        // Ranges are named where heights are shown, and a north point stands beside a title.
        let is_unlike_others = style.has_relief() || style.shows(Shown::CompassRose) || style.shows(Shown::NorthArrow);
        let is_annotated = self.is_annotated() && is_unlike_others;
        (self.has_scenery() || self.has_marks() || is_annotated).then_some(style)
    }

    /// Returns the person's own names.
    pub fn own_names(&self) -> OwnNames {
        OwnNames::readable(&Key::Names.parameter().text_of(self.value(Key::Names)))
    }
}
