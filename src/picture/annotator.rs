//! Makes the annotation of a picture part by part, and keeps the places of its labels for other views of the map.

use super::builder::AnnotationBuilder;
use super::carried::Lettering;
use super::{AnnotationKey, Picture};
use crate::annotate::place::{Label, Places};
use crate::map::Map;
use crate::paint::{AnnotationMasks, View};

/// The maker of a picture's annotations.
#[derive(Clone, Debug)]
pub(super) struct Annotator {
    /// Picture pixels per pixel of the unit in which letters are measured.
    ratio: f32,
    /// Where letters come from.
    lettering: Lettering,
    /// The next annotation, while it is being made.
    builder: Option<AnnotationBuilder>,
    /// The map and style whose labels have these places, as far as views of it have asked for them.
    places: (Option<AnnotationKey>, Places),
    /// The labels of the last annotation.
    labels: Vec<Label>,
}

impl Default for Annotator {
    fn default() -> Self {
        let lettering = Lettering::default();
        Self { ratio: 1.0, lettering, builder: None, places: Default::default(), labels: Vec::new() }
    }
}

impl Annotator {
    pub fn set_ratio(&mut self, ratio: f32) {
        self.ratio = ratio;
        self.begin_anew();
    }

    /// Drops the annotation that is being made.
    pub fn begin_anew(&mut self) {
        self.builder = None;
    }

    /// Takes over letters and places.
    pub fn follow(&mut self, before: Self) {
        (self.lettering, self.places) = (before.lettering, before.places);
    }

    pub fn letter(&mut self, lettering: Lettering) {
        self.lettering = lettering;
        self.begin_anew();
    }

    /// Returns `true` if this build can place letters, or if they are carried.
    pub fn is_able(&self) -> bool {
        cfg!(feature = "names") || self.lettering.are_carried()
    }

    /// Returns the masks of letters that need not be placed for this very picture.
    pub fn letters(&self, map: &Map, view: &View) -> Option<AnnotationMasks> {
        self.lettering.masks(map, view, self.ratio)
    }

    /// Does a part of an annotation. Returns it after the last part.
    pub fn advance(&mut self, key: AnnotationKey, map: &Map, view: &View) -> Option<AnnotationMasks> {
        if self.places.0 != Some(key) {
            self.places = (Some(key), Places::default());
            self.begin_anew();
        }
        let builder = self.builder.get_or_insert_default();
        let annotation = builder.advance(&mut self.places.1, map, view, self.ratio)?;
        self.labels = self.builder.take().map_or_else(Vec::new, AnnotationBuilder::into_labels);
        Some(annotation)
    }
}

#[cfg(test)]
impl Annotator {
    pub fn places(&mut self) -> &mut Places {
        &mut self.places.1
    }
}

impl Picture {
    /// Returns the labels of the annotation that this picture made last.
    #[doc(hidden)]
    pub fn labels(&self) -> &[Label] {
        &self.annotator.labels
    }
}
